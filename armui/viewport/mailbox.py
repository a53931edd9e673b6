"""A box for one letter between two threads: the latest wins, and the reader sets the pace."""

from __future__ import annotations

import threading
from typing import Generic, TypeVar

T = TypeVar("T")


class Mailbox(Generic[T]):
    """Holds the newest item only.

    After each item that led to a result the reader waits until that result was `acknowledged`;
    items put in meanwhile replace each other. So a slow receiver slows the reader down instead of
    filling a queue.
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

    @property
    def is_closed(self) -> bool:
        """Whether `close` was called."""
        with self._changed:
            return self._closed

    @property
    def has_item(self) -> bool:
        """Whether an item waits."""
        with self._changed:
            return self._item is not None

    @property
    def is_result_pending(self) -> bool:
        """Whether a result was sent and not acknowledged yet."""
        with self._changed:
            return self._result_pending

    def take(self, timeout_s: float | None = None) -> T | None:
        """Sleep until no result is pending, then until there is an item.

        Args:
            timeout_s: how long to wait for an item; by default for ever.

        Returns:
            The item; None once the box is closed, or when time is up.
        """
        with self._changed:
            self._changed.wait_for(lambda: self._closed or not self._result_pending)
            self._changed.wait_for(lambda: self._closed or self._may_take(), timeout_s)
            return None if self._closed else self._pop()

    def take_at_once(self) -> T | None:
        """The item if there is one and no result is pending, else None; never waits."""
        with self._changed:
            return self._pop() if self._may_take() and not self._closed else None

    def result_sent(self) -> None:
        """The reader has sent a result: nothing more is taken before it is acknowledged."""
        with self._changed:
            self._result_pending = True

    def acknowledge(self) -> None:
        """The receiver has used the result."""
        with self._changed:
            self._result_pending = False
            self._changed.notify_all()

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
