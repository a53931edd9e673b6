"""Draws lines over the picture, projected by its camera."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QPoint, QPointF, QRectF, Qt
from PySide6.QtGui import (
    QColor,
    QFont,
    QFontMetricsF,
    QPainter,
    QPen,
    QPixmap,
    QPolygonF,
    QStaticText,
)

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

    from armui.viewport.palette import ScenePalette
    from armui.viewport.projection import Projection
    from armui.viewport.strokes import Stroke

_FILL_OPACITY: Final = 0.14
_HALO_OPACITY: Final = 0.7
_HALO_PX: Final = 2.0
_LABEL_GAP_PX: Final = 4.0
_RIM_PX: Final = 80.0
"""The largest distance of a label from its line."""


class KeptLayer:
    """Caches an image of the last drawing."""

    def __init__(self) -> None:
        self._key: object = None
        self._image: QPixmap | None = None
        self._place = QPoint()

    def paint(
        self,
        painter: QPainter,
        key: object,
        room: Callable[[], QRectF],
        draw: Callable[[QPainter], object],
    ) -> None:
        """Paint the layer, drawing it again if its key has changed.

        Args:
            painter: The painter of the widget.
            key: All that the drawing depends on, beside font and pixels of the painter.
            room: Returns the rectangle it covers; called only after a change.
            draw: Draws it; called only after a change.
        """
        wanted = (key, painter.device().devicePixelRatio(), painter.font())
        if wanted != self._key:
            self._key = wanted
            frame = room().toAlignedRect()
            self._image = None
            if not frame.isEmpty():
                self._place = frame.topLeft()
                ratio = painter.device().devicePixelRatio()
                self._image = QPixmap(frame.size() * ratio)
                self._image.setDevicePixelRatio(ratio)
                self._image.fill(Qt.GlobalColor.transparent)
                own = QPainter(self._image)
                own.setRenderHints(painter.renderHints())
                own.setFont(painter.font())
                own.translate(-frame.topLeft())
                draw(own)
                own.end()
        if self._image is not None:
            painter.drawPixmap(self._place, self._image)


class StrokePainter:
    """Draws lines and surfaces, each line with a halo that sets it off from the arm.

    It paints with every picture while the arm moves, so pens and label sizes are cached.
    """

    def __init__(self) -> None:
        self._pens: dict[tuple[str, float, float], QPen] = {}
        self._font: QFont | None = None
        self._labels: dict[str, QStaticText] = {}
        self._label_height_px = 0.0

    def paint(
        self,
        painter: QPainter,
        strokes: Iterable[Stroke],
        projection: Projection,
        palette: ScenePalette,
    ) -> None:
        """Draw strokes through the camera; one that is partly behind the eye is left out."""
        painter.save()
        for stroke in strokes:
            pixels = [projection.pixel(place) for place in stroke.places]
            points = [QPointF(*pixel) for pixel in pixels if pixel is not None]
            if len(points) != len(pixels):
                continue
            if stroke.filled:
                color = QColor(stroke.color)
                color.setAlphaF(_FILL_OPACITY)
                painter.setPen(Qt.PenStyle.NoPen)
                painter.setBrush(color)
                painter.drawPolygon(points)
                continue
            halo_px = stroke.width_px + 2.0 * _HALO_PX
            for pen in (
                self._pen(palette.background, _HALO_OPACITY, halo_px),
                self._pen(stroke.color, 1.0, stroke.width_px),
            ):
                painter.setPen(pen)
                painter.drawPolyline(points)
            if stroke.label and len(points) > 1:
                self._label(painter, stroke, points[-2:], projection, palette)
        painter.restore()

    def _pen(self, color: str, opacity: float, width_px: float) -> QPen:
        key = (color, opacity, width_px)
        pen = self._pens.get(key)
        if pen is None:
            shade = QColor(color)
            shade.setAlphaF(opacity)
            pen = self._pens[key] = QPen(shade, width_px)
            pen.setCapStyle(Qt.PenCapStyle.RoundCap)
            pen.setJoinStyle(Qt.PenJoinStyle.RoundJoin)
        return pen

    def _label(
        self,
        painter: QPainter,
        stroke: Stroke,
        line: Sequence[QPointF],
        projection: Projection,
        palette: ScenePalette,
    ) -> None:
        """Write a label beyond the end of a line and clear of it, if its end is visible."""
        before, end = line
        if not _whole(projection).contains(end):
            return
        text = self._text(painter, stroke.label)
        size = text.size()
        across, down = end.x() - before.x(), end.y() - before.y()
        share = ((size.width() + size.height()) / 4.0 + _LABEL_GAP_PX) / max(
            1e-6, math.hypot(across, down)
        )
        place = QRectF(0.0, 0.0, size.width() + 6.0, self._label_height_px)
        place.moveCenter(QPointF(end.x() + across * share, end.y() + down * share))
        place = _moved_inside(place, projection)
        painter.setPen(Qt.PenStyle.NoPen)
        ground = self._pen(palette.background, _HALO_OPACITY, 0.0).color()
        painter.setBrush(ground)
        painter.drawRoundedRect(place, 3.0, 3.0)
        painter.setPen(self._pen(stroke.color, 1.0, stroke.width_px))
        painter.drawStaticText(place.topLeft() + QPointF(3.0, 0.0), text)

    def _text(self, painter: QPainter, label: str) -> QStaticText:
        font = painter.font()
        if font != self._font:
            self._font = font
            self._labels.clear()
            self._label_height_px = QFontMetricsF(font).height()
        text = self._labels.get(label)
        if text is None:
            text = self._labels[label] = QStaticText(label)
            text.setTextFormat(Qt.TextFormat.PlainText)
            text.prepare(painter.transform(), font)
        return text


class StrokeLayer:
    """Lines that stay the same in most pictures."""

    def __init__(self, painter: StrokePainter) -> None:
        self._painter = painter
        self._layer = KeptLayer()

    def paint(
        self,
        painter: QPainter,
        key: object,
        strokes: Callable[[], Sequence[Stroke]],
        projection: Projection,
        palette: ScenePalette,
    ) -> None:
        """Paint the lines over the picture.

        Args:
            painter: The painter of the widget.
            key: All that the lines depend on but the picture's camera, size and colours.
            strokes: Returns the lines; called only after a change.
            projection: The projection of the picture.
            palette: The theme's colours.
        """
        known: list[Stroke] = []

        def room() -> QRectF:
            known.extend(strokes())
            pixels = (projection.pixel(place) for stroke in known for place in stroke.places)
            return room_around(pixels, projection)

        def draw(on: QPainter) -> None:
            self._painter.paint(on, known, projection, palette)

        whole = (key, projection.key, palette)
        self._layer.paint(painter, whole, room, draw)


def room_around(pixels: Iterable[tuple[float, float] | None], projection: Projection) -> QRectF:
    """Return the rectangle around pixels, with room for the labels beside them."""
    points = QPolygonF([QPointF(*pixel) for pixel in pixels if pixel is not None])
    if points.isEmpty():
        return QRectF()
    around = points.boundingRect().adjusted(-_RIM_PX, -_RIM_PX, _RIM_PX, _RIM_PX)
    return around & _whole(projection)


def _whole(projection: Projection) -> QRectF:
    return QRectF(0.0, 0.0, projection.width_px, projection.height_px)


def _moved_inside(label: QRectF, projection: Projection) -> QRectF:
    """Return a label's rectangle moved so that the edges of the picture do not cut it."""
    left = min(label.left(), projection.width_px - label.width())
    top = min(label.top(), projection.height_px - label.height())
    return QRectF(QPointF(max(0.0, left), max(0.0, top)), label.size())


def paint_tag(
    painter: QPainter,
    at: QPointF,
    text: str,
    projection: Projection,
    *,
    color: str,
    palette: ScenePalette,
) -> None:
    """Paint a short text on a plate beside a place of the picture."""
    metrics = QFontMetricsF(painter.font())
    width = max(metrics.height(), metrics.horizontalAdvance(text) + 8.0)
    plate = _moved_inside(QRectF(at.x(), at.y(), width, metrics.height()), projection)
    ground = QColor(palette.plate)
    ground.setAlphaF(0.88)
    painter.setPen(QPen(QColor(color), 1.0))
    painter.setBrush(ground)
    painter.drawRoundedRect(plate, 3.0, 3.0)
    painter.setPen(QColor(color))
    painter.drawText(plate, Qt.AlignmentFlag.AlignCenter, text)
