"""The same point the other way: joint angles as a pose, a pose as joint angles."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from armui.arm.limits import JointLimits, check_joints
from armui.arm.refusal import Reason, Refusal
from armui.kinematics.arm_kinematics import Kinematics
from armui.kinematics.poses import Pose
from armui.protocol.codes import MoveMode
from armui.trajectory.points.program import Waypoint

CONVERT_NEEDS_MIDDLE = Reason(
    "convert_needs_middle",
    "An arc needs a middle pose, which no conversion can know. Enter it by hand.",
)
CONVERT_OUT_OF_REACH = Reason(
    "convert_out_of_reach",
    "The arm cannot bring its flange to X {x}  Y {y}  Z {z} mm with this orientation: no joint "
    "angles belong to it. Change the pose.",
)


def to_pose(
    point: Waypoint, kinematics: Kinematics, move: MoveMode = MoveMode.MOVE_P
) -> Waypoint | Refusal:
    """Return a point by the pose its joint angles give the flange.

    Args:
        point: The point; one that holds a pose keeps it.
        kinematics: Of the arm.
        move: MOVE_P or MOVE_L. An arc needs a middle that no conversion can know.
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
    """Return a point by joint angles that bring the flange to its pose.

    Args:
        point: The point; one that holds joint angles stays as it is.
        kinematics: Of the arm.
        near_deg: Of several ways the one nearest to these angles is taken.
        limits: Where given, a way within them goes before a nearer one beyond.
    """
    if point.is_joint:
        return point
    ways = kinematics.inverse(Pose(*point.target), near_deg)
    if not ways:
        x, y, z = point.target[:3]
        return CONVERT_OUT_OF_REACH(x=x, y=y, z=z)
    within = [way for way in ways if limits is None or check_joints(way, limits) is None]
    best = (within or ways)[0]
    return replace(point, move=MoveMode.MOVE_J, target=tuple(best), middle=None)


def to_move(
    point: Waypoint,
    move: MoveMode,
    kinematics: Kinematics,
    near_deg: Sequence[float],
    before: Sequence[float],
) -> Waypoint | Refusal:
    """The same place reached by another kind of motion.

    Args:
        point: The point.
        move: How it shall be reached.
        kinematics: Of the arm.
        near_deg: As in :func:`to_joints`.
        before: The pose an arc would begin in. Its middle becomes half-way from there, which is
            no arc until the operator moves it.
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


def comes_from(
    points: Sequence[Waypoint], row: int, kinematics: Kinematics, measured_deg: Sequence[float]
) -> tuple[Sequence[float], Pose]:
    """Return where the arm is about to come from when it moves to a row.

    Args:
        points: Of the trajectory.
        row: Which, from 0.
        kinematics: Of the arm.
        measured_deg: Where the arm is before the first point.

    Returns:
        Joint angles: those of the nearest row above, or this one, that has some, else the measured
        ones. The pose of the row above, else the measured one.
    """
    above = points[row::-1] if row < len(points) else points[::-1]
    near_deg = next((point.target for point in above if point.is_joint), measured_deg)
    if row == 0:
        return near_deg, kinematics.forward(measured_deg)
    last = points[row - 1]
    return near_deg, kinematics.forward(last.target) if last.is_joint else Pose(*last.target)
