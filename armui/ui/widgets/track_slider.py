"""A slider for a requested value, with a mark for the measured value on the same track."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QPointF, QRectF, QSignalBlocker, QSize, Qt
from PySide6.QtGui import QColor, QMouseEvent, QPainter, QPaintEvent, QPen, QPolygonF, QWheelEvent
from PySide6.QtWidgets import QSizePolicy, QSlider

from armui.ui.theme import Colors, colors_of
from armui.ui.widgets import painting

_HANDLE_PX: Final = 7.0
_MARK_PX: Final = 5.0
_EDGE_PX: Final = _HANDLE_PX + 2
_GROOVE_PX: Final = 4.0


class TrackSlider(QSlider):
    """A horizontal slider whose handle is the requested value and whose mark is the measured one.

    The slider counts in whole steps, as Qt's sliders do; a step is ``resolution`` of the quantity's
    unit. An unknown value has no handle, or no mark.

    Args:
        resolution: The size of one step of the slider.
        origin: The beginning of the coloured part of the track; ``None`` for the mark.
        marked: True if there is room for a mark below the track.
        jumps: True if a click beside the handle moves it there; otherwise it moves by a page, for
            quantities that take effect at once.
    """

    def __init__(
        self,
        resolution: float,
        *,
        origin: float | None = None,
        marked: bool = False,
        jumps: bool = True,
    ) -> None:
        super().__init__(Qt.Orientation.Horizontal)
        self._resolution = resolution
        self._origin = origin
        self._above_middle_px = _MARK_PX - 2 if marked else 0.0
        self._jumps = jumps
        self._grabbed_at: float | None = None
        self._requested_known = True
        self._attention = False
        self._measured: float | None = None
        self._mark_px: float | None = None
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)

    # -- values -------------------------------------------------------------------------------

    @property
    def requested(self) -> float:
        """The value of the handle in the quantity's unit."""
        return self.sliderPosition() * self._resolution

    @property
    def measured(self) -> float | None:
        """The value of the mark."""
        return self._measured

    def set_limits(self, minimum: float, maximum: float) -> None:
        """Set the ends of the track without emitting a signal."""
        with QSignalBlocker(self):
            self.setRange(round(minimum / self._resolution), round(maximum / self._resolution))
        self._mark_px = self._place(self._measured)
        self.update()

    def show_requested(self, value: float | None, *, attention: bool = False) -> None:
        """Set the handle without emitting a signal; ``None`` removes it.

        Args:
            value: The value in the quantity's unit; beyond the track it is at the end.
            attention: True to draw it in the colour of attention.
        """
        before = self._requested_known, self._attention
        self._requested_known = value is not None
        self._attention = attention
        if value is not None:
            with QSignalBlocker(self):
                self.setValue(round(self._steps(value)))  # this repaints if the handle moves
        if before != (self._requested_known, self._attention):
            self.update()

    def show_measured(self, value: float | None) -> None:
        """Set the mark; repaints only if it moves on the screen."""
        self._measured = value
        place = self._place(value)
        if place != self._mark_px:
            self._mark_px = place
            self.update()

    # -- geometry -----------------------------------------------------------------------------

    def sizeHint(self) -> QSize:
        """Return the preferred size."""
        return QSize(160, 24)

    def minimumSizeHint(self) -> QSize:
        """Return the smallest size."""
        return QSize(60, 24)

    def _place(self, value: float | None) -> float | None:
        """Return a value's place on the track, rounded to half pixels: finer is not visible."""
        if value is None or self.maximum() == self.minimum():
            return None
        share = (self._steps(value) - self.minimum()) / (self.maximum() - self.minimum())
        return round(2 * (_EDGE_PX + share * (self.width() - 2 * _EDGE_PX))) / 2

    def _steps(self, value: float) -> float:
        """Return a value in steps, limited to the track: Qt rejects larger integers."""
        return min(max(value / self._resolution, self.minimum()), self.maximum())

    def _value_at(self, x: float) -> int:
        share = (x - _EDGE_PX) / max(1.0, self.width() - 2 * _EDGE_PX)
        share = min(max(share, 0.0), 1.0)
        return round(self.minimum() + share * (self.maximum() - self.minimum()))

    # -- input --------------------------------------------------------------------------------

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Grab the handle, or move it to the click."""
        if event.button() is not Qt.MouseButton.LeftButton:
            event.ignore()
            return
        x = event.position().x()
        handle = self._place(self.requested) if self._requested_known else None
        if handle is not None and abs(x - handle) <= _HANDLE_PX + 2:
            self._grabbed_at = x - handle
        elif self._jumps:
            self._grabbed_at = 0.0
            self._requested_known = True
            self.setValue(self._value_at(x))
        else:
            step = self.pageStep() if handle is None or x > handle else -self.pageStep()
            self.setValue(self.value() + step)
            return
        self.setSliderDown(True)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Drag the handle."""
        if self._grabbed_at is not None:
            self.setSliderPosition(self._value_at(event.position().x() - self._grabbed_at))

    def mouseReleaseEvent(self, _event: QMouseEvent) -> None:
        """Release the handle."""
        if self._grabbed_at is not None:
            self._grabbed_at = None
            self.setSliderDown(False)

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Use the wheel only if the slider has the focus, not merely under the pointer."""
        if self.hasFocus():
            super().wheelEvent(event)
        else:
            event.ignore()

    # -- picture ------------------------------------------------------------------------------

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the slider."""
        colors = colors_of(self)
        painter = painting.begin(self)
        middle = self.height() / 2 - self._above_middle_px
        self._mark_px = self._place(self._measured)
        handle = self._place(self.requested) if self._requested_known else None
        self._draw_track(painter, colors, middle, handle)
        if self._mark_px is not None:
            self._draw_mark(painter, colors, QPointF(self._mark_px, middle))
        if handle is not None:
            self._draw_handle(painter, colors, QPointF(handle, middle))
        painter.end()

    def _draw_track(
        self, painter: QPainter, colors: Colors, middle: float, handle: float | None
    ) -> None:
        top = middle - _GROOVE_PX / 2
        groove = QRectF(_EDGE_PX, top, self.width() - 2 * _EDGE_PX, _GROOVE_PX)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(colors.border if self.isEnabled() else colors.sunken))
        painter.drawRoundedRect(groove, _GROOVE_PX / 2, _GROOVE_PX / 2)
        start = self._mark_px if self._origin is None else self._place(self._origin)
        if handle is None or start is None or not self.isEnabled():
            return
        painter.setBrush(QColor(colors.warn if self._attention else colors.accent))
        way = QRectF(min(start, handle), top, abs(handle - start), _GROOVE_PX)
        painter.drawRoundedRect(way, _GROOVE_PX / 2, _GROOVE_PX / 2)

    def _draw_mark(self, painter: QPainter, colors: Colors, center: QPointF) -> None:
        """Draw a tick on the track, and a pointer below, where the handle doesn't cover it."""
        color = QColor(colors.text if self.isEnabled() else colors.faint)
        painter.setPen(QPen(color, 2))
        painter.drawLine(center - QPointF(0, _GROOVE_PX), center + QPointF(0, _GROOVE_PX))
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(color)
        tip = center + QPointF(0, _HANDLE_PX)
        foot = QPointF(_MARK_PX * 0.9, 0)
        down = QPointF(0, _MARK_PX)
        painter.drawPolygon(QPolygonF([tip, tip + down + foot, tip + down - foot]))

    def _draw_handle(self, painter: QPainter, colors: Colors, center: QPointF) -> None:
        color = QColor(colors.warn if self._attention else colors.accent)
        if not self.isEnabled():
            color = QColor(colors.faint)
        if self.hasFocus():
            halo = QColor(color)
            halo.setAlpha(70)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(halo)
            painter.drawEllipse(center, _HANDLE_PX + 2.5, _HANDLE_PX + 2.5)
        painter.setPen(QPen(color, 2))
        painter.setBrush(color if self.isSliderDown() else QColor(colors.surface))
        painter.drawEllipse(center, _HANDLE_PX - 1, _HANDLE_PX - 1)
