"""A button that moves a joint by one step at once, and again and again while it is held."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QTimer, Signal
from PySide6.QtWidgets import QPushButton, QWidget

_FIRST_REPEAT_MS: Final = 400
_REPEAT_MS: Final = 100


class JogButton(QPushButton):
    """Emits :attr:`stepped` on press and :attr:`repeated` while held.

    Letting go, losing the focus, being disabled and being hidden all end the repetition.
    """

    stepped = Signal()
    """The button was pressed: one step."""
    repeated = Signal()
    """The button is still held: another step."""

    def __init__(self, sign: str, parent: QWidget | None = None) -> None:
        super().__init__(sign, parent)
        self.setProperty("step", True)
        self.setAutoDefault(False)
        self.setFixedSize(34, 32)
        self._timer = QTimer(self)
        self._timer.timeout.connect(self._on_timeout)
        self.pressed.connect(self._on_pressed)
        self.released.connect(self._timer.stop)

    def _on_pressed(self) -> None:
        self._timer.start(_FIRST_REPEAT_MS)
        self.stepped.emit()

    def _on_timeout(self) -> None:
        if not (self.isDown() and self.isEnabled() and self.isVisible()):
            self._timer.stop()
            return
        self._timer.setInterval(_REPEAT_MS)
        self.repeated.emit()
