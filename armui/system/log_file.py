"""The program's log: a rotating file, written by a thread of its own without blocking others.

Programs that run at the same time have a file each: rotating another one's file would fail on
Windows, and lose lines elsewhere.
"""

from __future__ import annotations

import contextlib
import errno
import logging
import os
import queue
import threading
from collections.abc import Iterator
from io import TextIOWrapper
from logging.handlers import RotatingFileHandler
from pathlib import Path
from typing import Final

from filelock import FileLock, Timeout

from armui.system.failures import LOGGERS, Repeats
from armui.system.files import open_file

_MOST_BYTES: Final = 1_000_000
_OLD_FILES: Final = 4

NAME: Final = "armui.log"
"""The file of the first of several programs running at a time; the others write armui-2.log and so
on.
"""
_MOST_PROGRAMS: Final = 9
_MOST_WAITING: Final = 1000
"""The most lines that wait for a slow disk; further ones are lost."""
_FLUSH_S: Final = 0.05
"""The longest wait for the disk, which may hang."""
_FORMAT: Final = "%(asctime)s %(levelname)s %(name)s [%(threadName)s] %(message)s"


class RotatingFile(RotatingFileHandler):
    """Writes lines to a rotating file, which is opened with the first line.

    Args:
        path: The file; older ones are beside it, with a number.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        super().__init__(
            path, maxBytes=_MOST_BYTES, backupCount=_OLD_FILES, encoding="utf-8", delay=True
        )

    def add(self, line: str) -> None:
        """Write a line; waits for the disk."""
        self.handle(logging.makeLogRecord({"msg": line}))

    def _open(self) -> TextIOWrapper:
        return TextIOWrapper(open_file(self._path, "ab"), encoding="utf-8")

    def handleError(self, record: logging.LogRecord) -> None:  # noqa: N802 - logging's name
        """Ignore a full disk, or a file held by another program: the log continues when it can."""


class UnhurriedHandler(logging.Handler):
    """Passes lines on without ever waiting; if the queue is full they are lost.

    Attributes:
        lines: The queue of lines; ``None`` marks the end.
    """

    def __init__(self) -> None:
        super().__init__()
        self.lines: queue.Queue[str | None] = queue.Queue(_MOST_WAITING)

    def emit(self, record: logging.LogRecord) -> None:
        """Put the record's line into the queue."""
        try:
            self.lines.put_nowait(self.format(record))
        except queue.Full:
            pass
        except Exception:  # noqa: BLE001 - the record cannot be formatted
            self.handleError(record)

    def flush(self) -> None:
        """Wait briefly until the lines are written."""
        with self.lines.all_tasks_done:
            self.lines.all_tasks_done.wait_for(lambda: not self.lines.unfinished_tasks, _FLUSH_S)

    def handleError(self, record: logging.LogRecord) -> None:  # noqa: N802 - logging's name
        """Ignore errors of the log itself."""


def flush_log() -> None:
    """Wait briefly until the log is written, because the process is about to end."""
    for handler in logging.getLogger(LOGGERS[0]).handlers:
        handler.flush()


class _LogThread(threading.Thread):
    """Writes the lines of a queue to the file, until the end mark."""

    def __init__(self, path: Path, lines: queue.Queue[str | None]) -> None:
        super().__init__(name="log", daemon=True)
        self._path = path
        self._lines = lines

    def run(self) -> None:
        line = self._lines.get()
        if line is None:
            self._lines.task_done()
            return

        with contextlib.closing(RotatingFile(self._path)) as file:
            while line is not None:
                file.add(line)
                self._lines.task_done()
                line = self._lines.get()
            self._lines.task_done()


@contextlib.contextmanager
def log_to(folder: Path) -> Iterator[Path | None]:
    """Write the program's log to a folder within a ``with`` block.

    The logger ``armui`` gets its level, and each of `LOGGERS` gets one handler for that time. A
    folder that cannot be used does not keep the program from starting.

    Args:
        folder: The folder; it need not exist.

    Yields:
        The file, or ``None`` if none can be written.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
        path, lock = _own_file(folder)
    except (OSError, ValueError):
        yield None
        return
    handler = UnhurriedHandler()
    handler.setFormatter(logging.Formatter(_FORMAT))
    handler.addFilter(Repeats())
    thread = _LogThread(path, handler.lines)
    logger = logging.getLogger("armui")
    level = logger.level
    logger.setLevel(logging.INFO)
    for name in LOGGERS:
        logging.getLogger(name).addHandler(handler)
    thread.start()
    try:
        yield path
    finally:
        for name in LOGGERS:
            logging.getLogger(name).removeHandler(handler)
        logger.setLevel(level)
        # the queue is full if the disk hangs: then do not wait for it
        with contextlib.suppress(queue.Full):
            handler.lines.put_nowait(None)
            thread.join()
        _release(lock)


def _release(lock: FileLock) -> None:
    with contextlib.suppress(OSError):
        lock.release()
        Path(lock.lock_file).unlink(missing_ok=True)


def _own_file(folder: Path) -> tuple[Path, FileLock]:
    """Return the first file that no running program writes, and the lock that reserves it.

    Raises:
        OSError: The folder cannot be used.
        ValueError: Neither can its name.
    """
    for number in range(1, _MOST_PROGRAMS + 1):
        path = folder / (NAME if number == 1 else NAME.replace(".", f"-{number}."))
        lock = FileLock(folder / f".{path.name}.lock", thread_local=False)
        try:
            lock.acquire(blocking=False)
        except Timeout:
            continue
        except NotImplementedError:  # a file system without locks: as if there were no other
            pass
        try:
            open_file(path, "ab").close()
        except (OSError, ValueError):
            _release(lock)
            raise
        return path, lock
    raise OSError(errno.EBUSY, os.strerror(errno.EBUSY), str(folder))
