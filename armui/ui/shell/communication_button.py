"""The communication button: which device is connected, and whether an arm answers on it."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFont, QFontMetrics, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QAbstractButton, QSizePolicy

from armui.arm.device import Device
from armui.control.operating_state import LinkState, OperatingState
from armui.protocol.addressing import Addressing
from armui.ui import words
from armui.ui.theme import Colors, colors_of, scaled_font
from armui.ui.widgets import painting
from armui.ui.widgets.translated import Translated

_SIGN_PX: Final = 8.0
_WIDTH_PX: Final = 188
_HEIGHT_PX: Final = 46
_TEXT_LEFT_PX: Final = 12 + 2 * _SIGN_PX + 12
_TEXT_RIGHT_PX: Final = 8


class CommunicationButton(Translated, QAbstractButton):
    """A sign, a word and the device's name; each state has a sign of its own shape."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("communication_button")
        self._link = LinkState.NO_DEVICE
        self._device: Device | None = None
        self._addressing = Addressing()
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Maximum, QSizePolicy.Policy.Fixed)
        self.setAttribute(Qt.WidgetAttribute.WA_Hover)
        self.retranslate_ui()

    @property
    def link(self) -> LinkState:
        """The state shown."""
        return self._link

    @property
    def device_name(self) -> str:
        """The device shown; empty if there is none."""
        return "" if self._device is None else words.device_name(self._device)

    def show_operating_state(self, operating_state: OperatingState) -> None:
        """Show how the program stands to its arm."""
        shown = (self._link, self._device, self._addressing)
        if (operating_state.link, operating_state.device, operating_state.addressing) != shown:
            self._link, self._device = operating_state.link, operating_state.device
            self._addressing = operating_state.addressing
            self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Put the word into the operator's language."""
        tips = {
            LinkState.NO_DEVICE: self.tr("No CAN device is connected. Press to choose one."),
            LinkState.OPENING: self.tr("The CAN device is being opened."),
            LinkState.OFFLINE: self.tr(
                "The CAN device is open, but no arm is heard on it. "
                "Check the arm's power, the cable and the bit rate."
            ),
            LinkState.ONLINE: self.tr("The arm is heard. Press to disconnect or choose another."),
            LinkState.LOST: self.tr(
                "The CAN device is gone. Plug it in again: it is reconnected by itself."
            ),
        }
        self.setText(self._link_words()[self._link])
        lines = (self.device_name, tips[self._link], self._offset_text())
        self.setToolTip("\n".join(filter(None, lines)))
        self.setAccessibleName(f"{self.text()} {self.device_name}".strip())
        self.updateGeometry()
        self.update()

    def _offset_text(self) -> str:
        """Under which identifiers the arm is heard, where they are not the usual ones."""
        offset = self._addressing.feedback_offset
        if self._link is not LinkState.ONLINE or self._addressing == Addressing():
            return ""
        return self.tr("Its feedback comes from {feedback} on; see Linkage control.").format(
            feedback=f"0x{0x2A1 + offset:03X}"
        )

    def _link_words(self) -> dict[LinkState, str]:
        return {
            LinkState.NO_DEVICE: self.tr("Not connected"),
            LinkState.OPENING: self.tr("Connecting…"),
            LinkState.OFFLINE: self.tr("Offline"),
            LinkState.ONLINE: self.tr("Online"),
            LinkState.LOST: self.tr("Connection lost"),
        }

    def sizeHint(self) -> QSize:
        """As large as it wants to be."""
        return self.minimumSizeHint().expandedTo(QSize(_WIDTH_PX, _HEIGHT_PX))

    def minimumSizeHint(self) -> QSize:
        """The word is never cut; the device's name gives way."""
        metrics = QFontMetrics(self._word_font())
        word = max(metrics.horizontalAdvance(word) for word in self._link_words().values())
        return QSize(int(_TEXT_LEFT_PX + word + _TEXT_RIGHT_PX) + 1, _HEIGHT_PX)

    def _word_font(self) -> QFont:
        return scaled_font(self, 1.05, bold=True)

    def _second_line(self) -> str:
        return self.device_name or self.tr("Choose a device")

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw it."""
        colors = colors_of(self)
        painter = painting.begin(self)
        active = self.underMouse() or self.isDown()
        fill = colors.accent_pale if active else colors.surface
        line = colors.accent if active or self.hasFocus() else colors.border
        painting.panel(painter, QRectF(self.rect()), fill, line, 2 if self.hasFocus() else 1)
        _draw_sign(painter, colors, QPointF(12 + _SIGN_PX, self.height() / 2), self._link)
        half = self.height() / 2
        width = self.width() - _TEXT_LEFT_PX - _TEXT_RIGHT_PX
        painter.setFont(self._word_font())
        painter.setPen(QColor(colors.text))
        above = QRectF(_TEXT_LEFT_PX, 0, width, half)
        painter.drawText(above, Qt.AlignmentFlag.AlignBottom, self.text())
        font = scaled_font(self, 0.88)
        name = QFontMetrics(font).elidedText(
            self._second_line(), Qt.TextElideMode.ElideRight, int(width)
        )
        painter.setFont(font)
        painter.setPen(QColor(colors.muted))
        below = QRectF(_TEXT_LEFT_PX, half + 1, width, half)
        painter.drawText(below, Qt.AlignmentFlag.AlignTop, name)
        painter.end()


def _draw_sign(painter: QPainter, colors: Colors, center: QPointF, link: LinkState) -> None:
    """Tick: online. Ring: offline. Dotted ring: nothing. Arc: opening. Triangle: lost."""
    round_cap = Qt.PenCapStyle.RoundCap
    painter.setBrush(Qt.BrushStyle.NoBrush)
    box = QRectF(
        center.x() - _SIGN_PX + 1, center.y() - _SIGN_PX + 1, 2 * _SIGN_PX - 2, 2 * _SIGN_PX - 2
    )
    if link is LinkState.ONLINE:
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(colors.ok))
        painter.drawEllipse(center, _SIGN_PX, _SIGN_PX)
        painter.setPen(QPen(QColor(colors.surface), 2, c=round_cap))
        painter.drawLine(center + QPointF(-3.5, 0.3), center + QPointF(-1.0, 3.0))
        painter.drawLine(center + QPointF(-1.0, 3.0), center + QPointF(3.8, -2.8))
    elif link is LinkState.OFFLINE:
        painter.setPen(QPen(QColor(colors.warn), 2.4))
        painter.drawEllipse(box)
        painter.setPen(QPen(QColor(colors.warn), 2.4, c=round_cap))
        painter.drawLine(center + QPointF(-2.6, 0), center + QPointF(2.6, 0))
    elif link is LinkState.OPENING:
        painter.setPen(QPen(QColor(colors.accent), 2.4, c=round_cap))
        painter.drawArc(box, 30 * 16, 240 * 16)
    elif link is LinkState.LOST:
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(colors.stop))
        painter.drawPolygon(painting.triangle(center + QPointF(0, 1.5), _SIGN_PX + 1.5))
        painter.setPen(QPen(QColor(colors.surface), 1.8, c=round_cap))
        painter.drawLine(center + QPointF(0, -2.5), center + QPointF(0, 1.8))
        painter.drawPoint(center + QPointF(0, 4.6))
    else:
        painter.setPen(QPen(QColor(colors.muted), 1.6, Qt.PenStyle.DotLine))
        painter.drawEllipse(box)
