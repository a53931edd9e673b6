"""Labels for plain text, for figures, and for text that is shortened."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QResizeEvent
from PySide6.QtWidgets import QLabel, QSizePolicy, QWidget

from armui.ui import format as fmt
from armui.ui.theme import colors_of


class ValueLabel(QWidget):
    """Shows a text of known greatest width; a new text needs a repaint, but no layout.

    Args:
        widest: The longest text it will have to show.
        alignment: The alignment of the text.
    """

    def __init__(
        self, widest: str, alignment: Qt.AlignmentFlag = Qt.AlignmentFlag.AlignRight
    ) -> None:
        super().__init__()
        self._widest = widest
        self._alignment = alignment | Qt.AlignmentFlag.AlignVCenter
        self._text = fmt.NOTHING
        self._stale = False
        self._attention = False
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)

    def set_widest(self, widest: str) -> None:
        """Reserve room for another longest text."""
        self._widest = widest
        self.updateGeometry()

    def text(self) -> str:
        """Return the text."""
        return self._text

    def is_stale(self) -> bool:
        """Return whether the figure is too old to count as present."""
        return self._stale

    def show_text(self, text: str, *, stale: bool = False) -> None:
        """Show a text; muted if it is too old to count as present."""
        if text == self._text and stale == self._stale:
            return
        self._text, self._stale = text, stale
        self.update()

    def show_attention(self, *, wanted: bool) -> None:
        """Draw it in the colour of attention, or not."""
        if wanted != self._attention:
            self._attention = wanted
            self.update()

    def sizeHint(self) -> QSize:
        """Return the size of the longest text."""
        metrics = self.fontMetrics()
        return QSize(metrics.horizontalAdvance(self._widest) + 2, metrics.height() + 4)

    def changeEvent(self, event: QEvent) -> None:
        """Update the size after a change of font."""
        if event.type() == QEvent.Type.FontChange:
            self.updateGeometry()
        super().changeEvent(event)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the text."""
        colors = colors_of(self)
        dim = self._stale or self._text == fmt.NOTHING or not self.isEnabled()
        painter = QPainter(self)
        ink = colors.muted if dim else colors.text
        painter.setPen(QColor(colors.warn if self._attention else ink))
        painter.drawText(self.rect(), self._alignment, self._text)
        painter.end()


class ElidedLabel(QLabel):
    """One line that is shortened with «…» if it does not fit; the tooltip has the whole text.

    If two lines fit, a longer text is split at its last “·”.
    """

    def __init__(self, rank: str = "") -> None:
        super().__init__()
        self.setProperty("rank", rank or None)
        self.setTextFormat(Qt.TextFormat.PlainText)
        self._tip = ""

    def show_text(self, text: str, tip: str = "") -> None:
        """Set the text.

        Args:
            text: The line.
            tip: The tooltip, below the whole line if that does not fit.
        """
        self._tip = tip
        self.setText(text)
        self._update_tooltip()

    def minimumSizeHint(self) -> QSize:
        """Return the height without a minimal width."""
        return QSize(0, super().minimumSizeHint().height())

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Fit the text into the new width."""
        super().resizeEvent(event)
        self._update_tooltip()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw as much of the line as fits."""
        painter = QPainter(self)
        painter.setPen(self.palette().color(self.foregroundRole()))
        painter.drawText(self.contentsRect(), self.alignment(), self._elided())
        painter.end()

    def _elided(self) -> str:
        metrics, room, text = self.fontMetrics(), self.contentsRect(), self.text()
        parts = metrics.horizontalAdvance(text) > room.width()
        parts = parts and room.height() >= 2 * metrics.lineSpacing()
        lines = text.rsplit(" · ", 1) if parts else [text]
        right = Qt.TextElideMode.ElideRight
        return "\n".join(metrics.elidedText(line, right, room.width()) for line in lines)

    def _update_tooltip(self) -> None:
        text = self.text()
        whole = text if self._elided().replace("\n", " · ") != text else ""
        self.setToolTip("\n".join(filter(None, (whole, self._tip))))


def text_label(
    name: str = "", text: str = "", *, rank: str = "", wraps: bool = False, plain: bool = False
) -> QLabel:
    """Return a label.

    Args:
        name: Its object name.
        text: What it says; empty if that comes later.
        rank: How the style sheet shows it: ``title``, ``muted``, …
        wraps: True to wrap long text.
        plain: True to show text that looks like HTML literally.
    """
    label = QLabel(text)
    label.setObjectName(name)
    if rank:
        label.setProperty("rank", rank)
    label.setWordWrap(wraps)
    if plain:
        label.setTextFormat(Qt.TextFormat.PlainText)
    return label
