"""Draws the numbers of points and the signs of findings over the picture."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QPainter, QPen, QPolygonF

from armui.viewport.kept_layer import KeptLayer
from armui.viewport.stroke_painter import paint_tag, room_around

if TYPE_CHECKING:
    from armui.viewport.palette import ScenePalette
    from armui.viewport.path_picture import FindingMark, PathPicture, Preview
    from armui.viewport.point_tags import Sign, Tag
    from armui.viewport.projection import Projection

_SIGN_PX: Final = 10.0
_TAG_OFFSET_PX: Final = (8.0, 6.0)
_SMALLER: Final = 0.85


class PathOverlay:
    """Works out where numbers and signs stand once for each path and camera."""

    def __init__(self) -> None:
        self._layer = KeptLayer()
        self._tags: list[Tag] = []
        self._signs: list[Sign] = []

    def paint(
        self, painter: QPainter, preview: Preview, projection: Projection, palette: ScenePalette
    ) -> None:
        """Draw what belongs to a path; nothing where there is none."""
        path = preview.path
        if path is None:
            return
        rows = (preview.selected_row, preview.current_row)
        key = (path, projection.key, rows, palette)

        def room() -> QRectF:
            self._work_out(path, rows, projection)
            places = [(each.x_px, each.y_px) for each in self._tags]
            places += [(each.x_px, each.y_px) for each in self._signs]
            return room_around(places, projection)

        def draw(on: QPainter) -> None:
            self._draw(on, path, preview.current_row, palette)

        self._layer.paint(painter, key, room, draw)

    def _draw(
        self, painter: QPainter, path: PathPicture, current_row: int | None, palette: ScenePalette
    ) -> None:
        font = QFont(painter.font())
        font.setPointSizeF(font.pointSizeF() * _SMALLER)
        painter.setFont(font)
        for tag in self._tags:
            color = palette.text
            if tag.row in path.bad_rows:
                color = palette.fault
            elif tag.row == current_row:
                color = palette.current
            place = QPointF(tag.x_px + _TAG_OFFSET_PX[0], tag.y_px + _TAG_OFFSET_PX[1])
            paint_tag(painter, place, str(tag.row + 1), color, palette)
        for sign in self._signs:
            _paint_sign(painter, sign, palette)

    @staticmethod
    def finding_at(preview: Preview, projection: Projection, at: QPointF) -> FindingMark | None:
        """The finding whose sign is at a place of the widget."""
        from armui.viewport.point_tags import finding_at  # noqa: PLC0415 - numpy, with the path

        path = preview.path
        if path is None or not path.findings:
            return None
        return finding_at(path, projection, at.x(), at.y())

    def _work_out(
        self, path: PathPicture, rows: tuple[int | None, ...], projection: Projection
    ) -> None:
        from armui.viewport.point_tags import signs, tags  # noqa: PLC0415 - numpy, with the path

        self._tags = tags(path, projection, frozenset(row for row in rows if row is not None))
        self._signs = signs(path, projection)


def _paint_sign(painter: QPainter, sign: Sign, palette: ScenePalette) -> None:
    """An error is an octagon with a cross, a warning a triangle with an exclamation mark."""
    centre = QPointF(sign.x_px, sign.y_px)
    is_error = sign.finding.is_error
    corners, turn = (8, math.pi / 8.0) if is_error else (3, -math.pi / 2.0)
    radius = _SIGN_PX if is_error else _SIGN_PX * 1.25
    angles = (turn + number * 2.0 * math.pi / corners for number in range(corners))
    shape = QPolygonF(
        [centre + QPointF(math.cos(angle), math.sin(angle)) * radius for angle in angles]
    )
    painter.setPen(QPen(QColor(palette.plate), 1.5))
    painter.setBrush(QColor(palette.fault if is_error else palette.warning))
    if sign.beyond is not None:
        ahead = QPointF(*sign.beyond)
        aside = QPointF(-ahead.y(), ahead.x())
        root = centre + ahead * radius * 0.7
        wings = aside * radius * 0.6
        painter.drawPolygon(QPolygonF([root - wings, centre + ahead * radius * 1.8, root + wings]))
    painter.drawPolygon(shape)
    font = QFont(painter.font())
    font.setBold(True)
    painter.setFont(font)
    painter.setPen(QColor(palette.plate))
    room = QRectF(0.0, 0.0, 3.0 * radius, 3.0 * radius)
    room.moveCenter(centre + QPointF(0.0, 0.0 if is_error else radius * 0.12))
    painter.drawText(room, Qt.AlignmentFlag.AlignCenter, "✕" if is_error else "!")
