"""Halt and hold 停住: ends any motion with power on; beside the emergency stop, and smaller."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFontMetrics, QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

from armui.control.arm_controller import ArmController
from armui.ui.theme import colors_of, scaled_font
from armui.ui.widgets import painting
from armui.ui.widgets.press_button import Face, PressButton
from armui.ui.widgets.stop_shortcut import HALT_KEY_NAME
from armui.ui.widgets.translated import Translated

_LARGE: Final = Face(52, 0, 8.0, 9.0, 14.0, 8.0, 1.15, has_caption=True)
_SLIM: Final = Face(30, 0, 6.0, 7.0, 12.0, 8.0, 1.0, has_caption=False)
_CAPTION_SCALE: Final = 0.82
_SQUARE: Final = 1.5
"""The side of the stop square, by the sign's radius. Two bars would promise that it goes on."""


class HaltButton(Translated, PressButton):
    """Ends the arm's motion when pressed down; the joints hold where they come to rest.

    Args:
        controller: The controller of the arm.
        slim: True for one line, as in the windows beside the main one.
    """

    def __init__(
        self, controller: ArmController, parent: QWidget | None = None, *, slim: bool = False
    ) -> None:
        super().__init__(parent)
        self._face = _SLIM if slim else _LARGE
        self.setObjectName("halt_button")
        self._controller = controller
        self.retranslate_ui()

    def act(self) -> None:
        """End the motion."""
        self._controller.halt_and_hold()

    def retranslate_ui(self) -> None:
        """Set the text in the operator's language."""
        self.setText(self.tr("Halt"))
        self.setAccessibleName(self.text())
        self.setToolTip(
            self.tr(
                "Ends any motion; the motors keep their power and the arm holds where it comes to "
                "rest. Key: {key}"
            ).format(key=HALT_KEY_NAME)
        )
        self.updateGeometry()
        self.update()

    def sizeHint(self) -> QSize:
        """Return a size with room for sign, word and key."""
        return self._size(self._face.padding_px)

    def minimumSizeHint(self) -> QSize:
        """Return the same with smaller margins."""
        return self._size(self._face.tight_px)

    def _size(self, padding_px: float) -> QSize:
        face = self._face
        width = 2 * face.sign_px + face.gap_px + self._text_width() + 2 * padding_px
        return QSize(int(width), face.height_px)

    def _caption(self) -> str:
        """Return what stands below the word, smaller."""
        return HALT_KEY_NAME if self._face.has_caption else ""

    def _text_width(self) -> int:
        word = QFontMetrics(scaled_font(self, self._face.word_scale, bold=True))
        caption = QFontMetrics(scaled_font(self, _CAPTION_SCALE))
        return max(word.horizontalAdvance(self.text()), caption.horizontalAdvance(self._caption()))

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the stop square, the word, and the key below it."""
        colors = colors_of(self)
        painter = painting.begin(self)
        pressed = self.isDown() or self.underMouse()
        ground = colors.stop_pale if pressed else colors.surface
        painting.panel(painter, QRectF(self.rect()), ground, colors.stop_ink, 2)
        if self.hasFocus():
            painter.setPen(QPen(QColor(colors.stop_ink), 1.0))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRoundedRect(QRectF(self.rect()).adjusted(4, 4, -4, -4), 5, 5)
        word_font = scaled_font(self, self._face.word_scale, bold=True)
        caption_font = scaled_font(self, _CAPTION_SCALE)
        word, caption = QFontMetrics(word_font), QFontMetrics(caption_font)
        face = self._face
        left = (self.width() - (2 * face.sign_px + face.gap_px + self._text_width())) / 2
        side_px = _SQUARE * face.sign_px
        square = QRectF(0.0, 0.0, side_px, side_px)
        square.moveCenter(QPointF(left + face.sign_px, self.height() / 2))
        painter.fillRect(square, QColor(colors.stop_ink))
        text_left = left + 2 * face.sign_px + face.gap_px
        below_px = caption.height() if face.has_caption else 0
        top = (self.height() - word.height() - below_px) / 2
        painter.setPen(QColor(colors.stop_ink))
        painter.setFont(word_font)
        painter.drawText(QPointF(text_left, top + word.ascent()), self.text())
        painter.setFont(caption_font)
        painter.setPen(QColor(colors.muted))
        baseline = top + word.height() + caption.ascent()
        painter.drawText(QPointF(text_left, baseline), self._caption())
        painter.end()
