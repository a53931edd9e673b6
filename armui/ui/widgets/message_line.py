"""The line in which a panel shows an obstacle and its remedy."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final, TypeAlias

from PySide6.QtCore import QEvent, QRect, QRectF, QSize, Qt
from PySide6.QtGui import QPaintEvent, QResizeEvent
from PySide6.QtWidgets import QLabel, QSizePolicy, QWidget

from armui.control.events import Level
from armui.ui.theme import Colors, colors_of
from armui.ui.translation import shown_language
from armui.ui.widgets import icons, painting
from armui.ui.widgets.layouts import in_row
from armui.ui.widgets.text_label import text_label

Words: TypeAlias = str | Callable[[], str]
"""A text, or a function that returns it in the present language."""

_ICON_PX: Final = 20
_SIDE_PX: Final = 12
_TOP_PX: Final = 8
_LEAST_TOP_PX: Final = 2
"""The margin above and below a message with one line more than usual."""
_GAP_PX: Final = 10
_LINE: Final = "急"
"""A character to measure a line of Chinese text, which may be higher than others."""
_LEAST_PX: Final = 200
_UNBOUNDED_PX: Final = 10_000
_OVER: Final = frozenset({Level.INFO, Level.DONE, Level.WARNING})
"""The levels of messages that are dropped after a change of language."""
_ICONS: Final = {
    Level.INFO: "info",
    Level.DONE: "done",
    Level.WARNING: "warning",
    Level.FAULT: "warning",
}


class MessageLine(QWidget):
    """One message with a sign before it.

    Args:
        parent: The parent widget.
        keeps_room: True if its room is kept when there is no message; not needed below a table,
            which only becomes lower.
        lines: The least number of lines to have room for.
        steady: True if there is room for one line more, so that a longer text moves nothing above
            it.
    """

    def __init__(
        self,
        parent: QWidget | None = None,
        *,
        keeps_room: bool = True,
        lines: int = 2,
        steady: bool = False,
    ) -> None:
        super().__init__(parent)
        self._room = "\n".join([_LINE] * lines)
        self._more_room = "\n".join([_LINE] * (lines + 1)) if steady else ""
        self._keeps_room = keeps_room
        self._level = Level.INFO
        self._words: Words = ""
        self._message_language = shown_language()
        self._icon = QLabel()
        self._icon.setFixedWidth(_ICON_PX)
        self._label = text_label(wraps=True, plain=True)
        self._label.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Ignored)
        top_px = _LEAST_TOP_PX if steady else _TOP_PX
        layout = in_row(on=self, spacing=_GAP_PX, margins=(_SIDE_PX, top_px, _SIDE_PX, top_px))
        layout.addWidget(self._icon, 0, Qt.AlignmentFlag.AlignVCenter)
        layout.addWidget(self._label, 1)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.show_message("")

    def text(self) -> str:
        """Return the present text."""
        return self._label.text()

    def show_message(self, words: Words, level: Level = Level.INFO) -> None:
        """Show a message; an empty text hides it.

        After a change of language a plain text disappears unless it is shown anew; a fault stays.

        Args:
            words: The text.
            level: The severity.
        """
        self._level, self._words = level, words
        self._message_language = shown_language()
        text = words if isinstance(words, str) else words()
        self._label.setText(text)
        self.setAccessibleName(text)
        self._update_icon()
        if not self._keeps_room:
            self.setHidden(not text)
        self.updateGeometry()
        self.update()

    def hasHeightForWidth(self) -> bool:  # noqa: N802 - the name Qt calls
        """Return false: :meth:`sizeHint` gives the height for the present width."""
        return False

    def sizeHint(self) -> QSize:
        """Return a size with room for its lines, or more if the message needs them."""
        top_px = _LEAST_TOP_PX if self._more_room else _TOP_PX
        height = max(self.kept_px(), self._text_px(self.text()) + 2 * top_px)
        return QSize(_LEAST_PX if self._keeps_room else self._natural_px(), height)

    def kept_px(self) -> int:
        """Return the height kept for messages, in pixels."""
        usual = self._text_px(self._room) + 2 * _TOP_PX
        return max(usual, self._text_px(self._more_room) + 2 * _LEAST_TOP_PX)

    def _text_px(self, text: str) -> int:
        """Return how high a text is in the present width."""
        width = max(1, self.width() - 2 * _SIDE_PX - _GAP_PX - _ICON_PX)
        room = QRect(0, 0, width, _UNBOUNDED_PX)
        wrap = int(Qt.TextFlag.TextWordWrap)
        return self.fontMetrics().boundingRect(room, wrap, text).height()

    def _natural_px(self) -> int:
        """Return the width in pixels that the longest line needs without a break."""
        lines = (self.fontMetrics().horizontalAdvance(line) for line in self.text().split("\n"))
        return max(_LEAST_PX, max(lines) + 2 * _SIDE_PX + _GAP_PX + _ICON_PX)

    def minimumSizeHint(self) -> QSize:
        """Return the same height with a small width, at which the text wraps."""
        return QSize(_LEAST_PX, self.sizeHint().height())

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Fit the height to the new width."""
        super().resizeEvent(event)
        if event.size().width() != event.oldSize().width():
            self.updateGeometry()

    def changeEvent(self, event: QEvent) -> None:
        """Update after a change of colours or language."""
        if event.type() == QEvent.Type.PaletteChange:
            self._update_icon()
        elif event.type() == QEvent.Type.LanguageChange:
            if not isinstance(self._words, str):
                self.show_message(self._words, self._level)
            elif self._level in _OVER and self._message_language != shown_language():
                self.show_message("")
        super().changeEvent(event)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the background of the message."""
        if not self.text():
            return
        colors = colors_of(self)
        fill, _ink = self._paint_colors(colors)
        painter = painting.begin(self)
        painting.panel(painter, QRectF(self.rect()), fill, fill)
        painter.end()

    def _update_icon(self) -> None:
        if not self.text():
            self._icon.clear()
            return
        _fill, ink = self._paint_colors(colors_of(self))
        name = _ICONS[self._level]
        self._icon.setPixmap(icons.pixmap(name, ink, _ICON_PX, self.devicePixelRatioF()))

    def _paint_colors(self, colors: Colors) -> tuple[str, str]:
        return {
            Level.INFO: (colors.accent_pale, colors.accent),
            Level.DONE: (colors.accent_pale, colors.ok),
            Level.WARNING: (colors.warn_pale, colors.warn),
            Level.FAULT: (colors.stop_pale, colors.stop_ink),
        }[self._level]
