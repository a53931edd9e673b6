"""A key or a mouse gesture as it is drawn in a manual."""

from __future__ import annotations

from PySide6.QtCore import QRectF
from PySide6.QtGui import QPaintEvent
from PySide6.QtWidgets import QLabel, QSizePolicy

from armui.ui.theme import colors_of
from armui.ui.widgets import painting


class KeyCap(QLabel):
    """A word in a box that looks like a key."""

    def __init__(self) -> None:
        super().__init__()
        self.setContentsMargins(9, 4, 9, 5)
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the key, then the word on it."""
        colors = colors_of(self)
        painter = painting.begin(self)
        box = QRectF(self.rect())
        painting.panel(painter, box, colors.border, colors.border)
        painting.panel(painter, box.adjusted(0, 0, 0, -2), colors.surface, colors.border)
        painter.end()
        super().paintEvent(event)
