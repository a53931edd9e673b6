"""末端负载: the arm's load and mounting, and the speed of each joint's end (0x477, 0x481–0x486)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QAbstractButton,
    QButtonGroup,
    QFrame,
    QHBoxLayout,
    QLabel,
    QSizePolicy,
)

from armui.arm.limits import JOINTS
from armui.arm.refusal import Reason, Refusal
from armui.arm.state import ArmState
from armui.control.arm_controller import ArmController
from armui.control.devices.end_reports import EndReports, is_reporting, why_no_load
from armui.control.devices.mounting import MountingControl
from armui.control.link.link_state import LinkState
from armui.control.operating_state import OperatingState
from armui.control.operations.started import refusal_of
from armui.protocol.codes import EndLoad, Mounting
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.actions.act import Act, HasActs
from armui.ui.actions.command import Command, Target
from armui.ui.freshness import is_stale
from armui.ui.panels.panel import Panel
from armui.ui.widgets.buttons import caption, choice_button, enable_or_explain, named
from armui.ui.widgets.curve_menu import set_quantities
from armui.ui.widgets.layouts import empty_grid, fill, in_column, scrolled
from armui.ui.widgets.text_label import ValueLabel, text_label
from armui.ui.words.arm import END_LOADS, MOUNTINGS
from armui.ui.words.text import Text

if TYPE_CHECKING:
    from armui.setting_checks import MountingName
    from armui.settings import SettingsStore

LOAD_NOT_CHOSEN = Reason("load_not_chosen", "No end load is chosen. Choose one first.")


_LOADS: Final = (EndLoad.EMPTY, EndLoad.HALF, EndLoad.FULL)
_FIGURES: Final = (
    ("linear_speed_m_s", "m/s"),
    ("angular_speed_rad_s", "rad/s"),
    ("linear_acceleration_m_s2", "m/s²"),
    ("angular_acceleration_rad_s2", "rad/s²"),
)
_CHOICES: Final[dict[Mounting, MountingName]] = {
    Mounting.LEVEL: "level",
    Mounting.ON_THE_LEFT_SIDE: "on_the_left_side",
    Mounting.ON_THE_RIGHT_SIDE: "on_the_right_side",
    Mounting.UPSIDE_DOWN: "upside_down",
}
_MOTION: Final = Text("EndLoadPanel", "Speed and acceleration of the end, by joint")


class MountingCard(HasActs, QFrame):
    """The choice of a mounting; its owner asks the operator before it is sent.

    Args:
        controller: Sends the mounting.
        preferences: The settings with the last mounting of each arm.

    Signals:
        wanted: The chosen mounting shall be sent.
    """

    wanted = Signal()

    send = Act(
        "Set mounting…",
        named="mounting_confirm_button",
        does=MountingControl.tell,
        tip="Tells the arm how it is mounted. Asks first.",
        whose=Text("MountingCard", "Mounting of the arm"),
        key="end_load.mounting",
        leads=True,
    )

    def __init__(self, controller: ArmController, preferences: SettingsStore) -> None:
        super().__init__()
        self._controller = controller
        self._preferences = preferences
        self._arm: str | None = None
        self.setProperty("card", True)
        self._heading = QLabel()
        self._choices = QButtonGroup(self)
        self._mounting_label = text_label("mounting_told", wraps=True)
        self._note = text_label(rank="muted", wraps=True)
        row = QHBoxLayout()
        for mounting, name in _CHOICES.items():
            button = choice_button(f"mounting_{name}")
            button.setProperty("tight", True)
            button.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)
            self._choices.addButton(button, int(mounting))
            row.addWidget(button, 1)
        column = in_column(on=self, margins=(16, 12, 16, 12))
        fill(column, self._heading, row, self.send, self._mounting_label, self._note)
        self._choices.idToggled.connect(lambda _id, _on: self.show_possible())

    @property
    def chosen(self) -> Mounting | None:
        """The mounting chosen by the operator."""
        code = self._choices.checkedId()
        return None if code < 0 else Mounting(code)

    @property
    def buttons(self) -> dict[str, QAbstractButton]:
        """The buttons that choose a mounting, by its name."""
        return {name: self._choices.button(int(each)) for each, name in _CHOICES.items()}

    def tell(self) -> Refusal | None:
        """Send the chosen mounting and store it; return ``None``, or why it was refused."""
        mounting = self.chosen
        if mounting is None:
            return None
        refusal = refusal_of(self._controller.mounting.tell(mounting))
        if refusal is None:
            refusal = self._keep(mounting)
            self._show_told()
            self.show_possible()
        return refusal

    def follow_arm(self) -> None:
        """Show the last mounting of the connected arm, after it has changed or named itself."""
        device = self._controller.operating_state.device
        identity = self._controller.state.identity
        node = "" if identity is None else identity.node_number
        arm = None if device is None else device.arm_key(node)
        if arm is not None and identity is not None and not node:
            # an identity without a number may be a partial answer to another host: keep the arm
            arm = self._arm or arm
        if arm != self._arm:
            self._arm = arm
            self._show_kept()
            self._show_told()

    @property
    def _kept(self) -> Mounting | None:
        """The mounting that was last sent to this arm by this program, or ``None``."""
        kept = self._preferences.settings.mountings.get(self._arm or "")
        return next((each for each, name in _CHOICES.items() if name == kept), None)

    def _keep(self, mounting: Mounting) -> Refusal | None:
        if self._arm is None:
            return None
        return self._preferences.keep("mountings", {self._arm: _CHOICES[mounting]})

    def question(self) -> tuple[str, str]:
        """Return title and text of the question before it is sent."""
        how = "" if self.chosen is None else MOUNTINGS.text(self.chosen)
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
        """Enable the possible choices; the others show their reasons."""
        self.follow_arm()
        self._show_told()
        control = self._controller.mounting
        for mounting in _CHOICES:
            button = self._choices.button(int(mounting))
            why_not = control.why_not_by_firmware(mounting)
            enable_or_explain(button, words.why_not(why_not), MOUNTINGS.text(mounting))
        self.show_acts()

    @send.pressed
    def _on_send(self) -> None:
        self.wanted.emit()

    @send.why_not
    def _why_not_send(self) -> Refusal | str | None:
        if self.chosen is None:
            return self.tr("Choose how the arm is mounted first.")
        return self._controller.mounting.why_not(self.chosen)

    @send.lit
    def _is_new(self) -> bool:
        """Return true while another mounting is chosen than the last one sent."""
        return self.chosen is not None and self.chosen is not self._kept

    def _show_kept(self) -> None:
        """Choose the mounting last sent to this arm, or none: another arm's must not stay."""
        self._choices.setExclusive(False)
        for mounting in _CHOICES:
            self._choices.button(int(mounting)).setChecked(mounting is self._kept)
        self._choices.setExclusive(True)

    def _show_told(self) -> None:
        told, cell = self._kept, self._controller.cell.cell
        text = self.tr("Mounting: not set from here yet")
        if told is not None:
            text = self.tr("Mounting, as last set from here: {mounting}")
            text = text.format(mounting=MOUNTINGS.text(told))
        if cell is not None and cell.placement.is_set:
            text = f"{text}\n{words.mounting_check(cell.placement.mounting, told)}".rstrip()
        elif told not in {None, Mounting.LEVEL}:
            upright = self.tr(
                "The picture and the check of the floor take the base as upright all the same: "
                "place it under Cell, Base."
            )
            text = f"{text}\n{upright}"
        self._mounting_label.setText(text)

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._heading.setText(self.tr("Mounting of the arm"))
        for mounting in _CHOICES:
            button = self._choices.button(int(mounting))
            caption(button, MOUNTINGS.text(mounting), whose=self._heading.text())
        self._note.setText(
            self.tr(
                "The arm does not answer this and cannot be asked for it: another program, or "
                "the arm itself after a power cut, may have another one."
            )
        )
        self._show_told()
        self.show_possible()


