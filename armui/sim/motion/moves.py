"""All motion by frames: targets of every kind, arcs, setpoints, and the commands of 0x150."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Iterable
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

    def obey(self, signals: dict[str, float]) -> bool:
        """Obeys one command and return whether it asks for an answer."""
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
        self._moves.drop_targets()
        self._teaching.interrupt()

    def _teach(self, command: TeachingState) -> None:
        if command is TeachingState.START_RECORDING:
            self._moves.drop_targets()
        self._teaching.command(command)

    def _trajectory(self, command: TrajectoryCommand) -> bool:
        if command is TrajectoryCommand.OFF or self._moves.command(command):
            return False
        if command is not TrajectoryCommand.GET_CURRENT:
            self._unsupported[command.name] += 1
            return False
        return self._generation is not Generation.ONE


NAMES: Final = tuple(f"MitControl{joint}" for joint in JOINTS)
"""The frames 0x15A–0x15F, joint 1 first."""

_FOLLOW_GAINS: Final = ((50.0, 2.5),) * 3 + ((20.0, 1.0),) * 3
"""kp and kd of high-follow, which are not published: with the simulated arm's friction they lag a
triangle of 1.2 rad/s by 0.089 rad, as a user measured."""


class DirectControl:
    """Joints that follow setpoints in their drivers, without a plan: MIT and high-follow.

    0x151 byte 3 = 0xAD hands the joints to their drivers' own loop. The code of MIT, the signs of
    its commands, the scale of its torques and the way out of it are those of the arm's firmware and
    model (`firmware_version`). The rest follows reports of single users that no text of the maker
    denies, in their worst reading: every mode word that arrives while 0xAD is in force, or that
    brings it, voids the setpoints; each joint is limp, though powered, until its next one. That is
    a frame 0x15A–0x15F in MIT, a complete joint target in high-follow, and in the MOVE modes
    without 0xAD the next target of any kind, which the joints take up from where they have fallen
    to. Before S-V1.8-5 no target is taken up there: the arm stays limp until it is reset. A joint
    that is switched on in MIT or high-follow is limp until its setpoint, too.
    """

    def __init__(self, mechanics: Mechanics, condition: Condition, arm_type: ArmType) -> None:
        self._mechanics = mechanics
        self._condition = condition
        self._quirks = arm_type.quirks
        self._torque_scale = arm_type.mit_torque_scale

    def mode_word(self, signals: dict[str, float]) -> None:
        """Takes a 0x151 that the arm has accepted; its modes are in the condition already."""
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
            self._mechanics.let_go(range(JOINT_COUNT))

    def take_frame(self, name: str, signals: dict[str, float]) -> bool:
        """Takes a frame 0x15A–0x15F; whether it was one. Outside MIT it does nothing."""
        if name not in NAMES:
            return False
        condition = self._condition
        if condition.direct and condition.move_mode == self._quirks.mit_code:
            self._set(NAMES.index(name), signals)
        return True

    def follow_target(self, target_deg: SixValues) -> None:
        """Hands a complete joint target of high-follow to the drivers."""
        for index, angle_deg in enumerate(target_deg):
            kp, kd = _FOLLOW_GAINS[index]
            setpoint = DriverSetpoint(angle_deg, kp=kp, kd=kd, carries_weight=True)
            self._mechanics.steer(index, setpoint)

    def power_on(self, indices: Iterable[int]) -> None:
        """Powers motors; in MIT and high-follow those that had none are limp."""
        if not self._condition.direct:
            self._mechanics.power_on(indices)
            return
        off = [index for index in indices if not self._mechanics.powered[index]]
        self._mechanics.power_on(off)
        self._mechanics.let_go(off)

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
        cpv: What each joint is told for itself in CPV.
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
        """Moves one arm.

        Args:
            mechanics: Its joints.
            condition: Its modes.
            settings: What it keeps.
            kinematics: Of its geometry.
            arm_type: Which arm it is.
            unsupported: Counts what the arm understands but does not do.
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
        """Where the last target taken on leads."""
        return self._executor.targets_deg

    @property
    def ik_solution_deg(self) -> SixValues | None:
        """Where the last pose of MOVE P leads the joints; None before the first."""
        return self._tool.ik_solution_deg

    def take_frame(self, name: str, signals: dict[str, float]) -> bool:
        """Takes a frame that is part of a target and return whether it was one."""
        taker = self._takers.get(name)
        if taker is None:
            return self._direct.take_frame(name, signals) or self.cpv.take_frame(name, signals)
        taker(signals)
        return True

    def command(self, command: TrajectoryCommand) -> bool:
        """Obeys 0x150 byte 1 and return whether it is a command about motions the arm knows.

        A pause holds back new targets too, until the motion is continued or cleared. The protocol
        text says no more than the names of the commands. Assumed: «abort» and «clear current» drop
        the motion under way and what has come of the next target's frames; a complete target that
        waits for its mode (frames before 0x151) is no motion yet, and only «clear all» drops it.
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
        """Takes a 0x151 whose modes and speed are in the condition already.

        It starts, ends or changes motions as they now ask. It brings back nothing that was cut
        short: an aborted target is gone, and one frame of its three does not complete it either.
        """
        self._direct.mode_word(signals)
        self.cpv.mode_changed()
        self._executor.mode_changed()
        self._joints.mode_changed()
        self._tool.mode_changed(self._mechanics.positions_deg)

    def speed_changed(self) -> None:
        """Takes a 0x151 that keeps the modes."""
        self._executor.mode_changed()

    def abort_motion(self) -> None:
        """Brakes; the target counts as not reached. One that waits goes on waiting."""
        self._executor.abort_motion()

    def drop_targets(self) -> None:
        """Drops every target, whole or in parts; what moves is left to the caller."""
        self._executor.drop_order()
        self._joints.drop_targets()
        self._tool.drop_poses()

    def time_passed(self) -> None:
        """Advances in time: notes the targets that have been reached."""
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
