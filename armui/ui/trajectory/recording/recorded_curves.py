"""The recorded angles over time, with a handle at either end of the part to be kept."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QPainter, QPen, QPolygonF
from PySide6.QtWidgets import QSizePolicy, QWidget

from armui.ui import format as fmt
from armui.ui.theme import colors_of, curve_colors
from armui.ui.widgets import painting
from armui.ui.widgets.translated import Translated

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray
    from PySide6.QtGui import QMouseEvent, QPaintEvent, QResizeEvent

    from armui.trajectory.samples.recording import Recording

_HEIGHT_PX: Final = 150
_GRIP_PX: Final = 7.0
_NEAR_PX: Final = 14.0
_PAD_PX: Final = 8.0
_GAP_PX: Final = 14.0
_LEAST_SPAN_DEG: Final = 1.0
"""The least height of a curve: a joint that stands still is a line in the middle."""
_LEAST_S: Final = 0.001


def drawn_curves(recording: Recording, width_px: int) -> tuple[NDArray[np.float64], ...]:
    """Return for each joint (n, 2) times and angles, no more than can be seen.

    If there are more samples than pixels, the smallest and the largest angle of each pixel are
    drawn, so that no peak is lost.

    Args:
        recording: Samples over time.
        width_px: The width of the curve.
    """
    times_s, angles_deg = recording.times_s, recording.joints_deg
    if len(times_s) <= 2 * max(width_px, 1):
        return tuple(np.column_stack((times_s, angles)) for angles in angles_deg.T)
    pixel = (times_s - times_s[0]) * (width_px / max(recording.duration_s, _LEAST_S))
    firsts = np.flatnonzero(np.diff(np.floor(pixel), prepend=-1.0))
    at_s = np.repeat(times_s[firsts], 2)
    curves = []
    for angles in angles_deg.T:
        low, high = np.minimum.reduceat(angles, firsts), np.maximum.reduceat(angles, firsts)
        curves.append(np.column_stack((at_s, np.column_stack((low, high)).ravel())))
    return tuple(curves)


class RecordedCurves(Translated, QWidget):
    """Curves with two handles; a press elsewhere moves the nearer one there.

    Signals:
        trimmed: The beginning and the end of the kept part in s, and the one of them that is
            dragged.
    """

    trimmed = Signal(float, float, float)

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("recorded_curves")
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMinimumHeight(_HEIGHT_PX)
        self.setMouseTracking(True)
        self._recording: Recording | None = None
        self._grows = False
        self._from_s, self._to_s = 0.0, 0.0
        self._dragged: int | None = None
        self._curves: tuple[NDArray[np.float64], ...] = ()
        self._low_deg, self._high_deg = 0.0, 0.0
        self.retranslate_ui()

    def show_recording(self, recording: Recording | None, *, grows: bool = False) -> None:
        """Show another recording, all of it kept, or none with ``None``.

        Args:
            recording: The recording.
            grows: True while it is being made: it has no handles yet.
        """
        self._grows = grows
        self._recording = recording if recording is not None and len(recording.samples) else None
        self._dragged = None
        if self._recording is not None:
            angles_deg = self._recording.joints_deg
            self._low_deg, self._high_deg = float(angles_deg.min()), float(angles_deg.max())
            spare = max(0.0, _LEAST_SPAN_DEG - (self._high_deg - self._low_deg)) / 2.0
            self._low_deg, self._high_deg = self._low_deg - spare, self._high_deg + spare
            self._from_s, self._to_s = 0.0, self._recording.duration_s
        self._make_curves()

    def show_range(self, from_s: float, to_s: float) -> None:
        """Show the kept part, in s, clipped to the recording."""
        if self._recording is not None and self._dragged is None:
            whole_s = self._recording.duration_s
            self._from_s, self._to_s = (min(max(each, 0.0), whole_s) for each in (from_s, to_s))
            self.update()

    def sizeHint(self) -> QSize:
        """Return the preferred size."""
        return QSize(400, 2 * _HEIGHT_PX)

    def place_px(self, at_s: float) -> float:
        """Return the x coordinate of a time, in pixels."""
        box, whole_s = self._box(), self._whole_s
        return box.left() + at_s / whole_s * box.width()

    def _time_at(self, x_px: float) -> float:
        box = self._box()
        share = (x_px - box.left()) / max(box.width(), 1.0)
        return min(max(share, 0.0), 1.0) * self._whole_s

    @property
    def _whole_s(self) -> float:
        return max(_LEAST_S, 0.0 if self._recording is None else self._recording.duration_s)

    def _box(self) -> QRectF:
        """Return the area of the curves: below their names, above the times."""
        line_px = self.fontMetrics().height()
        left = self.fontMetrics().horizontalAdvance("-000.0°") + _PAD_PX
        return QRectF(
            left,
            line_px + 2 * _PAD_PX,
            max(1.0, self.width() - left - _GRIP_PX - _PAD_PX),
            max(1.0, self.height() - 2 * line_px - 4 * _PAD_PX),
        )

    def _make_curves(self) -> None:
        recording = self._recording
        width_px = round(self._box().width())
        self._curves = () if recording is None else drawn_curves(recording, width_px)
        self.update()

    # The operator -----------------------------------------------------------------------------

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Grab the nearer handle."""
        if event.button() != Qt.MouseButton.LeftButton or self._recording is None or self._grows:
            return
        x_px = event.position().x()
        away_px = [abs(x_px - self.place_px(each)) for each in (self._from_s, self._to_s)]
        at_the_left = x_px < self.place_px(self._from_s)
        self._dragged = 0 if away_px[0] < away_px[1] or at_the_left else 1
        self._drag(x_px)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Drag the grabbed handle; over one the pointer's shape changes."""
        x_px = event.position().x()
        if self._dragged is not None:
            self._drag(x_px)
            return
        fixed = self._recording is None or self._grows
        ends_s = () if fixed else (self._from_s, self._to_s)
        near = any(abs(x_px - self.place_px(each)) < _NEAR_PX for each in ends_s)
        self.setCursor(Qt.CursorShape.SizeHorCursor if near else Qt.CursorShape.ArrowCursor)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Release the handle."""
        if event.button() == Qt.MouseButton.LeftButton:
            self._dragged = None

    def _drag(self, x_px: float) -> None:
        at_s = round(self._time_at(x_px), 3)
        if self._dragged == 0:
            self._from_s = at_s = min(at_s, self._to_s)
        else:
            self._to_s = at_s = max(at_s, self._from_s)
        self.update()
        self.trimmed.emit(self._from_s, self._to_s, at_s)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Compute the curves again for the new width."""
        super().resizeEvent(event)
        self._make_curves()

    # Drawing ----------------------------------------------------------------------------------

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw curves, omitted parts, and handles."""
        colors = colors_of(self)
        painter = painting.begin(self)
        painting.panel(painter, QRectF(self.rect()), colors.surface, colors.border)
        box = self._box()
        if self._recording is None:
            painter.setPen(QColor(colors.muted))
            painter.drawText(box, Qt.AlignmentFlag.AlignCenter, self._nothing)
        else:
            self._draw_axes(painter, box)
            self._draw_curves(painter, box)
            if not self._grows:
                self._draw_ends(painter, box)
        painter.end()

    def _draw_axes(self, painter: QPainter, box: QRectF) -> None:
        colors = colors_of(self)
        line_px = float(self.fontMetrics().height())
        painter.setPen(QColor(colors.muted))
        right = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        for angle_deg, y_px in ((self._high_deg, box.top()), (self._low_deg, box.bottom())):
            place = QRectF(0.0, y_px - line_px / 2, box.left() - 4.0, line_px)
            painter.drawText(place, right, f"{angle_deg:.1f}°")
        painter.setPen(QColor(colors.border))
        for y_px in (box.top(), box.center().y(), box.bottom()):
            painter.drawLine(QPointF(box.left(), y_px), QPointF(box.right(), y_px))

    def _draw_curves(self, painter: QPainter, box: QRectF) -> None:
        names_px = box.left()
        metrics = self.fontMetrics()
        scale = np.array(
            (box.width() / self._whole_s, -box.height() / (self._high_deg - self._low_deg))
        )
        origin = np.array((0.0, self._high_deg))
        begin = np.array((box.left(), box.top()))
        for joint, (curve, color) in enumerate(
            zip(self._curves, curve_colors(self), strict=False), 1
        ):
            painter.setPen(QPen(QColor(color), 1.5))
            name = f"J{joint}"
            painter.drawText(QPointF(names_px, _PAD_PX + metrics.ascent()), name)
            names_px += metrics.horizontalAdvance(name) + _GAP_PX
            places = (curve - origin) * scale + begin
            painter.drawPolyline(QPolygonF([QPointF(x, y) for x, y in places.tolist()]))

    def _draw_ends(self, painter: QPainter, box: QRectF) -> None:
        """Shade what is left out, and draw a handle with its time at either end."""
        colors = colors_of(self)
        veil = QColor(colors.sunken)
        veil.setAlphaF(0.8)
        from_px, to_px = self.place_px(self._from_s), self.place_px(self._to_s)
        painter.fillRect(QRectF(box.left(), box.top(), from_px - box.left(), box.height()), veil)
        painter.fillRect(QRectF(to_px, box.top(), box.right() - to_px, box.height()), veil)
        metrics = self.fontMetrics()
        ends: Sequence[tuple[float, float, bool]] = (
            (from_px, self._from_s, False),
            (to_px, self._to_s, True),
        )
        for x_px, at_s, last in ends:
            painter.setPen(QPen(QColor(colors.accent), 2.0))
            painter.drawLine(QPointF(x_px, box.top()), QPointF(x_px, box.bottom()))
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(QColor(colors.accent))
            painter.drawEllipse(QPointF(x_px, box.center().y()), _GRIP_PX, _GRIP_PX)
            text = f"{fmt.number(at_s, 3)} s"
            width_px = metrics.horizontalAdvance(text)
            left_px = x_px - width_px if last else x_px
            left_px = min(max(left_px, 4.0), self.width() - width_px - 4.0)
            painter.setPen(QColor(colors.text))
            painter.drawText(QPointF(left_px, box.bottom() + _PAD_PX + metrics.ascent()), text)

    # Texts ------------------------------------------------------------------------------------

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._nothing = self.tr("What is recorded appears here")
        self.setAccessibleName(self.tr("Recorded angles of the joints"))
        self.setToolTip(self.tr("Drag the handles: what lies between them is kept"))
        self.update()

    def _recolor(self) -> None:
        self.update()
