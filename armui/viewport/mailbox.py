"""A box for one letter between two threads: the latest wins, and the reader sets the pace."""

from __future__ import annotations

import threading
from typing import Final, Generic, TypeVar

T = TypeVar("T")

MOST_UNUSED: Final = 1
"""So many results may lie unused when the next item is taken."""


class Mailbox(Generic[T]):
    """Holds the newest item only.

    Items may lead to results, which the receiver uses. While more than `MOST_UNUSED` of them are
    unused nothing is taken; items put in meanwhile replace each other. So a slow receiver slows
    the reader down instead of filling a queue.
    """

    def __init__(self) -> None:
        self._changed = threading.Condition()
        self._item: T | None = None
        self._results = 0
        self._used = 0
        self._is_interrupted = False
        self._is_closed = False

    def put(self, item: T) -> None:
        """Replace whatever is waiting."""
        with self._changed:
            self._item = item
            self._changed.notify_all()

    @property
    def is_closed(self) -> bool:
        """Tell whether `close` was called."""
        with self._changed:
            return self._is_closed

    @property
    def has_item(self) -> bool:
        """Tell whether an item waits."""
        with self._changed:
            return self._item is not None

    def take(self, timeout_s: float | None = None) -> T | None:
        """Sleep until results were used, then until there is an item.

        Args:
            timeout_s: how long to wait for an item; by default for ever.

        Returns:
            The item; None once the box is closed or the reader interrupted, or when time is up.
        """
        with self._changed:
            self._changed.wait_for(lambda: self._is_woken or self._has_room)
            self._changed.wait_for(lambda: self._is_woken or self._item is not None, timeout_s)
            return None if self._is_woken else self._pop()

    def take_at_once(self) -> T | None:
        """The item if there is one, else None; never waits."""
        with self._changed:
            return self._pop()

    def result_sent(self) -> int:
        """The reader has sent a result; its number, from 1."""
        with self._changed:
            self._results += 1
            return self._results

    def acknowledge(self, number: int) -> None:
        """The receiver has used this result, and needs none of those before it."""
        with self._changed:
            self._used = max(self._used, number)
            self._changed.notify_all()

    def forget_results(self) -> None:
        """No result is unused: what was sent so far does not count any more."""
        with self._changed:
            self._used = self._results

    def interrupt(self) -> None:
        """Wake the reader, and let it not sleep before `resume`."""
        with self._changed:
            self._is_interrupted = True
            self._changed.notify_all()

    def resume(self) -> None:
        """The reader may sleep again."""
        with self._changed:
            self._is_interrupted = False

    def close(self) -> None:
        """Wake the reader for the last time."""
        with self._changed:
            self._is_closed = True
            self._changed.notify_all()

    @property
    def _is_woken(self) -> bool:
        return self._is_closed or self._is_interrupted

    @property
    def _has_room(self) -> bool:
        return self._results - self._used <= MOST_UNUSED

    def _pop(self) -> T | None:
        item, self._item = self._item, None
        return item
