"""How the arm is mounted (0x151 byte 5, generation 2): four ways, told and never told back."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtWidgets import QButtonGroup, QFrame, QHBoxLayout, QLabel, QSizePolicy

from armui.protocol.codes import Mounting
from armui.ui import words
from armui.ui.widgets.buttons import caption, choice_button, push_button, show_primary
from armui.ui.widgets.enable_or_explain import enable_or_explain
from armui.ui.widgets.layouts import fill, in_column
from armui.ui.widgets.text_label import text_label

if TYPE_CHECKING:
    from armui.arm.refusal import Refusal
    from armui.control.arm_controller import ArmController
    from armui.setting_checks import MountingName
    from armui.settings import SettingsStore

_CHOICES: Final[dict[Mounting, MountingName]] = {
    Mounting.LEVEL: "level",
    Mounting.ON_THE_LEFT_SIDE: "on_the_left_side",
    Mounting.ON_THE_RIGHT_SIDE: "on_the_right_side",
    Mounting.UPSIDE_DOWN: "upside_down",
}
_MOST: Final = 200
"""Arms that are remembered; those told longest ago are forgotten."""


class MountingCard(QFrame):
    """Chooses a mounting; who owns it asks the operator before it is told.

    Args:
        controller: Tells the arm.
        preferences: Keeps what each arm was told last.

    Attributes:
        send: The button that tells it.
    """

    def __init__(self, controller: ArmController, preferences: SettingsStore) -> None:
        super().__init__()
        self._controller = controller
        self._preferences = preferences
        self._arm: str | None = None
        self.setProperty("card", True)
        self._heading = QLabel()
        self._choices = QButtonGroup(self)
        self.send = push_button("mounting_confirm_button")
        self._told = text_label("mounting_told", wraps=True)
        self._note = text_label(rank="muted", wraps=True)
        row = QHBoxLayout()
        for mounting, name in _CHOICES.items():
            button = choice_button(f"mounting_{name}")
            button.setProperty("tight", True)
            button.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
            self._choices.addButton(button, int(mounting))
            row.addWidget(button, 1)
        column = in_column(on=self, margins=(16, 12, 16, 12))
        fill(column, self._heading, row, self.send, self._told, self._note)
        self._choices.idToggled.connect(lambda _id, _on: self.show_possible())

    @property
    def chosen(self) -> Mounting | None:
        """What the operator has chosen."""
        code = self._choices.checkedId()
        return None if code < 0 else Mounting(code)

    def tell(self) -> Refusal | None:
        """Tell the arm what is chosen, and keep it: ``None``, or why not."""
        mounting = self.chosen
        if mounting is None:
            return None
        refusal = self._controller.mounting.tell(mounting)
        if refusal is None:
            refusal = self._keep(mounting)
            self._show_told()
            self.show_possible()
        return refusal

    def follow_arm(self) -> None:
        """Show what the arm that is connected was told; it is another one, or has named itself."""
        device = self._controller.operating_state.device
        identity = self._controller.state.identity
        node = "" if identity is None else identity.node_number
        arm = None if device is None else device.arm_key(node)
        if arm is not None and identity is not None and not node:
            arm = self._arm or arm  # its answer to another's question was cut
        if arm != self._arm:
            self._arm = arm
            self._show_kept()
            self._show_told()

    @property
    def _kept(self) -> Mounting | None:
        """What this arm was told last by this program; ``None``: nothing, or no arm is there."""
        kept = self._preferences.settings.mountings.get(self._arm or "")
        return next((each for each, name in _CHOICES.items() if name == kept), None)

    def _keep(self, mounting: Mounting) -> Refusal | None:
        if self._arm is None:
            return None
        kept = dict(self._preferences.settings.mountings)
        kept.pop(self._arm, None)
        kept[self._arm] = _CHOICES[mounting]
        return self._preferences.change(mountings=dict(list(kept.items())[-_MOST:]))

    def question(self) -> tuple[str, str]:
        """Title and text of the question before it is told."""
        how = "" if self.chosen is None else words.mounting(self.chosen)
        return (
            self.tr("Tell the arm its mounting: {mounting}").format(mounting=how),
            self.tr(
                "The arm carries its own weight by what it believes of its mounting. If that is "
                "wrong it may sink or rise when it is led by hand, hold badly, and stop for "
                "collisions that are none.\nIt takes this over at once. Compare with how the arm "
                "really stands, and keep clear."
            ),
        )

    def show_possible(self) -> None:
        """What can be chosen and told now; the others say why not."""
        self.follow_arm()
        control = self._controller.mounting
        for mounting in _CHOICES:
            button = self._choices.button(int(mounting))
            why_not = control.why_not_by_firmware(mounting)
            enable_or_explain(button, words.why_not(why_not), words.mounting(mounting))
        chosen = self.chosen
        use = self.tr("Tells the arm how it is mounted. Asks first.")
        if chosen is None:
            enable_or_explain(self.send, self.tr("Choose how the arm is mounted first."), use)
        else:
            enable_or_explain(self.send, words.why_not(control.why_not(chosen)), use)
        show_primary(self.send, wanted=chosen is not None and chosen is not self._kept)

    def _show_kept(self) -> None:
        """Nothing that was chosen for another arm stays chosen."""
        self._choices.setExclusive(False)
        for mounting in _CHOICES:
            self._choices.button(int(mounting)).setChecked(mounting is self._kept)
        self._choices.setExclusive(True)

    def _show_told(self) -> None:
        told = self._kept
        how = self.tr("nothing yet") if told is None else words.mounting(told)
        text = self.tr("Told this arm last by this program: {mounting}").format(mounting=how)
        self._told.setText(text)

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self._heading.setText(self.tr("Mounting of the arm"))
        for mounting in _CHOICES:
            button = self._choices.button(int(mounting))
            caption(button, words.mounting(mounting), whose=self._heading.text())
        caption(self.send, self.tr("Confirm"), whose=self._heading.text())
        self._note.setText(
            self.tr(
                "The arm does not answer this and cannot be asked for it: another program, or "
                "the arm itself after a power cut, may have another one."
            )
        )
        self._show_told()
        self.show_possible()
