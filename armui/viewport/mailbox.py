"""A box for one letter between two threads: the latest wins, and the reader sets the pace."""

from __future__ import annotations

import threading
from typing import Generic, TypeVar

T = TypeVar("T")


class Mailbox(Generic[T]):
    """Holds the newest item only.

    After each item that led to a result the reader waits until that result was `acknowledged`; items put
    in meanwhile replace each other. So a slow receiver slows the reader down instead of filling a queue.
    """

    def __init__(self) -> None:
        self._changed = threading.Condition()
        self._item: T | None = None
        self._result_pending = False
        self._closed = False

    def put(self, item: T) -> None:
        """Replace whatever is waiting."""
        with self._changed:
            self._item = item
            self._changed.notify_all()

    def take(self) -> T | None:
        """Sleep until there is an item and no result is pending; None once the box is closed."""
        with self._changed:
            self._changed.wait_for(lambda: self._closed or self._may_take())
            return None if self._closed else self._pop()

    def take_at_once(self) -> T | None:
        """The item if there is one and no result is pending, else None; never waits."""
        with self._changed:
            return self._pop() if self._may_take() and not self._closed else None

    def result_sent(self) -> None:
        """The reader has sent a result: nothing more is taken before it is acknowledged."""
        with self._changed:
            self._result_pending = True

    def acknowledge(self) -> bool:
        """The receiver has used the result. True when one was pending."""
        with self._changed:
            was_pending, self._result_pending = self._result_pending, False
            self._changed.notify_all()
            return was_pending

    def close(self) -> None:
        """Wake the reader for the last time."""
        with self._changed:
            self._closed = True
            self._changed.notify_all()

    def _may_take(self) -> bool:
        return self._item is not None and not self._result_pending

    def _pop(self) -> T | None:
        item, self._item = self._item, None
        return item
