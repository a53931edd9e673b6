"""Frames on their way to the bus: an ordinary lane, and the stop's, which passes it.

Every frame goes out under one lock, taken frame by frame. The stop is written by the thread that
asks for it: it waits for no other thread but the frame being written at that moment.
"""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable, Iterable, Sequence
from typing import Final

import can

from armui.clock import steady_s
from armui.protocol.frame import Frame

KEEP_S: Final = 0.5
"""An ordinary frame that could not be sent for so long is dropped: a command must not act late."""

_URGENT_LOCK_S: Final = 0.05
_SEND_TIMEOUT_S: Final = 0.05


class Outbox:
    """What waits to be sent on one bus; used by the bus thread and by the threads that send.

    Args:
        clock: Monotonic time in seconds.
    """

    def __init__(self, clock: Callable[[], float] = steady_s) -> None:
        self._clock = clock
        self._lock = threading.Lock()
        self._bus: can.BusABC | None = None
        self._waiting: deque[tuple[float, Frame]] = deque()
        self._urgent: deque[Frame] = deque()
        self._dropped = 0

    @property
    def dropped(self) -> int:
        """How many ordinary frames were given up, by a stop or by age."""
        return self._dropped

    @property
    def empty(self) -> bool:
        """Whether nothing waits."""
        return not self._waiting and not self._urgent

    def attach(self, bus: can.BusABC) -> None:
        """Frames may go out on this bus from now on. What was left from before is dropped."""
        with self._lock:
            self._drop_waiting()
            self._bus = bus

    def detach(self) -> None:
        """No frame goes out any more; nothing that waits survives."""
        with self._lock:
            self._bus = None
            self._drop_waiting()
            self._urgent.clear()

    def put(self, frames: Iterable[Frame], keep_s: float = KEEP_S) -> bool:
        """Queue frames in order; false if there is no bus, and then nothing is queued.

        Args:
            frames: What to send.
            keep_s: Frames that could not be sent within this time are dropped.
        """
        until_s = self._clock() + keep_s
        with self._lock:
            if self._bus is None:
                return False
            self._waiting.extend((until_s, frame) for frame in frames)
            return True

    def put_urgent(self, frames: Sequence[Frame]) -> bool:
        """Drop every ordinary frame still waiting and send these at once, from this very thread.

        Returns:
            Whether all of them are on the bus. Otherwise those that are not stay first in line
            for the bus thread's next round, as long as there is a bus.
        """
        if not self._lock.acquire(timeout=_URGENT_LOCK_S):
            # Another frame hangs in the driver. Both deques are safe to touch without the lock:
            # what waits is emptied and the stop is the next thing the bus thread sends.
            self._drop_waiting()
            self._urgent.extend(frames)
            return False
        try:
            self._drop_waiting()
            if self._bus is None:
                return False
            self._urgent.extend(frames)
            return self._send_urgent(self._bus)
        finally:
            self._lock.release()

    def send_waiting(self) -> None:
        """Send what waits, stop frames first; called by the bus thread.

        A full transmit queue leaves the rest for the next call.

        Raises:
            can.CanError, OSError: The bus is gone.
        """
        while True:
            with self._lock:
                if self._bus is None or not self._send_urgent(self._bus):
                    return
                self._drop_old()
                if not self._waiting:
                    return
                waited = self._waiting.popleft()
                if not _sent(self._bus, waited[1]):
                    self._put_back(waited)
                    return

    def _send_urgent(self, bus: can.BusABC) -> bool:
        while self._urgent:
            try:
                if not _sent(bus, self._urgent[0]):
                    return False
            except Exception:  # noqa: BLE001 - drivers of others raise anything; who stops goes on
                # The bus thread finds out for itself that the bus is gone and reports it.
                return False
            self._urgent.popleft()
        return True

    def _put_back(self, waited: tuple[float, Frame]) -> None:
        # A stop that could not get the lock has emptied the lane meanwhile: stay out of it then.
        if not self._urgent:
            self._waiting.appendleft(waited)

    def _drop_waiting(self) -> None:
        while self._waiting:
            self._waiting.popleft()
            self._dropped += 1

    def _drop_old(self) -> None:
        now_s = self._clock()
        while self._waiting and self._waiting[0][0] < now_s:
            self._waiting.popleft()
            self._dropped += 1


def _sent(bus: can.BusABC, frame: Frame) -> bool:
    """Put one frame on the bus; false if the transmit queue is full just now."""
    message = can.Message(
        arbitration_id=frame.arbitration_id, data=frame.data, is_extended_id=False, check=False
    )
    try:
        bus.send(message, timeout=_SEND_TIMEOUT_S)
    except (can.CanError, OSError) as error:
        if _queue_is_full(error):
            return False
        raise
    return True


def _queue_is_full(error: BaseException) -> bool:
    if isinstance(error, can.CanTimeoutError):
        return True
    cause: BaseException | None = error
    while cause is not None:
        number = getattr(cause, "error_code", None) or getattr(cause, "errno", None)
        if number in _FULL_ERRNOS:
            return True
        cause = cause.__cause__ or cause.__context__
    return False


_FULL_ERRNOS: Final = frozenset({11, 105})
"""EAGAIN and ENOBUFS of Linux, what socketcan answers when nobody acknowledges."""