class EndLoadPanel(Panel):
    """Three loads and four mountings to choose from, and a table while 0x481–0x486 arrive."""

    commands = (
        Command("end_load.empty", Text("EndLoad", "No load")),
        Command("end_load.half", Text("EndLoad", "Half load")),
        Command("end_load.full", Text("EndLoad", "Full load")),
        Command("end_load.level", Text("Mounting", "Level")),
        Command("end_load.on_the_left_side", Text("Mounting", "Left side")),
        Command("end_load.on_the_right_side", Text("Mounting", "Right side")),
        Command("end_load.upside_down", Text("Mounting", "Upside down")),
        *MountingCard.commands,
    )

    send = Act(
        "Set load",
        named="load_confirm_button",
        does=EndReports.set_load,
        tip="Tells the arm its load, so that it compensates for the weight.",
        whose=True,
        key="end_load.confirm",
        title=Text("EndLoadPanel", "Set load"),
        leads=True,
    )
    switch = Act(
        "Switch on",
        named="end_feedback_button",
        does=EndReports.switch,
        tip="Switches the periodic frames 0x481–0x486.",
        whose=_MOTION,
        key="end_load.feedback",
        title=_MOTION,
    )

    def __init__(self, controller: ArmController, preferences: SettingsStore) -> None:
        super().__init__(controller, "end_load_message")
        self._mounting = MountingCard(controller, preferences)
        self._reporting: bool | None = None
        self._loads = QButtonGroup(self)
        self._sent = -1
        self._note = text_label(rank="muted", wraps=True)
        self._motion_title = QLabel()
        self._state = text_label("end_feedback_state")
        self._units = [text_label(text=unit, rank="muted") for _field, unit in _FIGURES]
        self._cells = {
            (joint, field): named(f"{field}_{joint}", ValueLabel("-00.000"))
            for joint in JOINTS
            for field, _unit in _FIGURES
        }
        for (joint, field), cell in self._cells.items():
            kind = field.partition("_m_")[0].partition("_rad_")[0]
            set_quantities(cell, f"arm.end_{kind}.{joint}")
        self._lay_out()
        self._loads.idToggled.connect(lambda _load, _on: self.show_acts())
        self._mounting.wanted.connect(self._on_mounting)
        self._listen("load_", "end_feedback_", "mounting_")
        self.retranslate_ui()

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each command, by the command's name."""
        return {
            **super().command_targets(),
            **{f"end_load.{each.name.lower()}": self._loads.button(int(each)) for each in _LOADS},
            **{f"end_load.{name}": button for name, button in self._mounting.buttons.items()},
        }

    def act_parts(self) -> Iterable[HasActs]:
        """Return the card of the mounting."""
        return (self._mounting,)

    def _lay_out(self) -> None:
        load_card, motion_card = QFrame(), QFrame()
        load_card.setProperty("card", True)
        column = in_column(on=load_card, margins=(16, 12, 16, 12))
        row = QHBoxLayout()
        for load in _LOADS:
            button = choice_button(f"load_{load.name.lower()}")
            button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            self._loads.addButton(button, int(load))
            row.addWidget(button)
        fill(column, row, self.send, self._note)

        grid = empty_grid(motion_card, gaps=(None, 6), margins=(16, 12, 16, 12))
        grid.addWidget(self._motion_title, 0, 0, 1, 5)
        grid.addWidget(self._state, 1, 0, 1, 3)
        grid.addWidget(self.switch, 1, 3, 1, 2)
        right = Qt.AlignmentFlag.AlignRight
        for place, label in enumerate(self._units, start=1):
            grid.addWidget(label, 2, place, right)
            grid.setColumnStretch(place, 1)
        for joint in JOINTS:
            grid.addWidget(QLabel(f"J{joint}"), joint + 2, 0)
            for place, (field, _unit) in enumerate(_FIGURES, start=1):
                grid.addWidget(self._cells[joint, field], joint + 2, place, right)
        self._stack(load_card, self._mounting, scrolled(motion_card))

    # -- actions ------------------------------------------------------------------------------

    @send.pressed
    def _on_send(self) -> None:
        chosen = self._loads.checkedId()
        if self._accepted(self._controller.end_reports.set_load(EndLoad(chosen))):
            self._sent = chosen
        self.show_acts()

    @send.why_not
    def _why_not_send(self) -> Refusal | None:
        none = LOAD_NOT_CHOSEN() if self._loads.checkedId() < 0 else None
        return why_no_load(self._operating_state) or none

    @send.lit
    def _is_new(self) -> bool:
        """Return true while there is a load to be sent."""
        return self._loads.checkedId() not in {-1, self._sent}

    def _on_mounting(self) -> None:
        title, text = self._mounting.question()
        label = self._mounting.send.text()
        chosen = self._mounting.chosen
        self._ask_to_hold(
            title, text, label, self._mounting.tell, still=lambda: self._mounting.chosen is chosen
        )

    @switch.pressed
    def _on_switch(self) -> None:
        on = not is_reporting(self._controller.state)
        self._accepted(self._controller.end_reports.switch(on=on))

    # -- appearance ---------------------------------------------------------------------------

    def _forget_outdated(self, old: OperatingState) -> None:
        if old.link is not self._operating_state.link:
            self._refusal = self._event = None

    def _show_state(self, state: ArmState) -> None:
        self._mounting.follow_arm()
        for joint in JOINTS:
            heard = state.end_motion[joint - 1]
            stale = is_stale(heard, state, self._operating_state)
            for field, _unit in _FIGURES:
                value = None if heard is None else getattr(heard.value, field)
                self._cells[joint, field].show_text(fmt.number(value), stale=stale)
        reporting = is_reporting(state) and self._operating_state.link is LinkState.ONLINE
        if reporting is not self._reporting:
            self._reporting = reporting
            self._state.setText(self.tr("The arm reports") if reporting else self.tr("Not heard"))
            self.show_acts()

    @switch.text
    def _switch_text(self) -> str:
        return self.tr("Switch off") if self._reporting else self.tr("Switch on")

    def _show_all(self) -> None:
        self.show_acts()
        self._mounting.show_possible()
        self._show_state(self._controller.state)
        self._show_message()

    def _show_message(self) -> None:
        standing = self._unless_told(self._operating_state.unreachable)
        self._show_outcome(self._refusal or standing, self._event)

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._title.setText(self.tr("End load"))
        for load in _LOADS:
            button = self._loads.button(int(load))
            caption(button, END_LOADS.text(load), whose=self._title.text())
        self._note.setText(
            self.tr("The arm acknowledges this setting, but cannot be asked for it afterwards.")
        )
        self._motion_title.setText(_MOTION.text())
        names = (
            self.tr("Linear speed"),
            self.tr("Angular speed"),
            self.tr("Linear acceleration"),
            self.tr("Angular acceleration"),
        )
        for (field, _unit), label, name in zip(_FIGURES, self._units, names, strict=True):
            label.setToolTip(name)
            for joint in JOINTS:
                self._cells[joint, field].setAccessibleName(f"J{joint} {name}")
        self._reporting = None
        self._mounting.retranslate_ui()
        self._show_all()
