"""A button that moves something: by a step for each press, or for as long as it is held."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QEvent, QTimer, Signal
from PySide6.QtGui import QFocusEvent, QHideEvent, QKeyEvent, QMouseEvent
from PySide6.QtWidgets import QPushButton

from armui.ui.widgets.hold_guard import HoldGuard, can_be_let_go

_FIRST_REPEAT_MS: Final = 400
_REPEAT_MS: Final = 100


class JogButton(QPushButton):
    """Steps, or if it is :attr:`continuous` is held.

    Repetition or hold ends when it is released, left by the pointer, disabled or hidden, when it
    loses the focus, and when :class:`HoldGuard` reports it. A pointer that returns with its button
    still down does not begin again.
    """

    stepped = Signal()
    """Emitted when the button was pressed, for one step."""
    repeated = Signal()
    """Emitted for another step while the button is still held."""
    held = Signal()
    """Emitted when the button was pressed, to move until it is released."""
    hold_ended = Signal()
    """Emitted once after each :attr:`held`, when the hold is over."""
    unattended = Signal()
    """Emitted when the hold ended because the operator gave no sign for too long."""

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
        # Qt also emits `pressed` when the pointer returns with its button down: nothing may begin
        # then
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
        """Emit `hold_ended` before releasing the guard: the motion must end even if that fails."""
        self._timer.stop()
        if self._holding:
            self._holding = False
            self.hold_ended.emit()
        self._guard.release()

    def _on_timeout(self) -> None:
        # checked at each repetition, in case the end of the hold was not reported
        if not (self.isDown() and self.isEnabled() and self.isVisible()):
            self._end()
            return
        self._timer.setInterval(_REPEAT_MS)
        self.repeated.emit()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Mark a fresh press, which alone can begin something."""
        if not can_be_let_go(event):
            event.ignore()
            return
        self._fresh_press = True
        super().mousePressEvent(event)
        self._fresh_press = False

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Mark a fresh press of the space bar."""
        # a held space bar repeats, and its repetitions are no new presses
        self._fresh_press = not event.isAutoRepeat()
        super().keyPressEvent(event)
        self._fresh_press = False

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """End the hold."""
        self._end()
        super().focusOutEvent(event)

    def hideEvent(self, event: QHideEvent) -> None:
        """End the hold."""
        self._end()
        super().hideEvent(event)

    def changeEvent(self, event: QEvent) -> None:
        """End the hold when the button is disabled."""
        if event.type() == QEvent.Type.EnabledChange and not self.isEnabled():
            self._end()
        super().changeEvent(event)
