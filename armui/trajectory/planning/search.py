"""Finds and replaces in points as they are shown: in their notes, or in one figure."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from armui.arm.limits import JointLimits
from armui.arm.refusal import Refusal
from armui.trajectory.planning.tool_points import ToolPoints
from armui.trajectory.planning.user_frames import RowsOrRefusal
from armui.trajectory.points import edits
from armui.trajectory.points.cells import VALUES, PointColumn, edited, figure
from armui.trajectory.points.program import POSE_NAMES, Waypoint, check_point

NOTE: Final = "note"
_COLUMNS: Final = {"speed": PointColumn.SPEED, "dwell": PointColumn.DWELL}


@dataclass(frozen=True, slots=True)
class Search:
    """A search for a text or a figure, and what takes its place.

    Attributes:
        field: "note", or the name of a figure as of `edits.FigureQuery`.
        wanted: The text or figure to find, as it was typed.
        by: The text or figure that replaces it, as it was typed.
        limits: As for `armui.trajectory.points.cells.edited`.
    """

    field: str
    wanted: str
    by: str = ""
    limits: Sequence[JointLimits] = ()

    def rows(self, points: Sequence[Waypoint], tool: ToolPoints) -> list[int] | Refusal:
        """Return the rows that match as they are shown, or why nothing can be searched."""
        if self.field == NOTE:
            return list(edits.find_text(points, self.wanted)) if self.wanted else []
        value = figure(self.field, self.wanted, far=True)
        if isinstance(value, Refusal):
            return value
        query = edits.FigureQuery(self.field, value)
        if self.field in POSE_NAMES and not tool.is_flange:
            return tool.rows_showing(points, query)
        return list(edits.find_figure(points, query))

    def replaced(
        self, points: Sequence[Waypoint], rows: Sequence[int], tool: ToolPoints
    ) -> RowsOrRefusal:
        """Return matching rows with their text or figure replaced, or why one cannot be."""
        before = [points[row] for row in rows]
        shown: list[Waypoint] = []
        for point in tool.all_shown(before):
            changed = self._replaced(point)
            if isinstance(changed, Refusal):
                return changed
            shown.append(changed)
        kept = tool.all_kept(shown, before)
        refusal = next(filter(None, map(check_point, kept)), None)
        return refusal or dict(zip(rows, kept, strict=True))

    def _replaced(self, point: Waypoint) -> Waypoint | Refusal:
        if self.field == NOTE:
            return edits.replace_text(point, self.wanted, self.by)
        column = _COLUMNS.get(self.field) or PointColumn(VALUES[point.names.index(self.field)])
        return edited(point, column, self.by, self.limits)


def replaced_everywhere(
    search: Search, points: Sequence[Waypoint], tool: ToolPoints
) -> RowsOrRefusal:
    """Return all rows that match with their text or figure replaced, or why one cannot be."""
    rows = search.rows(points, tool)
    return rows if isinstance(rows, Refusal) else search.replaced(points, rows, tool)
