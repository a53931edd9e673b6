"""The keys that stop the arm from every window of the program."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QCoreApplication, QEvent, QObject, Qt
from PySide6.QtGui import QKeyEvent

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController

STOP_KEYS: Final = frozenset({Qt.Key.Key_F12, Qt.Key.Key_Pause})
STOP_KEY_NAME: Final = "F12, Pause"


class StopShortcut(QObject):
    """Listens to the whole application, below any dialog that holds the other keys back.

    A key only ever stops; recovery needs the button and its question.

    Args:
        app: The application to listen to; the listener lives and dies with it.
        controller: Whom to tell.
    """

    def __init__(self, app: QCoreApplication, controller: ArmController) -> None:
        super().__init__(app)
        self._controller = controller
        app.installEventFilter(self)

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        """Take the stop keys, whichever window they were meant for."""
        # A key press passes its window first and its widgets after; the first one is taken.
        if event.type() == QEvent.Type.KeyPress and isinstance(event, QKeyEvent):
            if event.key() not in STOP_KEYS:
                return False
            if not event.isAutoRepeat():
                self._controller.emergency_stop()
            return True
        return False
