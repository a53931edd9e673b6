"""Draws lines over the picture, where its camera shows them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPen, QPolygonF

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from armui.viewport.palette import ScenePalette
    from armui.viewport.projection import Projection
    from armui.viewport.strokes import Stroke

_FILL_OPACITY: Final = 0.14
_HALO_OPACITY: Final = 0.7
_HALO_PX: Final = 2.0
_LABEL_GAP_PX: Final = 4.0


def paint_strokes(
    painter: QPainter, strokes: Iterable[Stroke], projection: Projection, palette: ScenePalette
) -> None:
    """Draw lines and surfaces, each line with a halo that sets it off from the arm."""
    painter.save()
    for stroke in strokes:
        pixels = [projection.pixel(place) for place in stroke.places]
        points = [QPointF(*pixel) for pixel in pixels if pixel is not None]
        if len(points) != len(pixels):
            continue
        line = QPolygonF(points)
        color = QColor(stroke.color)
        if stroke.filled:
            color.setAlphaF(_FILL_OPACITY)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(color)
            painter.drawPolygon(line)
            continue
        halo = QColor(palette.background)
        halo.setAlphaF(_HALO_OPACITY)
        for shade, width_px in ((halo, stroke.width_px + 2.0 * _HALO_PX), (color, stroke.width_px)):
            pen = QPen(shade, width_px)
            pen.setCapStyle(Qt.PenCapStyle.RoundCap)
            pen.setJoinStyle(Qt.PenJoinStyle.RoundJoin)
            painter.setPen(pen)
            painter.drawPolyline(line)
        if stroke.label and len(points) > 1:
            _label(painter, stroke.label, points[-2:], color, palette)
    painter.restore()


def paint_tag(
    painter: QPainter, at: QPointF, text: str, color: str, palette: ScenePalette
) -> QRectF:
    """Write a short text on a plate beside a place; returns the plate."""
    metrics = QFontMetricsF(painter.font())
    width = max(metrics.height(), metrics.horizontalAdvance(text) + 8.0)
    plate = QRectF(at.x(), at.y(), width, metrics.height())
    ground = QColor(palette.plate)
    ground.setAlphaF(0.88)
    painter.setPen(QPen(QColor(color), 1.0))
    painter.setBrush(ground)
    painter.drawRoundedRect(plate, 3.0, 3.0)
    painter.setPen(QColor(color))
    painter.drawText(plate, Qt.AlignmentFlag.AlignCenter, text)
    return plate


def _label(
    painter: QPainter, text: str, line: Sequence[QPointF], color: QColor, palette: ScenePalette
) -> None:
    """Write beyond the end of a line, so that it stands on neither."""
    before, end = line
    metrics = QFontMetricsF(painter.font())
    along = end - before
    length = max(1e-6, (along.x() ** 2 + along.y() ** 2) ** 0.5)
    size = metrics.boundingRect(text)
    reach = (size.width() + size.height()) / 4.0 + _LABEL_GAP_PX
    centre = end + along * (reach / length)
    place = QRectF(0.0, 0.0, size.width() + 6.0, metrics.height())
    place.moveCenter(centre)
    ground = QColor(palette.background)
    ground.setAlphaF(_HALO_OPACITY)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(ground)
    painter.drawRoundedRect(place, 3.0, 3.0)
    painter.setPen(color)
    painter.drawText(place, Qt.AlignmentFlag.AlignCenter, text)
