"""MOVE P, L and C: from the frames of a pose to a motion of the tool."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from typing import Final

from armui.kinematics.arm_kinematics import Kinematics
from armui.kinematics.poses import Pose, pose_to_matrix
from armui.kinematics.tool_path import Arc, ArcError, Line
from armui.protocol.codes import ArcPointNumber, ArmStatusCode, MoveMode
from armui.sim.condition import Condition
from armui.sim.mechanics.powered_joints import SixValues
from armui.sim.motion.motion_executor import Leg, MotionExecutor, beyond_limits
from armui.sim.motion.tool_plan import PathMotion, PlanningError, plan
from armui.sim.parameters.settings import ArmSettingsRecord

_PARTS: Final = 3
_POSE_MODES: Final = (MoveMode.MOVE_P, MoveMode.MOVE_L)
_ARC_POINTS: Final = (ArcPointNumber.START, ArcPointNumber.MIDDLE, ArcPointNumber.END)

_NO_WAY_MM: Final = 1e-6
_NO_TURN_DEG: Final = 1e-6
"""A smaller turn is no path: the tool is there already."""

Order = tuple[MoveMode, tuple[Pose, ...]]


class ToolMotions:
    """Collects the frames of poses, and has the tool moved to them.

    A complete pose waits until the arm is in CAN control and MOVE P or L; then it starts at once
    and replaces the one before. A pose that 0x158 marks is a point of an arc and no target; three
    of them wait for MOVE C. As with joint targets, nothing is kept for an arm that cannot move.

    Attributes:
        ik_solution_deg: The joint angles of the last pose of MOVE P; None before the first.
    """

    def __init__(
        self,
        executor: MotionExecutor,
        condition: Condition,
        settings: ArmSettingsRecord,
        kinematics: Kinematics,
    ) -> None:
        self._executor = executor
        self._condition = condition
        self._settings = settings
        self._kinematics = kinematics
        self._staged: dict[str, float] = {}
        self._fresh: set[frozenset[str]] = set()
        self._latest: Pose | None = None
        self._waiting: Pose | None = None
        self._arc: dict[ArcPointNumber, Pose] = {}
        self.ik_solution_deg: SixValues | None = None

    def take_pose(self, values: Mapping[str, float], joints_deg: SixValues) -> None:
        """Receives one frame of a pose.

        Args:
            values: The values by signal: X, Y, Z in mm, RX, RY, RZ in degrees.
            joints_deg: The present joint angles.
        """
        if not self._executor.may_move:
            return
        self._staged.update(values)
        self._fresh.add(frozenset(values))
        if len(self._fresh) == _PARTS:
            self._fresh.clear()
            self._latest = self._waiting = Pose(
                *(self._staged[name] for name in ("X", "Y", "Z", "RX", "RY", "RZ"))
            )
            self.mode_changed(joints_deg)

    def mark_arc_point(self, point: ArcPointNumber, joints_deg: SixValues) -> None:
        """Makes the last pose a point of an arc; a first point begins a new arc."""
        pose = self._latest
        if point is ArcPointNumber.NONE or pose is None:
            return
        if any(self._executor.pursues((mode, (pose,))) for mode in _POSE_MODES):
            self._executor.abort_motion()
        self._latest = self._waiting = None
        if point is ArcPointNumber.START:
            self._arc.clear()
        self._arc[point] = pose
        self.mode_changed(joints_deg)

    def mode_changed(self, joints_deg: SixValues) -> None:
        """Starts a waiting motion, if the mode is right for it."""
        condition = self._condition
        if self._waiting is not None and condition.obeys(*_POSE_MODES):
            pose, self._waiting = self._waiting, None
            self._pursue((condition.move_mode, (pose,)), joints_deg)
        elif len(self._arc) == len(_ARC_POINTS) and condition.obeys(MoveMode.MOVE_C):
            points = tuple(self._arc[point] for point in _ARC_POINTS)
            self._arc.clear()
            self._pursue((MoveMode.MOVE_C, points), joints_deg)

    def drop_poses(self) -> None:
        """Drops every pose, complete or incomplete, and every point of an arc."""
        self.drop_parts()
        self._latest = self._waiting = None
        self._arc.clear()

    def drop_parts(self) -> None:
        """Drops the frames of an incomplete pose."""
        self._fresh.clear()

    def _pursue(self, order: Order, joints_deg: SixValues) -> None:
        """Takes on an order, or refuses it and stays."""
        if self._executor.serves(order):
            return
        move_mode, poses = order
        try:
            end_deg = self._nearest(poses[-1], joints_deg)
            if move_mode is MoveMode.MOVE_P:
                self.ik_solution_deg = end_deg
            legs: list[Leg]
            if move_mode is MoveMode.MOVE_P:
                legs = [end_deg]
            elif move_mode is MoveMode.MOVE_L:
                legs = [partial(self._line, poses[0])]
            else:
                start_deg = self._nearest(poses[0], joints_deg)
                arc = self._arc_from(start_deg, poses)
                legs, end_deg = [start_deg, arc], arc.end_deg
        except PlanningError as planning_error:
            self._executor.refuse(order, planning_error)
            return
        self._executor.begin(order, legs, move_mode, end_deg)

    def _nearest(self, pose: Pose, joints_deg: SixValues) -> SixValues:
        """Return the nearest way to a pose within the joints' limits.

        Raises:
            PlanningError: None of the ways is within them, or there is none at all.
        """
        solutions = self._kinematics.inverse(pose, joints_deg)
        if not solutions:
            raise PlanningError(ArmStatusCode.NO_SOLUTION)
        for solution in solutions:
            if not any(beyond_limits(solution, self._settings)):
                return solution
        beyond = beyond_limits(solutions[0], self._settings)
        raise PlanningError(ArmStatusCode.TARGET_BEYOND_LIMIT, beyond)

    def _line(self, pose: Pose, joints_deg: SixValues) -> PathMotion | None:
        link = Line(self._kinematics.matrix(joints_deg), pose_to_matrix(pose))
        if link.length_mm < _NO_WAY_MM and link.angle_deg < _NO_TURN_DEG:
            return None
        return plan(self._kinematics, link, joints_deg, self._settings)

    def _arc_from(self, start_deg: SixValues, poses: tuple[Pose, ...]) -> PathMotion:
        start, middle, end = map(pose_to_matrix, poses)
        try:
            arc = Arc(start, middle, end)
        except ArcError:
            raise PlanningError(ArmStatusCode.NO_SOLUTION) from None
        return plan(self._kinematics, arc, start_deg, self._settings)
