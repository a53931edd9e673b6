"""The note over the picture, placed where it hides least of the arm."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QEvent, QObject, QPointF, QRect, QSize, Qt, QTimer
from PySide6.QtGui import QHideEvent, QShowEvent
from PySide6.QtWidgets import QLabel, QWidget

from armui.control.events import Level
from armui.ui.picture.note_place import freest, note_places
from armui.ui.theme import colors_of

if TYPE_CHECKING:
    from armui.viewport.view import ArmView

_LONG_MS: Final = 6000
"""The time for which a note is shown, unless it stays."""
_LOOK_MS: Final = 250
"""The period of checking whether the arm has moved behind the visible note."""
_WIDEST_PX: Final = 420
_NARROW_PX: Final = 240
"""The least width: a text that fits into it stays in one line."""
_NOTE_RIM_PX: Final = 11


class PictureNote(QLabel):
    """A note over the picture, beside the arm where possible, transparent for the mouse."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("picture_note")
        self.setWordWrap(True)
        self.setTextFormat(Qt.TextFormat.PlainText)
        self.setMaximumWidth(_WIDEST_PX)
        self.setIndent(0)  # the padding of the style sheet is the only margin
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self._words: str | Callable[[], str] = ""
        self._level = Level.INFO
        self._end = QTimer(self, singleShot=True, interval=_LONG_MS)
        self._end.timeout.connect(self.hide)
        self._view: ArmView | None = None
        self._place = 0
        self._place_timer = QTimer(self, interval=_LOOK_MS)
        self._place_timer.timeout.connect(self.find_place)
        self.hide()

    def stand_over(self, region: QWidget, view: ArmView) -> None:
        """Place the note in a region of the window, over the view that is in it."""
        self._view = view
        self.setParent(region)
        view.installEventFilter(self)

    def find_place(self) -> None:
        """Move to the place that hides least of the arm; arm or camera may have moved."""
        view = self._view
        if view is None or not self.isVisible():
            return
        width = min(self.maximumWidth(), max(self.minimumWidth(), self.sizeHint().width()))
        height = self.heightForWidth(width)
        places = note_places(view.room, width, height)
        self._place = freest(places, view.arm_boxes(), self._place)
        corner = QPointF(places[self._place].left, places[self._place].top).toPoint()
        self.setGeometry(QRect(view.pos() + corner, QSize(width, height)))

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Find a new place when the picture has another size."""
        if watched is self._view and event.type() in {QEvent.Type.Resize, QEvent.Type.Move}:
            self.find_place()
        return super().eventFilter(watched, event)

    def showEvent(self, event: QShowEvent) -> None:
        """Follow the arm's motion while the note is visible."""
        super().showEvent(event)
        self._place_timer.start()
        self.find_place()

    def hideEvent(self, event: QHideEvent) -> None:
        """Stop looking for a better place while the note is hidden."""
        self._place_timer.stop()
        super().hideEvent(event)

    def show_message(
        self, words: str | Callable[[], str], level: Level = Level.INFO, *, stays: bool = False
    ) -> None:
        """Show a text; an empty text hides the note.

        Args:
            words: The text, or a function that returns it in the present language.
            level: Its severity.
            stays: True if it stays until another text.
        """
        self._end.stop()
        self._words, self._level = words, level
        text = words if isinstance(words, str) else words()
        self._write(text)
        self._color()
        self.setVisible(bool(text))
        if text and not stays:
            self._end.start()

    def _write(self, text: str) -> None:
        """Show a text, in one line where it is a short one."""
        self.setText(text)
        self.setAccessibleName(text)
        self.ensurePolished()  # the width of the text depends on the theme's font
        line_px = self.fontMetrics().horizontalAdvance(text) + 2 * _NOTE_RIM_PX
        self.setMinimumWidth(min(line_px, _NARROW_PX) if text else 0)
        self.find_place()

    def changeEvent(self, event: QEvent) -> None:
        """Update text and colours after a change of language or theme."""
        if event.type() == QEvent.Type.LanguageChange and not isinstance(self._words, str):
            self._write(self._words())
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
            f"border-radius: 6px; padding: 6px {_NOTE_RIM_PX - 1}px; color: {colors.text}; }}"
        )
        # setting it is itself a change of the palette, which would lead here again
        if sheet != self.styleSheet():
            self.setStyleSheet(sheet)
