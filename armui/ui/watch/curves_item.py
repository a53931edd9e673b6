"""The item of a plot that draws all its curves and the cursors."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

import pyqtgraph as pg
from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QBrush, QColor, QPen, QPolygonF

if TYPE_CHECKING:
    from PySide6.QtGui import QPainter

CURSOR_NAMES: Final = ("A", "B")
_NAME_PX: Final = 4.0


@dataclass(frozen=True, slots=True)
class DrawnCurve:
    """One curve.

    Attributes:
        color: As ``#rrggbb``.
        pieces: The drawable pieces, over monotonic times.
    """

    color: str
    pieces: Sequence[QPolygonF]


@dataclass(frozen=True, slots=True)
class Missing:
    """A time whose curves are not loaded yet.

    Attributes:
        begin_s, end_s: Monotonic times.
        text: The text on it.
    """

    begin_s: float
    end_s: float
    text: str


polygon = pg.functions.arrayToQPolygonF
"""Converts times and figures to a polygon, which Qt draws fastest."""


def thin_pen(color: str) -> QPen:
    """Return a pen of one pixel at any scale, which Qt draws faster than wider ones."""
    pen = QPen(QColor(color), 1.0)
    pen.setCosmetic(True)
    return pen


class CurvesItem(pg.GraphicsObject):  # type: ignore[misc]
    """Draws lines over monotonic times; the axis shows seconds from its edge."""

    def __init__(self) -> None:
        super().__init__()
        self._curves: Sequence[tuple[QPen, Sequence[QPolygonF]]] = ()
        self._edge_s = 0.0
        self._bounds = QRectF(0, 0, 1, 1)
        self._cursors: Sequence[float | None] = ()
        self._cursor_pen = thin_pen("#808080")
        self._grid_pen = thin_pen("#808080")
        self._grid: list[QLineF] = []
        self._missing: Missing | None = None
        self._missing_brush = QBrush()
        self._pens: dict[str, QPen] = {}
        self.setFlag(self.GraphicsItemFlag.ItemUsesExtendedStyleOption, enabled=False)

    def show_curves(self, curves: Sequence[DrawnCurve], edge_s: float) -> None:
        """Set the curves; the axis' zero is a monotonic time."""
        self._curves = [(self._pen(each.color), each.pieces) for each in curves]
        self._edge_s = edge_s
        self.update()

    def show_cursors(self, at_s: Sequence[float | None], color: str) -> None:
        """Set the cursors, vertical lines at monotonic times."""
        self._cursors = tuple(at_s)
        self._cursor_pen = self._pen(color)
        self.update()

    def show_missing(self, missing: Missing | None, color: str) -> None:
        """Hatch a time whose curves are not loaded yet."""
        if missing != self._missing:
            self._missing = missing
            self._missing_brush = QBrush(QColor(color), Qt.BrushStyle.BDiagPattern)
            self.update()

    def show_grid(
        self, times_s: Sequence[float], figures: Sequence[float], color: str | None = None
    ) -> None:
        """Set the grid lines at times and figures of the axes."""
        bounds = self._bounds
        self._grid = [QLineF(at, bounds.top(), at, bounds.bottom()) for at in times_s]
        self._grid += [QLineF(bounds.left(), at, bounds.right(), at) for at in figures]
        if color is not None:
            self._grid_pen = self._pen(color)
        self.update()

    def _pen(self, color: str) -> QPen:
        if color not in self._pens:
            self._pens[color] = thin_pen(color)
        return self._pens[color]

    def set_bounds(self, bounds: QRectF) -> None:
        """Set the extent of the plot."""
        if bounds != self._bounds:
            self.prepareGeometryChange()
            self._bounds = bounds

    def boundingRect(self) -> QRectF:  # noqa: N802 - the name Qt calls
        """Return the extent of the plot."""
        return self._bounds

    def paint(self, painter: QPainter, *_args: Any) -> None:
        """Draw curves, grid and cursors."""
        painter.save()
        painter.setPen(self._grid_pen)
        painter.drawLines(self._grid)
        self._paint_missing(painter)
        painter.translate(-self._edge_s, 0.0)
        for pen, pieces in self._curves:
            painter.setPen(pen)
            for piece in pieces:
                painter.drawPolyline(piece)
        painter.setPen(self._cursor_pen)
        bounds = self._bounds
        for at_s in self._cursors:
            if at_s is not None:
                painter.drawLine(QLineF(at_s, bounds.top(), at_s, bounds.bottom()))
        to_view = painter.worldTransform()
        painter.resetTransform()
        for name, at_s in zip(CURSOR_NAMES, self._cursors, strict=False):
            if at_s is not None:
                # figures grow upwards: the upper end is the rectangle's bottom
                top = to_view.map(QPointF(at_s, bounds.bottom()))
                place = top + QPointF(_NAME_PX, painter.fontMetrics().ascent())
                painter.drawText(place, name)
        painter.restore()

    def _paint_missing(self, painter: QPainter) -> None:
        missing, bounds = self._missing, self._bounds
        if missing is None:
            return
        begin_s = max(missing.begin_s - self._edge_s, bounds.left())
        end_s = min(missing.end_s - self._edge_s, bounds.right())
        if end_s <= begin_s:
            return
        place = QRectF(begin_s, bounds.top(), end_s - begin_s, bounds.height())
        to_view = painter.worldTransform()
        on_screen = to_view.mapRect(place)
        painter.save()
        painter.resetTransform()
        painter.fillRect(on_screen, self._missing_brush)
        painter.setPen(self._cursor_pen)
        painter.drawText(on_screen, Qt.AlignmentFlag.AlignCenter, missing.text)
        painter.restore()
