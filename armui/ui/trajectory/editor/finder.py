"""Finding in the points of a trajectory, and replacing what was found."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from armui.arm.refusal import Refusal
from armui.trajectory.points import edits

if TYPE_CHECKING:
    from armui.trajectory.points.program import Waypoint
    from armui.ui.trajectory.editor.document import Document
    from armui.ui.trajectory.editor.find_bar import FindBar
    from armui.ui.trajectory.editor.points_table import PointsTable


class Finder(QObject):
    """Does what the bar asks for.

    Args:
        document: Whose points.
        table: Shows the row that is found.
        bar: Says what is sought.
    """

    def __init__(self, document: Document, table: PointsTable, bar: FindBar) -> None:
        super().__init__(bar)
        self._document, self._table, self._bar = document, table, bar
        bar.next_wanted.connect(self._find)
        bar.replace_wanted.connect(self._replace)

    def _find(self, by: int) -> None:
        rows = self._bar.found(self._document.points)
        if isinstance(rows, Refusal):
            self._bar.show_refusal(rows)
            return
        if not rows:
            self._bar.show_result(self.tr("Not found"))
            return
        here = self._table.current_row()
        ahead = [row for row in rows if row > here] if by > 0 else [r for r in rows if r < here]
        row = (ahead or rows)[0 if by > 0 else -1]
        self._table.select_row(row)
        self._bar.show_result(
            self.tr("{place} of {count}").format(place=rows.index(row) + 1, count=len(rows))
        )

    def _replace(self, everywhere: bool) -> None:
        points = self._document.points
        rows = self._bar.found(points)
        if not isinstance(rows, Refusal) and not everywhere:
            rows = [row for row in rows if row == self._table.current_row()]
        changed: dict[int, Waypoint] = {}
        for row in [] if isinstance(rows, Refusal) else rows:
            point = self._bar.replaced(points[row])
            if isinstance(point, Refusal):
                rows = point
                break
            changed[row] = point
        if isinstance(rows, Refusal):
            self._bar.show_refusal(rows)
            return
        self._document.edit(edits.change(points, changed), self.tr("Replace"))
        if everywhere:
            self._bar.show_result(self.tr("{count} replaced").format(count=len(changed)))
        else:
            self._find(1)
