"""The program's log: a file that rotates, written by a thread that nobody waits for."""

from __future__ import annotations

import contextlib
import logging
import queue
from collections.abc import Iterator
from logging.handlers import QueueHandler, QueueListener, RotatingFileHandler
from pathlib import Path
from typing import Final

from armui.system.failures import Repeats

NAME: Final = "armui.log"
_MOST_BYTES: Final = 1_000_000
_OLD_FILES: Final = 4
_MOST_WAITING: Final = 1000
"""Records that wait for a slow disk; later ones are lost, never waited for."""
_FORMAT: Final = "%(asctime)s %(levelname)s %(name)s [%(threadName)s] %(message)s"


class _Unhurried(QueueHandler):
    """Hands records over and never waits; where nobody takes them they are lost."""

    def enqueue(self, record: logging.LogRecord) -> None:
        with contextlib.suppress(queue.Full):
            self.queue.put_nowait(record)

    def handleError(self, record: logging.LogRecord) -> None:  # noqa: N802 - logging's name
        """A log that fails is no reason to say more."""


class _Quiet(RotatingFileHandler):
    def handleError(self, record: logging.LogRecord) -> None:  # noqa: N802 - logging's name
        """A disk that is full, or a file another program holds: the log goes on when it can."""


@contextlib.contextmanager
def log_to(folder: Path) -> Iterator[Path | None]:
    """Keep what the program logs in a folder, until the end.

    The logger ``armui`` gets its level and one handler for that time. A folder that cannot be used
    is no reason not to start.

    Args:
        folder: It need not exist.

    Yields:
        The file, or ``None``: there is none.
    """
    path = folder / NAME
    try:
        folder.mkdir(parents=True, exist_ok=True)
        file = _Quiet(path, maxBytes=_MOST_BYTES, backupCount=_OLD_FILES, encoding="utf-8")
    except (OSError, ValueError):
        yield None
        return
    file.setFormatter(logging.Formatter(_FORMAT))
    records: queue.Queue[logging.LogRecord] = queue.Queue(_MOST_WAITING)
    handler = _Unhurried(records)
    handler.addFilter(Repeats())
    listener = QueueListener(records, file)
    logger = logging.getLogger("armui")
    level = logger.level
    logger.setLevel(logging.INFO)
    logger.addHandler(handler)
    listener.start()
    try:
        yield path
    finally:
        logger.removeHandler(handler)
        logger.setLevel(level)
        with contextlib.suppress(queue.Full):
            listener.stop()
        file.close()
