"""How far an axis is pushed, as a bar from its centre, with the dead zone marked."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QPointF, QRectF, QSize
from PySide6.QtGui import QColor, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from armui.ui.theme import colors_of
from armui.ui.widgets import painting

_HEIGHT_PX: Final = 18
_GROOVE_PX: Final = 8.0
_CORNER_PX: Final = 4.0


class AxisBar(QWidget):
    """Shows −1 to 1, or 0 to 1.

    Args:
        dead_zone: The axis counts as at rest within it.
        from_left: Whether it begins at the left, as a trigger does.
    """

    def __init__(self, dead_zone: float, *, from_left: bool = False) -> None:
        super().__init__()
        self._dead_zone = dead_zone
        self._from_left = from_left
        self._value = 0.0
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)

    @property
    def value(self) -> float:
        """What it shows."""
        return self._value

    def show_value(self, value: float) -> None:
        """Show how far it is pushed."""
        value = max(-1.0, min(1.0, value))
        if value != self._value:
            self._value = value
            self.update()

    def sizeHint(self) -> QSize:
        """As wide as there is room."""
        return QSize(120, _HEIGHT_PX)

    def minimumSizeHint(self) -> QSize:
        """So that it can still be read."""
        return QSize(70, _HEIGHT_PX)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw groove, dead zone and bar."""
        colors = colors_of(self)
        painter = painting.begin(self)
        painter.setPen(QPen(QColor(colors.border), 1.0))
        painter.setBrush(QColor(colors.sunken))
        top = (self.height() - _GROOVE_PX) / 2
        groove = QRectF(0.5, top, self.width() - 1.0, _GROOVE_PX)
        painter.drawRoundedRect(groove, _CORNER_PX, _CORNER_PX)
        centre = groove.left() if self._from_left else groove.center().x()
        reach = groove.width() if self._from_left else groove.width() / 2
        moves = abs(self._value) > self._dead_zone
        end = centre + reach * self._value
        painter.setPen(QPen(QColor("transparent")))
        painter.setBrush(QColor(colors.accent if moves else colors.muted))
        bar = QRectF(QPointF(min(centre, end), top), QPointF(max(centre, end), top + _GROOVE_PX))
        painter.drawRoundedRect(bar, _CORNER_PX, _CORNER_PX)
        painter.setPen(QPen(QColor(colors.muted), 1.0))
        for side in (-1, 1):
            if not self._from_left:
                at = centre + side * reach * self._dead_zone
                painter.drawLine(QPointF(at, top - 3), QPointF(at, top + _GROOVE_PX + 3))
        painter.end()
