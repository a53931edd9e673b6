"""A field to pick a colour from: hue from left to right, paler from top to bottom."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QKeyEvent,
    QLinearGradient,
    QMouseEvent,
    QPainter,
    QPainterPath,
    QPaintEvent,
    QPen,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from armui.ui.theme import colors_of
from armui.ui.widgets import painting

_EDGE_PX: Final = 9.0
_MARK_PX: Final = 6.5
_SIXTHS: Final = 6
_KEY_STEP: Final = 0.02
_KEYS: Final = {
    Qt.Key.Key_Left: (-_KEY_STEP, 0.0),
    Qt.Key.Key_Right: (_KEY_STEP, 0.0),
    Qt.Key.Key_Up: (0.0, _KEY_STEP),
    Qt.Key.Key_Down: (0.0, -_KEY_STEP),
}
_JUST_BELOW_ONE: Final = 0.9999
"""Hue 1 is hue 0 again: the mark would jump from one end to the other."""


class HueField(QWidget):
    """Hue and saturation, each 0–1; a click, a drag or the arrow keys move the mark.

    Signals:
        picked: The operator moved the mark.
    """

    picked = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._hue = 0.0
        self._saturation = 0.0
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setCursor(Qt.CursorShape.CrossCursor)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)

    def color(self, value: float) -> QColor:
        """The colour under the mark at a brightness, 0–1."""
        return QColor.fromHsvF(self._hue, self._saturation, value)

    def show_color(self, color: QColor) -> None:
        """Put the mark on a colour without telling anyone.

        A grey has no hue and black has no saturation either: what is not there stays as it was, so
        that a colour turned dark and bright again comes back.
        """
        if color.value() > 0:
            self._saturation = color.hsvSaturationF()
            if color.hsvHueF() >= 0:
                self._hue = color.hsvHueF()
        self.update()

    def point(self) -> QPointF:
        """Where the mark stands."""
        area = self._area()
        return QPointF(
            area.left() + self._hue * area.width(),
            area.top() + (1 - self._saturation) * area.height(),
        )

    def sizeHint(self) -> QSize:
        """As large as it wants to be."""
        return QSize(200, 130)

    def minimumSizeHint(self) -> QSize:
        """No smaller than that."""
        return QSize(120, 80)

    def _area(self) -> QRectF:
        return QRectF(self.rect()).adjusted(_EDGE_PX, _EDGE_PX, -_EDGE_PX, -_EDGE_PX)

    def _move(self, hue: float, saturation: float) -> None:
        self._hue = min(max(hue, 0.0), _JUST_BELOW_ONE)
        self._saturation = min(max(saturation, 0.0), 1.0)
        self.update()
        self.picked.emit()

    # -- input --------------------------------------------------------------------------------

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Bring the mark to the mouse."""
        if event.button() is Qt.MouseButton.LeftButton:
            self._follow(event.position())

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Drag the mark."""
        if event.buttons() & Qt.MouseButton.LeftButton:
            self._follow(event.position())

    def _follow(self, place: QPointF) -> None:
        area = self._area()
        self._move(
            (place.x() - area.left()) / area.width(), 1 - (place.y() - area.top()) / area.height()
        )

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Arrow keys move the mark."""
        step = _KEYS.get(Qt.Key(event.key()))
        if step is None:
            super().keyPressEvent(event)
        else:
            self._move(self._hue + step[0], self._saturation + step[1])

    # -- picture ------------------------------------------------------------------------------

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw it."""
        painter = painting.begin(self)
        self._draw_colors(painter, self._area())
        colors = colors_of(self)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        focused = self.hasFocus()
        painter.setPen(
            QPen(QColor(colors.accent if focused else colors.border), 2 if focused else 1)
        )
        painter.drawRoundedRect(
            self._area().adjusted(-2, -2, 2, 2), painting.CORNER_PX, painting.CORNER_PX
        )
        # white in black is seen on every colour
        painter.setPen(QPen(Qt.GlobalColor.black, 4))
        painter.drawEllipse(self.point(), _MARK_PX, _MARK_PX)
        painter.setPen(QPen(Qt.GlobalColor.white, 2))
        painter.drawEllipse(self.point(), _MARK_PX, _MARK_PX)
        painter.end()

    @staticmethod
    def _draw_colors(painter: QPainter, area: QRectF) -> None:
        """Full colours across, and white that grows towards the bottom over them."""
        hues = QLinearGradient(area.topLeft(), area.topRight())
        for sixth in range(_SIXTHS + 1):
            hues.setColorAt(sixth / _SIXTHS, QColor.fromHsvF(sixth / _SIXTHS % 1.0, 1.0, 1.0))
        white = QLinearGradient(area.topLeft(), area.bottomLeft())
        white.setColorAt(0, QColor(255, 255, 255, 0))
        white.setColorAt(1, QColor(255, 255, 255))
        shape = QPainterPath()
        shape.addRoundedRect(area, painting.CORNER_PX - 2, painting.CORNER_PX - 2)
        painter.fillPath(shape, hues)
        painter.fillPath(shape, white)
