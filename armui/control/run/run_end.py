"""What is sent when a run ends before its end: the arm must not go on with it unnoticed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from armui.arm.refusal_codes import RefusalCode
from armui.protocol import commands
from armui.protocol.codes import TrajectoryCommand

if TYPE_CHECKING:
    from armui.arm.refusal import Refusal
    from armui.control.context import Context

_LEFT_ALONE: Final = frozenset(
    {
        # the stop has gone out, and says more
        RefusalCode.STOPPED,
        RefusalCode.STOP_REQUESTED,
        RefusalCode.RUN_STOPPED,
        # nothing reaches the arm, or nobody knows which arm it would reach
        RefusalCode.NOT_CONNECTED,
        RefusalCode.LINK_LOST,
        RefusalCode.CONTROL_OFFSET_UNKNOWN,
        # the arm serves another master: its motion is not this program's to end
        RefusalCode.OTHER_CONTROL,
        RefusalCode.OTHER_HOST,
        RefusalCode.LEADER_ARM,
        RefusalCode.OTHER_MODE,
    }
)
"""Reasons for a run to end after which the arm is told nothing more."""


def abort_motion(context: Context) -> bool:
    """Have the arm end its motion where it is, powered, and drop its target (0x150 byte 1 = 6).

    It goes past everything that waits to be sent: half a target must not follow it. Returns
    whether it is on the bus.
    """
    connection = context.connection
    if connection.device is None or connection.device.listen_only:
        return False
    frames = commands.trajectory_command(connection.codec, TrajectoryCommand.ABORT)
    context.authority.cancelled(context.clock())
    return connection.send_urgent(frames)


def abort_motion_for(context: Context, reason: Refusal) -> None:
    """The same for a run that cannot go on, unless its reason makes sending pointless.

    An arm that is blocked, or whose run took too long, would otherwise set out for the point of a
    run long over as soon as it can.
    """
    if reason.code not in _LEFT_ALONE:
        abort_motion(context)
