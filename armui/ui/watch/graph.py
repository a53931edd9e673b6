"""The axes, the mouse and the curves' item of one plot."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Final

import pyqtgraph as pg
from PySide6.QtCore import QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QColor, QPen
from PySide6.QtWidgets import QGraphicsGridLayout, QGraphicsRectItem, QWidget

from armui.ui.watch.curve_shapes import AutoHeight
from armui.ui.watch.curves_item import CurvesItem
from armui.ui.watch.time_axis import FigureAxis, TimeAxis

if TYPE_CHECKING:
    from collections.abc import Sequence

    from armui.ui.theme import Colors
    from armui.ui.watch.curve_shapes import Extent
    from armui.ui.watch.time_frame import Range, Shown

AXIS_PX: Final = 76
"""The width of figures and unit at the left, the same in every plot, so that their times align."""
_TIMES_PX: Final = 5

_GRAB_PX: Final = 6.0
_FLAT_PX: Final = 12.0
"""A frame drawn lower than this selects only the time."""
_WHEEL_STEP: Final = 1.25


class TimeViewBox(pg.ViewBox):  # type: ignore[misc]
    """Emits the mouse's gestures, and never changes its range itself.

    Signals:
        framed: A frame was drawn: begin and end on the axis, and a range of figures or ``None``.
        turned: The wheel: by which factor longer, and where on the axis.
        turned_height: The wheel over the figures: by which factor, and at which figure.
        panned: By how many seconds.
        cursor_dragged: The cursor, and its new place on the axis.
        clicked: The place on the axis.
        drag_finished: The gesture is over.
    """

    framed = Signal(float, float, object)
    turned = Signal(float, float)
    turned_height = Signal(float, float)
    panned = Signal(float)
    cursor_dragged = Signal(int, float)
    clicked = Signal(float)
    drag_finished = Signal()

    def __init__(self) -> None:
        super().__init__(enableMenu=False)
        self.disableAutoRange()
        self.setDefaultPadding(0.0)
        self.cursors: Sequence[float | None] = ()
        self._dragged: int | None = None
        self._frame = QGraphicsRectItem(self)
        self._frame.setZValue(1e6)
        self._frame.hide()

    def set_frame_color(self, color: str) -> None:
        """Set the colour of the zoom frame."""
        pen = QPen(QColor(color))
        pen.setCosmetic(True)
        self._frame.setPen(pen)
        filled = QColor(color)
        filled.setAlpha(40)
        self._frame.setBrush(filled)

    def mouseDragEvent(self, ev: Any, axis: int | None = None) -> None:
        """Draw a frame, move a cursor, or with the middle button or shift pan."""
        if axis is not None or ev.button() == Qt.MouseButton.RightButton:
            ev.ignore()
            return
        ev.accept()
        moves = ev.button() == Qt.MouseButton.MiddleButton or (
            ev.modifiers() & Qt.KeyboardModifier.ShiftModifier
        )
        if ev.isStart():
            self._dragged = None if moves else self._cursor_at(ev.buttonDownPos())
        if self._dragged is not None:
            self.cursor_dragged.emit(self._dragged, self.mapToView(ev.pos()).x())
        elif moves:
            self.panned.emit(self.mapToView(ev.lastPos()).x() - self.mapToView(ev.pos()).x())
        else:
            self._draw_frame(ev)
        if ev.isFinish():
            self._dragged = None
            self.drag_finished.emit()

    def _draw_frame(self, ev: Any) -> None:
        corners = QRectF(QPointF(ev.buttonDownPos()), QPointF(ev.pos())).normalized()
        flat = corners.height() < _FLAT_PX
        if flat:
            corners.setTop(self.rect().top())
            corners.setBottom(self.rect().bottom())
        corners = corners.intersected(self.rect())
        self._frame.setRect(corners)
        self._frame.setVisible(not ev.isFinish())
        if ev.isFinish():
            first, last = self.mapToView(corners.topLeft()), self.mapToView(corners.bottomRight())
            heights = None if flat else (last.y(), first.y())
            self.framed.emit(first.x(), last.x(), heights)

    def mouseClickEvent(self, ev: Any) -> None:
        """Emit the place of a left click; the window handles the right button."""
        if ev.button() == Qt.MouseButton.LeftButton:
            ev.accept()
            self.clicked.emit(self.mapToView(ev.pos()).x())
        else:
            ev.ignore()

    def wheelEvent(self, ev: Any, axis: int | None = None) -> None:
        """Zoom the time; over the figures, or with control, the height."""
        ev.accept()
        if not ev.delta():
            return
        factor = _WHEEL_STEP ** (-ev.delta() / 120.0)
        at = self.mapToView(ev.pos())
        if axis == 1 or ev.modifiers() & Qt.KeyboardModifier.ControlModifier:
            self.turned_height.emit(factor, at.y())
        else:
            self.turned.emit(factor, at.x())

    def _cursor_at(self, place: QPointF) -> int | None:
        per_px = self.viewRect().width() / max(self.rect().width(), 1.0)
        at_s = self.mapToView(place).x()
        near = [
            (abs(cursor - at_s), number)
            for number, cursor in enumerate(self.cursors)
            if cursor is not None and abs(cursor - at_s) <= _GRAB_PX * per_px
        ]
        return min(near)[1] if near else None


class Graph(pg.GraphicsView):  # type: ignore[misc]
    """The curves of one unit in a plot.

    Args:
        unit: The unit on its axis; "" for codes and bare numbers.

    Attributes:
        unit: As given.
        box: The box that handles the mouse.
        curves: The item that draws the curves.
        heights: The range of figures shown.
    """

    def __init__(self, unit: str = "", parent: QWidget | None = None) -> None:
        super().__init__(parent, useOpenGL=False, background="#ffffff")
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.NoContextMenu)
        self.setAcceptDrops(False)
        self.viewport().setAcceptDrops(False)
        self.box = TimeViewBox()
        self.curves = CurvesItem()
        self.box.addItem(self.curves, ignoreBounds=True)
        self.unit = unit
        self.heights: Range = (0.0, 1.0)
        self._height = AutoHeight(unit)
        self._figures = FigureAxis(unit)
        self._times = TimeAxis()
        self._figures.linkToView(self.box)
        self._times.linkToView(self.box)
        self._figures.setWidth(AXIS_PX)
        self._times.setHeight(_TIMES_PX)
        layout = QGraphicsGridLayout()
        layout.setContentsMargins(0, 7, 10, 2)
        layout.setSpacing(0)
        layout.addItem(self._figures, 0, 0)
        layout.addItem(self.box, 0, 1)
        layout.addItem(self._times, 1, 1)
        self.centralWidget.setLayout(layout)
        self._range = (0.0, 1.0, 0.0, 1.0)
        self._grid_color = "#808080"

    @property
    def width_px(self) -> int:
        """The width of the time axis in pixels."""
        width: float = self.box.rect().width() or self.width() - AXIS_PX
        return max(1, round(width))

    def set_colors(self, colors: Colors) -> None:
        """Apply the colours of a theme."""
        for axis in (self._figures, self._times):
            axis.setPen(colors.border)
            axis.setTextPen(colors.muted)
            axis.setTickPen(colors.faint)
            axis.setTickFont(self.font())
        self.setBackground(colors.surface)
        self._grid_color = colors.sunken
        self._draw_grid()
        self.box.set_frame_color(colors.accent)

    def show_heights(self, shown: Shown, zoomed: Range | None, extent: Extent | None) -> None:
        """Set the time range, and the figures' range: the zoomed one, or that of the curves."""
        self.heights = zoomed or self._height.fit(extent, codes=not self.unit)
        self._show_range(shown.begin_s, shown.end_s, *self.heights)

    def _show_range(self, begin_s: float, end_s: float, low: float, high: float) -> None:
        wanted = (begin_s, end_s, low, high)
        if wanted == self._range or not all(map(math.isfinite, wanted)):
            return
        self._range = wanted
        self.box.setRange(xRange=(begin_s, end_s), yRange=(low, high), padding=0.0)
        self.curves.set_bounds(QRectF(begin_s, low, end_s - begin_s, high - low))
        self._draw_grid()

    def _draw_grid(self) -> None:
        """Draw the grid as opaque lines: pyqtgraph's own, half transparent, takes 7 ms a plot."""
        begin_s, end_s, low, high = self._range
        rect = self.box.rect()
        self.curves.show_grid(
            _ticks(self._times, begin_s, end_s, rect.width()),
            _ticks(self._figures, low, high, rect.height()),
            self._grid_color,
        )

    def resizeEvent(self, ev: Any) -> None:
        """Update the grid, because the ticks have changed."""
        super().resizeEvent(ev)
        if hasattr(self, "_grid_color"):  # pyqtgraph resizes it in its constructor
            self._draw_grid()


def _ticks(axis: pg.AxisItem, low: float, high: float, length_px: float) -> list[float]:
    """Return the figures at which an axis has labelled ticks."""
    if length_px <= 0.0:
        return []
    levels = axis.tickValues(low, high, length_px)
    return [float(value) for value in levels[0][1]] if levels else []
