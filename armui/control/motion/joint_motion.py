"""运动控制: sends the joints to angles, together or in steps (manual section 1.0.7.1)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Annotated, Final

from armui.arm.figures import JointNumber, Percent, RangeOfArm
from armui.arm.limits import ANGLE_STEP_DEG, JointLimits, check_joint, clipped, settled
from armui.arm.refusal import Reason, Refusal
from armui.control.context import ControllerPart
from armui.control.events import Notice
from armui.control.motion.jog_path import JOG_AT_LIMIT
from armui.control.motion.motion_context import MotionContext, drop_waiting
from armui.control.motion.requests import joint_request
from armui.control.motion.retransmission import Retransmission
from armui.control.operating_state import OperatingState
from armui.control.operations.operation import Consent, operation, record_start
from armui.control.operations.started import Ending, Started
from armui.control.requests import reports
from armui.control.safety import interlocks
from armui.control.safety.gate import Agreed
from armui.telemetry.events import EventKind, Level

if TYPE_CHECKING:
    from armui.control.motion.motion_command import MotionCommand

STEP_BEYOND_LIMIT = Reason(
    "step_beyond_limit",
    "J{joint}: this step would go beyond its limit of {limit}°. Take a smaller step.",
)
NOTHING_OUTSIDE = Reason(
    "nothing_outside", "No joint lies outside its limits: there is no way back to go."
)
COMES_INSIDE = Notice(
    "comes_inside",
    "The arm is brought inside its limits: J1 {j1}°  J2 {j2}°  J3 {j3}°  J4 {j4}°  J5 {j5}°  "
    "J6 {j6}°",
    Level.INFO,
    EventKind.COMMAND,
)
LED_TO_LIMIT = Notice(
    "led_to_limit",
    "J{joint} stood outside its limits: the arm brings it to {target}° at least.",
    Level.INFO,
    EventKind.COMMAND,
)
SENT_JOINTS = Notice(
    "sent_joints",
    "Sent J1 {j1}°  J2 {j2}°  J3 {j3}°  J4 {j4}°  J5 {j5}°  J6 {j6}°",
    Level.INFO,
    EventKind.COMMAND,
)
JOGGED = Notice("jogged", "Sent J{joint} {target}°", Level.INFO, EventKind.COMMAND, streams=True)
WENT_HOME = Notice("went_home", "Home sent: all joints to 0°", Level.INFO, EventKind.COMMAND)
SENT_SPEED = Notice(
    "sent_speed", "Sent speed {percent} %", Level.INFO, EventKind.COMMAND, streams=True
)
SPEED_WAITS = Notice(
    "speed_waits",
    "{percent} % is kept: the arm gets it when the motion held back goes on",
    Level.WARNING,
    EventKind.COMMAND,
    streams=True,
)
_HOME_DEG: Final = (0.0,) * 6
COME_INSIDE_PERCENT: Final = 10
"""An arm found outside its limits comes back no faster."""
_FIRST_SPEED_PERCENT: Final = 30
"""The speed at the start of the program, until the operator sets another one."""
_LAG_STEPS: Final = 2
"""A held button continues to step only while its joint lags by at most this number of steps."""
_SETTLE_S: Final = 0.3
"""The operator's speed is not restored until this long after a command of ours."""


def why_not_move(now: OperatingState) -> Refusal | None:
    """Return why the joints may not be sent anywhere, or ``None``."""
    return now.cannot_move


def why_no_speed(_now: OperatingState) -> Refusal | None:
    """Return ``None``: the speed may be set at any time; without an arm it waits for one."""
    return None


def _why_no_step(
    joint: int, base_deg: float, delta_deg: float, limits: JointLimits
) -> Refusal | None:
    """Return why a joint can't go a step further: it is at its limit, or the step is too long.

    A joint outside its limits may come back.
    """
    bound_deg = limits.max_deg if delta_deg > 0 else limits.min_deg
    inwards = (bound_deg - base_deg) * delta_deg >= 0.0
    if check_joint(joint, base_deg + delta_deg, limits) is None or (
        inwards and not (limits.min_deg <= base_deg <= limits.max_deg)
    ):
        return None
    if abs(bound_deg - base_deg) <= ANGLE_STEP_DEG:
        return JOG_AT_LIMIT(joint=joint, limit=bound_deg)
    return STEP_BEYOND_LIMIT(joint=joint, limit=bound_deg)


