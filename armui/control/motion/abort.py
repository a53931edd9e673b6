"""Has the arm end its motion where it is, with its motors on (0x150)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from armui.arm.refusal import Reason, Refusal
from armui.control.devices.teaching_phase import may_replay
from armui.control.link.link_state import LINK_LOST, NOT_CONNECTED
from armui.control.motion.motion_command import End
from armui.control.safety.interlocks import (
    CONTROL_OFFSET_UNKNOWN,
    OTHER_CONTROL,
    STOP_REQUESTED,
    STOPPED,
)
from armui.control.safety.other_command import LEADER_ARM, OTHER_HOST, OTHER_MODE
from armui.protocol import commands
from armui.protocol.codes import TeachingState, TrajectoryCommand
from armui.protocol.frame import Frame

if TYPE_CHECKING:
    from armui.control.context import Context
    from armui.control.link.connection import Connection

RUN_STOPPED = Reason("run_stopped", "It was the emergency stop.")


_LEFT_ALONE: Final = frozenset(
    {
        # the emergency stop is stronger, and was sent
        STOPPED,
        STOP_REQUESTED,
        RUN_STOPPED,
        # no frame reaches the arm, or it might reach another one
        NOT_CONNECTED,
        LINK_LOST,
        CONTROL_OFFSET_UNKNOWN,
        # the motion is another host's, and not this program's to end
        OTHER_CONTROL,
        OTHER_HOST,
        LEADER_ARM,
        OTHER_MODE,
    }
)
"""The reasons for a run to end after which nothing more is sent to the arm."""


def ending_frames(connection: Connection) -> list[Frame]:
    """Return the frames that end the arm's motion with power on: 0x150 byte 1 = 6.

    A replay of the arm's own recording, which may be under way, is ended by byte 2 = 6.
    """
    codec, status = connection.codec, connection.newest.status
    frames = commands.trajectory_command(codec, TrajectoryCommand.ABORT)
    if may_replay(None if status is None else status.value):
        frames += commands.teaching_command(codec, TeachingState.ABORT)
    return frames


def clearing_frames(context: Context) -> list[Frame]:
    """Return the frames that drop a target whose mode word may be lost (0x150 byte 1 = 4), if any.

    Such a target is no motion yet that byte 1 = 6 would end, and the next mode word would start it
    (S10).
    """
    if not context.authority.mode_unproven:
        return []
    return commands.trajectory_command(context.connection.codec, TrajectoryCommand.CLEAR_ALL)


def abort_motion(context: Context, end: End = End.CANCELLED) -> bool:
    """End the arm's motion where it is, with power on, and drop its target (0x150).

    It goes ahead of everything that waits: half a target must not follow it. Return whether
    it is on the bus.

    Args:
        context: The context that the controller's parts share.
        end: The cause by which our command ends.
    """
    connection = context.connection
    if connection.device is None or connection.device.listen_only:
        return False
    frames = ending_frames(connection) + clearing_frames(context)
    context.authority.cancelled(context.clock(), end)
    return connection.send_urgent(frames)


def abort_motion_for(context: Context, reason: Refusal) -> None:
    """Abort the motion of a run that cannot go on, unless its reason makes sending pointless.

    A blocked arm, or one whose run took too long, would otherwise set out for its point as soon as
    it can, long after the run's end.
    """
    if reason.reason not in _LEFT_ALONE:
        abort_motion(context)
