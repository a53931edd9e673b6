"""Motions the arm has planned are paused, continued, cleared or ended (0x150 byte 1)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from armui.arm.refusal import Refusal
from armui.control import gate
from armui.control.context import Context
from armui.protocol import commands
from armui.protocol.codes import TrajectoryCommand

if TYPE_CHECKING:
    from collections.abc import Callable

_ENDS: Final = frozenset(
    {TrajectoryCommand.CLEAR_CURRENT, TrajectoryCommand.CLEAR_ALL, TrajectoryCommand.ABORT}
)
"""What only ends motions is never refused for what is under way: that ends."""


class PlannedMotion:
    """Sends what the arm obeys without saying so: 0x2A1 has no word for a paused motion.

    Args:
        context: What the parts of the controller share.
        end_all: Ends whatever run, replay or jog is under way.

    Attributes:
        paused: This program has paused the arm's motion and not continued or cleared it since. The
            arm holds back new targets as long, so the program refuses them.
    """

    def __init__(self, context: Context, end_all: Callable[[], None]) -> None:
        self._context = context
        self._end_all = end_all
        self.paused = False

    def why_not(self, command: TrajectoryCommand) -> Refusal | None:
        """The reason against a command now, or ``None``: it may be given."""
        situation = self._context.situation()
        refusal = gate.why_no_command(situation.link, situation.stop, situation.busy)
        if refusal is None and not situation.control_certain:
            refusal = Refusal("control_offset_unknown")
        if refusal is not None or command in _ENDS:
            return refusal
        if situation.running or situation.jogging:
            # a run has a pause of its own; setpoints of a jog held back would come to life later
            return situation.occupied
        if command is TrajectoryCommand.PAUSE and not situation.moving:
            return Refusal("not_moving")
        return None

    def command(self, command: TrajectoryCommand) -> Refusal | None:
        """Give a command of 0x150 byte 1: ``None`` if it is on its way, or why it is not.

        Raises:
            EncodeError: The command is one of the transfer of points.
        """
        context = self._context
        refusal = self.why_not(command)
        if refusal is None:
            frames = commands.trajectory_command(context.connection.codec, command)
            connection = context.connection
            if command in _ENDS:
                self._end_all()
                sent = connection.send_urgent(frames)  # past targets that wait to be sent
            else:
                sent = connection.send(frames)
            refusal = None if sent else Refusal("link_lost")
        if refusal is not None:
            return context.refuse(refusal)
        self.paused = command is TrajectoryCommand.PAUSE
        context.tell("plan_sent", plan=int(command))
        return None

    def advance(self) -> None:
        """Motors without power drop what was planned; nothing else comes back from the arm."""
        if self.paused and False in self._context.situation().enabled:
            self.paused = False

    def halt(self) -> None:
        """A stop drops what was planned, and the pause with it."""
        self.paused = False

    def forget(self) -> None:
        """Nothing is known of an arm that is gone."""
        self.paused = False
