"""A figure that changes sixty times a second without moving anything around it."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from armui.ui import format as fmt
from armui.ui.theme import colors_of


class ValueLabel(QWidget):
    """Shows a text of known greatest width; a new text costs one repaint and no new layout.

    Args:
        widest: The longest text it will have to show.
        alignment: Where the text stands.
    """

    def __init__(
        self,
        widest: str,
        alignment: Qt.AlignmentFlag = Qt.AlignmentFlag.AlignRight,
    ) -> None:
        super().__init__()
        self._widest = widest
        self._alignment = alignment | Qt.AlignmentFlag.AlignVCenter
        self._text = fmt.NOTHING
        self._stale = False
        self._attention = False
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)

    def set_widest(self, widest: str) -> None:
        """Leave room for another longest text."""
        self._widest = widest
        self.updateGeometry()

    def text(self) -> str:
        """What stands there."""
        return self._text

    def is_stale(self) -> bool:
        """Whether the figure is too old to stand for the present."""
        return self._stale

    def show_text(self, text: str, *, stale: bool = False) -> None:
        """Show a text; muted if it is too old to stand for the present."""
        if text == self._text and stale == self._stale:
            return
        self._text, self._stale = text, stale
        self.update()

    def show_attention(self, *, wanted: bool) -> None:
        """Draw it in the colour for something out of order, or no longer."""
        if wanted != self._attention:
            self._attention = wanted
            self.update()

    def sizeHint(self) -> QSize:
        """As large as it wants to be."""
        metrics = self.fontMetrics()
        return QSize(metrics.horizontalAdvance(self._widest) + 2, metrics.height() + 4)

    def changeEvent(self, event: QEvent) -> None:
        """Follow the font."""
        if event.type() == QEvent.Type.FontChange:
            self.updateGeometry()
        super().changeEvent(event)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw it."""
        colors = colors_of(self)
        dim = self._stale or self._text == fmt.NOTHING or not self.isEnabled()
        painter = QPainter(self)
        ink = colors.muted if dim else colors.text
        painter.setPen(QColor(colors.warn if self._attention else ink))
        painter.drawText(self.rect(), self._alignment, self._text)
        painter.end()
