"""运动控制: six joints, jogged at once or sent together (manual section 1.0.7.1)."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFrame, QLabel

from armui.arm.limits import ANGLE_STEP_DEG, JOINT_NOT_A_NUMBER, JOINTS, JointLimits, check_joint
from armui.arm.refusal import Refusal
from armui.arm.state import ArmState
from armui.control.arm_controller import ArmController
from armui.control.events import Event
from armui.control.motion.jog_path import JointJog
from armui.control.motion.jogging import Jogging
from armui.control.motion.joint_motion import Motion
from armui.control.operations.operation import operation_of
from armui.control.safety.interlocks import JOINTS_UNKNOWN
from armui.ui import format as fmt
from armui.ui.actions.act import Act, HasActs
from armui.ui.actions.command import Command, Target, also, with_angles
from armui.ui.freshness import is_stale
from armui.ui.panels.jogging.jog_panel import JogPanel, TargetRow
from armui.ui.panels.jogging.own_home import OwnHome
from armui.ui.theme import scaled_font
from armui.ui.widgets.buttons import describe, named
from armui.ui.widgets.curve_menu import set_quantities
from armui.ui.widgets.figure_field import FigureField
from armui.ui.widgets.layouts import empty_grid, in_column
from armui.ui.widgets.text_label import ValueLabel
from armui.ui.widgets.track_slider import TrackSlider
from armui.ui.words.text import Text, joined

if TYPE_CHECKING:
    from armui.settings import SettingsStore

_KEYS: Final = tuple(
    (f"J{joint}", plus, minus)
    for joint, plus, minus in zip(JOINTS, "QWERTY", "ASDFGH", strict=True)
)

_WIDEST_ANGLE: Final = "-000.000°"
_ZERO: Final = also("zero zeros origin go home 归零 零位 零点 原点 回原点")
_JOINTS: Final = also("movej joints 关节运动")
_TARGET: Final = Text("Action", "Target of")
_KEYBOARD: Final = also("keyboard teach 键盘")


class JointRow(TargetRow):
    """The controls of one joint; its signals carry the joint's number.

    Args:
        joint: Its number, 1–6.
        limits: Its range until the arm's own was read.
    """

    def __init__(self, joint: int, limits: JointLimits) -> None:
        field = named(f"target_field_{joint}", FigureField(fmt.DECIMALS, "°"))
        measured = named(f"measured_{joint}", ValueLabel(_WIDEST_ANGLE))
        super().__init__("jog", joint, joint, field, measured)
        self.joint = joint
        self._limits = limits
        self._limits_read = False
        self._name = QLabel(f"J{joint}")
        self._name.setFont(scaled_font(self._name, 1.15, bold=True))
        set_quantities(
            self, *(f"{source}.joint_angle.{joint}" for source in ("arm", "own", "other"))
        )
        self.slider = named(f"target_slider_{joint}", TrackSlider(ANGLE_STEP_DEG, marked=True))
        self.slider.setSingleStep(round(1.0 / ANGLE_STEP_DEG))
        self.slider.setPageStep(round(10.0 / ANGLE_STEP_DEG))
        self._lay_out()
        self.slider.set_limits(limits.min_deg, limits.max_deg)
        self.slider.valueChanged.connect(self._on_slider_moved)
        self.show_target(None)
        self.retranslate_ui()

    def _lay_out(self) -> None:
        grid = empty_grid(self, gaps=(8, 0), margins=0)
        grid.addWidget(self._name, 0, 0)
        grid.addWidget(self.minus, 0, 1)
        grid.addWidget(self.field, 0, 2)
        grid.addWidget(self.plus, 0, 3)
        grid.addWidget(self.measured, 0, 4, Qt.AlignmentFlag.AlignRight)
        grid.addWidget(self.slider, 1, 2)
        grid.setColumnMinimumWidth(0, 30)
        grid.setColumnStretch(2, 1)

    # -- target -------------------------------------------------------------------------------

    def beyond_limits(self) -> Refusal | None:
        """Return the reason against a figure beyond the limits in the field, or ``None``."""
        target = self.field.value
        return None if target is None else check_joint(self.joint, target, self._limits)

    def _on_slider_moved(self) -> None:
        self.own = self._own_before = True
        self.field.show_value(self.slider.requested)
        self._after_target()
        self.edited.emit()

    def _after_target(self) -> None:
        """Set slider, marks and colours by the figure in the field."""
        beyond = self.beyond_limits() is not None
        self.slider.show_requested(self.field.value, attention=beyond)
        self.field.show_attention(wanted=beyond or self.field.is_nonsense())

    # -- what the arm says --------------------------------------------------------------------

    def show_measured(self, angle_deg: float | None, *, stale: bool) -> None:
        """Show the measured angle as a figure and as a mark on the slider."""
        self.measured.show_text(fmt.angle(angle_deg), stale=stale)
        self.slider.show_measured(None if stale else angle_deg)

    def set_limits(self, limits: JointLimits, *, read: bool) -> None:
        """Set other limits.

        Args:
            limits: The range.
            read: True if it was read from the arm; otherwise it is the factory's.
        """
        if (limits, read) == (self._limits, self._limits_read):
            return
        self._limits, self._limits_read = limits, read
        self.slider.set_limits(limits.min_deg, limits.max_deg)
        self._after_target()
        self.retranslate_ui()

    def _tips(self) -> tuple[str, str]:
        """Return the tooltips of − and +."""
        if self.minus.continuous:
            hold = self.tr("Moves joint {joint} while it is held; let go to stop.")
            tips = (hold, hold)
        else:
            tips = (
                self.tr("Moves joint {joint} by −{step} at once. Hold to go on."),
                self.tr("Moves joint {joint} by +{step} at once. Hold to go on."),
            )
        step = fmt.short_angle(self.field.step)
        minus, plus = (tip.format(joint=self.joint, step=step) for tip in tips)
        return minus, plus

    def retranslate_ui(self) -> None:
        """Set names and tooltips in the operator's language."""
        joint = self.joint
        self.minus.setAccessibleName(self.tr("Joint {joint} minus").format(joint=joint))
        self.plus.setAccessibleName(self.tr("Joint {joint} plus").format(joint=joint))
        self.field.setAccessibleName(self.tr("Target angle of joint {joint}").format(joint=joint))
        self.slider.setAccessibleName(self.tr("Target slider of joint {joint}").format(joint=joint))
        measured = self.tr("Measured angle of joint {joint}").format(joint=joint)
        describe(self.measured, measured, self.tr("Measured by the arm"))
        target = self.tr(
            "Target of joint {joint}: {minimum} to {maximum}. Not sent before you press Send."
        ).format(
            joint=joint,
            minimum=fmt.short_angle(self._limits.min_deg),
            maximum=fmt.short_angle(self._limits.max_deg),
        )
        read = self.tr("Limits read from the arm.")
        origin = (
            read if self._limits_read else self.tr("Factory limits: not read from the arm yet.")
        )
        for widget in (self.field, self.slider):
            widget.setToolTip(joined(target, origin))


