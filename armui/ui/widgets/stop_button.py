"""The emergency stop: in the top bar and in every window, never disabled, never asked about."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFontMetrics, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

from armui.control.arm_controller import ArmController
from armui.control.operating_state import OperatingState, StopState
from armui.ui import words
from armui.ui.theme import Colors, colors_of, scaled_font
from armui.ui.widgets import painting
from armui.ui.widgets.press_button import Face, PressButton
from armui.ui.widgets.stop_shortcut import STOP_KEY_NAME
from armui.ui.widgets.translated import Translated

_LARGE: Final = Face(52, 200, 13.0, 12.0, 22.0, 10.0, 1.35, has_caption=True)
_SLIM: Final = Face(30, 0, 8.0, 8.0, 12.0, 8.0, 1.0, has_caption=False)
_CAPTION_SCALE: Final = 0.82


class StopButton(Translated, PressButton):
    """Stops the arm when pressed down, at every press: also an arm that has stopped, once more.

    It never releases the arm, which is the held button in the line of the next step.

    Args:
        controller: The controller of the arm.
        slim: True for one line, as in the windows beside the main one.
    """

    def __init__(
        self, controller: ArmController, parent: QWidget | None = None, *, slim: bool = False
    ) -> None:
        super().__init__(parent)
        self.setObjectName("stop_button")
        self._controller = controller
        self._face = _SLIM if slim else _LARGE
        self._operating_state = controller.operating_state
        controller.operating_state_changed.connect(self._on_operating_state_changed)
        self.retranslate_ui()

    # -- behaviour ----------------------------------------------------------------------------

    def act(self) -> None:
        """Stop the arm."""
        self._controller.emergency_stop()

    # -- appearance ---------------------------------------------------------------------------

    def _on_operating_state_changed(self, operating_state: OperatingState) -> None:
        old, self._operating_state = self._operating_state, operating_state
        if _shown(old) != _shown(operating_state):
            self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Set the present text in the operator's language."""
        self.setText(self._words())
        self.setAccessibleName(self.text())
        if self._operating_state.stop is StopState.STOPPED:
            tip = self.tr(
                "The arm has taken the emergency stop; a press sends it again. Release stands in "
                "the line of the next step above the panel: hold the arm before."
            )
        else:
            tip = self.tr(
                "Ends at once whatever drives the arm, and takes the power from its joints: they "
                "are only damped, and the arm sinks. Hold it. Key: {key}"
            ).format(key=STOP_KEY_NAME)
        self.setToolTip(tip)
        self.updateGeometry()
        self.update()

    def _words(self) -> str:
        if self._operating_state.stop is StopState.REQUESTED:
            if self._operating_state.stop_lapsed:
                return self.tr("Stop outstanding")
            if self._operating_state.stop_unconfirmed:
                return self.tr("Stop unconfirmed")
            return self.tr("Stopping…")
        return self.tr("Emergency stop")

    def _caption(self) -> str:
        """Return what stands below the word, smaller."""
        stop = self._operating_state.stop
        if stop is StopState.STOPPED:
            motion = self._operating_state.uncommanded
            if motion is not None:
                return words.uncommanded_motion_short(motion) or STOP_KEY_NAME
            return self.tr("The arm is at rest")
        if self._operating_state.stop_lapsed:
            return self.tr("Press to send it")
        return {
            StopState.REQUESTED: self.tr("Waiting for the arm"),
            StopState.RESUMING: self.tr("Hold the arm"),
        }.get(stop, STOP_KEY_NAME)

    def _all_words(self) -> list[str]:
        return [
            self.tr("Emergency stop"),
            self.tr("Stopping…"),
            self.tr("Stop unconfirmed"),
            self.tr("Stop outstanding"),
        ]

    def sizeHint(self) -> QSize:
        """Return a size for the longest of its texts, so that the bar does not change."""
        face = self._face
        return self._size(face.padding_px).expandedTo(QSize(face.least_px, face.height_px))

    def minimumSizeHint(self) -> QSize:
        """Return the size of its texts with smaller margins."""
        return self._size(self._face.tight_px)

    def _size(self, padding_px: float) -> QSize:
        face = self._face
        metrics = QFontMetrics(scaled_font(self, face.word_scale, bold=True))
        width = max(metrics.horizontalAdvance(word) for word in self._all_words())
        return QSize(int(2 * face.sign_px + face.gap_px + width + 2 * padding_px), face.height_px)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the button."""
        colors = colors_of(self)
        painter = painting.begin(self)
        fill = colors.stop_strong if self.isDown() or self.underMouse() else colors.stop
        painting.panel(painter, QRectF(self.rect()), fill, fill)
        ink = colors.on_stop
        if self.hasFocus():
            painter.setPen(QPen(QColor(ink), 1.5))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRoundedRect(QRectF(self.rect()).adjusted(4, 4, -4, -4), 5, 5)
        self._draw_face(painter, colors, ink)
        painter.end()

    def _draw_face(self, painter: QPainter, colors: Colors, ink: str) -> None:
        """Draw sign, word and caption, centred; the sign tells the state without its colour."""
        face = self._face
        word_font = scaled_font(self, face.word_scale, bold=True)
        caption_font = scaled_font(self, _CAPTION_SCALE)
        word, caption = QFontMetrics(word_font), QFontMetrics(caption_font)
        below = self._caption() if face.has_caption else ""
        text_width = max(word.horizontalAdvance(self.text()), caption.horizontalAdvance(below))
        left = (self.width() - (2 * face.sign_px + face.gap_px + text_width)) / 2
        center = QPointF(left + face.sign_px, self.height() / 2)
        self._draw_stop_sign(painter, center, ink, colors.stop)
        text_left = left + 2 * face.sign_px + face.gap_px
        top = (self.height() - word.height() - (caption.height() if below else 0)) / 2
        painter.setPen(QColor(ink))
        painter.setFont(word_font)
        painter.drawText(QPointF(text_left, top + word.ascent()), self.text())
        painter.setFont(caption_font)
        baseline = top + word.height() + caption.ascent()
        painter.drawText(QPointF(text_left, baseline), below)

    def _draw_stop_sign(self, painter: QPainter, center: QPointF, ink: str, ground: str) -> None:
        """Draw an octagon, with an exclamation mark until the arm confirms the stop."""
        unit = self._face.sign_px / 2
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(ink))
        painter.drawPolygon(painting.octagon(center, self._face.sign_px))
        painter.setPen(QPen(QColor(ground), 0.52 * unit, c=Qt.PenCapStyle.RoundCap))
        if self._operating_state.stop is StopState.REQUESTED:
            painter.drawLine(center + QPointF(0, -unit), center + QPointF(0, 0.08 * unit))
            painter.drawPoint(center + QPointF(0, unit))
        else:
            painter.drawLine(center + QPointF(-0.92 * unit, 0), center + QPointF(0.92 * unit, 0))


def _shown(operating_state: OperatingState) -> tuple[object, ...]:
    """Return what its words depend on."""
    now = operating_state
    return (now.stop, now.stop_unconfirmed, now.stop_lapsed, now.uncommanded)
