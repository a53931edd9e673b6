"""A button that acts when it is pressed, not when it is released, behind any popup."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFontMetrics, QMouseEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QPushButton, QSizePolicy, QWidget

from armui.ui.theme import Colors, colors_of, scaled_font
from armui.ui.widgets import painting
from armui.ui.widgets.tips import keep_in_sight

_CAPTION_SCALE: Final = 0.82


@dataclass(frozen=True, slots=True)
class Face:
    """The measures of a stop button: a large one with its key below the word, or a slim one.

    Attributes:
        height_px: The height of the button.
        least_px: The least width, if there is room.
        sign_px: The radius of the sign.
        gap_px: The gap between sign and word.
        padding_px: The margins at the left and right of both.
        tight_px: The margins if there is little room.
        word_scale: The size of the word's font, as a multiple of the window's.
        has_caption: True if a second line stands below the word.
    """

    height_px: int
    least_px: int
    sign_px: float
    gap_px: float
    padding_px: float
    tight_px: float
    word_scale: float
    has_caption: bool


@dataclass(frozen=True, slots=True)
class Inks:
    """The colours of a stop button.

    Attributes:
        ground: The background.
        edge: The line around it.
        word: The colour of sign and word.
        caption: The colour of the line below the word.
    """

    ground: str
    edge: str
    word: str
    caption: str


class PressButton(QPushButton):
    """The base of the stop and the halt button, which draws sign, word and caption.

    Args:
        face: The measures.
        parent: The parent widget.
    """

    def __init__(self, face: Face, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._face = face
        self.setAutoDefault(False)
        self.setCursor(Qt.CursorShape.PointingHandCursor)
        self.setSizePolicy(QSizePolicy.Policy.Maximum, QSizePolicy.Policy.Fixed)
        keep_in_sight(self)
        self._has_acted = False
        self.pressed.connect(self._on_pressed)

    def act(self) -> None:
        """Carry out the button's action."""
        raise NotImplementedError

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Act first, because Qt repaints the whole button before it emits `pressed`."""
        left = event.button() == Qt.MouseButton.LeftButton
        self._has_acted = left and self.hitButton(event.position().toPoint())
        if self._has_acted:
            self.act()
        super().mousePressEvent(event)
        self._has_acted = False

    def _on_pressed(self) -> None:
        """Act on a press by keyboard or assistive program; one by the mouse has acted already."""
        if not self._has_acted:
            self.act()

    # What a subclass defines ----------------------------------------------------------------------

    def _inks(self, colors: Colors, *, pressed: bool) -> Inks:
        """Return the colours, for a button that is pressed or pointed at, or not."""
        raise NotImplementedError

    def _all_words(self) -> Sequence[str]:
        """Return all words that it can show: the widest sets its width."""
        raise NotImplementedError

    def _caption(self) -> str:
        """Return the smaller text below the word."""
        raise NotImplementedError

    def _draw_sign(self, painter: QPainter, center: QPointF, colors: Colors) -> None:
        """Draw the sign, whose shape distinguishes the buttons without colour."""
        raise NotImplementedError

    # Appearance -----------------------------------------------------------------------------------

    def sizeHint(self) -> QSize:
        """Return a size for the longest of its words."""
        face = self._face
        return self._size(face.padding_px).expandedTo(QSize(face.least_px, face.height_px))

    def minimumSizeHint(self) -> QSize:
        """Return the same with smaller margins."""
        return self._size(self._face.tight_px)

    def _size(self, padding_px: float) -> QSize:
        face = self._face
        metrics = QFontMetrics(scaled_font(self, face.word_scale, bold=True))
        width = max(metrics.horizontalAdvance(word) for word in self._all_words())
        return QSize(int(2 * face.sign_px + face.gap_px + width + 2 * padding_px), face.height_px)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the button."""
        colors = colors_of(self)
        inks = self._inks(colors, pressed=self.isDown() or self.underMouse())
        painter = painting.begin(self)
        painting.panel(painter, QRectF(self.rect()), inks.ground, inks.edge, 2)
        if self.hasFocus():
            painter.setPen(QPen(QColor(inks.word), 1.5))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRoundedRect(QRectF(self.rect()).adjusted(4, 4, -4, -4), 5, 5)
        self._draw_face(painter, colors, inks)
        painter.end()

    def _draw_face(self, painter: QPainter, colors: Colors, inks: Inks) -> None:
        """Draw sign, word and caption, centred."""
        face = self._face
        word_font = scaled_font(self, face.word_scale, bold=True)
        caption_font = scaled_font(self, _CAPTION_SCALE)
        word, caption = QFontMetrics(word_font), QFontMetrics(caption_font)
        below = self._caption() if face.has_caption else ""
        text_width = max(word.horizontalAdvance(self.text()), caption.horizontalAdvance(below))
        left = (self.width() - (2 * face.sign_px + face.gap_px + text_width)) / 2
        self._draw_sign(painter, QPointF(left + face.sign_px, self.height() / 2), colors)
        text_left = left + 2 * face.sign_px + face.gap_px
        top = (self.height() - word.height() - (caption.height() if below else 0)) / 2
        painter.setPen(QColor(inks.word))
        painter.setFont(word_font)
        painter.drawText(QPointF(text_left, top + word.ascent()), self.text())
        painter.setPen(QColor(inks.caption))
        painter.setFont(caption_font)
        painter.drawText(QPointF(text_left, top + word.height() + caption.ascent()), below)
