"""A button that moves something: by one step a press, or for as long as it is held."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QEvent, QTimer, Signal
from PySide6.QtGui import QFocusEvent, QHideEvent, QKeyEvent, QMouseEvent
from PySide6.QtWidgets import QPushButton

from armui.ui.widgets.hold_guard import HoldGuard

_FIRST_REPEAT_MS: Final = 400
_REPEAT_MS: Final = 100


class JogButton(QPushButton):
    """Steps, or when it is :attr:`continuous` is held.

    Letting go, the pointer leaving it, losing the focus, being disabled or hidden, and all that
    :class:`HoldGuard` watches for end the repetition or the hold. A pointer that comes back with
    its button still down does not begin anew.
    """

    stepped = Signal()
    """The button was pressed: one step."""
    repeated = Signal()
    """The button is still held: another step."""
    held = Signal()
    """The button was pressed: move until it is let go."""
    let_go = Signal()
    """The hold is over; comes once after each :attr:`held`."""
    unattended = Signal()
    """It ended because the operator gave no sign for too long."""

    def __init__(self, sign: str) -> None:
        super().__init__(sign)
        self.continuous = False
        self._fresh_press = False
        self._holding = False
        self._guard = HoldGuard(self)
        self.setProperty("step", True)
        self.setAutoDefault(False)
        self.setFixedSize(34, 32)
        self._timer = QTimer(self)
        self._timer.timeout.connect(self._on_timeout)
        self._guard.lost.connect(self._end)
        self._guard.unattended.connect(self.unattended)
        self.pressed.connect(self._on_pressed)
        self.released.connect(self._end)

    def _on_pressed(self) -> None:
        if not self._fresh_press:
            return
        self._fresh_press = False
        self._guard.watch()
        if self.continuous:
            self._holding = True
            self.held.emit()
        else:
            self._timer.start(_FIRST_REPEAT_MS)
            self.stepped.emit()

    def _end(self) -> None:
        """The motion ends before anything is done that could fail."""
        self._timer.stop()
        if self._holding:
            self._holding = False
            self.let_go.emit()
        self._guard.release()

    def _on_timeout(self) -> None:
        if not (self.isDown() and self.isEnabled() and self.isVisible()):
            self._end()
            return
        self._timer.setInterval(_REPEAT_MS)
        self.repeated.emit()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Only a finger that goes down begins something."""
        self._fresh_press = True
        super().mousePressEvent(event)
        self._fresh_press = False

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """The same for the space bar."""
        self._fresh_press = not event.isAutoRepeat()
        super().keyPressEvent(event)
        self._fresh_press = False

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """The operator has turned to something else."""
        self._end()
        super().focusOutEvent(event)

    def hideEvent(self, event: QHideEvent) -> None:
        """What is not seen is not held."""
        self._end()
        super().hideEvent(event)

    def changeEvent(self, event: QEvent) -> None:
        """What is disabled is not held."""
        if event.type() == QEvent.Type.EnabledChange and not self.isEnabled():
            self._end()
        super().changeEvent(event)
