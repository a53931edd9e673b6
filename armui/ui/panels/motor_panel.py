"""电机设置: each motor's power, zero and errors, beside its driver's values (manual 1.0.7.7)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from typing import Final

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFrame, QLabel

from armui.arm.limits import JOINTS
from armui.arm.refusal import Refusal
from armui.arm.state import ArmState
from armui.control.arm_controller import ArmController
from armui.control.devices.joint_errors import JointErrors, why_not_clear
from armui.control.devices.motors import Motors, why_not_disable, why_not_enable
from armui.control.devices.zeroing import Zeroing, why_not_zero
from armui.control.operating_state import BUSY, OperatingState
from armui.control.operations.operation import operation_of
from armui.control.operations.started import Started
from armui.protocol.codes import ALL_JOINTS
from armui.ui import words
from armui.ui.actions.command import Command, Target
from armui.ui.freshness import is_stale
from armui.ui.panels.motor_row import (
    COLUMN_GAP_PX,
    FIGURE_PX,
    ActButtons,
    MotorAct,
    MotorRow,
)
from armui.ui.panels.panel import Panel
from armui.ui.widgets.layouts import STRETCH, fill, in_column, in_row, scrolled
from armui.ui.words.text import Text

_TALLEST_CARD_PX: Final = 520


_ACTS: Final = (
    (MotorAct.ENABLE, Text("ActButtons", "Enable"), operation_of(Motors.enable)),
    (MotorAct.DISABLE, Text("ActButtons", "Disable"), operation_of(Motors.disable)),
    (MotorAct.ZERO, Text("ActButtons", "Set zero"), operation_of(Zeroing.set_zero)),
    (MotorAct.CLEAR, Text("ActButtons", "Clear error"), operation_of(JointErrors.clear)),
)


class MotorPanel(Panel):
    """Six rows of figures and buttons, and a row of buttons for all joints.

    Disabling lets the arm drop and a wrong zero makes it run into its stops: both show a warning
    and must be confirmed by holding a button.
    """

    commands = tuple(
        Command(f"motor.{act.value}_{joint}", replace(title, suffix=whose), operation)
        for joint, whose in ((ALL_JOINTS, "J1–J6"), *((joint, f"J{joint}") for joint in JOINTS))
        for act, title, operation in _ACTS
    )

    def __init__(self, controller: ArmController) -> None:
        super().__init__(controller, "motor_message")
        self._heads = [QLabel() for _ in range(4)]
        self._rows = [MotorRow(joint) for joint in JOINTS]
        self._all_label = QLabel()
        self._all = ActButtons(ALL_JOINTS)
        self._lay_out()
        for acts in self._all_acts():
            acts.wanted.connect(self._on_wanted)
        self._listen("enable", "disable", "zero_", "clear_error_")
        self.retranslate_ui()

    def _lay_out(self) -> None:
        card = QFrame()
        rows = in_column(on=card, spacing=9, margins=(12, 8, 12, 10))
        heads = in_row(STRETCH, spacing=COLUMN_GAP_PX)
        for head in self._heads:
            head.setProperty("rank", "muted")
            head.setFixedWidth(FIGURE_PX)
            head.setAlignment(Qt.AlignmentFlag.AlignRight)
            heads.addWidget(head)
        fill(rows, heads, *self._rows, STRETCH)

        every = in_column(self._all_label, self._all, spacing=4)
        self._stack(scrolled(card, _TALLEST_CARD_PX), every, gap_px=10)

    def _all_acts(self) -> list[ActButtons]:
        return [*(row.acts for row in self._rows), self._all]

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each command, by the command's name."""
        numbers = (*JOINTS, ALL_JOINTS)
        return {
            f"motor.{act.value}_{number}": button
            for number, acts in zip(numbers, self._all_acts(), strict=True)
            for act, button in acts.buttons.items()
        }

    def focus_joint(self, joint: int) -> None:
        """Focus the buttons of a joint."""
        button = self._rows[joint - 1].acts.buttons[MotorAct.ENABLE]
        button.setFocus(Qt.FocusReason.OtherFocusReason)

    # -- actions ------------------------------------------------------------------------------

    def _on_wanted(self, joint: int, act: MotorAct) -> None:
        controller = self._controller
        if act is MotorAct.ENABLE:
            self._accepted(controller.motors.enable(joint))
        elif act is MotorAct.CLEAR:
            self._accepted(controller.joint_errors.clear(joint))
        elif act is MotorAct.DISABLE:
            self._ask_to_disable(joint)
        else:
            self._ask_for_zero(joint)

    def _ask_to_disable(self, joint: int) -> None:
        danger = self.tr("The arm will drop when it loses its power. Hold the arm.")
        if joint == ALL_JOINTS:
            title = self.tr("Disable all six motors")
            controller = self._controller
            generation = controller.operating_state.generation
            text = words.disabling(danger, generation, controller.state)
        else:
            title = self.tr("Disable the motor of joint {joint}").format(joint=joint)
            text = self.tr("Joint {joint} and what hangs on it gives way.").format(joint=joint)
            text = f"{danger}\n{text}"
        act = partial(self._controller.motors.disable, joint)
        self._ask_to_hold(title, text, self.tr("Disable"), act, sinks=True)

    def _ask_for_zero(self, joint: int) -> None:
        if joint == ALL_JOINTS:
            title = self.tr("Set the zero of all six joints")
            text = self.tr("Where all six joints stand now becomes their 0°.")
        else:
            title = self.tr("Set the zero of joint {joint}").format(joint=joint)
            text = self.tr("Where joint {joint} stands now becomes its 0°.").format(joint=joint)
        danger = self.tr(
            "The limits move with the zero, and so does every stored trajectory. With a wrong zero "
            "the arm runs into its stops.\nSet it only at the mark of the joint's zero, with the "
            "arm standing still. The arm keeps it; there is no way back but to set it again."
        )
        act = partial(self._controller.zeroing.set_zero, joint)
        still = partial(self._controller.zeroing.stands_as, self._controller.state, joint)
        self._ask_to_hold(title, f"{text}\n{danger}", self.tr("Set zero"), act, still=still)

    def _accepted(self, answer: Started | Refusal | None) -> bool:
        """A refusal by the controller is shown as an event is; it stays until the next command."""
        if isinstance(answer, Refusal):
            self._say(answer)
        return not isinstance(answer, Refusal)

    # -- what the arm says --------------------------------------------------------------------

    def _forget_outdated(self, old: OperatingState) -> None:
        now = self._operating_state
        if old.unreachable != now.unreachable or old.stop is not now.stop:
            self._event = None

    def _show_state(self, state: ArmState) -> None:
        for row in self._rows:
            slow, fast = state.drivers_slow[row.joint - 1], state.drivers_fast[row.joint - 1]
            row.show_slow(slow, stale=is_stale(slow, state, self._operating_state))
            row.show_fast(fast, stale=is_stale(fast, state, self._operating_state))

    def _show_all(self) -> None:
        self._show_state(self._controller.state)
        operating_state = self._operating_state
        for act, blocked in (
            (MotorAct.ENABLE, why_not_enable(operating_state)),
            (MotorAct.DISABLE, why_not_disable(operating_state)),
            (MotorAct.ZERO, why_not_zero(operating_state)),
            (MotorAct.CLEAR, why_not_clear(operating_state)),
        ):
            for acts in self._all_acts():
                acts.allow(act, words.why_not(blocked))
        self._show_message()

    def _show_message(self) -> None:
        blocked = self._unless_told(why_not_enable(self._operating_state))
        if blocked is not None and blocked.reason == BUSY:
            blocked = None  # what is under way will say itself how it ends
        self._say(blocked, self._event)

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._title.setText(self.tr("Motor settings"))
        self._all_label.setText(self.tr("All joints"))
        for head, text in zip(
            self._heads,
            (self.tr("Motor"), self.tr("Driver"), self.tr("Current"), self.tr("Voltage")),
            strict=True,
        ):
            head.setText(text)
        self._show_all()
