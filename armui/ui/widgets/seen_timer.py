"""Looking now and then, while somebody can see it."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QEvent, QObject, QTimer
from PySide6.QtWidgets import QWidget


class SeenTimer(QTimer):
    """Runs while a widget is shown: a hidden one costs nothing.

    Args:
        widget: Which.
        interval_ms: Between two looks.
        look: What is done.
    """

    def __init__(self, widget: QWidget, interval_ms: int, look: Callable[[], object]) -> None:
        super().__init__(widget, interval=interval_ms)
        self.timeout.connect(look)
        widget.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """The widget comes into sight, or goes out of it."""
        if event.type() == QEvent.Type.Show:
            self.start()
        elif event.type() == QEvent.Type.Hide:
            self.stop()
        return super().eventFilter(watched, event)
