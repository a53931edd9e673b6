"""0x150: emergency stop and resume, drag teaching, and commands about motions."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Final

from armui.protocol.codes import ControlMode, StopCommand, TeachingState, TrajectoryCommand
from armui.protocol.generation import Generation
from armui.sim.mechanics.powered_joints import JOINT_COUNT
from armui.sim.mechanics.unpowered_joints import UnpoweredJoints
from armui.sim.motion.moves import Moves

if TYPE_CHECKING:
    from armui.sim.firmware import Firmware

_ALL_INDICES: Final = range(JOINT_COUNT)


class MotionCommandHandler:
    """Obeys 0x150."""

    def __init__(self, arm: Firmware, moves: Moves, enter: Callable[[ControlMode], None]) -> None:
        """Commands one arm.

        Args:
            arm: Obeys.
            moves: Its motions.
            enter: Puts it in a control mode.
        """
        self._generation = arm.generation
        self._mechanics = arm.mechanics
        self._condition = arm.condition
        self._teaching = arm.teaching
        self._unsupported = arm.unsupported
        self._moves = moves
        self._enter = enter

    def take(self, signals: dict[str, float]) -> bool:
        """Obeys one command; whether it asks for an answer."""
        if signals["EmergencyStop"] == StopCommand.EMERGENCY_STOP:
            self.drop_work()
            self._mechanics.power_off(_ALL_INDICES, UnpoweredJoints.DAMPED)
            self._condition.stopped = True
        elif signals["EmergencyStop"] == StopCommand.RESUME:
            self.drop_work()
            self._mechanics.power_off(_ALL_INDICES, UnpoweredJoints.FREE)
            self._condition.clear_errors()
            if self._teaching.reset():
                self._enter(ControlMode.STANDBY)
        elif not self._condition.stopped:
            self._teach(TeachingState(int(signals["TeachingCommand"])))
            return self._trajectory(TrajectoryCommand(int(signals["TrajectoryCommand"])))
        return False

    def drop_work(self) -> None:
        """Forgets targets and replays; what moves is left to the caller."""
        self._moves.forget()
        self._teaching.interrupt()

    def _teach(self, command: TeachingState) -> None:
        if command is TeachingState.START_RECORDING:
            self._moves.forget()
        self._teaching.command(command)

    def _trajectory(self, command: TrajectoryCommand) -> bool:
        if command is TrajectoryCommand.OFF or self._moves.command(command):
            return False
        if command is not TrajectoryCommand.GET_CURRENT:
            self._unsupported[command.name] += 1
            return False
        return self._generation is not Generation.ONE
