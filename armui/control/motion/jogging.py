"""Jogging: the arm moves while a button or key is held, and rests when it is not.

While the operator holds a button or key, joint setpoints are streamed (MOVE J, 0x155–0x157), each
so near that the arm rests within 100 ms of the last one it heard (see
:mod:`armui.control.motion.jog_pace`). No further message is needed to stop it. MOVE L plans anew at
each target and cannot be streamed, so a straight line of the tool is solved here by the inverse
kinematics.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import Qt, QTimer

from armui.arm.limits import (
    JOINTS,
    JOINTS_OUTSIDE,
    JointLimits,
    check_joints,
    clipped,
    outside_limits,
    outside_list,
    settled,
)
from armui.arm.models import model_data
from armui.arm.refusal import Reason, Refusal
from armui.cell.user_frames import UserFrame
from armui.control.context import ControllerPart
from armui.control.events import Notice
from armui.control.motion.abort import abort_motion
from armui.control.motion.jog_pace import Pace, accelerations, pace
from armui.control.motion.jog_path import (
    JogPath,
    JointJog,
    JointJogPath,
    MotionFrame,
    ToolJog,
    ToolJogPath,
    axis_in,
)
from armui.control.motion.jog_stream import JOG_NOT_FOLLOWING, JogStream
from armui.control.motion.joint_motion import why_not_move
from armui.control.motion.motion_command import CommandKind, MotionCommand
from armui.control.motion.motion_context import MotionContext, drop_waiting
from armui.control.motion.steered_path import SteeredJog, SteeredToolPath
from armui.control.motion.target_stream import TargetJog, TargetStream, stream_pace
from armui.control.operations.operation import Consent, operation
from armui.control.operations.started import Ending, Started
from armui.control.safety.interlocks import JOINTS_UNKNOWN
from armui.control.safety.standstill import QUIET_DEG, QUIET_S, STILL_MOVING, RestWatch
from armui.kinematics.axes import AXES, JogFrame
from armui.protocol import commands
from armui.protocol.codes import MoveMode
from armui.telemetry.events import Asker, EventKind, Level

JOG_HELD_UP = Reason(
    "jog_held_up", "The program was held up for {value} ms. Let go and press again."
)
STREAM_HELD_UP = Reason(
    "stream_held_up",
    "The program was held up for {value} ms, which ended the stream. The next target begins "
    "another.",
)
JOG_NO_FEEDBACK = Reason(
    "jog_no_feedback",
    "The joint angles are no longer heard from the arm. Check its power and the CAN cable.",
)
GAMEPAD_SILENT = Reason(
    "gamepad_silent", "No more data from {name}. Release all its buttons and press again."
)
JOGGING_JOINT = Notice(
    "jogging_joint", "Jogging J{joint} {sign}", Level.INFO, EventKind.COMMAND, Asker.JOG
)
JOGGING_TOOL = Notice(
    "jogging_tool", "Jogging {axis} {sign}", Level.INFO, EventKind.COMMAND, Asker.JOG
)
DEVICE_JOGS_JOINTS = Notice(
    "device_jogs_joints", "{device} jogs {axes} (joints)", Level.INFO, EventKind.COMMAND
)
DEVICE_JOGS_BASE = Notice(
    "device_jogs_base", "{device} jogs {axes} (base frame)", Level.INFO, EventKind.COMMAND
)
DEVICE_JOGS_TOOL = Notice(
    "device_jogs_tool", "{device} jogs {axes} (tool frame)", Level.INFO, EventKind.COMMAND
)
DEVICE_JOGS_FRAME = Notice(
    "device_jogs_frame",
    "{device} jogs {axes} (user frame “{frame}”)",
    Level.INFO,
    EventKind.COMMAND,
)
STREAMING = Notice("streaming", "“{device}” streams targets", Level.INFO, EventKind.COMMAND)
JOG_ENDED = Notice(
    "jog_ended", "Jogging ended. {reason}", Level.WARNING, EventKind.RESULT, Asker.JOG
)


_STEERED: Final = {
    None: DEVICE_JOGS_JOINTS,
    JogFrame.BASE: DEVICE_JOGS_BASE,
    JogFrame.TOOL: DEVICE_JOGS_TOOL,
}

Jog = JointJog | ToolJog | SteeredJog | TargetJog

if TYPE_CHECKING:
    from armui.arm.state import ArmState
    from armui.control.motion.cartesian import Cartesian
    from armui.control.motion.joint_motion import Motion

_TICK_MS: Final = 10
"""The period at which a jog reads the feedback and sends the setpoint that is due."""
_SHORTEST_S: Final = 0.004
"""The least time between two setpoints: two timers drive the stream, and one is enough."""
_HELD_UP_S: Final = 0.08
"""A program stuck for this long must not go on by itself: the holder may have let go."""
_FEEDBACK_S: Final = 0.1
"""A jog needs angles younger than this."""
_KEEP_S: Final = 0.03
"""A setpoint that could not be sent within this time is dropped."""
_LED_BACK_DEG: Final = 3.0
"""No jog within the limits leads further ahead of a joint, its sag included."""
_SETTLE_S: Final = 0.3
"""A jog waits for this time at most for the arm to come to rest from the last one."""


@dataclass(slots=True)
class _Hold:
    """One press, from its beginning to its end.

    Attributes:
        stream: Its setpoints, once the arm has been seen at rest.
        before: Our command that was under way or had arrived when it began.
        command: The motion command, once the first setpoint is sent.
        steered_s: When :meth:`Jogging.steer` was last called.
        started: The operation.
    """

    jog: Jog
    began_s: float
    last_s: float
    steered_s: float
    started: Started
    stream: JogStream | TargetStream | None = None
    before: MotionCommand | None = None
    command: MotionCommand | None = None


class Jogging(ControllerPart):
    """Moves the arm while something is held, from :meth:`start` to :meth:`stop`.

    Args:
        context: The context that the controller's parts share.
        motion: Owns the speed.
        cartesian: Knows the tool and the kinematics.
    """

    def __init__(self, context: MotionContext, motion: Motion, cartesian: Cartesian) -> None:
        self._context = context
        self._motion = motion
        self._cartesian = cartesian
        self._rest = RestWatch(QUIET_DEG, QUIET_S)
        self._hold: _Hold | None = None
        # Qt's default timer may be off by 5 %, and is fired together with others: too uneven for
        # setpoints.
        self._timer = QTimer(interval=_TICK_MS, timerType=Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self.tick)

    @property
    def active(self) -> bool:
        """True if something is held."""
        return self._hold is not None

    @property
    def steered(self) -> SteeredJog | None:
        """The jog that a device steers now, or ``None``."""
        hold = self._hold
        return hold.jog if hold is not None and isinstance(hold.jog, SteeredJog) else None

    @property
    def streamed(self) -> TargetJog | None:
        """The stream of a client's targets under way, or ``None``."""
        hold = self._hold
        return hold.jog if hold is not None and isinstance(hold.jog, TargetJog) else None

    @property
    def setpoint_deg(self) -> tuple[float, ...] | None:
        """The newest setpoint of the jog under way, or ``None``."""
        stream = None if self._hold is None else self._hold.stream
        return None if stream is None else stream.setpoint_deg

    def _end_last(self) -> None:
        """End the jog under way, and drop a motion that waits: the press replaces both."""
        self.stop()
        drop_waiting(self)

    @operation("jog.begin", "Jog", why_not_move, moves=True, consent=Consent.HELD, first=_end_last)
    def start(self, started: Started, jog: Jog) -> Refusal | None:
        """Begin a jog that goes on until :meth:`stop`; a jog under way ends.

        A steered one ends as well if :meth:`steer` is not called for longer than a program may be
        stuck.

        Returns:
            Why it does not begin, or ``None``. The notice ``jog_ended`` tells what
            ends it later.
        """
        context, frame = self._context, _frame(jog)
        if frame is not None:
            refusal = self._cartesian.why_no_frame(frame) or self._cartesian.why_unknown()
            if refusal is not None:
                return refusal
        now_s, before = context.clock(), context.authority.command
        self._hold = _Hold(jog, now_s, now_s, now_s, started, before=before)
        self._timer.start()
        context.refresh()
        self._emit_begun(started, jog)
        return None

    def _emit_begun(self, started: Started, jog: Jog) -> None:
        emit_event = self._context.emit_event
        if isinstance(jog, TargetJog):
            emit_event(STREAMING, started, device=jog.device)
        elif isinstance(jog, JointJog):
            emit_event(JOGGING_JOINT, started, joint=jog.joint, sign=_sign(jog.direction))
        elif isinstance(jog, ToolJog):
            axis = axis_in(jog.frame, jog.axis)
            emit_event(JOGGING_TOOL, started, axis=axis, sign=_sign(jog.direction))
        elif isinstance(jog.frame, UserFrame):
            figures = {"axes": axes_text(jog), "device": jog.device, "frame": jog.frame.name}
            emit_event(DEVICE_JOGS_FRAME, started, **figures)
        else:
            emit_event(_STEERED[jog.frame], started, axes=axes_text(jog), device=jog.device)

    def steer(self, jog: SteeredJog) -> bool:
        """Continue as a device steers now, in the frame in which the jog began.

        Returns:
            True if a steered jog is still under way; false, with no effect, if it has ended or
            something else is held.
        """
        hold, before = self._hold, self.steered
        if hold is None or before is None or before.frame != jog.frame:
            return False
        hold.steered_s = self._context.clock()
        if jog.rates != before.rates:
            hold.jog = jog
            if isinstance(hold.stream, JogStream):
                hold.stream.follow_path(self._path_of(jog, hold.stream.setpoint_deg))
        return True

    def end_jog(self, reason: Refusal) -> None:
        """End the jog and tell the operator why."""
        if self._hold is not None:
            self._end(reason)

    def stop(self) -> None:
        """Send no more setpoints: the arm rests at the last one within 100 ms."""
        if self._hold is not None:
            self._end_hold()
            self._context.refresh()

    def _end_hold(self) -> None:
        hold, self._hold = self._hold, None
        self._timer.stop()
        if hold is None:
            return
        if hold.command is None:
            # No setpoint was sent; otherwise the record ends when the arm has come to rest.
            hold.started.close(Ending.CUT_OFF)
        elif not self._is_replaced(hold) and self._is_led_back(hold):
            abort_motion(self._context)  # not if another command has replaced it

    def _is_led_back(self, hold: _Hold) -> bool:
        """Return whether the arm is far behind: it is led to its limits from outside."""
        measured_deg = self._context.state().angles_deg()
        if hold.stream is None or measured_deg is None:
            return False
        pairs = zip(hold.stream.setpoint_deg, measured_deg, strict=True)
        return any(abs(asked - angle) > _LED_BACK_DEG for asked, angle in pairs)

    def tick(self) -> None:
        """Send the next setpoint; called by the jog's own timer and by the controller's."""
        hold = self._hold
        if hold is None:
            return
        context = self._context
        now_s = context.clock()
        dt_s = now_s - hold.last_s
        if dt_s < _SHORTEST_S:
            return
        hold.last_s = now_s
        state = context.connection.newest
        measured_deg = state.angles_deg()
        refusal = (
            _why_blind(state, dt_s, now_s, hold.jog)
            or _why_not_steered(hold, now_s)
            or context.operating_state().cannot_move
            or self._cartesian.why_no_frame(_frame(hold.jog))
        )
        if refusal is not None or measured_deg is None:
            self._end(refusal)
        elif self._is_replaced(hold):
            self.stop()  # another command has taken over
        elif hold.stream is None:
            self._begin(hold, state, measured_deg, now_s)
        else:
            self._go_on(hold, hold.stream, measured_deg, dt_s)

    def _is_replaced(self, hold: _Hold) -> bool:
        """Return whether a command that is not this jog's has been given since it began."""
        ours = self._context.authority.command
        if hold.command is not None:
            return ours is None or ours.number != hold.command.number
        before = 0 if hold.before is None else hold.before.number
        return ours is not None and ours.number != before

    def _begin(
        self, hold: _Hold, state: ArmState, measured_deg: Sequence[float], now_s: float
    ) -> None:
        """Begin a jog once the arm rests: only then it is sure to rest in time again."""
        self._rest.observe(state, now_s)
        if not self._rest.at_rest:
            if now_s - hold.began_s >= _SETTLE_S:
                self._end(STILL_MOVING())
            return
        limits = self._context.operating_state().limits
        base_deg = self._begins_at(hold.jog, measured_deg, limits)
        if isinstance(hold.jog, TargetJog) and outside_limits(base_deg, limits):
            self._end(JOINTS_OUTSIDE(joints=outside_list(base_deg, limits)))
            return
        sag_deg = [base - measured for base, measured in zip(base_deg, measured_deg, strict=True)]
        if outside_limits(measured_deg, limits):
            # outside its limits the arm is led to where the jog begins: the difference is no sag
            sag_deg = [0.0] * len(JOINTS)
        check = self._context.gate().stream()

        def why_barred(
            ahead_deg: Sequence[float], now_deg: Sequence[float], lag_deg: Sequence[float] = ()
        ) -> Refusal | None:
            return check.why_not(_less(ahead_deg, sag_deg), _less(now_deg, sag_deg), lag_deg)

        from armui.ways.way import straight_way  # noqa: PLC0415 - numpy

        way = straight_way(measured_deg, _less(base_deg, sag_deg))
        refusal = self._context.gate().judge(way)
        if refusal is not None:
            self._end(refusal)
            return
        if isinstance(hold.jog, TargetJog):
            hold.stream = TargetStream(
                *(hold.jog, base_deg, measured_deg),
                accelerations_deg_s2=self._accelerations(),
                limits=limits,
                why_barred=why_barred,
            )
            return
        path = self._path_of(hold.jog, base_deg)
        hold.stream = JogStream(path, base_deg, measured_deg, why_barred)

    def _begins_at(
        self, jog: Jog, measured_deg: Sequence[float], limits: Sequence[JointLimits]
    ) -> tuple[float, ...]:
        """Return the angles at which a jog begins.

        That is our own target only if the arm is at it, but for sag, and not if it has been sent
        there and has not begun to move.

        A joint that stands outside its limits alone, and is jogged back, begins at the limit: the
        arm takes no target outside.
        """
        base_deg = self._context.authority.joint_base_deg() or measured_deg
        if any(abs(a - b) > _LED_BACK_DEG for a, b in zip(base_deg, measured_deg, strict=True)):
            base_deg = measured_deg
        base_deg = settled(base_deg, limits)
        outside = outside_limits(base_deg, limits)
        if not isinstance(jog, JointJog) or outside != (jog.joint,):
            return base_deg
        place = jog.joint - 1
        inside = clipped(base_deg[place], limits[place])
        if (inside - base_deg[place]) * jog.direction <= 0.0:
            return base_deg
        return (*base_deg[:place], inside, *base_deg[place + 1 :])

    def _path_of(self, jog: JointJog | ToolJog | SteeredJog, base_deg: Sequence[float]) -> JogPath:
        limits = self._context.operating_state().limits
        if isinstance(jog, JointJog):
            return JointJogPath(jog.rates, base_deg, limits)
        cartesian = self._cartesian
        if isinstance(jog, SteeredJog):
            if jog.frame is None:
                return JointJogPath(jog.rates, base_deg, limits)
            return SteeredToolPath(
                *(jog.rates, jog.frame, cartesian.kinematics(), base_deg),
                tool=cartesian.tool,
                limits=limits,
            )
        return ToolJogPath(jog, cartesian.kinematics(), base_deg, cartesian.tool, limits)

    def present_pace(self) -> Pace:
        """Return the limits of a jog, or of the stream under way, at the operator's speed."""
        make = pace if self.streamed is None else stream_pace
        limits = self._context.operating_state().limits
        return make(self._motion.speed_percent, limits, self._accelerations())

    def _accelerations(self) -> tuple[float, ...]:
        model = self._context.operating_state().model
        heard = self._context.state().accelerations_deg_s2
        return accelerations(heard, model_data(model).accelerations_deg_s2)

    def _go_on(
        self,
        hold: _Hold,
        stream: JogStream | TargetStream,
        measured_deg: Sequence[float],
        dt_s: float,
    ) -> None:
        context = self._context
        operating_state = context.operating_state()
        present = self.present_pace()
        reason = stream.advance_setpoint(measured_deg, dt_s, present)
        if reason is not None and reason.reason == JOG_NOT_FOLLOWING:
            if not context.connection.newest.in_time(context.clock()):
                return  # late angles would look as if the arm lagged
            # an arm beyond its limits follows no target before the first within them
            reason = check_joints(stream.setpoint_deg, operating_state.limits) or reason
        target_deg = tuple(round(angle, 3) for angle in stream.setpoint_deg)
        refusal = None
        if not (self.streamed and hold.command and hold.command.joints_deg == target_deg):
            refusal = self._send(hold, target_deg, present.arm_percent)
        if refusal is not None or reason is not None:
            self._end(refusal or reason)

    def _send(self, hold: _Hold, target_deg: Sequence[float], percent: int) -> Refusal | None:
        """Send the next setpoint; the first one carries the mode word, the others do not."""
        context = self._context
        codec, command = context.connection.codec, hold.command
        passed = context.gate().ask_no_way()  # the stream has asked for each setpoint
        if command is None or command.speed_percent != percent:
            sent = context.send_motion(
                CommandKind.JOG,
                commands.move_joints(codec, target_deg, speed_percent=percent),
                passed=passed,
                started=hold.started,
                move_mode=MoveMode.MOVE_J,
                speed_percent=percent,
                joints_deg=target_deg,
                keep_s=_KEEP_S,
            )
        else:
            frames = commands.joint_target(codec, target_deg)
            sent = context.send_on(
                command, frames, passed=passed, joints_deg=target_deg, keep_s=_KEEP_S
            )
        if isinstance(sent, Refusal):
            return sent
        hold.command = sent
        return None

    def _end(self, reason: Refusal | None) -> None:
        hold, self._hold = self._hold, None
        self._timer.stop()
        self._context.refresh()
        self._context.close(
            None if hold is None else hold.started,
            Ending.CUT_OFF,
            JOG_ENDED,
            reason=reason or JOINTS_UNKNOWN(),
        )

    # The controller's tick ------------------------------------------------------------------

    def follow_arm(self) -> None:
        """Observe whether the arm rests, and send the next setpoint if it is due."""
        self._rest.observe(self._context.connection.newest, self._context.clock())
        self.tick()

    def halt(self) -> None:
        """End the jog: the arm is to stop, or has stopped."""
        self._end_hold()

    def forget_arm(self) -> None:
        """End the jog, because the arm is gone."""
        self.halt()
        self._rest.reset()


