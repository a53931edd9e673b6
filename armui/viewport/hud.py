"""The figures over the picture: end pose and joint angles as the arm reports them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF

if TYPE_CHECKING:
    from collections.abc import Sequence

    from PySide6.QtGui import QPainter

    from armui.viewport.palette import ScenePalette

_NOT_HEARD = "—"
_POSE = (("X", "mm"), ("Y", "mm"), ("Z", "mm"), ("RX", "°"), ("RY", "°"), ("RZ", "°"))
_JOINTS = tuple((f"J{number}", "°") for number in range(1, 7))
_WIDEST_NAME, _WIDEST_FIGURE, _WIDEST_UNIT = "RX ", "-0000.000", " mm"
_LINE_SPACING = 1.15
_MARGIN_PX = 12.0
_PADDING_PX = 10.0
_GAP_PX = 18.0


@dataclass(frozen=True)
class HudValues:
    """What the figures say; None: never heard from the arm.

    Attributes:
        pose: X, Y, Z in mm, RX, RY, RZ in degrees.
        angles_deg: six joint angles.
        pose_stale: the pose is no longer fresh.
        angles_stale: the angles are no longer fresh.
    """

    pose: tuple[float, ...] | None = None
    angles_deg: tuple[float, ...] | None = None
    pose_stale: bool = False
    angles_stale: bool = False


def hud_font(base: QFont) -> QFont:
    """The figures' font: all digits equally wide, so that nothing dances at 60 Hz."""
    font = QFont(base)
    font.setFeature(QFont.Tag("tnum"), 1)
    return font


def figures(values: Sequence[float] | None) -> list[str]:
    """Six figures with three decimals, or six dashes."""
    if values is None:
        return [_NOT_HEARD] * 6
    # Adding zero turns the "-0.000" of tiny negative values into "0.000".
    return [f"{round(value, 3) + 0.0:.3f}" for value in values]


def hud_frame(base_font: QFont) -> QRectF:
    """The rectangle the figures take, at the top left."""
    metrics = QFontMetricsF(hud_font(base_font))
    return QRectF(
        _MARGIN_PX,
        _MARGIN_PX,
        2.0 * (_PADDING_PX + _column_px(metrics)) + _GAP_PX,
        2.0 * _PADDING_PX + 6.0 * metrics.height() * _LINE_SPACING,
    )


def paint_hud(
    painter: QPainter, values: HudValues, palette: ScenePalette, base_font: QFont
) -> None:
    """Draw both columns into their frame."""
    font = hud_font(base_font)
    metrics = QFontMetricsF(font)
    frame = hud_frame(base_font)
    line_px = metrics.height() * _LINE_SPACING
    name_px = metrics.horizontalAdvance(_WIDEST_NAME)
    figure_px = metrics.horizontalAdvance(_WIDEST_FIGURE)
    painter.save()
    painter.setFont(font)
    backdrop = QColor(palette.background)
    backdrop.setAlphaF(0.72)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(backdrop)
    painter.drawRoundedRect(frame, 6.0, 6.0)
    columns = (
        (_POSE, values.pose, values.pose_stale),
        (_JOINTS, values.angles_deg, values.angles_stale),
    )
    left = frame.left() + _PADDING_PX
    for rows, numbers, stale in columns:
        ink = QColor(palette.muted if stale or numbers is None else palette.text)
        top = frame.top() + _PADDING_PX
        for (name, unit), figure in zip(rows, figures(numbers), strict=True):
            baseline = top + metrics.ascent()
            painter.setPen(QColor(palette.muted))
            painter.drawText(QPointF(left, baseline), name)
            painter.setPen(ink)
            right_aligned = left + name_px + figure_px - metrics.horizontalAdvance(figure)
            painter.drawText(QPointF(right_aligned, baseline), figure)
            painter.setPen(QColor(palette.muted))
            painter.drawText(QPointF(left + name_px + figure_px, baseline), f" {unit}")
            top += line_px
        left += _column_px(metrics) + _GAP_PX
    painter.restore()


def _column_px(metrics: QFontMetricsF) -> float:
    return sum(map(metrics.horizontalAdvance, (_WIDEST_NAME, _WIDEST_FIGURE, _WIDEST_UNIT)))
