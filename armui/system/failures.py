"""Unexpected exceptions: caught at the outermost place, logged, and reported once if they repeat.

An exception in a slot of Qt, in a thread, or in a part of the controller goes through the logger
``armui`` to the log file (:mod:`armui.system.log_file`) and to the window (safety S23).
"""

from __future__ import annotations

import contextlib
import logging
import platform
import sys
import threading
import traceback
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from types import TracebackType
from typing import Final

from armui import __version__

_LOG: Final = logging.getLogger("armui.system.failures")

Key = tuple[str, str, int]

LOGGERS: Final = ("armui", "concurrent.futures")
"""The loggers through which unexpected exceptions come, also those of waiting futures."""

_LONGEST: Final = 200


@dataclass(frozen=True, slots=True)
class Failure:
    """An unexpected exception.

    Attributes:
        error: Its type and message in one line.
        text: The full text for a developer, to be copied.
        modules: This program's modules in the traceback, from where it was caught to where it was
            raised.
        count: The number of times it has happened.
    """

    error: str
    text: str
    modules: tuple[str, ...]
    count: int


def key_of(error: BaseException) -> Key:
    """Return a key that is equal for two exceptions of the same type from the same place."""
    file, line = "", 0
    for frame, at in traceback.walk_tb(error.__traceback__):
        file, line = frame.f_code.co_filename, at or 0
    return (type(error).__name__, file, line)


def is_our_own(error: BaseException) -> bool:
    """Return whether an exception was raised by this program, not by a library or driver.

    That another process has closed its end of a line is none of ours either.
    """
    if isinstance(error, ConnectionError):
        return False
    last = None
    for frame, _line in traceback.walk_tb(error.__traceback__):
        last = frame.f_globals.get("__name__", "")
    return last is not None and last.startswith("armui.")


class FailureHandler(logging.Handler):
    """Makes a :class:`Failure` of each logged exception.

    Args:
        on_failure: Called with each failure, in the thread where it happens.
    """

    def __init__(self, on_failure: Callable[[Failure], None]) -> None:
        super().__init__(logging.ERROR)
        self._on_failure = on_failure
        self._counts: Counter[Key] = Counter()

    def emit(self, record: logging.LogRecord) -> None:
        """Report a record that carries an exception; others are for the log file only."""
        error = record.exc_info[1] if record.exc_info else None
        if error is None:
            return
        key = key_of(error)
        self._counts[key] += 1
        try:
            failure = _failure(record, error, self._counts[key])
        except Exception:  # noqa: BLE001 - the exception's own text may fail: then use its type
            failure = Failure(type(error).__name__, type(error).__name__, (), self._counts[key])
        try:
            self._on_failure(failure)
        except Exception:  # noqa: BLE001 - telling of a failure must not be another one
            self.handleError(record)


class Repeats(logging.Filter):
    """Filters a repeated failure out of the log except for the 1st, 10th, 100th … time."""

    def __init__(self) -> None:
        super().__init__()
        self._counts: Counter[Key] = Counter()

    def filter(self, record: logging.LogRecord) -> bool:
        """Return whether to log a record; a repeated one gets the number of its repetition."""
        error = record.exc_info[1] if record.exc_info else None
        if error is None:
            return True
        key = key_of(error)
        self._counts[key] += 1
        count = self._counts[key]
        if count > 1:
            record.msg, record.args = f"{record.getMessage()} (time {count})", ()
        return set(str(count)) <= {"0", "1"} and str(count).count("1") == 1


def _failure(record: logging.LogRecord, error: BaseException, count: int) -> Failure:
    line = " ".join(f"{type(error).__name__}: {error}".split())
    trace = "".join(traceback.format_exception(error))
    text = (
        f"armui {__version__}, Python {platform.python_version()}, {platform.platform()}\n"
        f"{record.getMessage()}, thread {record.threadName}\n{trace}"
    )
    modules = tuple(
        frame.f_globals.get("__name__", "")
        for frame, _line in traceback.walk_tb(error.__traceback__)
    )
    ours = tuple(dict.fromkeys(name for name in modules if name.startswith("armui.")))
    return Failure(line[:_LONGEST], text, ours, count)


@contextlib.contextmanager
def hooks() -> Iterator[None]:
    """Log every uncaught exception: in slots and threads of Qt, in Python's threads, in callbacks.

    The former hooks are restored at the end.
    """
    before, before_in_threads = sys.excepthook, threading.excepthook
    before_unraisable = sys.unraisablehook

    def on_exception(
        kind: type[BaseException], error: BaseException, trace: TracebackType | None
    ) -> None:
        if not isinstance(error, Exception):  # Ctrl-C, and what ends the program on purpose
            before(kind, error, trace)
            return
        _LOG.error("Nobody expected this", exc_info=(kind, error, trace))

    def on_exception_in_thread(hooked: threading.ExceptHookArgs) -> None:
        if isinstance(hooked.exc_value, Exception):
            on_exception(hooked.exc_type, hooked.exc_value, hooked.exc_traceback)
        else:
            before_in_threads(hooked)

    def on_unraisable(hooked: sys.UnraisableHookArgs) -> None:
        if isinstance(hooked.exc_value, Exception):
            on_exception(hooked.exc_type, hooked.exc_value, hooked.exc_traceback)
        else:
            before_unraisable(hooked)

    sys.excepthook, threading.excepthook = on_exception, on_exception_in_thread
    sys.unraisablehook = on_unraisable
    try:
        yield
    finally:
        sys.excepthook, threading.excepthook = before, before_in_threads
        sys.unraisablehook = before_unraisable
