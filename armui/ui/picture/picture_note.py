"""A short message over the picture, which goes away by itself."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from PySide6.QtCore import QEvent, Qt, QTimer
from PySide6.QtWidgets import QLabel

from armui.control.events import Level
from armui.ui.theme import colors_of

_LONG_MS: Final = 6000
_WIDEST_PX: Final = 420


class PictureNote(QLabel):
    """Stands at the lower left of the picture; the mouse goes through it."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("picture_note")
        self.setWordWrap(True)
        self.setTextFormat(Qt.TextFormat.PlainText)
        self.setMaximumWidth(_WIDEST_PX)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self._words: str | Callable[[], str] = ""
        self._level = Level.INFO
        self._end = QTimer(self, singleShot=True, interval=_LONG_MS)
        self._end.timeout.connect(self.hide)
        self.hide()

    def say(
        self,
        words: str | Callable[[], str],
        level: Level = Level.INFO,
        *,
        stays: bool = False,
    ) -> None:
        """Say something; an empty text says nothing.

        Args:
            words: What; something to be called has words in whichever language is chosen.
            level: How much it matters.
            stays: Whether it stands until something else is said.
        """
        self._end.stop()
        self._words, self._level = words, level
        text = words if isinstance(words, str) else words()
        self.setText(text)
        self.setAccessibleName(text)
        self._color()
        self.setVisible(bool(text))
        if text and not stays:
            self._end.start()

    def changeEvent(self, event: QEvent) -> None:
        """Follow the language and the colours."""
        if event.type() == QEvent.Type.LanguageChange and not isinstance(self._words, str):
            self.setText(self._words())
        elif event.type() == QEvent.Type.PaletteChange and self.text():
            self._color()
        super().changeEvent(event)

    def _color(self) -> None:
        colors = colors_of(self)
        ground, line = {
            Level.WARNING: (colors.warn_pale, colors.warn),
            Level.FAULT: (colors.stop_pale, colors.stop_ink),
        }.get(self._level, (colors.surface, colors.border))
        sheet = (
            f"#picture_note {{ background: {ground}; border: 1px solid {line}; "
            f"border-radius: 6px; padding: 6px 10px; color: {colors.text}; }}"
        )
        if sheet != self.styleSheet():  # which is itself a change of the palette
            self.setStyleSheet(sheet)
