"""All motion by frames: targets of every kind, arcs, setpoints, and the commands of 0x150."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from armui.arm.limits import JOINTS
from armui.kinematics.arm_kinematics import Kinematics
from armui.protocol.codes import (
    ArcPointNumber,
    ControlMode,
    MitMode,
    MoveMode,
    StopCommand,
    TeachingState,
    TrajectoryCommand,
)
from armui.protocol.generation import Generation
from armui.sim.arm_type import ArmType
from armui.sim.condition import Condition
from armui.sim.mechanics.driver_loop import DriverSetpoint
from armui.sim.mechanics.mechanics import Mechanics
from armui.sim.mechanics.powered_joints import JOINT_COUNT, SixValues
from armui.sim.mechanics.unpowered_joints import UnpoweredJoints
from armui.sim.motion.cpv import CpvControl
from armui.sim.motion.motion_executor import JointMoves, MotionExecutor
from armui.sim.motion.tool_moves import ToolMotions
from armui.sim.parameters.settings import ArmSettingsRecord

if TYPE_CHECKING:
    from armui.sim.motion.teaching import SimulatedTeaching


_ALL_INDICES: Final = range(JOINT_COUNT)

NAMES: Final = tuple(f"MitControl{joint}" for joint in JOINTS)
"""The names of the frames 0x15A–0x15F, joint 1 first."""

_FOLLOW_GAINS: Final = ((50.0, 2.5),) * 3 + ((20.0, 1.0),) * 3
"""kp and kd of high-follow, which are not published: with the simulated arm's friction the joints
lag a triangle of 1.2 rad/s by 0.089 rad, as a user measured.
"""


@dataclass(eq=False, repr=False)
class MotionCommandHandler:
    """Obeys the commands of 0x150 to one arm.

    Attributes:
        generation: The protocol it speaks.
        mechanics: Its joints and motors.
        condition: Its modes, flags and faults.
        teaching: Its drag teaching.
        moves: Its motions.
        unsupported: Counts what it was asked and cannot do.
        enter: Enters a control mode.
    """

    generation: Generation
    mechanics: Mechanics
    condition: Condition
    teaching: SimulatedTeaching
    moves: Moves
    unsupported: Counter[str]
    enter: Callable[[ControlMode], None]

    def obey(self, signals: dict[str, float]) -> bool:
        """Obeys one command, and returns whether it requires an answer."""
        if signals["EmergencyStop"] == StopCommand.EMERGENCY_STOP:
            self.drop_work()
            self.mechanics.power_off(_ALL_INDICES, UnpoweredJoints.DAMPED)
            self.condition.stopped = True
        elif signals["EmergencyStop"] == StopCommand.RESUME:
            self.drop_work()
            self.mechanics.power_off(_ALL_INDICES, UnpoweredJoints.FREE)
            self.condition.clear_errors()
            if self.teaching.reset():
                self.enter(ControlMode.STANDBY)
        elif not self.condition.stopped:
            self._teach(TeachingState(int(signals["TeachingCommand"])))
            return self._trajectory(TrajectoryCommand(int(signals["TrajectoryCommand"])))
        return False

    def drop_work(self) -> None:
        """Drops targets and replays; the caller stops the joints."""
        self.moves.drop_targets()
        self.teaching.interrupt()

    def _teach(self, command: TeachingState) -> None:
        if command is TeachingState.START_RECORDING:
            self.moves.drop_targets()
        self.teaching.command(command)

    def _trajectory(self, command: TrajectoryCommand) -> bool:
        if command is TrajectoryCommand.OFF or self.moves.command(command):
            return False
        if command is not TrajectoryCommand.GET_CURRENT:
            self.unsupported[command.name] += 1
            return False
        return self.generation is not Generation.ONE


class DirectControl:
    """Controls joints that follow setpoints in their drivers, without a plan: MIT and high-follow.

    0x151 byte 3 = 0xAD puts the joints under their drivers' own loop. The code of MIT, the signs of
    its commands, the scale of its torques and the way out of it are those of the arm's firmware and
    model (`firmware_version`). The rest follows the worst reading of reports by single users that
    no text of the maker contradicts: every mode word that arrives while 0xAD is in force, or that
    brings it, voids the setpoints; each joint is limp, though powered, until its next one. That is
    a frame 0x15A–0x15F in MIT, a complete joint target in high-follow, and in the MOVE modes
    without 0xAD the next target of any kind, which the joints follow from where they have fallen
    to. Before S-V1.8-5 no target is accepted there: the arm stays limp until it is reset. A joint
    that is switched on in MIT or high-follow is limp until its setpoint, too.
    """

    def __init__(self, mechanics: Mechanics, condition: Condition, arm_type: ArmType) -> None:
        self._mechanics = mechanics
        self._condition = condition
        self._quirks = arm_type.quirks
        self._torque_scale = arm_type.mit_torque_scale

    def mode_word(self, signals: dict[str, float]) -> None:
        """Handles an accepted 0x151; its modes are in the condition already."""
        condition = self._condition
        was_direct = condition.direct
        condition.direct = (
            signals.get("MitMode") == MitMode.MIT
            and condition.control_mode is ControlMode.CAN_CONTROL
            and condition.move_mode in (self._quirks.mit_code, MoveMode.MOVE_J)
        )
        if condition.direct:
            condition.needs_reset = False
        elif was_direct:
            condition.needs_reset = not self._quirks.exits_by_mode_word
        if was_direct or condition.direct:
            self._mechanics.drop_setpoints(range(JOINT_COUNT))

    def take_frame(self, name: str, signals: dict[str, float]) -> bool:
        """Handles a frame 0x15A–0x15F; returns whether it was one. Outside MIT it has no effect."""
        if name not in NAMES:
            return False
        condition = self._condition
        if condition.direct and condition.move_mode == self._quirks.mit_code:
            self._set(NAMES.index(name), signals)
        return True

    def follow_target(self, target_deg: SixValues) -> None:
        """Passes a complete joint target of high-follow to the drivers."""
        for index, angle_deg in enumerate(target_deg):
            kp, kd = _FOLLOW_GAINS[index]
            setpoint = DriverSetpoint(angle_deg, kp=kp, kd=kd, carries_weight=True)
            self._mechanics.steer(index, setpoint)

    def power_on(self, indices: Iterable[int]) -> None:
        """Powers motors; in MIT and high-follow those that were off are limp."""
        if not self._condition.direct:
            self._mechanics.power_on(indices)
            return
        off = [index for index in indices if not self._mechanics.powered[index]]
        self._mechanics.power_on(off)
        self._mechanics.drop_setpoints(off)

    def _set(self, index: int, signals: dict[str, float]) -> None:
        sign = self._quirks.mit_signs[index]
        setpoint = DriverSetpoint(
            sign * math.degrees(signals["Position"]),
            sign * signals["Velocity"],
            signals["Kp"],
            signals["Kd"],
            sign * signals["Torque"] * self._torque_scale[index],
        )
        self._mechanics.steer(index, setpoint)


_JOINT_TARGETS: Final = ("JointTarget12", "JointTarget34", "JointTarget56")
_TOOL_TARGETS: Final = ("CartesianTarget1", "CartesianTarget2", "CartesianTarget3")


class Moves:
    """Collects targets of all kinds and has the newest carried out.

    Attributes:
        cpv: The control of single joints in CPV.
    """

    def __init__(
        self,
        mechanics: Mechanics,
        condition: Condition,
        settings: ArmSettingsRecord,
        kinematics: Kinematics,
        arm_type: ArmType,
        *,
        unsupported: Counter[str],
    ) -> None:
        """Handles the motions of one arm.

        Args:
            mechanics: Its joints.
            condition: Its modes.
            settings: The arm's settings.
            kinematics: The kinematics of its geometry.
            arm_type: The arm's type.
            unsupported: Counts commands that the arm understands but does not carry out.
        """
        self._mechanics = mechanics
        self._direct = DirectControl(mechanics, condition, arm_type)
        self.cpv = CpvControl(mechanics, condition, settings, arm_type.quirks, unsupported)
        self._executor = MotionExecutor(mechanics, condition, settings)
        self._joints = JointMoves(self._executor, condition, settings, self._direct.follow_target)
        self._tool = ToolMotions(self._executor, condition, settings, kinematics)
        self._takers: dict[str, Callable[[dict[str, float]], None]] = {
            **dict.fromkeys(_JOINT_TARGETS, self._take_joints),
            **dict.fromkeys(_TOOL_TARGETS, self._take_pose),
            "ArcPoint": self._take_arc_point,
        }
        executor = self._executor
        self._commands: dict[TrajectoryCommand, Callable[[], None]] = {
            TrajectoryCommand.PAUSE: executor.pause,
            TrajectoryCommand.CONTINUE: executor.go_on,
            TrajectoryCommand.CLEAR_CURRENT: self._abort,
            TrajectoryCommand.CLEAR_ALL: self._clear_all,
            TrajectoryCommand.ABORT: self._abort,
        }

    @property
    def targets_deg(self) -> SixValues:
        """The end of the last accepted target."""
        return self._executor.targets_deg

    @property
    def ik_solution_deg(self) -> SixValues | None:
        """The joint angles of the last pose of MOVE P; None before the first."""
        return self._tool.ik_solution_deg

    def take_frame(self, name: str, signals: dict[str, float]) -> bool:
        """Handles a frame that is part of a target; returns whether it was one."""
        taker = self._takers.get(name)
        if taker is None:
            return self._direct.take_frame(name, signals) or self.cpv.take_frame(name, signals)
        taker(signals)
        return True

    def command(self, command: TrajectoryCommand) -> bool:
        """Obeys 0x150 byte 1; returns whether it is a known command about motions.

        A pause holds back new targets too, until the motion is continued or cleared. The protocol
        text gives only the commands' names. Assumed: «abort» and «clear current» drop the motion in
        progress and an incomplete target; a complete target that waits for its mode (frames before
        0x151) is no motion yet, and only «clear all» drops it.
        """
        obey = self._commands.get(command)
        if obey is None:
            return False
        obey()
        return True

    def power_on(self, indices: Iterable[int]) -> None:
        """Powers motors (0–5)."""
        self._direct.power_on(indices)

    def mode_word(self, signals: dict[str, float]) -> None:
        """Handles a 0x151 whose modes and speed are in the condition already.

        It starts, ends or changes motions accordingly. It never resumes an aborted motion: the
        target is gone, and one of its three frames does not complete it either.
        """
        self._direct.mode_word(signals)
        self.cpv.mode_changed()
        self._executor.mode_changed()
        self._joints.mode_changed()
        self._tool.mode_changed(self._mechanics.positions_deg)

    def speed_changed(self) -> None:
        """Handles a 0x151 that keeps the modes."""
        self._executor.mode_changed()

    def abort_motion(self) -> None:
        """Brakes; the target counts as not reached. A waiting target goes on waiting."""
        self._executor.abort_motion()

    def drop_targets(self) -> None:
        """Drops every target, complete or incomplete; the caller stops the joints."""
        self._executor.drop_order()
        self._joints.drop_targets()
        self._tool.drop_poses()

    def time_passed(self) -> None:
        """Notes targets that have been reached."""
        self._executor.time_passed()

    def _abort(self) -> None:
        self._joints.drop_parts()
        self._tool.drop_parts()
        self._executor.abort_motion()

    def _clear_all(self) -> None:
        self.drop_targets()
        self._executor.abort_motion()

    def _take_joints(self, signals: dict[str, float]) -> None:
        self._joints.take_angles({int(name[1:]): angle_deg for name, angle_deg in signals.items()})

    def _take_pose(self, signals: dict[str, float]) -> None:
        self._tool.take_pose(signals, self._mechanics.positions_deg)

    def _take_arc_point(self, signals: dict[str, float]) -> None:
        self._tool.mark_arc_point(
            ArcPointNumber(int(signals["Point"])), self._mechanics.positions_deg
        )
