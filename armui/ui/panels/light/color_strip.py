"""A strip filled with a colour that says which one it is."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QRectF, QSize, Qt
from PySide6.QtGui import QBrush, QColor, QPaintEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from armui.ui import format as fmt
from armui.ui.theme import colors_of, scaled_font
from armui.ui.widgets import painting

_HEIGHT_PX: Final = 44
_BRIGHT: Final = 0.45
"""From this luminance on, black is read better than white."""


class ColorStrip(QWidget):
    """Shows one colour with its hexadecimal value in it; without a colour it is hatched."""

    def __init__(self) -> None:
        super().__init__()
        self._color: QColor | None = None
        self.setFont(scaled_font(self, 1.1, bold=True))
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)

    def text(self) -> str:
        """The value it shows: ``#RRGGBB``, or «—»."""
        return fmt.NOTHING if self._color is None else self._color.name().upper()

    def show_color(self, color: QColor | None) -> None:
        """Show a colour, or that there is none."""
        self._color = color
        self.update()

    def sizeHint(self) -> QSize:
        """As large as it wants to be."""
        return QSize(200, _HEIGHT_PX)

    def minimumSizeHint(self) -> QSize:
        """No smaller than that."""
        return QSize(100, _HEIGHT_PX)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw it."""
        colors = colors_of(self)
        painter = painting.begin(self)
        fill = colors.sunken if self._color is None else self._color.name()
        painting.panel(painter, QRectF(self.rect()), fill, colors.faint)
        if self._color is None:
            hatching = QBrush(QColor(colors.border), Qt.BrushStyle.BDiagPattern)
            painter.fillRect(self.rect().adjusted(4, 4, -4, -4), hatching)
            ink = colors.text
        else:
            ink = "#000000" if _luminance(self._color) > _BRIGHT else "#ffffff"
        painter.setPen(QColor(ink))
        painter.drawText(self.rect(), Qt.AlignmentFlag.AlignCenter, self.text())
        painter.end()


def _luminance(color: QColor) -> float:
    """How bright a colour looks, 0–1 (the weights of Rec. 709, without its gamma)."""
    return 0.2126 * color.redF() + 0.7152 * color.greenF() + 0.0722 * color.blueF()