def _why_blind(state: ArmState, dt_s: float, now_s: float, jog: Jog) -> Refusal | None:
    """Return why the arm's place, or the operator's hold, is not certain, or ``None``."""
    if dt_s > _HELD_UP_S:
        held_up = STREAM_HELD_UP if isinstance(jog, TargetJog) else JOG_HELD_UP
        return held_up(value=round(1000 * dt_s))
    if any(heard is None or now_s - heard.at_s > _FEEDBACK_S for heard in state.joints_deg):
        return JOG_NO_FEEDBACK()
    return None


def _sign(direction: int) -> str:
    return "+" if direction > 0 else "−"


def _why_not_steered(hold: _Hold, now_s: float) -> Refusal | None:
    """Return why a jog by a device ends: the device has been silent for too long."""
    if isinstance(hold.jog, SteeredJog) and now_s - hold.steered_s > _HELD_UP_S:
        return GAMEPAD_SILENT(name=hold.jog.device)
    return None


def _frame(jog: Jog) -> MotionFrame | None:
    """Return the frame whose axes a jog follows; ``None`` for one of the joints."""
    return None if isinstance(jog, JointJog) else jog.frame


def axes_text(jog: SteeredJog) -> str:
    """Return the axes that move and their directions, as J1+ J3−."""
    names = tuple(f"J{joint}" for joint in JOINTS) if jog.frame is None else AXES
    moving = zip(names, jog.rates, strict=True)
    return " ".join(f"{name}{'+' if rate > 0 else '−'}" for name, rate in moving if rate)


def _less(pose_deg: Sequence[float], sag_deg: Sequence[float]) -> tuple[float, ...]:
    return tuple(angle - sag for angle, sag in zip(pose_deg, sag_deg, strict=True))
