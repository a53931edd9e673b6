"""What 运动控制 and 末端控制 share: targets beside what is measured, a step, and keys to jog by."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Final

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFrame, QLabel, QLayout, QPushButton, QWidget

from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode
from armui.arm.state import ArmState
from armui.control.arm_controller import ArmController
from armui.control.events import ZEROING_ENDED, Event, EventCode
from armui.control.operating_state import OperatingState
from armui.ui import words
from armui.ui.panels.jogging.jog_signals import JogSignals
from armui.ui.panels.jogging.key_pad import KeyPad, Keys
from armui.ui.panels.jogging.step_box import StepBox
from armui.ui.panels.panel import Panel
from armui.ui.widgets.buttons import choice_button, describe, named
from armui.ui.widgets.card import scrolled
from armui.ui.widgets.hold_guard import UNATTENDED_S
from armui.ui.widgets.layouts import STRETCH, in_row

_BUTTON_PX: Final = 38
_FOLLOW_S: Final = 0.1


class JogPanel(Panel):
    """A card of targets, and two ways to jog: − and + beside them, and keys.

    Targets are void when another arm is connected. What is jogged goes by numbers: those of the
    joints, or the places in a pose. A key of the pad does what the button of the same number does.

    Args:
        controller: Whom to ask for motion.
        name: For the names of its widgets: ``<name>_step``, ``<name>_keys_button``.
        message_name: The object name of the message.
        keys: Of each number in order, the keys that jog it.
        numbers: By which the rows go, in the order of the keys.
        write_step: A step as text.
    """

    def __init__(
        self,
        controller: ArmController,
        name: str,
        *,
        message_name: str,
        keys: Keys,
        numbers: Sequence[int],
        write_step: Callable[[float], str],
    ) -> None:
        super().__init__(controller, message_name)
        self._followed_s = 0.0
        self._numbers = tuple(numbers)
        self._step_label = QLabel()
        self._step_box = named(f"{name}_step", StepBox(write_step))
        self._step_label.setBuddy(self._step_box)
        self._keys = choice_button(f"{name}_keys_button")
        self._key_pad = KeyPad(keys, f"{name}_key_pad")
        self._key_pad.hide()

    def _follow_rows(self, rows: Iterable[JogSignals]) -> None:
        for row in rows:
            row.stepped.connect(self._on_stepped)
            row.repeated.connect(self._on_repeated)
            row.held.connect(self._on_held)
            row.let_go.connect(self._on_let_go)
            row.unattended.connect(self._on_unattended)
            row.edited.connect(self._on_edited)

    def _finish(
        self,
        card: QFrame,
        buttons: Sequence[QPushButton],
        *,
        tallest_px: int,
        above: Sequence[QWidget] = (),
    ) -> None:
        """Lay the panel out around its card, and listen; the last step but the words.

        Args:
            card: Holds the rows.
            buttons: Those below it, from left to right.
            tallest_px: The card grows no higher.
            above: What stands between the title and the card.
        """
        head = in_row(self._title, STRETCH, *(self._keys, self._step_label, self._step_box))
        row = in_row(spacing=10)
        for button in buttons:
            button.setMinimumHeight(_BUTTON_PX)
            row.addWidget(button, 1)
        parts: list[QWidget | QLayout] = [*above, scrolled(card, tallest_px), self._key_pad, row]
        self._stack(*parts, head=head)
        self._step_box.chosen.connect(self._on_step_chosen)
        self._keys.toggled.connect(self._on_keys_toggled)
        self._key_pad.pressed.connect(self._on_key_pressed)
        self._key_pad.let_go.connect(self._on_let_go)
        self._key_pad.unattended.connect(self._on_unattended)
        self._listen()

    # -- what a panel of its own adds ---------------------------------------------------------

    def _on_stepped(self, number: int, direction: int) -> None:
        """Jog by one step."""
        raise NotImplementedError

    def _on_repeated(self, number: int, direction: int) -> None:
        """Jog by another step: the button is still held."""
        raise NotImplementedError

    def _on_edited(self) -> None:
        """The operator changed a target."""
        raise NotImplementedError

    def _on_held(self, number: int, direction: int) -> None:
        """Jog until :meth:`_on_let_go`."""
        raise NotImplementedError

    def _take_step(self, step: float, *, continuous: bool) -> None:
        """Have − and + of the rows go by a step, or on and on while they are held."""
        raise NotImplementedError

    def _first_wrong(self) -> Refusal | None:
        """What is to be said against the targets as they stand in the fields."""
        raise NotImplementedError

    def _follow_now_and_then(self, state: ArmState) -> None:
        """Follow a moving arm no faster than fields can be read; painting them costs the most."""
        at_s = state.last_feedback_s or 0.0
        if not 0.0 < at_s - self._followed_s < _FOLLOW_S:
            self._followed_s = at_s
            self._follow_arm()

    def _follow_arm(self) -> None:
        """Show in the fields in which no target was given where the arm is."""
        raise NotImplementedError

    def _forget_targets(self) -> None:
        """The arm is another one, or counts its angles anew."""
        raise NotImplementedError

    def _show_possible(self) -> None:
        """Enable what can be used now; say in the tooltips of the rest why not."""
        raise NotImplementedError

    # -- jogging ------------------------------------------------------------------------------

    def _on_step_chosen(self) -> None:
        self._take_step(self._step_box.step, continuous=self._step_box.continuous)
        self._key_pad.set_continuous(self._step_box.continuous)
        self._show_possible()

    def _on_keys_toggled(self, wanted: bool) -> None:
        self._key_pad.setVisible(wanted)
        if wanted:
            self._key_pad.setFocus(Qt.FocusReason.OtherFocusReason)

    def _on_key_pressed(self, place: int, direction: int) -> None:
        jog = self._on_held if self._step_box.continuous else self._on_stepped
        jog(self._numbers[place], direction)

    def _on_let_go(self) -> None:
        self._controller.jogging.stop()

    def _on_unattended(self) -> None:
        self._accepted(Refusal(RefusalCode.HOLD_UNATTENDED, {"seconds": UNATTENDED_S}))

    def _on_noticed(self, event: Event) -> None:
        """What ended a jog is said where the operator looks; a new zero makes targets void."""
        reason = event.params.get("reason")
        if event.code == EventCode.JOG_ENDED and isinstance(reason, Refusal) and self.isVisible():
            self._accepted(reason)
        elif event.code in ZEROING_ENDED:
            # the same figures are another place by the new zero
            self._forget_targets()
            self._show_message()

    # -- what the arm says --------------------------------------------------------------------

    def _forget_outdated(self, old: OperatingState) -> None:
        if old.device != self._operating_state.device:
            # another arm: targets made for the last one would be a trap
            self._forget_targets()
        if old.cannot_move != self._operating_state.cannot_move:
            self._refusal = None

    def _why_not_move(self) -> str:
        return words.why_not(self._operating_state.cannot_move)

    def _show_message(self) -> None:
        standing = self._unless_told(self._operating_state.cannot_move)
        self._say(self._refusal or standing or self._first_wrong())

    def retranslate_ui(self) -> None:
        """Put the words of the head into the operator's language."""
        self._step_label.setText(self.tr("Step"))
        self._step_box.setAccessibleName(self.tr("Step of − and +"))
        self._keys.setText(self.tr("Keys"))
        tip = self.tr("Jog by keys, with the space bar held as dead-man key")
        describe(self._keys, self.tr("Keyboard jogging"), tip)
        self._show_possible()
        self._show_message()
