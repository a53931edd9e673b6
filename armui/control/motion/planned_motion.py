"""Pauses, continues, clears and ends motions that the arm has planned (0x150 byte 1)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from armui.arm.refusal import Reason, Refusal
from armui.control.context import ControllerPart
from armui.control.events import Notice
from armui.control.link.link_state import LINK_LOST
from armui.control.motion.abort import clearing_frames
from armui.control.motion.motion_command import Hold
from armui.control.motion.motion_context import MotionContext, drop_waiting
from armui.control.motion.retransmission import Retransmission
from armui.control.operations.operation import operation
from armui.control.operations.started import Ending, Started
from armui.control.safety import interlocks
from armui.control.safety.interlocks import CONTROL_OFFSET_UNKNOWN, SPEED_ZERO
from armui.protocol import commands
from armui.protocol.codes import TrajectoryCommand
from armui.telemetry.events import EventKind, Level

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from armui.control.operating_state import OperatingState
    from armui.protocol.frame import Frame

NOT_MOVING = Reason("not_moving", "The arm is not moving: there is nothing to pause.")
NOTHING_HELD = Reason("nothing_held", "No motion is held back.")
PLAN_SENT = Notice(
    "plan_sent",
    "Sent: {plan}. The arm does not report this; watch it.",
    Level.INFO,
    EventKind.COMMAND,
)


_ENDS: Final = frozenset(
    {TrajectoryCommand.CLEAR_CURRENT, TrajectoryCommand.CLEAR_ALL, TrajectoryCommand.ABORT}
)
"""The commands that only end motions: an activity under way is no reason against them."""


def why_not_plan(now: OperatingState, command: TrajectoryCommand) -> Refusal | None:
    """Return why a command of 0x150 byte 1 may not be given, or ``None``."""
    refusal = interlocks.why_no_command(now.unreachable, now.stop, now.busy)
    if refusal is None and not now.control_certain:
        refusal = CONTROL_OFFSET_UNKNOWN()
    if refusal is not None or command in _ENDS:
        return refusal
    if now.running or now.jogging:
        # A run has a pause of its own; the setpoints of a jog, held back by a pause, would move the
        # arm later.
        return now.occupied
    if command is TrajectoryCommand.PAUSE and not now.moving:
        return NOT_MOVING()
    if command is not TrajectoryCommand.CONTINUE:
        return None
    # Continuing starts the motion held back (S11): it needs a speed above 0 and an arm that may be
    # sent motion.
    if not now.holds:
        return NOTHING_HELD()
    if now.speed_percent == 0:
        return SPEED_ZERO()
    return now.cannot_send_motion


class PauseCommand:
    """Pauses a planned motion where the arm is (0x150 byte 1 = 1).

    It is sent twice: a frame may be lost, and too slow a motion is not seen to go on.

    Args:
        context: The context that the controller's parts share.
    """

    def __init__(self, context: MotionContext) -> None:
        self._context = context
        self._second = Retransmission(context)

    def send(self) -> bool:
        """Send the pause, and once more after 0.1 s; return false if no bus is open."""
        self._context.authority.paused()
        self._second.schedule()
        return self._send()

    def repeat(self) -> None:
        """Send the pause once more when that is due and the motion is still held back."""
        if self._second.take_due() and Hold.PAUSE in self._context.authority.holds:
            self._send()

    def drop(self) -> None:
        """Do not repeat the pause, because the motion goes on or has ended."""
        self._second.drop()

    def _send(self) -> bool:
        connection = self._context.connection
        pause = commands.trajectory_command(connection.codec, TrajectoryCommand.PAUSE)
        return connection.send(pause)


class PlannedMotion(ControllerPart):
    """Sends commands that the feedback does not confirm: 0x2A1 has no code for a paused motion.

    Args:
        context: The context that the controller's parts share.
        end_all: Ends a run, replay or jog that is under way.
        end_gripper: Ends a motion of the gripper, behind the frames that end the arm's.
        send_speed: Sends the operator's speed percentage; returns false if it cannot.
    """

    def __init__(
        self,
        context: MotionContext,
        end_all: Callable[[], None],
        end_gripper: Callable[[], None],
        send_speed: Callable[[], bool],
    ) -> None:
        self._context = context
        self._end_all, self._end_gripper = end_all, end_gripper
        self._send_speed = send_speed
        self._pause = PauseCommand(context)

    @operation(
        "planned.command",
        "Pause, continue, clear or end a planned motion",
        why_not_plan,
        moves=True,
        first=drop_waiting,
    )
    def command(self, started: Started, command: TrajectoryCommand) -> Refusal | None:
        """Give a command of 0x150 byte 1.

        Raises:
            EncodeError: The command belongs to the transfer of points.
        """
        context = self._context
        if command is TrajectoryCommand.PAUSE and context.authority.is_braking:
            # no motion is left to pause: repeat the end
            command = TrajectoryCommand.ABORT
        frames = commands.trajectory_command(context.connection.codec, command)
        if command in _ENDS:
            self._end_all()
            # Sent in front of targets that still wait in the outbox, which would move the arm
            # first.
            sent = context.connection.send_urgent([*frames, *clearing_frames(context)])
            refusal = None if sent else LINK_LOST()
            context.authority.cancelled(context.clock())
            self._end_gripper()
        else:
            refusal = self._send(command, frames)
        if refusal is None:
            started.close(Ending.SENT)
            context.emit_event(PLAN_SENT, started, plan=int(command))
        return refusal

    def _send(self, command: TrajectoryCommand, frames: Sequence[Frame]) -> Refusal | None:
        authority, connection = self._context.authority, self._context.connection
        if command is TrajectoryCommand.PAUSE:
            return None if self._pause.send() else LINK_LOST()
        self._pause.drop()
        if command is not TrajectoryCommand.CONTINUE:
            return None if connection.send(frames) else LINK_LOST()
        passed = self._context.gate().ask_on(authority.command)
        if isinstance(passed, Refusal):
            return passed
        holds, percent = authority.holds, self._context.operating_state().speed_percent
        authority.went_on(self._context.clock())
        slower = Hold.SPEED_ZERO in holds or authority.arm_percent != percent
        if slower and not self._send_speed():
            authority.holds = holds
            return LINK_LOST()
        out = Hold.PAUSE not in holds or connection.send(frames, passed=passed)
        return None if out else LINK_LOST()

    # The controller's tick ----------------------------------------------------------------------

    def follow_arm(self) -> None:
        """Repeat a pause that is due."""
        self._pause.repeat()

    def halt(self) -> None:
        """Drop a pause that is due: nothing may follow the frame that ends the motion."""
        self._pause.drop()

    def forget_arm(self) -> None:
        """Drop a pause that is due, because the arm is gone."""
        self._pause.drop()