class Motion(ControllerPart):
    """Joint motions, and the speed of every motion.

    Args:
        context: The context that the controller's parts share.

    Attributes:
        speed_percent: The speed of motions, in percent of the arm's maximum.
        set_speed_of_run: Sets the speed while something runs; records it.
    """

    def __init__(self, context: MotionContext) -> None:
        self._context = context
        self.speed_percent = _FIRST_SPEED_PERCENT
        self.set_speed_of_run: Callable[[Started, int], Refusal | None] = lambda *_: None
        self._lower_speed = Retransmission(context)
        self._next_deg: tuple[tuple[float, ...], ...] = ()
        self._next_after = 0

    @property
    def setpoint_deg(self) -> tuple[float, ...] | None:
        """The six angles sent last, as long as a step starts from them, or ``None``."""
        command = self._context.authority.command
        return None if command is None else command.joints_deg

    @operation("motion.set_speed", "Set the speed", why_no_speed)
    def set_speed_percent(self, started: Started, percent: Percent) -> Refusal | None:
        """Set the speed of everything: of motions, of the arm's maximum (0x151 byte 2).

        In a run it is the share of the run's own pace, from this moment on; at 0 % the run is held
        back until a held press on 继续.

        The arm is told at once, in its present mode. Only the next motion brings the speed to the
        arm during a jog, while its identifiers are uncertain, while somebody else moves it and
        while a motion is held back in it.
        """
        context = self._context
        operating_state = context.operating_state()
        if operating_state.running:
            return self.set_speed_of_run(started, percent)
        # slowing down is allowed while a joint's reference is in doubt
        slows = context.authority.lowers_speed(percent)
        if operating_state.moving and not slows:
            refusal = operating_state.reference.why_not_move(percent)
            if refusal is not None:
                return refusal
        lower = percent < self.speed_percent
        self.speed_percent = percent
        self._lower_speed.drop()
        sendable = operating_state.control_certain and not operating_state.jogging
        sendable &= (
            interlocks.why_no_command(operating_state.unreachable, operating_state.stop, None)
            is None
        )
        started.close(Ending.SENT)
        if sendable and self.send_speed():
            context.emit_event(SENT_SPEED, started, percent=context.authority.arm_percent)
            if lower and context.authority.may_be_ours:
                self._lower_speed.schedule()
        elif context.authority.holds:
            context.emit_event(SPEED_WAITS, started, percent=self.speed_percent)
        context.refresh()
        return None

    def send_speed(self) -> bool:
        """Send the speed in the arm's present mode; return false if that is impossible now."""
        return self._context.send_percent(self.speed_percent)

    @operation("motion.step", "Move a joint by a step", why_not_move, moves=True)
    def jog(
        self, started: Started, joint: JointNumber, delta_deg: Annotated[float, RangeOfArm("°")]
    ) -> Refusal | None:
        """Move one joint by a step at once; the other five keep their targets."""
        base_deg = self._context.authority.joint_base_deg()
        if base_deg is None:
            return self._context.authority.why_unmeasured()
        limits = self._context.operating_state().limits
        base_deg = settled(base_deg, limits)
        refusal = _why_no_step(joint, base_deg[joint - 1], delta_deg, limits[joint - 1])
        if refusal is not None:
            return refusal
        target_deg = list(base_deg)
        target_deg[joint - 1] = asked = round(target_deg[joint - 1] + delta_deg, 3)
        if not limits[joint - 1].min_deg <= base_deg[joint - 1] <= limits[joint - 1].max_deg:
            # the arm takes no target outside: the step leads to the limit at least
            target_deg[joint - 1] = clipped(asked, limits[joint - 1])
        figures = {"joint": joint, "target": target_deg[joint - 1]}
        notice = JOGGED if target_deg[joint - 1] == asked else LED_TO_LIMIT
        return self._move(started, target_deg, notice, None, **figures)

    def jog_lagging(self, joint: int, step_deg: float) -> bool:
        """Return whether the arm lags so far that a held button should not step on."""
        asked_deg, heard = self.setpoint_deg, self._context.state().joints_deg[joint - 1]
        if asked_deg is None or heard is None:
            return False
        return abs(asked_deg[joint - 1] - heard.value) > _LAG_STEPS * abs(step_deg)

    @operation(
        "motion.send",
        "Move the joints to angles",
        why_not_move,
        moves=True,
        shown_first=True,
        first=drop_waiting,
    )
    def send_joints(
        self,
        started: Started,
        angles_deg: Annotated[Sequence[float], "°"],
        agreed_mm: Agreed = 0.0,
    ) -> Refusal | None:
        """Move to six angles in degrees (MOVE J, 0x155–0x157 and 0x151).

        Args:
            started: The record of the command.
            angles_deg: The angles.
            agreed_mm: The height down to which the operator has agreed to go.
        """
        figures = reports.numbered(angles_deg)
        return self._move(started, angles_deg, SENT_JOINTS, agreed_mm, **figures)

    @operation(
        "motion.home",
        "Move to the factory zero angles",
        why_not_move,
        moves=True,
        first=drop_waiting,
    )
    def go_home(self, started: Started, agreed_mm: Agreed = 0.0) -> Refusal | None:
        """Move to the factory zero angles; see :meth:`send_joints`."""
        return self._move(started, _HOME_DEG, WENT_HOME, agreed_mm)

    def _drop_inside(self) -> None:
        """Drop the motion that waits, and the second part of the way back, which is found anew."""
        drop_waiting(self)
        self._next_deg = ()

    @operation(
        "motion.come_inside",
        "Bring the arm inside its limits",
        why_not_move,
        moves=True,
        consent=Consent.HELD,
        first=_drop_inside,
    )
    def come_inside(self, started: Started) -> Refusal | None:
        """Bring an arm that lies outside its limits inside, slowly; its hand leaves its base then.

        All joints come inside together: until then the arm takes only what has all of them inside.
        """
        targets = self._context.gate().ways_inside()
        return self._come_inside(started, targets) if targets else NOTHING_OUTSIDE()

    def _come_inside(
        self, started: Started, targets: Sequence[tuple[float, ...]]
    ) -> Refusal | None:
        target_deg, *further = targets

        def on_sent(command: MotionCommand) -> None:
            self._next_deg, self._next_after = tuple(further), command.number

        request = joint_request(
            self._context,
            started,
            target_deg,
            lambda: self.speed_percent,
            most_percent=COME_INSIDE_PERCENT,
            why_not=why_not_move,
            sent_event=(COMES_INSIDE, reports.numbered(target_deg)),
        )
        return self._context.gate().send(replace(request, sent=on_sent))

    def _go_on_inside(self) -> None:
        """Start the second part of the way back inside once the first one is completed."""
        authority = self._context.authority
        command = authority.command
        if not self._next_deg:
            return
        if command is None or command.number != self._next_after:
            self._next_deg = ()
        elif authority.holds:
            pass  # the first part is not over
        elif authority.at_rest and not authority.under_way and command.started is not None:
            targets, self._next_deg = self._next_deg, ()
            started = record_start(self.come_inside)
            refusal = self._come_inside(started, targets)
            if refusal is not None:
                started.close(Ending.REFUSED)
                self._context.refuse(refusal)

    def _move(
        self,
        started: Started,
        angles_deg: Sequence[float],
        notice: Notice,
        agreed_mm: float | None,
        **figures: object,
    ) -> Refusal | None:
        """Send six angles if the gate lets them pass, and report it with a notice."""
        context = self._context
        request = joint_request(
            context,
            started,
            angles_deg,
            lambda: self.speed_percent,
            why_not=why_not_move,
            sent_event=(notice, figures),
        )
        return context.gate().send(replace(request, agreed_mm=agreed_mm))

    def follow_arm(self) -> None:
        """Restore the operator's speed after a motion, and repeat a lower speed that is due.

        A lower speed that could not be sent, as while the arm was not heard, does not wait for the
        end of the motion. One that was sent during a motion is sent once more.
        """
        self._resend_lower_speed()
        self._go_on_inside()
        context = self._context
        authority = context.authority
        given = authority.arm_percent
        if given is None or given == min(self.speed_percent, authority.most_percent):
            return
        slower = given > self.speed_percent and authority.may_be_ours
        if not authority.at_rest and not slower:
            return
        operating_state = context.operating_state()
        occupied = operating_state.occupied is not None or authority.mode_in_force() is None
        if occupied or not operating_state.control_certain or not self._settled():
            return
        if (
            interlocks.why_no_command(
                operating_state.unreachable, operating_state.stop, operating_state.busy
            )
            is None
        ):
            self.send_speed()

    def _resend_lower_speed(self) -> None:
        if not self._lower_speed.take_due():
            return
        now = self._context.operating_state()
        if self._context.authority.may_be_ours and not (now.running or now.jogging):
            self.send_speed()

    def halt(self) -> None:
        """Do not repeat a lower speed: nothing may follow the frame that ends the motion."""
        self._lower_speed.drop()
        self._next_deg = ()

    def forget_arm(self) -> None:
        """Do not repeat a lower speed, because another arm may come."""
        self._lower_speed.drop()
        self._next_deg = ()

    def _settled(self) -> bool:
        command = self._context.authority.command
        return command is None or self._context.clock() - command.sent_s >= _SETTLE_S
