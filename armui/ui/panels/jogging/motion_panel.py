"""运动控制: six joints, jogged at once or sent together (manual section 1.0.7.1)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFrame

from armui.arm.limits import JOINTS
from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode
from armui.arm.state import ArmState
from armui.control.arm_controller import ArmController
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.actions.keys import keys_of
from armui.ui.freshness import is_stale
from armui.ui.panels.jogging.jog_panel import JogPanel
from armui.ui.panels.jogging.joint_row import JointRow
from armui.ui.panels.jogging.taken_figures import take_figures
from armui.ui.widgets.buttons import caption, push_button, show_primary
from armui.ui.widgets.enable_or_explain import enable_or_explain
from armui.ui.widgets.layouts import STRETCH, in_column, in_row
from armui.ui.widgets.text_label import text_label

_FIELD_INDENT_PX: Final = 80
_TALLEST_CARD_PX: Final = 600
_KEYS: Final = tuple(
    (f"J{joint}", plus, minus)
    for joint, plus, minus in zip(JOINTS, "QWERTY", "ASDFGH", strict=True)
)
_HOME_KEY, _LOAD_KEY, _SEND_KEY = (keys_of(f"motion.{act}") for act in ("home", "load", "send"))


class MotionPanel(JogPanel):
    """Targets on the left, measured angles on the right; says why if the arm can't move.

    The fields follow the arm until the operator types something else, so that sending them never
    moves a joint nobody touched. 发送 is lit while there is something to be sent.

    Args:
        controller: Whom to ask for motion.
        jog_step_deg: Step of − and + to begin with.
    """

    def __init__(self, controller: ArmController, jog_step_deg: float) -> None:
        super().__init__(
            controller,
            "jog",
            message_name="motion_message",
            keys=_KEYS,
            numbers=JOINTS,
            write_step=fmt.short_angle,
        )
        self._heard = False
        self._target_head = text_label(rank="muted")
        self._measured_head = text_label(rank="muted")
        self._rows = [JointRow(j, self._operating_state.limits[j - 1]) for j in JOINTS]
        self._home = push_button("home_button")
        self._load = push_button("load_button")
        self._send = push_button("send_button")
        self._lay_out()
        self._connect()
        self.set_jog_step(jog_step_deg)
        self.retranslate_ui()

    def _lay_out(self) -> None:
        card = QFrame()
        heads = in_row(_FIELD_INDENT_PX, self._target_head, STRETCH, self._measured_head)
        rows = ((row, 1) for row in self._rows)
        in_column(heads, *rows, on=card, spacing=2, margins=(16, 6, 16, 6))
        buttons = (self._home, self._load, self._send)
        self._finish(card, buttons, tallest_px=_TALLEST_CARD_PX)

    def _connect(self) -> None:
        self._follow_rows(self._rows)
        self._home.clicked.connect(self._on_home)
        self._load.clicked.connect(self._on_load)
        self._send.clicked.connect(self._on_send)

    # -- step ---------------------------------------------------------------------------------

    @property
    def jog_step_deg(self) -> float:
        """How far one press of − or + goes."""
        return self._step_box.step

    def set_jog_step(self, step_deg: float) -> None:
        """Take the step of the settings; the usual ones can still be chosen."""
        self._step_box.set_step(step_deg)
        self._on_step_chosen()

    def focus_joint(self, joint: int) -> None:
        """Bring the operator to the target field of a joint."""
        field = self._rows[joint - 1].field
        field.setFocus(Qt.FocusReason.OtherFocusReason)
        field.selectAll()

    def targets_deg(self) -> tuple[float, ...] | None:
        """The six angles in the fields; None while one of them is no figure."""
        angles_deg = [row.target_deg for row in self._rows]
        known = tuple(angle for angle in angles_deg if angle is not None)
        return known if len(known) == len(angles_deg) else None

    def given(self) -> tuple[bool, ...]:
        """Of each field, whether its target was given; else it follows the arm."""
        return tuple(row.own for row in self._rows)

    def take_targets(
        self, angles_deg: Sequence[float], given: Sequence[bool] | None = None
    ) -> None:
        """Put six angles into the fields, as if those that differ were typed; nothing is sent.

        Args:
            angles_deg: The angles.
            given: Which of them stand still from now on; by default those that were given before,
                and those that differ.
        """
        take_figures(self._rows, angles_deg, given)
        self._follow_arm()
        self._on_edited()

    def _take_step(self, step: float, *, continuous: bool) -> None:
        for row in self._rows:
            row.set_step(step, continuous=continuous)

    # -- actions ------------------------------------------------------------------------------

    def _on_repeated(self, joint: int, direction: int) -> None:
        """A held button waits for an arm that doesn't keep up: letting go must end the motion."""
        if not self._controller.motion.jog_lagging(joint, self.jog_step_deg):
            self._on_stepped(joint, direction)

    def _on_stepped(self, joint: int, direction: int) -> None:
        if self._accepted(self._controller.motion.jog(joint, direction * self.jog_step_deg)):
            self._release(joint)
            self._show_message()

    def _on_held(self, joint: int, direction: int) -> None:
        from armui.control.motion.jog_path import JointJog  # noqa: PLC0415 - faster start

        if self._accepted(self._controller.jogging.start(JointJog(joint, direction))):
            self._release(joint)

    def _on_let_go(self) -> None:
        super()._on_let_go()
        self._follow_arm()

    def _release(self, *joints: int) -> None:
        """These joints were sent on: their fields go along, and sending takes none of them back."""
        for joint in joints:
            self._rows[joint - 1].own = False
        self._follow_arm()

    def _follow_device(self) -> None:
        """The fields of joints that a gamepad turns go along, too."""
        jog = self._controller.jogging.steered
        if jog is not None and not jog.frame:
            for joint in _moving(jog.rates):
                self._rows[joint - 1].own = False

    def _on_home(self) -> None:
        if self._accepted(self._controller.motion.go_home()):
            self._release(*JOINTS)

    def _on_load(self) -> None:
        angles_deg = self._controller.state.angles_deg()
        if angles_deg is None:
            self._accepted(Refusal(RefusalCode.JOINTS_UNKNOWN))
            return
        self._fill(angles_deg)
        self._light_send()
        self._accepted(None)

    def _on_send(self) -> None:
        targets_deg: list[float] = []
        for row in self._rows:
            if row.target_deg is None:
                self._accepted(self._why_no_figure(row))
                return
            targets_deg.append(row.target_deg)
        if self._accepted(self._controller.motion.send_joints(targets_deg)):
            self._release(*JOINTS)

    @staticmethod
    def _why_no_figure(row: JointRow) -> Refusal:
        if row.field.is_nonsense():
            return Refusal(
                RefusalCode.JOINT_NOT_A_NUMBER, {"joint": row.joint, "value": row.field.text()}
            )
        return Refusal(RefusalCode.JOINTS_UNKNOWN)

    def _on_edited(self) -> None:
        self._refusal = None
        self._light_send()
        self._show_message()

    # -- what the arm says --------------------------------------------------------------------

    def _on_state_changed(self, state: ArmState) -> None:
        self._follow_device()
        if self.isVisible():
            self._follow_now_and_then(state)
            self._show_measured(state)

    def _show_measured(self, state: ArmState) -> None:
        for row, heard in zip(self._rows, state.joints_deg, strict=True):
            angle_deg = None if heard is None else heard.value
            row.show_measured(angle_deg, stale=is_stale(heard, state, self._operating_state))

    def _follow_arm(self) -> None:
        """Fields in which nothing was given show where the arm is sent, else where it is."""
        angles_deg = self._angles_deg()
        if angles_deg is not None:
            for row, angle_deg in zip(self._rows, angles_deg, strict=True):
                row.follow(angle_deg)
        if (angles_deg is None) is self._heard:
            self._heard = angles_deg is not None
            self._show_possible()
        self._light_send()

    def _angles_deg(self) -> tuple[float, ...] | None:
        if self._operating_state.device is None:
            return None
        return self._controller.motion.setpoint_deg or self._controller.state.angles_deg()

    def _light_send(self) -> None:
        """Light 发送 while a target was given that the arm is not at."""
        angles_deg = self._angles_deg() or (math.inf,) * len(JOINTS)
        show_primary(
            self._send,
            wanted=any(
                row.differs_from(angle_deg)
                for row, angle_deg in zip(self._rows, angles_deg, strict=True)
            ),
        )

    def _fill(self, angles_deg: tuple[float, ...] | None) -> None:
        for row, angle_deg in zip(self._rows, angles_deg or (None,) * len(JOINTS), strict=True):
            row.show_target(angle_deg)

    def _forget_targets(self) -> None:
        self._fill(None)
        self._follow_arm()

    def _show_all(self) -> None:
        for row, limits, read in zip(
            self._rows, self._operating_state.limits, self._operating_state.limits_read, strict=True
        ):
            row.set_limits(limits, read=read)
        self._follow_arm()
        self._show_possible()
        self._show_message()
        self._show_measured(self._controller.state)

    # -- appearance ---------------------------------------------------------------------------

    def _show_possible(self) -> None:
        why_not = self._why_not_move()
        for row in self._rows:
            row.allow_jog(why_not)
        self._key_pad.allow(why_not)
        heard = self._controller.state.angles_deg() is not None
        no_angles = "" if heard else words.refusal(Refusal(RefusalCode.JOINTS_UNKNOWN))
        use = self.tr("Moves all joints to 0°.")
        enable_or_explain(self._home, why_not, use, key=_HOME_KEY)
        use = self.tr("Fills the fields with the measured angles; nothing moves.")
        enable_or_explain(self._load, no_angles, use, key=_LOAD_KEY)
        use = self.tr("Moves the arm to the angles in the fields.")
        enable_or_explain(self._send, why_not, use, key=_SEND_KEY)

    def _first_wrong(self) -> Refusal | None:
        for row in self._rows:
            if row.field.is_nonsense():
                return self._why_no_figure(row)
            beyond = row.beyond_limits()
            if beyond is not None:
                return beyond
        return None

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self._title.setText(self.tr("Motion control"))
        self._step_box.setToolTip(self.tr("How far one press of − or + moves a joint"))
        self._target_head.setText(self.tr("Target"))
        self._measured_head.setText(self.tr("Measured"))
        caption(self._home, self.tr("Home"), key=_HOME_KEY)
        caption(self._load, self.tr("Load"), key=_LOAD_KEY)
        caption(self._send, self.tr("Send"), key=_SEND_KEY)
        super().retranslate_ui()


def _moving(rates: Sequence[float]) -> frozenset[int]:
    return frozenset(joint for joint, rate in zip(JOINTS, rates, strict=True) if rate)
