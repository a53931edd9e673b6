"""A timer that runs only while a widget is visible."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QEvent, QObject, QTimer
from PySide6.QtWidgets import QWidget


class SeenTimer(QTimer):
    """Calls a function periodically while a widget is visible.

    Args:
        widget: The widget.
        interval_ms: The period.
        callback: The function.
    """

    def __init__(self, widget: QWidget, interval_ms: int, callback: Callable[[], object]) -> None:
        super().__init__(widget, interval=interval_ms)
        self.timeout.connect(callback)
        widget.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Start or stop when the widget is shown or hidden."""
        if event.type() == QEvent.Type.Show:
            self.start()
        elif event.type() == QEvent.Type.Hide:
            self.stop()
        return super().eventFilter(watched, event)
