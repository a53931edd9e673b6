"""Waits for something that other threads or processes bring about, with a limit."""

from collections.abc import Callable

from PySide6.QtCore import QEventLoop, QTimer

LIMIT_MS = 120_000


def wait_until(condition: Callable[[], object], limit_ms: int = LIMIT_MS) -> None:
    """Let Qt and the threads work until something is so."""
    loop = QEventLoop()
    look = QTimer(interval=2)
    look.timeout.connect(lambda: loop.quit() if condition() else None)
    limit = QTimer(interval=limit_ms, singleShot=True)
    limit.timeout.connect(loop.quit)
    look.start()
    limit.start()
    try:
        if not condition():
            loop.exec()
    finally:  # what fails here is not asked for in the tests behind it
        look.stop()
        limit.stop()
    assert condition(), "it never came"