class MotionPanel(JogPanel):
    """Targets, with limits and measured angles on the sliders, and the reason against moving.

    The fields follow the arm until the operator types something else, so that sending them moves
    only the joints that were changed. 发送 is highlighted while there is something to send.

    Args:
        controller: Sends the motions.
        preferences: The settings, with the first step of − and +, and the operator's own home pose.
    """

    commands = (
        *OwnHome.commands,
        Command(
            "motion.set_own_home_measured", Text("Action", "Park position: the measured angles")
        ),
        Command("motion.set_own_home_typed", Text("Action", "Park position: the targets")),
        Command("motion.keys", Text("JogPanel", "Keyboard jogging"), synonyms=_KEYBOARD),
        Command("motion.step", Text("JogPanel", "Step of − and +")),
        Command("motion.jog_step", operation=operation_of(Motion.jog), presses=False),
        Command("motion.jog", operation=operation_of(Jogging.start)),
        *(Command(f"motion.target_{j}", replace(_TARGET, suffix=f"J{j}")) for j in JOINTS),
    )

    home = Act(
        "Home",
        named="home_button",
        does=Motion.go_home,
        tip="Moves all joints to 0°.",
        key="motion.home",
        synonyms=_ZERO,
    )
    load = Act(
        "Take current",
        named="load_button",
        tip="Fills the fields with the measured angles; nothing moves.",
        key="motion.load",
        needs=with_angles,
    )
    send = Act(
        "Send",
        named="send_button",
        does=Motion.send_joints,
        tip="Moves the arm to the angles in the fields.",
        key="motion.send",
        synonyms=_JOINTS,
    )

    def __init__(self, controller: ArmController, preferences: SettingsStore) -> None:
        super().__init__(
            controller,
            "jog",
            message_name="motion_message",
            keys=_KEYS,
            numbers=JOINTS,
            write_step=fmt.short_angle,
        )
        self._heard = False
        limits = self._operating_state.limits
        self._rows: Sequence[JointRow] = [JointRow(j, limits[j - 1]) for j in JOINTS]
        self._own_home = OwnHome(controller, preferences, self.targets)
        self._lay_out()
        self._connect()
        self.set_jog_step(preferences.settings.jog_step_deg)
        self.retranslate_ui()

    def _lay_out(self) -> None:
        card = QFrame()
        in_column(*self._rows, on=card, spacing=4, margins=(16, 10, 16, 8))
        self._finish(card, (self.home, self._own_home, self.load), (self.send,))

    def _connect(self) -> None:
        self._follow_rows()
        self._own_home.refused.connect(self._accepted)
        self._own_home.wanted.connect(
            lambda move: self._drive(move, partial(self._release, *JOINTS))
        )
        self._own_home.kept.connect(self._on_home_kept)

    def act_parts(self) -> Iterable[HasActs]:
        """Return the park position, whose act the panel offers."""
        return (self._own_home,)

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each command, by the command's name."""
        return {
            **super().command_targets(),
            "motion.set_own_home_measured": self._own_home.set_measured,
            "motion.set_own_home_typed": self._own_home.set_typed,
            "motion.keys": self._keys,
            "motion.step": self._step_box,
            "motion.jog_step": self._rows[0].plus,
            "motion.jog": self._rows[0].plus,
            **{f"motion.target_{row.joint}": row.field for row in self._rows},
        }

    # -- step ---------------------------------------------------------------------------------

    @property
    def jog_step_deg(self) -> float:
        """The step of − and +."""
        return self._step_box.step

    def set_jog_step(self, step_deg: float) -> None:
        """Set the step of the settings; the usual ones can still be chosen."""
        self._step_box.set_step(step_deg)
        self._on_step_chosen()

    def focus_joint(self, joint: int) -> None:
        """Focus the target field of a joint."""
        field = self._rows[joint - 1].field
        field.setFocus(Qt.FocusReason.OtherFocusReason)
        field.selectAll()

    # -- actions ------------------------------------------------------------------------------

    def _on_repeated(self, joint: int, direction: int) -> None:
        """Jog by another step unless the arm lags behind: letting go must end the motion."""
        if not self._controller.motion.jog_lagging(joint, self.jog_step_deg):
            self._on_stepped(joint, direction)

    def _on_stepped(self, joint: int, direction: int) -> None:
        if self._accepted(self._controller.motion.jog(joint, direction * self.jog_step_deg)):
            self._release(joint)
            self._show_message()

    def _on_held(self, joint: int, direction: int) -> None:
        if self._accepted(self._controller.jogging.start(JointJog(joint, direction))):
            self._release(joint)

    def _on_hold_ended(self) -> None:
        super()._on_hold_ended()
        self._follow_arm()

    def _release(self, *joints: int) -> None:
        """Let the fields of these joints follow the arm, so that Send does not move them back."""
        self._event = None
        for joint in joints:
            self._rows[joint - 1].own = False
        self._follow_arm()

    def _follow_device(self) -> None:
        """Let the fields follow the joints that a gamepad moves."""
        jog = self._controller.jogging.steered
        if jog is not None and not jog.frame:
            for joint in _moving(jog.rates):
                self._rows[joint - 1].own = False

    def _on_home_kept(self, event: Event) -> None:
        self._refusal, self._event = None, event
        self._show_message()

    @home.pressed
    def _on_home(self) -> None:
        self._drive(self._controller.motion.go_home, partial(self._release, *JOINTS))

    @load.pressed
    def _on_load(self) -> None:
        """Drop the typed targets: the fields follow the arm, and there is nothing to send."""
        self._release(*JOINTS)
        self._accepted(None if self._angles_deg() is not None else JOINTS_UNKNOWN())

    @send.pressed
    def _on_send(self) -> None:
        targets_deg = self._tried = self.targets()
        if targets_deg is None:
            unknown = next(row for row in self._rows if row.field.value is None)
            self._accepted(self._why_no_figure(unknown))
        else:
            move = partial(self._controller.motion.send_joints, targets_deg)
            self._drive(move, partial(self._on_sent, targets_deg))

    def _on_sent(self, targets_deg: tuple[float, ...]) -> None:
        self._untaken = targets_deg, self.given()
        self._release(*JOINTS)

    def _given_figures(self) -> list[object]:
        return [*super()._given_figures(), self._own_home.angles_deg]

    @staticmethod
    def _why_no_figure(row: JointRow) -> Refusal:
        if row.field.is_nonsense():
            return JOINT_NOT_A_NUMBER(joint=row.joint, value=row.field.text())
        return JOINTS_UNKNOWN()

    def _on_edited(self) -> None:
        self._refusal = self._event = None
        self.show_acts()
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
        """Show the arm's setpoint, or else its angles, in the fields without a typed target."""
        angles_deg = self._angles_deg()
        if angles_deg is not None:
            self._follow(angles_deg)
        if (angles_deg is None) is self._heard:
            self._heard = angles_deg is not None
            self._show_possible()
        MotionPanel.send.show(self)

    def _angles_deg(self) -> tuple[float, ...] | None:
        if self._operating_state.device is None:
            return None
        return self._controller.motion.setpoint_deg or self._controller.state.angles_deg()

    @send.lit
    def _is_elsewhere(self) -> bool:
        """Return true while a target was entered that the arm is not at, and may reach."""
        angles_deg = self._angles_deg() or (math.inf,) * len(JOINTS)
        return self._differ_from(angles_deg) and self._may_work()

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
        self._allow_jog()
        self._own_home.show_possible()
        self.show_acts()

    def _first_wrong(self) -> Refusal | None:
        for row in self._rows:
            if row.field.is_nonsense():
                return self._why_no_figure(row)
            # a field that follows the arm may exceed a limit: another line reports that
            beyond = row.beyond_limits() if row.own else None
            if beyond is not None:
                return beyond
        return None

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._title.setText(self.tr("Motion control"))
        self._step_box.setToolTip(self.tr("How far one press of − or + moves a joint"))
        super().retranslate_ui()


def _moving(rates: Sequence[float]) -> frozenset[int]:
    return frozenset(joint for joint, rate in zip(JOINTS, rates, strict=True) if rate)
