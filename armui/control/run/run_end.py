"""What is sent when a run ends before its end: the arm must not go on with it unnoticed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from armui.arm.refusal import Reason
from armui.control.operating_state import LINK_LOST, NOT_CONNECTED
from armui.control.safety.interlocks import (
    CONTROL_OFFSET_UNKNOWN,
    OTHER_CONTROL,
    STOP_REQUESTED,
    STOPPED,
)
from armui.control.safety.other_command import LEADER_ARM, OTHER_HOST, OTHER_MODE
from armui.protocol import commands
from armui.protocol.codes import TrajectoryCommand

if TYPE_CHECKING:
    from armui.arm.refusal import Refusal
    from armui.control.context import Context

RUN_STOPPED = Reason(
    "run_stopped",
    "The arm is in emergency stop. Hold the arm, press Resume, enable the motors; then the "
    "run can go on from this row.",
)


_LEFT_ALONE: Final = frozenset(
    {
        # the stop has gone out, and says more
        STOPPED,
        STOP_REQUESTED,
        RUN_STOPPED,
        # nothing reaches the arm, or nobody knows which arm it would reach
        NOT_CONNECTED,
        LINK_LOST,
        CONTROL_OFFSET_UNKNOWN,
        # the arm serves another master: its motion is not this program's to end
        OTHER_CONTROL,
        OTHER_HOST,
        LEADER_ARM,
        OTHER_MODE,
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
    if reason.reason not in _LEFT_ALONE:
        abort_motion(context)
