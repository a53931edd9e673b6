"""Motions the arm has planned are paused, continued, cleared or ended (0x150 byte 1)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode
from armui.control.context import Context
from armui.control.events import EventCode
from armui.control.motion.motion_command import Hold
from armui.control.safety import interlocks
from armui.protocol import commands
from armui.protocol.codes import TrajectoryCommand

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from armui.control.operating_state import OperatingState
    from armui.protocol.frame import Frame

_ENDS: Final = frozenset(
    {TrajectoryCommand.CLEAR_CURRENT, TrajectoryCommand.CLEAR_ALL, TrajectoryCommand.ABORT}
)
"""What only ends motions is never refused for what is under way: that ends."""


class PlannedMotion:
    """Sends commands that the feedback does not confirm: 0x2A1 has no code for a paused motion.

    Args:
        context: What the parts of the controller share.
        end_all: Ends whatever run, replay or jog is under way.
        tell_speed: Gives the arm the operator's speed percentage; says whether it could.
    """

    def __init__(
        self, context: Context, end_all: Callable[[], None], tell_speed: Callable[[], bool]
    ) -> None:
        self._context = context
        self._end_all = end_all
        self._tell_speed = tell_speed

    def why_not(self, command: TrajectoryCommand) -> Refusal | None:
        """The reason against a command now, or ``None``: it may be given."""
        operating_state = self._context.operating_state()
        refusal = interlocks.why_no_command(
            operating_state.unreachable, operating_state.stop, operating_state.busy
        )
        if refusal is None and not operating_state.control_certain:
            refusal = Refusal(RefusalCode.CONTROL_OFFSET_UNKNOWN)
        if refusal is not None or command in _ENDS:
            return refusal
        if operating_state.running or operating_state.jogging:
            # a run has a pause of its own; setpoints of a jog held back would be carried out later
            return operating_state.occupied
        if command is TrajectoryCommand.PAUSE and not operating_state.moving:
            return Refusal(RefusalCode.NOT_MOVING)
        if command is TrajectoryCommand.CONTINUE:
            return self._why_not_continue(operating_state)
        return None

    def _why_not_continue(self, operating_state: OperatingState) -> Refusal | None:
        """What is held back goes on at the operator's speed, and only in an arm that is ours."""
        if not operating_state.holds:
            return Refusal(RefusalCode.NOTHING_HELD)
        if operating_state.speed_percent == 0:
            return Refusal(RefusalCode.SPEED_ZERO)
        return self._context.authority.why_not_ours()

    def command(self, command: TrajectoryCommand) -> Refusal | None:
        """Give a command of 0x150 byte 1: ``None`` if it is on its way, or why it is not.

        Raises:
            EncodeError: The command is one of the transfer of points.
        """
        context = self._context
        context.refresh()
        refusal = self.why_not(command)
        if refusal is None:
            frames = commands.trajectory_command(context.connection.codec, command)
            connection = context.connection
            if command in _ENDS:
                self._end_all()
                sent = connection.send_urgent(frames)  # past targets that wait to be sent
                context.authority.cancelled(context.clock())
            else:
                sent = self._send(command, frames)
            refusal = None if sent else Refusal(RefusalCode.LINK_LOST)
        if refusal is not None:
            return context.refuse(refusal)
        context.tell(EventCode.PLAN_SENT, plan=int(command))
        return None

    def _send(self, command: TrajectoryCommand, frames: Sequence[Frame]) -> bool:
        authority, connection = self._context.authority, self._context.connection
        if command is TrajectoryCommand.PAUSE:
            authority.paused()
            return connection.send(frames)
        if command is not TrajectoryCommand.CONTINUE:
            return connection.send(frames)
        holds, percent = authority.holds, self._context.operating_state().speed_percent
        authority.went_on(self._context.clock())
        slower = Hold.SPEED_ZERO in holds or authority.arm_percent != percent
        if slower and not self._tell_speed():
            authority.holds = holds
            return False
        return Hold.PAUSE not in holds or connection.send(frames)
