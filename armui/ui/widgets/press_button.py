"""A button that acts when it is pressed, not when it is released, behind any popup."""

from __future__ import annotations

from dataclasses import dataclass

from PySide6.QtCore import Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QPushButton, QSizePolicy, QWidget


@dataclass(frozen=True, slots=True)
class Face:
    """The measures of a stop button: a large one with its key below the word, or a slim line.

    Attributes:
        height_px: Of the button.
        least_px: Its width at least, where there is room.
        sign_px: The sign's radius.
        gap_px: Between sign and word.
        padding_px: Left and right of them.
        tight_px: The same where there is no room.
        word_scale: The word's font, by the window's.
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


class PressButton(QPushButton):
    """The base of the stop and the halt button."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAutoDefault(False)
        self.setCursor(Qt.CursorShape.PointingHandCursor)
        self.setSizePolicy(QSizePolicy.Policy.Maximum, QSizePolicy.Policy.Fixed)
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
