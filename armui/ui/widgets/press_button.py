"""A button that acts when it is pressed, not when it is let go, whatever popup is open."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QPushButton, QSizePolicy, QWidget


class PressButton(QPushButton):
    """The base of the stop and the halt."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAutoDefault(False)
        self.setCursor(Qt.CursorShape.PointingHandCursor)
        self.setSizePolicy(QSizePolicy.Policy.Maximum, QSizePolicy.Policy.Fixed)

    def press_behind_popup(self) -> bool:
        """Act as if pressed while a popup holds the mouse; false: let the popup have the press."""
        raise NotImplementedError
