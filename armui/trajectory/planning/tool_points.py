"""Poses of points as they are shown and typed: those of the tool in force.

A point keeps the pose of the flange, which is what the arm is told: another tool changes the
figures that are shown, never where the arm goes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

import numpy as np

from armui.cell.tools import NO_TOOL
from armui.kinematics.poses import Matrix, flange_matrix, pose_to_matrix, rows_to_pose, tool_matrix
from armui.trajectory.points.edits import FigureQuery
from armui.trajectory.points.program import POSE_NAMES, Values, Waypoint

_TURNS: Final = 3
"""The index at which the angles of a pose begin."""
_SHOWN_DECIMALS: Final = 6
KEPT_DECIMALS: Final = 9
"""The decimals of poses that are kept: enough to show figures as they were typed, for any tool."""


class ToolPoints:
    """Shows points for one tool, and turns what was typed into the poses that they keep.

    Args:
        tool: The tool centre point in the flange, mm and degrees; zeros for the flange itself.
        decimals: The decimals of what is shown.
    """

    def __init__(self, tool: Values = NO_TOOL, decimals: int = _SHOWN_DECIMALS) -> None:
        self.tool = tool
        self._decimals = decimals
        self._shown: dict[Values, Values] = {}  # by the flange's pose; as typed, if it was

    @property
    def is_flange(self) -> bool:
        """True without a tool: points are shown as they are kept."""
        return not any(self.tool)

    def shown(self, point: Waypoint) -> Waypoint:
        """Return a point with target and middle as poses of the tool, in the point's own frame."""
        return self.all_shown((point,))[0]

    def all_shown(self, points: Sequence[Waypoint]) -> Sequence[Waypoint]:
        """Return points likewise, many at once."""
        if self.is_flange:
            return points
        poses = {each for point in points if not point.is_joint for each in _poses(point)}
        new = list(poses.difference(self._shown))
        if new:
            tips = tool_matrix(pose_to_matrix(np.array(new)), self.tool)
            self._shown.update(zip(new, _figures(tips, self._decimals), strict=True))
        return [self._turned(point, self._shown) for point in points]

    def kept(self, shown: Waypoint, before: Waypoint | None = None) -> Waypoint:
        """Return a point whose poses were typed as it is kept: with those of the flange.

        Args:
            shown: The point with poses of the tool.
            before: The point as it was kept; poses of it that still show the same stay.
        """
        return self.all_kept((shown,), () if before is None else (before,))[0]

    def all_kept(
        self, shown: Sequence[Waypoint], before: Sequence[Waypoint] = ()
    ) -> Sequence[Waypoint]:
        """Return points likewise, many at once."""
        if self.is_flange:
            return shown
        old = (each for point in before if not point.is_joint for each in _poses(point))
        known = {self._shown[each]: each for each in old if each in self._shown}
        poses = {each for point in shown if not point.is_joint for each in _poses(point)}
        new = list(poses.difference(known))
        if new:
            flanges = flange_matrix(pose_to_matrix(np.array(new)), self.tool)
            known.update(zip(new, _figures(flanges, KEPT_DECIMALS), strict=True))
            self._shown.update((known[each], each) for each in new)
        return [self._turned(point, known) for point in shown]

    def rows_showing(self, points: Sequence[Waypoint], query: FigureQuery) -> list[int]:
        """Return the rows whose target shows a figure, without working out what each row shows."""
        place = POSE_NAMES.index(query.field)
        rows = [row for row, point in enumerate(points) if not point.is_joint]
        if not rows:
            return []
        targets = [points[row].target for row in rows]
        tips = tool_matrix(pose_to_matrix(np.array(targets)), self.tool)
        if place < _TURNS:
            figures = tips[:, place, 3]
        else:
            x, y, z = tips[:, :3, 0].T
            turns = (
                lambda: np.arctan2(tips[:, 2, 1], tips[:, 2, 2]),
                lambda: np.arctan2(-z, np.hypot(x, y)),
                lambda: np.arctan2(y, x),
            )
            figures = np.degrees(turns[place - _TURNS]())
        found = np.abs(figures.round(_SHOWN_DECIMALS) - query.value) <= query.tolerance
        for index, target in enumerate(targets):
            shown = self._shown.get(target)  # it may have been typed in another notation
            if shown is not None:
                found[index] = abs(shown[place] - query.value) <= query.tolerance
        return [rows[index] for index in np.flatnonzero(found)]

    @staticmethod
    def _turned(point: Waypoint, by: dict[Values, Values]) -> Waypoint:
        if point.is_joint:
            return point
        middle = None if point.middle is None else by[point.middle]
        return replace(point, target=by[point.target], middle=middle)


def rounded(point: Waypoint) -> Waypoint:
    """Return a point computed from figures with more decimals, rounded to those that are shown."""
    if point.is_joint:
        return point
    target, *middle = (
        tuple(round(value, _SHOWN_DECIMALS) + 0.0 for value in pose) for pose in _poses(point)
    )
    return replace(point, target=target, middle=middle[0] if middle else None)


def _poses(point: Waypoint) -> Sequence[Values]:
    return (point.target,) if point.middle is None else (point.target, point.middle)


def _figures(poses: Matrix, decimals: int) -> list[Values]:
    rows = poses[:, :3].reshape(-1, 12).tolist()
    return [tuple(round(value, decimals) + 0.0 for value in rows_to_pose(each)) for each in rows]
