"""电机设置: each motor's power, zero and errors, beside its driver's values (manual 1.0.7.7)."""

from __future__ import annotations

import enum
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from typing import Final

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFrame, QLabel, QLayout

from armui.arm.limits import JOINTS
from armui.arm.refusal import Refusal
from armui.arm.state import ArmState
from armui.control.arm_controller import ArmController
from armui.control.devices.joint_errors import JointErrors
from armui.control.devices.motors import Motors, why_not_enable
from armui.control.devices.zeroing import Zeroing
from armui.control.operating_state import BUSY, OperatingState
from armui.control.operations.started import Started
from armui.protocol.codes import ALL_JOINTS
from armui.ui import words
from armui.ui.actions.act import Act, ActFamily
from armui.ui.actions.command import also
from armui.ui.freshness import is_stale
from armui.ui.panels.motor_row import COLUMN_GAP_PX, FIGURE_PX, MotorRow
from armui.ui.panels.panel import Panel
from armui.ui.widgets.layouts import STRETCH, fill, in_column, in_row, scrolled
from armui.ui.widgets.text_label import text_label
from armui.ui.words.text import Texts

_INSET_PX: Final = (12, 0, 12, 0)
"""The margins of the buttons for all joints, which align them with the columns of the card."""


class MotorAct(enum.Enum):
    """The commands to a motor (manual section 1.0.7.7)."""

    ENABLE = "enable"
    DISABLE = "disable"
    ZERO = "zero"
    CLEAR = "clear"


_DOES: Final[Mapping[MotorAct, Callable[..., object]]] = {
    MotorAct.ENABLE: Motors.enable,
    MotorAct.DISABLE: Motors.disable,
    MotorAct.ZERO: Zeroing.set_zero,
    MotorAct.CLEAR: JointErrors.clear,
}
_LABELS: Final = Texts("MotorPanel") | {
    MotorAct.ENABLE: "Enable",
    MotorAct.DISABLE: "Disable",
    MotorAct.ZERO: "Set zero",
    MotorAct.CLEAR: "Clear error",
}
_USES: Final = Texts("MotorPanel") | {
    MotorAct.ENABLE: "Gives the motor power: it holds its position.",
    MotorAct.DISABLE: "Cuts the motor's power: the arm drops. Asks first.",
    MotorAct.ZERO: "Makes the present position the joint's zero. Asks first.",
    MotorAct.CLEAR: "Clears the error of the joint's driver; nothing moves.",
}

_ALSO: Final = {
    MotorAct.CLEAR: also("reset alarm fault 复位 清错 报警 故障"),
    MotorAct.ZERO: also("calibrate 标定"),
}


class MotorPanel(Panel):
    """Six rows of figures and buttons, and a row of buttons for all joints.

    Disabling lets the arm drop and a wrong zero makes it run into its stops: both show a warning
    and must be confirmed by holding a button.
    """

    motors = ActFamily(
        {
            (joint, act): Act(
                _LABELS.entry(act),
                named=f"{act.value}_motor_{joint}",
                does=_DOES[act],
                tip=_USES.entry(act),
                key=f"motor.{act.value}_{joint}",
                title=replace(_LABELS.entry(act), suffix=whose),
                synonyms=_ALSO.get(act, ()),
                on_enter=False,
            )
            for joint, whose in ((ALL_JOINTS, "J1–J6"), *((joint, f"J{joint}") for joint in JOINTS))
            for act in MotorAct
        }
    )

    def __init__(self, controller: ArmController) -> None:
        super().__init__(controller, "motor_message")
        self._heads = [text_label(rank="muted") for _ in range(4)]
        self._rows = [MotorRow(joint, self._buttons_of(joint)) for joint in JOINTS]
        self._all_label = QLabel()
        self._lay_out()
        self._listen("enable", "disable", "zero_", "clear_error_")
        self.retranslate_ui()

    def _lay_out(self) -> None:
        card = QFrame()
        rows = in_column(on=card, spacing=9, margins=(12, 8, 12, 10))
        heads = in_row(STRETCH, spacing=COLUMN_GAP_PX)
        for head in self._heads:
            head.setFixedWidth(FIGURE_PX)
            head.setAlignment(Qt.AlignmentFlag.AlignRight)
            heads.addWidget(head)
        fill(rows, heads, *self._rows, STRETCH)

        every = in_column(
            self._all_label, self._buttons_of(ALL_JOINTS), spacing=4, margins=_INSET_PX
        )
        self._stack(scrolled(card), every, gap_px=10)

    def _buttons_of(self, joint: int) -> QLayout:
        row = in_row(spacing=6)
        for act in MotorAct:
            button = self.motors[joint, act]
            button.setProperty("compact", True)
            row.addWidget(button, 1)
        return row

    def focus_joint(self, joint: int) -> None:
        """Focus the buttons of a joint."""
        button = self.motors[joint, MotorAct.ENABLE]
        button.setFocus(Qt.FocusReason.OtherFocusReason)

    # -- actions ------------------------------------------------------------------------------

    @motors.pressed
    def _on_pressed(self, key: tuple[int, MotorAct]) -> None:
        joint, act = key
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
        """Show a refusal until the next command, and return whether the command was accepted."""
        if isinstance(answer, Refusal):
            self._show_outcome(answer)
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
        self.show_acts()
        self._show_message()

    @motors.whose
    def _name_of(self, key: tuple[int, MotorAct]) -> str:
        joint, _act = key
        one = self.tr("joint {joint}").format(joint=joint)
        return self.tr("all joints") if joint == ALL_JOINTS else one

    def _show_message(self) -> None:
        blocked = self._unless_told(why_not_enable(self._operating_state))
        if blocked is not None and blocked.reason == BUSY:
            blocked = None  # no message is needed: the end of the request is reported
        self._show_outcome(blocked, self._event)

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
