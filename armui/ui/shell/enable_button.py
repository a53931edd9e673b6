"""The enable button: six numbered marks and a word; a click turns all six round."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFontMetrics, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QAbstractButton, QSizePolicy

from armui.arm.limits import JOINTS
from armui.control.operating_state import Busy, OperatingState
from armui.ui import format as fmt
from armui.ui.theme import Colors, colors_of, scaled_font
from armui.ui.widgets import painting
from armui.ui.widgets.translated import Translated
from armui.ui.words.text import Texts

_MARK_PX: Final = 20.0
_GAP_PX: Final = 4.0
_PAD_PX: Final = 10.0
_WORDS: Final = Texts("EnableButton") | {
    "enabling": "Enabling…",
    "disabling": "Disabling…",
    "enabled": "Enabled",
    "partly": "Partly enabled",
    "unknown": "Unknown",
    "disabled": "Disabled",
}


class EnableButton(Translated, QAbstractButton):
    """Filled mark: enabled. Hollow: disabled. Dashed: not heard. Each joint by the arm's word."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("enable_button")
        self._enabled: tuple[bool | None, ...] = (None,) * len(JOINTS)
        self._busy: Busy | None = None
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
        self.setAttribute(Qt.WidgetAttribute.WA_Hover)
        self.retranslate_ui()

    @property
    def marks(self) -> tuple[bool | None, ...]:
        """What the six marks show, joint 1 first."""
        return self._enabled

    @property
    def turns_off(self) -> bool:
        """Whether a click would disable: all six are enabled."""
        return all(self._enabled)

    def show_operating_state(self, operating_state: OperatingState) -> None:
        """Show what the arm says of its motors."""
        if (operating_state.enabled, operating_state.busy) != (self._enabled, self._busy):
            self._enabled, self._busy = operating_state.enabled, operating_state.busy
            self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Put the word into the operator's language."""
        self.setText(_WORDS.text(self._stands()))
        known = [fmt.joints([j for j, on in zip(JOINTS, self._enabled, strict=True) if on])]
        self.setAccessibleName(f"{self.text()} {known[0]}".strip())
        self.updateGeometry()
        self.update()

    def _stands(self) -> str:
        if self._busy is Busy.ENABLING:
            return "enabling"
        if self._busy is Busy.DISABLING:
            return "disabling"
        if all(self._enabled):
            return "enabled"
        if any(self._enabled):
            return "partly"
        return "unknown" if None in self._enabled else "disabled"

    def _word_width(self) -> int:
        metrics = QFontMetrics(scaled_font(self, 1.0, bold=True))
        return max(metrics.horizontalAdvance(_WORDS.text(word)) for word in _WORDS)

    def sizeHint(self) -> QSize:
        """As large as it wants to be."""
        marks = len(JOINTS) * (_MARK_PX + _GAP_PX) - _GAP_PX
        return QSize(int(2 * _PAD_PX + self._word_width() + _PAD_PX + marks), 40)

    def minimumSizeHint(self) -> QSize:
        """No smaller than that."""
        return self.sizeHint()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw it."""
        colors = colors_of(self)
        painter = painting.begin(self)
        active = self.isEnabled() and (self.underMouse() or self.isDown())
        fill = colors.accent_pale if active else colors.surface
        line = colors.accent if active or self.hasFocus() else colors.border
        painting.panel(painter, QRectF(self.rect()), fill, line, 2 if self.hasFocus() else 1)
        painter.setFont(scaled_font(self, 1.0, bold=True))
        painter.setPen(QColor(colors.text if self.isEnabled() else colors.muted))
        area = QRectF(_PAD_PX, 0, self._word_width() + 2, self.height())
        painter.drawText(
            area, Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft, self.text()
        )
        left = self.width() - _PAD_PX - len(JOINTS) * (_MARK_PX + _GAP_PX) + _GAP_PX
        painter.setFont(scaled_font(self, 0.85, bold=True))
        for joint, enabled in zip(JOINTS, self._enabled, strict=True):
            x = left + (joint - 1) * (_MARK_PX + _GAP_PX) + _MARK_PX / 2
            _draw_mark(painter, colors, QPointF(x, self.height() / 2), joint, enabled)
        painter.end()


def _draw_mark(
    painter: QPainter, colors: Colors, center: QPointF, joint: int, enabled: bool | None
) -> None:
    pen = QPen(QColor(colors.ok if enabled else colors.muted), 1.4)
    if enabled is None:
        pen.setStyle(Qt.PenStyle.DotLine)
    painter.setPen(pen)
    painter.setBrush(QColor(colors.ok) if enabled else Qt.BrushStyle.NoBrush)
    radius = _MARK_PX / 2 - 0.7
    painter.drawEllipse(center, radius, radius)
    painter.setPen(QColor(colors.surface if enabled else colors.muted))
    box = QRectF(center.x() - radius, center.y() - radius, 2 * radius, 2 * radius)
    painter.drawText(box, Qt.AlignmentFlag.AlignCenter, str(joint))
