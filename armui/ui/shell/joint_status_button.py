"""Region 10: how the worst of the six joints is, all the time; a click opens their window."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFontMetrics, QPaintEvent
from PySide6.QtWidgets import QAbstractButton, QSizePolicy

from armui.arm.joint_status import StatusVerdict
from armui.arm.limits import JOINTS
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.theme import colors_of, scaled_font
from armui.ui.widgets import painting, state_mark
from armui.ui.widgets.state_mark import Mark
from armui.ui.widgets.translated import Translated

if TYPE_CHECKING:
    from armui.control.devices.joint_monitor import JointMonitor

_HEIGHT_PX: Final = 52
_WIDTH_PX: Final = 150
_MARK_PX: Final = 9.0
_TEXT_LEFT_PX: Final = 12 + 2 * _MARK_PX + 10
_TEXT_RIGHT_PX: Final = 8

_MARKS: Final = {
    StatusVerdict.NORMAL: Mark.GOOD,
    StatusVerdict.DISABLED: Mark.OFF,
    StatusVerdict.UNKNOWN: Mark.UNKNOWN,
    StatusVerdict.FAULT: Mark.FAULT,
    StatusVerdict.OFFLINE: Mark.OFFLINE,
}


class JointStatusButton(Translated, QAbstractButton):
    """A mark, the name of the window, and in words how the joints are.

    Args:
        monitor: Knows the joints.
    """

    def __init__(self, monitor: JointMonitor) -> None:
        super().__init__()
        self.setObjectName("joint_status_button")
        self._monitor = monitor
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setAttribute(Qt.WidgetAttribute.WA_Hover)
        monitor.worst_changed.connect(self.retranslate_ui)
        self.retranslate_ui()

    @property
    def mark(self) -> Mark:
        """The mark shown."""
        return _MARKS[self._monitor.worst.verdict]

    @property
    def state_text(self) -> str:
        """The state shown in words: how it is, and which joints it is about."""
        worst = self._monitor.worst
        text = words.joint_verdict(worst.verdict)
        if worst.joints and len(worst.joints) < len(JOINTS):
            return f"{text} {fmt.joint_spans(list(worst.joints))}"
        if worst.joints and worst.verdict is StatusVerdict.FAULT:
            return f"{text} J1–J6"
        return f"{text} {fmt.NOTHING}" if worst.verdict is StatusVerdict.UNKNOWN else text

    def retranslate_ui(self) -> None:
        """Say how the joints are in the operator's language."""
        self.setText(self.tr("Joint status"))
        self.setAccessibleName(f"{self.text()} {self.state_text}")
        faults = [
            f"J{joint}  {words.joint_item(item)} {words.joint_word(word)}"
            for joint, item, word in self._monitor.faults
        ]
        tip = self.tr("The worst of the six joints. Press to see all of them.")
        self.setToolTip("\n".join([self.state_text, *faults, tip]))
        self.update()

    def sizeHint(self) -> QSize:
        """As large as it wants to be."""
        return QSize(_WIDTH_PX, _HEIGHT_PX)

    def minimumSizeHint(self) -> QSize:
        """No smaller than that."""
        return self.sizeHint()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw it."""
        colors = colors_of(self)
        fault = self._monitor.worst.verdict is StatusVerdict.FAULT
        painter = painting.begin(self)
        active = self.underMouse() or self.isDown()
        ground = colors.stop_pale if fault else colors.surface
        fill = colors.accent_pale if active else ground
        edge = colors.stop if fault else colors.border
        line = colors.accent if active or self.hasFocus() else edge
        painting.panel(painter, QRectF(self.rect()), fill, line, 2 if self.hasFocus() else 1)
        center = QPointF(12 + _MARK_PX, self.height() / 2)
        state_mark.draw(painter, colors, center, _MARK_PX, self.mark)
        half, width = self.height() / 2, self.width() - _TEXT_LEFT_PX - _TEXT_RIGHT_PX
        painter.setFont(scaled_font(self, 1.0, bold=True))
        painter.setPen(QColor(colors.text))
        above = QRectF(_TEXT_LEFT_PX, 0, width, half)
        painter.drawText(above, Qt.AlignmentFlag.AlignBottom, self.text())
        font = scaled_font(self, 0.92, bold=fault)
        state = QFontMetrics(font).elidedText(
            self.state_text, Qt.TextElideMode.ElideRight, int(width)
        )
        painter.setFont(font)
        painter.setPen(QColor(colors.text if fault else colors.muted))
        below = QRectF(_TEXT_LEFT_PX, half + 1, width, half)
        painter.drawText(below, Qt.AlignmentFlag.AlignTop, state)
        painter.end()
