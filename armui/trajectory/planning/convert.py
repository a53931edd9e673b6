"""Converts points between joint angles and poses; these are in the base."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

from armui.arm.limits import JointLimits, check_joints
from armui.arm.refusal import Reason, Refusal
from armui.kinematics.arm_kinematics import Kinematics
from armui.kinematics.geometry import Geometry
from armui.kinematics.poses import Pose, apart
from armui.protocol.codes import MoveMode
from armui.trajectory.planning.user_frames import Frames, placed
from armui.trajectory.points.program import Waypoint

CONVERT_NEEDS_MIDDLE = Reason(
    "convert_needs_middle",
    "An arc needs a middle pose, which no conversion can know. Enter it by hand.",
)
CONVERT_OUT_OF_REACH = Reason(
    "convert_out_of_reach",
    "The arm does not reach X {x}  Y {y}  Z {z} mm with this orientation: no joint angles belong "
    "to it. Change the pose.",
)


_AS_WRITTEN: Final = 0.002
"""A pose within this error is the same: files and tables have 0.001 mm and 0.001°."""


def to_pose(
    point: Waypoint, kinematics: Kinematics, move: MoveMode = MoveMode.MOVE_P
) -> Waypoint | Refusal:
    """Return a point converted to the pose that its joint angles give the flange.

    Args:
        point: The point; one that holds a pose keeps it.
        kinematics: The arm's kinematics.
        move: MOVE_P or MOVE_L. Not MOVE_C: an arc needs a middle pose, which no conversion can
            give.
    """
    if move not in (MoveMode.MOVE_P, MoveMode.MOVE_L):
        return CONVERT_NEEDS_MIDDLE()
    if not point.is_joint:
        return replace(point, move=move, middle=None)
    pose = kinematics.forward(point.target)
    return replace(point, move=move, target=tuple(pose), middle=None)


def to_joints(
    point: Waypoint,
    kinematics: Kinematics,
    near_deg: Sequence[float],
    limits: Sequence[JointLimits] | None = None,
) -> Waypoint | Refusal:
    """Return a point converted to joint angles that bring the flange to its pose.

    Args:
        point: The point; one that holds joint angles stays as it is.
        kinematics: The arm's kinematics.
        near_deg: The solution nearest to these angles is taken.
        limits: If given, a solution within them is preferred to a nearer one beyond.
    """
    if point.is_joint:
        return point
    ways = kinematics.inverse(Pose(*point.target), near_deg)
    if not ways:
        x, y, z = point.target[:3]
        return CONVERT_OUT_OF_REACH(x=x, y=y, z=z)
    within = [way for way in ways if limits is None or check_joints(way, limits) is None]
    best = _neat((within or ways)[0], Pose(*point.target), kinematics)
    return replace(point, move=MoveMode.MOVE_J, target=best, middle=None)


def _neat(angles_deg: Sequence[float], pose: Pose, kinematics: Kinematics) -> tuple[float, ...]:
    """Return the roundest angles that give a pose as exactly as it is written: 55, not 54.999."""
    for decimals in range(3):
        neat_deg = tuple(round(angle, decimals) for angle in angles_deg)
        if max(apart(kinematics.forward(neat_deg), pose)) <= _AS_WRITTEN:
            return neat_deg
    return tuple(angles_deg)


def to_move(
    point: Waypoint,
    move: MoveMode,
    kinematics: Kinematics,
    near_deg: Sequence[float],
    before: Sequence[float],
) -> Waypoint | Refusal:
    """Return a point that reaches the same place by another kind of motion, or why there is none.

    Args:
        point: The point.
        move: The new kind of motion.
        kinematics: The arm's kinematics.
        near_deg: As in :func:`to_joints`.
        before: The pose in which an arc would begin. Its middle is set half-way from there, which
            makes no arc until the operator moves it.
    """
    if move is MoveMode.MOVE_J:
        return to_joints(point, kinematics, near_deg)
    if move is MoveMode.MOVE_C:
        if point.move is MoveMode.MOVE_C:
            return point
        target = to_pose(point, kinematics)
        if isinstance(target, Refusal):
            return target
        halves = ((a + b) / 2 for a, b in zip(before[:3], target.target[:3], strict=True))
        return replace(target, move=move, middle=(*halves, *target.target[3:]))
    return to_pose(point, kinematics, move)


@dataclass(frozen=True, slots=True)
class RowRefusal:
    """The reason why a row cannot be converted.

    Attributes:
        row: The row, from 0.
        refusal: The reason.
    """

    row: int
    refusal: Refusal


@dataclass(frozen=True, slots=True)
class Conversion:
    """The arm, frames and limits that a conversion of points depends on.

    Attributes:
        geometry: The arm's geometry.
        measured_deg: The joint angles before the first point.
        limits: The limits of the joints.
        frames: The user frames.
        frame: The frame that converted poses come into; "" for the base.
    """

    geometry: Geometry
    measured_deg: Sequence[float]
    limits: Sequence[JointLimits]
    frames: Frames
    frame: str


def converted(
    points: Sequence[Waypoint], rows: Sequence[int], by: Conversion
) -> dict[int, Waypoint] | RowRefusal:
    """Return rows by their numbers with joint angles for their poses, and poses for their angles.

    The joint angles of a row are those nearest to the last ones above it.
    """
    model = Kinematics(by.geometry)
    wanted, near_deg = frozenset(rows), by.measured_deg
    changed: dict[int, Waypoint] = {}
    for row, point in enumerate(points):
        near_deg = point.target if point.is_joint else near_deg
        if row not in wanted:
            continue
        result = placed(point, "", by.frames)
        if isinstance(result, Waypoint):
            result = (
                to_pose(result, model)
                if result.is_joint
                else to_joints(result, model, near_deg, by.limits)
            )
        if isinstance(result, Waypoint):
            result = placed(result, by.frame, by.frames)
        if isinstance(result, Refusal):
            return RowRefusal(row, result)
        changed[row] = result
    return changed


def joints_above(
    points: Sequence[Waypoint], row: int, measured_deg: Sequence[float]
) -> Sequence[float]:
    """Return the joint angles near which the arm comes to a row.

    Args:
        points: The points of the trajectory.
        row: The row, from 0.
        measured_deg: The joint angles before the first point.

    Returns:
        Those of this row or the nearest one above that holds some, else the measured ones.
    """
    above = points[row::-1] if row < len(points) else points[::-1]
    return next((point.target for point in above if point.is_joint), measured_deg)


def pose_of(point: Waypoint, kinematics: Kinematics) -> Pose:
    """Return the pose of the flange at a point whose place is in the base."""
    return kinematics.forward(point.target) if point.is_joint else Pose(*point.target)
