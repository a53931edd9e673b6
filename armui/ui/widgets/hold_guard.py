"""Ends the hold of a control when the operator cannot be holding it any more.

Reasons are another window in front, a hidden or closing one, and a time without a sign of the
operator: when the connection of a remote desktop drops, some servers leave the mouse button and the
keys pressed forever.
"""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QEvent, QObject, Qt, QTimer, Signal
from PySide6.QtGui import QGuiApplication, QKeyEvent, QMouseEvent
from PySide6.QtWidgets import QWidget

from armui.arm.refusal import Reason

HOLD_UNATTENDED = Reason(
    "hold_unattended",
    "Jogging ended: held for {seconds} s without a movement of the mouse or another key. Let "
    "go and press again; move the mouse a little while you hold it for long.",
)


_ENDS: Final = frozenset(
    {
        QEvent.Type.WindowDeactivate,
        QEvent.Type.WindowStateChange,
        QEvent.Type.WindowBlocked,
        QEvent.Type.Close,
        QEvent.Type.Hide,
    }
)
_KEYS: Final = frozenset({QEvent.Type.KeyPress, QEvent.Type.KeyRelease})

UNATTENDED_S: Final = 10
"""A hold ends after this time without a movement of the pointer or another key."""


def can_be_let_go(press: QMouseEvent) -> bool:
    """Return whether Qt will report the release of a press: no other mouse button is down.

    While another button is down that was pressed elsewhere, or on a widget that has gone, Qt
    reports the press of a further button to a widget, but its release to none.
    """
    return press.buttons() == press.button()


class HoldGuard(QObject):
    """Watches the window of a control while it is held.

    Args:
        control: The widget that is held, which is the guard's parent.
        unattended_s: The longest hold without a sign of the operator.
    """

    lost = Signal()
    """Emitted when the hold has ended, even if a button is still pressed."""

    unattended = Signal()
    """Emitted after :attr:`lost` if nothing moved for too long."""

    def __init__(self, control: QWidget, unattended_s: float = UNATTENDED_S) -> None:
        super().__init__(control)
        self._control = control
        self._patience = QTimer(self, singleShot=True, interval=round(1000 * unattended_s))
        self._patience.timeout.connect(self._on_unattended)
        self._window: QWidget | None = None
        application = QGuiApplication.instance()
        if isinstance(application, QGuiApplication):
            application.applicationStateChanged.connect(self._on_application_state)

    def watch(self, window: QWidget | None = None) -> None:
        """Begin to watch a hold.

        Args:
            window: The window that must stay in front; by default the control's own.
        """
        self.release()
        self._window = window or self._control.window()
        self._window.installEventFilter(self)
        # while a button is down, moves of the pointer go to the control and need not reach the
        # window
        self._control.installEventFilter(self)
        self._patience.start()

    def release(self) -> None:
        """Stop watching: the hold is over."""
        self._patience.stop()
        self._control.removeEventFilter(self)
        if self._window is not None:
            self._window.removeEventFilter(self)
            self._window = None

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        """Detect the end of the hold; the window gets all its events."""
        kind = event.type()
        if kind in _ENDS:
            self.lost.emit()
        elif kind is QEvent.Type.MouseMove or (
            kind in _KEYS and isinstance(event, QKeyEvent) and not event.isAutoRepeat()
        ):
            # a held key repeats by itself, so a repetition is no sign of the operator
            self._patience.start()
        return False

    def _on_unattended(self) -> None:
        self.lost.emit()
        self.unattended.emit()

    def _on_application_state(self, state: Qt.ApplicationState) -> None:
        if self._window is not None and state is not Qt.ApplicationState.ApplicationActive:
            self.lost.emit()
