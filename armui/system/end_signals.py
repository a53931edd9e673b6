"""The signals by which the system or the user asks the program to end.

Source: signal(7).
"""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType
from typing import Any, Final

_NAMES: Final = ("SIGTERM", "SIGHUP", "SIGINT", "SIGBREAK")

Handler = Callable[[int, FrameType | None], Any] | signal.Handlers


def take_over(handler: Handler) -> dict[int, Any]:
    """Install a handler for these signals, except for ignored ones, as under ``nohup``.

    Args:
        handler: Called in the main thread; this can be called only there, too.

    Returns:
        The former handlers.
    """
    numbers = [getattr(signal, name) for name in _NAMES if hasattr(signal, name)]
    followed = [each for each in numbers if signal.getsignal(each) is not signal.SIG_IGN]
    return {number: signal.signal(number, handler) for number in followed}


def give_back(before: dict[int, Any]) -> None:
    """Restore the former handlers of these signals."""
    for number, handler in before.items():
        signal.signal(number, handler)


@contextmanager
def handled_by(handler: Handler) -> Iterator[None]:
    """Have them handled for a while; in another thread than the main one nothing is done."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = take_over(handler)
    try:
        yield
    finally:
        give_back(before)


@contextmanager
def interrupting() -> Iterator[list[int]]:
    """Let each of these signals raise `KeyboardInterrupt`; yield the list of those that came."""
    heard: list[int] = []

    def interrupt(number: int, _frame: FrameType | None) -> None:
        heard.append(number)
        raise KeyboardInterrupt

    with handled_by(interrupt):
        yield heard


def ignore_from_now_on() -> None:
    """Ignore these signals: the work is done, and its exit code must not become a signal's."""
    take_over(signal.SIG_IGN)


def end_at_once_on_ctrl_c() -> None:
    """Let Ctrl-C end the process immediately, like SIGTERM, while there is nothing to end properly.

    Python's own exception would get lost in Qt, or print a traceback of a half-loaded module.
    """
    if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
        signal.signal(signal.SIGINT, signal.SIG_DFL)
