"""Points in user frames of a cell, and the same places in the base: only those an arm is told."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Final

import numpy as np

from armui.arm.refusal import Reason, Refusal
from armui.kinematics.poses import Matrix, pose_to_matrix, rows_to_pose
from armui.trajectory.points.program import Values, Waypoint, check_point

if TYPE_CHECKING:
    from armui.cell.cell import Cell
    from armui.trajectory.points.edits import Points

POINT_FRAME_UNKNOWN = Reason(
    "point_frame_unknown",
    "The cell has no user frame “{name}”, which the point is in. Choose the cell that has it, or "
    "make a frame of this name under Cell.",
)

Frames = Mapping[str, Values]
"""The poses of a cell's user frames in the base, by name."""
RowsOrRefusal = dict[int, Waypoint] | Refusal
"""Changed points by their rows, or why nothing is changed."""

_DECIMALS: Final = 6
"""The decimals of figures worked out for a frame: to a nanometre, and no longer than needed."""


def frames_of(cell: Cell | None) -> Frames:
    """Return the user frames of a cell."""
    return {} if cell is None else {frame.name: frame.pose for frame in cell.all_frames}


def why_unknown(points: Sequence[Waypoint], frames: Frames) -> Refusal | None:
    """Return why points have no place in the base, or ``None`` if all frames are known."""
    names = (point.frame for point in points if point.frame and point.frame not in frames)
    name = next(names, None)
    return None if name is None else POINT_FRAME_UNKNOWN(name=name)


def in_base(points: Points, frames: Frames) -> Points:
    """Return points with their places in the base; those that are there already stay as they are.

    Raises:
        KeyError: A frame is not known.
    """
    rows = [row for row, point in enumerate(points) if point.frame]
    if not rows:
        return points
    placed = [points[row] for row in rows]
    known = {name: pose_to_matrix(frames[name]) for name in {point.frame for point in placed}}
    ways = np.array([known[point.frame] for point in placed])
    targets = _carried(ways, [point.target for point in placed])
    middles = _carried(ways, [point.middle or point.target for point in placed])
    result = list(points)
    for row, point, target, middle in zip(rows, placed, targets, middles, strict=True):
        passed = None if point.middle is None else middle
        result[row] = replace(point, target=target, middle=passed, frame="")
    return tuple(result)


def in_frame(point: Waypoint, name: str, frames: Frames) -> Waypoint:
    """Return a point with the same place in another frame, its figures rounded.

    Args:
        point: The point; joint angles belong to no frame and stay.
        name: The frame; "" for the base.
        frames: All frames.

    Raises:
        KeyError: A frame is not known.
    """
    if point.is_joint or point.frame == name:
        return point
    (based,) = in_base((point,), frames)
    middle = None if based.middle is None else pose_in_frame(based.middle, name, frames)
    return replace(
        based, target=pose_in_frame(based.target, name, frames), middle=middle, frame=name
    )


def reframed(points: Points, rows: Sequence[int], name: str, frames: Frames) -> RowsOrRefusal:
    """Return rows of points with another frame, by row, or why one cannot have it.

    Each keeps its place; where the frame it was in is not known, its figures.

    Args:
        points: All points.
        rows: The rows.
        name: The frame; "" for the base.
        frames: All frames.
    """
    changed: dict[int, Waypoint] = {}
    for row in rows:
        point = points[row]
        if point.frame and point.frame not in frames:
            point = replace(point, frame=name)
            refusal = check_point(point)
            if refusal is not None:
                return refusal
        else:
            moved = placed(point, name, frames)
            if isinstance(moved, Refusal):
                return moved
            point = moved
        changed[row] = point
    return changed


def placed(point: Waypoint, name: str, frames: Frames) -> Waypoint | Refusal:
    """Return the same place in another frame, or why where it is is not known."""
    if point.is_joint or point.frame == name:
        return point
    return why_unknown((point, replace(point, frame=name)), frames) or in_frame(point, name, frames)


def pose_in_frame(pose: Sequence[float], name: str, frames: Frames) -> Values:
    """Return a pose of the base in a frame, rounded; "" is the base.

    Raises:
        KeyError: The frame is not known.
    """
    if name:
        frame = pose_to_matrix(frames[name])
        pose = rows_to_pose(np.linalg.solve(frame, pose_to_matrix(pose))[:3].ravel().tolist())
    return tuple(round(value, _DECIMALS) + 0.0 for value in pose)


def _carried(ways: Matrix, poses: Sequence[Values]) -> list[Values]:
    """Return (n, 6) poses, each moved by its 4×4 transform."""
    rows = (ways @ pose_to_matrix(np.array(poses)))[:, :3].reshape(-1, 12)
    return [tuple(rows_to_pose(each)) for each in rows.tolist()]
