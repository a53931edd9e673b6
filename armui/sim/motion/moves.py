"""All motion by frames: targets of every kind, arcs, and the commands of 0x150 about them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable
from typing import Final

from armui.kinematics.arm_kinematics import Kinematics
from armui.protocol.codec import Codec
from armui.protocol.codes import ArcPointNumber, TrajectoryCommand
from armui.protocol.frame import Frame
from armui.sim.arm_type import ArmType
from armui.sim.condition import Condition
from armui.sim.mechanics.mechanics import Mechanics
from armui.sim.mechanics.powered_joints import SixValues
from armui.sim.motion.cpv import CpvControl
from armui.sim.motion.joint_moves import JointMoves
from armui.sim.motion.mit import DirectControl
from armui.sim.motion.motion_executor import MotionExecutor
from armui.sim.motion.tool_moves import ToolMotions
from armui.sim.parameters.settings import ArmSettingsRecord

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
        self._joints = JointMoves(self._executor, condition, settings, self._direct.follow)
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

    @property
    def paused(self) -> bool:
        """Whether the host has paused the motion."""
        return self._executor.paused

    def take(self, name: str, signals: dict[str, float]) -> bool:
        """Takes a frame that is part of a target; whether it was one."""
        taker = self._takers.get(name)
        if taker is None:
            return self._direct.take(name, signals) or self.cpv.take(name, signals)
        taker(signals)
        return True

    def answers(self, codec: Codec) -> list[Frame]:
        """What the frame that was taken last asks to be told."""
        return self.cpv.answers(codec)

    def command(self, command: TrajectoryCommand) -> bool:
        """Obeys 0x150 byte 1; whether it is a command about motions the arm knows.

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

    def cut_short(self) -> None:
        """Brakes; the target counts as not reached. One that waits goes on waiting."""
        self._executor.cut_short()

    def forget(self) -> None:
        """Drops every target, whole or in parts; what moves is left to the caller."""
        self._executor.forget()
        self._joints.forget()
        self._tool.forget()

    def time_passed(self) -> None:
        """Advances in time: notes the targets that have been reached."""
        self._executor.time_passed()

    def _abort(self) -> None:
        self._joints.drop_parts()
        self._tool.drop_parts()
        self._executor.cut_short()

    def _clear_all(self) -> None:
        self.forget()
        self._executor.cut_short()

    def _take_joints(self, signals: dict[str, float]) -> None:
        self._joints.take({int(name[1:]): angle_deg for name, angle_deg in signals.items()})

    def _take_pose(self, signals: dict[str, float]) -> None:
        self._tool.take(signals, self._mechanics.positions_deg)

    def _take_arc_point(self, signals: dict[str, float]) -> None:
        self._tool.mark(ArcPointNumber(int(signals["Point"])), self._mechanics.positions_deg)
