"""The mark before a word for a state: each differs by shape, not only by colour."""

from __future__ import annotations

import enum

from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QPainter, QPen

from armui.ui.theme import Colors
from armui.ui.widgets import painting


class Mark(enum.Enum):
    """The state that a mark shows."""

    GOOD = enum.auto()
    """A filled disc with a tick."""
    OFF = enum.auto()
    """A hollow ring: not on, which is no fault."""
    FAULT = enum.auto()
    """A warning triangle with an exclamation mark."""
    OFFLINE = enum.auto()
    """A ring with a bar."""
    UNKNOWN = enum.auto()
    """A dotted ring."""
    ATTENTION = enum.auto()
    """A filled disc with an exclamation mark, in the colour of attention."""
    CHANGED = enum.auto()
    """A filled disc, smaller than the others."""
    WAITING = enum.auto()
    """Three dots in a row."""


def draw(
    painter: QPainter,
    colors: Colors,
    center: QPointF,
    radius: float,
    mark: Mark,
    *,
    muted: bool = False,
) -> None:
    """Draw a mark.

    Args:
        painter: The painter; its pen and brush are changed.
        colors: The colours of the theme.
        center: Its middle.
        radius: Half its size, in pixels.
        mark: The mark.
        muted: True to draw it without its colour, because the state is stale.
    """
    ink = QColor(colors.muted if muted else _ink(colors, mark))
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(ink)
    unit = radius / 8
    if mark is Mark.GOOD:
        painter.drawEllipse(center, radius, radius)
        painter.setPen(_stroke(QColor(colors.surface), 2 * unit))
        painter.drawPolyline(
            [center + QPointF(x, y) * unit for x, y in ((-3.5, 0.3), (-1.0, 3.0), (3.8, -2.8))]
        )
    elif mark is Mark.CHANGED:
        painter.drawEllipse(center, 0.6 * radius, 0.6 * radius)
    elif mark is Mark.WAITING:
        for x in (-5.0, 0.0, 5.0):
            painter.drawEllipse(center + QPointF(x, 0) * unit, 1.7 * unit, 1.7 * unit)
    elif mark is Mark.ATTENTION:
        painter.drawEllipse(center, radius, radius)
        painter.setPen(_stroke(QColor(colors.surface), 2 * unit))
        painter.drawLine(center + QPointF(0, -4.2) * unit, center + QPointF(0, 0.8) * unit)
        painter.drawPoint(center + QPointF(0, 4.2) * unit)
    elif mark is Mark.FAULT:
        painter.drawPolygon(painting.triangle(center + QPointF(0, 1.5 * unit), radius * 1.2))
        painter.setPen(_stroke(QColor(colors.surface), 1.8 * unit))
        painter.drawLine(center + QPointF(0, -2.5) * unit, center + QPointF(0, 1.8) * unit)
        painter.drawPoint(center + QPointF(0, 4.6) * unit)
    else:
        painter.setBrush(Qt.BrushStyle.NoBrush)
        pen = QPen(ink, 2 * unit)
        if mark is Mark.UNKNOWN:
            pen.setStyle(Qt.PenStyle.DotLine)
        painter.setPen(pen)
        painter.drawEllipse(center, radius - unit, radius - unit)
        if mark is Mark.OFFLINE:
            painter.setPen(_stroke(ink, 2.4 * unit))
            painter.drawLine(center - QPointF(2.6, 0) * unit, center + QPointF(2.6, 0) * unit)


def _ink(colors: Colors, mark: Mark) -> str:
    return {
        Mark.GOOD: colors.ok,
        Mark.OFF: colors.muted,
        Mark.FAULT: colors.stop,
        Mark.OFFLINE: colors.warn,
        Mark.UNKNOWN: colors.muted,
        Mark.ATTENTION: colors.warn,
        Mark.CHANGED: colors.accent,
        Mark.WAITING: colors.muted,
    }[mark]


def _stroke(color: QColor, width: float) -> QPen:
    return QPen(color, width, c=Qt.PenCapStyle.RoundCap, j=Qt.PenJoinStyle.RoundJoin)
