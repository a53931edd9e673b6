"""What takes a held control away from the operator: another window, a hidden or closing one."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QWidget

_ENDS: Final = frozenset(
    {
        QEvent.Type.WindowDeactivate,
        QEvent.Type.WindowStateChange,
        QEvent.Type.WindowBlocked,
        QEvent.Type.Close,
        QEvent.Type.Hide,
    }
)


class HoldGuard(QObject):
    """Watches the window of a control while it is held.

    Args:
        control: The widget that is held; the guard lives and dies with it.
    """

    lost = Signal()
    """The hold counts no more, whatever finger is still down."""

    def __init__(self, control: QWidget) -> None:
        super().__init__(control)
        self._control = control
        self._window: QWidget | None = None
        application = QGuiApplication.instance()
        if isinstance(application, QGuiApplication):
            application.applicationStateChanged.connect(self._on_application_state)

    def watch(self) -> None:
        """The hold begins."""
        self.release()
        self._window = self._control.window()
        self._window.installEventFilter(self)

    def release(self) -> None:
        """The hold is over."""
        if self._window is not None:
            self._window.removeEventFilter(self)
            self._window = None

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        """Tell, and let the window have its event."""
        if event.type() in _ENDS:
            self.lost.emit()
        return False

    def _on_application_state(self, state: Qt.ApplicationState) -> None:
        if self._window is not None and state is not Qt.ApplicationState.ApplicationActive:
            self.lost.emit()
