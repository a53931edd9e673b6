"""Shapes shared by self-painted widgets, and the update of their style."""

from __future__ import annotations

import math

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPalette, QPen, QPolygonF
from PySide6.QtWidgets import QWidget

CORNER_PX = 7.0


def repolish(widget: QWidget) -> None:
    """Apply the style sheet again to a widget that was shown before."""
    if widget.testAttribute(Qt.WidgetAttribute.WA_WState_Polished):
        style = widget.style()
        style.unpolish(widget)
        style.polish(widget)


def set_rank(widget: QWidget, rank: str) -> None:
    """Show the widget's text in the style sheet's colour for a rank.

    A colour set by `QWidget.setPalette` is lost as soon as another theme is chosen.
    """
    if widget.property("rank") != rank:
        widget.setProperty("rank", rank)
        repolish(widget)


def begin(widget: QWidget) -> QPainter:
    """Return a painter on a widget, with smooth edges; the caller must end it."""
    painter = QPainter(widget)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    return painter


def fill_ground(widget: QWidget) -> None:
    """Make a widget on a card fill its own background, in the card's colour.

    It looks the same, but when a figure in it changes, nothing behind the widget is painted again:
    painting from the window down to the card by the style sheet takes five times as long as the
    figure.
    """
    widget.setBackgroundRole(QPalette.ColorRole.Base)
    widget.setAutoFillBackground(True)


def panel(painter: QPainter, rect: QRectF, fill: str, line: str, line_px: float = 1.0) -> None:
    """Draw a rounded box with a line inside its edge."""
    inset = line_px / 2
    painter.setPen(QPen(QColor(line), line_px))
    painter.setBrush(QColor(fill))
    painter.drawRoundedRect(rect.adjusted(inset, inset, -inset, -inset), CORNER_PX, CORNER_PX)


def octagon(center: QPointF, radius: float) -> QPolygonF:
    """Return the shape of a stop sign."""
    corners = (math.pi / 8 + n * math.pi / 4 for n in range(8))
    return QPolygonF([center + QPointF(math.cos(a), math.sin(a)) * radius for a in corners])


def triangle(center: QPointF, radius: float) -> QPolygonF:
    """Return the shape of a warning sign, its point upwards."""
    corners = (-math.pi / 2 + n * 2 * math.pi / 3 for n in range(3))
    return QPolygonF([center + QPointF(math.cos(a), math.sin(a)) * radius for a in corners])
