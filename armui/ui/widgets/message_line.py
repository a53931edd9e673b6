"""The place where a panel says what stands in the way and what to do about it."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QRectF, QSize, Qt
from PySide6.QtGui import QPaintEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QSizePolicy, QWidget

from armui.control.situation import Level
from armui.ui.theme import Colors, colors_of
from armui.ui.widgets import icons, painting

_ICON_PX = 20
_LINES = 2


class MessageLine(QWidget):
    """One message with a sign before it; keeps its room when there is nothing to say."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._level = Level.INFO
        self._icon = QLabel()
        self._icon.setFixedWidth(_ICON_PX)
        self._label = QLabel()
        self._label.setWordWrap(True)
        self._label.setTextFormat(Qt.TextFormat.PlainText)
        self._label.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(12, 8, 12, 8)
        layout.setSpacing(10)
        layout.addWidget(self._icon, 0, Qt.AlignmentFlag.AlignVCenter)
        layout.addWidget(self._label, 1)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Minimum)
        self.show_message("")

    def text(self) -> str:
        """What it says now."""
        return self._label.text()

    def show_message(self, text: str, level: Level = Level.INFO) -> None:
        """Say something; an empty text says nothing."""
        self._level = level
        self._label.setText(text)
        self.setAccessibleName(text)
        self._update_icon()
        self.update()

    def minimumSizeHint(self) -> QSize:
        return QSize(120, _LINES * self.fontMetrics().lineSpacing() + 18)

    def sizeHint(self) -> QSize:
        return self.minimumSizeHint().expandedTo(super().sizeHint())

    def changeEvent(self, event: QEvent) -> None:
        if event.type() == QEvent.Type.PaletteChange:
            self._update_icon()
        super().changeEvent(event)

    def paintEvent(self, _event: QPaintEvent) -> None:
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
        name = "warning" if self._level in {Level.WARNING, Level.FAULT} else "info"
        self._icon.setPixmap(icons.pixmap(name, ink, _ICON_PX, self.devicePixelRatioF()))

    def _paint_colors(self, colors: Colors) -> tuple[str, str]:
        return {
            Level.INFO: (colors.accent_pale, colors.accent),
            Level.DONE: (colors.accent_pale, colors.ok),
            Level.WARNING: (colors.warn_pale, colors.warn),
            Level.FAULT: (colors.stop_pale, colors.stop),
        }[self._level]
