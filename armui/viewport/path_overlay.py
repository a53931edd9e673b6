"""Draws the numbers of points and the signs of findings over the picture."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QPainter, QPen, QPolygonF

from armui.viewport.stroke_painter import KeptLayer, paint_tag, room_around

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from armui.viewport.palette import ScenePalette
    from armui.viewport.path_picture import FindingMark, PathPicture, Preview
    from armui.viewport.projection import Projection
    from armui.viewport.vectors import Vector


_CELL_PX: Final = (34.0, 20.0)
"""The size of a cell that holds one number at most: closer ones are not readable."""
_MOST: Final = 120
_NEAR_PX: Final = 13.0
_SIGN_PX: Final = 10.0
_TAG_OFFSET_PX: Final = (8.0, 6.0)
_SMALLER: Final = 0.85


@dataclass(frozen=True, slots=True)
class _Rim:
    """The least distance of a sign from each edge of the picture."""

    left: float
    top: float
    right: float
    bottom: float


_RIM_PX: Final = _Rim(18.0, 18.0, 66.0, 18.0)
"""The margins for signs; the buttons are at the right edge."""


@dataclass(frozen=True, slots=True)
class Tag:
    """A number beside a point.

    Attributes:
        x_px, y_px: The place of the point, from the top left.
        row: Its row, from 0.
    """

    x_px: float
    y_px: float
    row: int


@dataclass(frozen=True, slots=True)
class Sign:
    """The sign of a finding.

    Attributes:
        x_px, y_px: The place of the sign, from the top left.
        finding: The finding.
        beyond: The direction on the screen to the finding's place, if that is out of sight.
    """

    x_px: float
    y_px: float
    finding: FindingMark
    beyond: tuple[float, float] | None = None


def tags(
    path: PathPicture, projection: Projection, first: frozenset[int] = frozenset()
) -> list[Tag]:
    """Return the row numbers that can be read without overlapping.

    Args:
        path: The path with its points.
        projection: The projection of the picture.
        first: Rows whose numbers are always shown.
    """
    import numpy as np  # noqa: PLC0415 - see above

    if not path.is_numbered or not len(path.rows):
        return []
    pixels = _pixels(path.marks_mm / 1000.0, projection)
    inside = np.isfinite(pixels[:, 0])
    inside &= (pixels >= 0.0).all(axis=1)
    inside &= pixels[:, 0] < projection.width_px
    inside &= pixels[:, 1] < projection.height_px
    rows = np.asarray(path.rows)
    forced = np.isin(rows, list(first | path.bad_rows))
    order = np.lexsort((rows, ~forced))
    order = order[inside[order]]
    cells = np.floor(pixels[order] / _CELL_PX).astype(int)
    _, chosen = np.unique(cells, axis=0, return_index=True)
    kept = order[np.sort(chosen)][:_MOST]
    return [Tag(float(pixels[at, 0]), float(pixels[at, 1]), int(rows[at])) for at in kept.tolist()]


def signs(path: PathPicture, projection: Projection) -> list[Sign]:
    """Return the signs of findings, the gravest last, so that they lie on top.

    A finding outside of the picture has its sign at the rim, in its direction.
    """
    found = []
    gravest_first = sorted(path.findings, key=lambda each: not each.is_error)
    for finding in reversed(gravest_first[:_MOST]):
        x, y, z = finding.place_mm
        seen_px = _seen_px(projection, (x / 1000.0, y / 1000.0, z / 1000.0))
        x_px = _within(seen_px[0], _RIM_PX.left, projection.width_px - _RIM_PX.right)
        y_px = _within(seen_px[1], _RIM_PX.top, projection.height_px - _RIM_PX.bottom)
        across, down = seen_px[0] - x_px, seen_px[1] - y_px
        away_px = math.hypot(across, down)
        beyond = (across / away_px, down / away_px) if away_px > _NEAR_PX else None
        found.append(Sign(x_px, y_px, finding, beyond))
    return found


def finding_at(
    path: PathPicture, projection: Projection, x_px: float, y_px: float
) -> FindingMark | None:
    """Return the finding whose sign is at a pixel, the gravest if there are several."""
    near = [
        sign
        for sign in signs(path, projection)
        if max(abs(sign.x_px - x_px), abs(sign.y_px - y_px)) <= _NEAR_PX
    ]
    return near[-1].finding if near else None


def _seen_px(projection: Projection, place_m: Vector) -> tuple[float, float]:
    """Return the pixel of a place; for one behind the eye, one far outside in its direction."""
    pixel = projection.pixel(place_m)
    if pixel is not None:
        return pixel
    across, up, _ = projection.relative(place_m)
    away = math.hypot(across, up) or 1.0
    size_px = projection.width_px + projection.height_px
    return (
        projection.width_px / 2.0 + across / away * size_px,
        projection.height_px / 2.0 - up / away * size_px,
    )


def _within(value: float, low: float, high: float) -> float:
    return max(low, min(value, high))


def _pixels(places_m: NDArray[np.float64], projection: Projection) -> NDArray[np.float64]:
    """Return where places are seen, as (n, 2) pixels; infinite for those behind the eye."""
    import numpy as np  # noqa: PLC0415 - see above

    camera = projection.camera
    outward, right, up = (np.array(axis) for axis in camera.axes())
    relative = places_m - np.array(camera.focus_m)
    scales = np.full(len(places_m), projection.scale_px(0.0) or 0.0)
    if not camera.orthographic:
        away = (camera.distance_m - relative @ outward) / camera.distance_m
        scales = np.where(away > 0.0, scales / np.where(away > 0.0, away, 1.0), np.inf)
    with np.errstate(invalid="ignore"):
        across = projection.width_px / 2.0 + relative @ right * scales
        down = projection.height_px / 2.0 - relative @ up * scales
    return np.column_stack((across, down))


class PathOverlay:
    """Computes the places of numbers and signs once for each path and camera."""

    def __init__(self) -> None:
        self._layer = KeptLayer()
        self._tags: list[Tag] = []
        self._signs: list[Sign] = []

    def paint(
        self, painter: QPainter, preview: Preview, projection: Projection, palette: ScenePalette
    ) -> None:
        """Draw numbers and signs of a path; nothing without one."""
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
            self._draw(on, preview, projection, palette)

        self._layer.paint(painter, key, room, draw)

    def _draw(
        self, painter: QPainter, preview: Preview, projection: Projection, palette: ScenePalette
    ) -> None:
        path = preview.path
        font = QFont(painter.font())
        font.setPointSizeF(font.pointSizeF() * _SMALLER)
        painter.setFont(font)
        for tag in self._tags:
            color = palette.text
            if path is not None and tag.row in path.bad_rows:
                color = palette.fault
            elif tag.row == preview.current_row:
                color = palette.current
            place = QPointF(tag.x_px + _TAG_OFFSET_PX[0], tag.y_px + _TAG_OFFSET_PX[1])
            paint_tag(painter, place, str(tag.row + 1), projection, color=color, palette=palette)
        for sign in self._signs:
            _paint_sign(painter, sign, palette)

    @staticmethod
    def finding_at(preview: Preview, projection: Projection, at: QPointF) -> FindingMark | None:
        """Return the finding whose sign is at a place of the widget."""
        path = preview.path
        if path is None or not path.findings:
            return None
        return finding_at(path, projection, at.x(), at.y())

    def _work_out(
        self, path: PathPicture, rows: tuple[int | None, ...], projection: Projection
    ) -> None:

        self._tags = tags(path, projection, frozenset(row for row in rows if row is not None))
        self._signs = signs(path, projection)


def _paint_sign(painter: QPainter, sign: Sign, palette: ScenePalette) -> None:
    """Paint an octagon and a cross for an error, a triangle and an exclamation mark otherwise."""
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
