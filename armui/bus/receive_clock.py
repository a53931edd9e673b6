"""Determines when the system received a frame, which the bus thread may read later: pure.

A thread that was held up, by a busy computer or a sleeping one, finds a backlog. Frames of a
backlog are old: taken as new they would show the arm at a former place, and keep it online.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Final

STAMPED: Final = frozenset({"socketcan"})
"""Back-ends of python-can whose time stamp is the system's time of day at reception. Others stamp
frames when they are read, or count from a moment of their own.
"""

_AWAY_S: Final = 0.05
"""A queue that was not read for this long may hold a backlog."""
_EARLY_S: Final = 1.0
"""A stamp this far in the future shows that the time of day was set back, and is ignored."""


class ReceiveClock:
    """Gives frames their times of reception; used by the thread that reads them.

    No frame is dated before the moment when the queue was last found empty. Without a stamp of the
    system all frames of a backlog get exactly that time, the earliest possible. None is dated
    before one that was read earlier.

    Args:
        clock: The program's clock in seconds.
        stamped: True if the frames bear the system's time of day at reception.
        time_of_day: The time of day in seconds; tests may replace the system's.
    """

    def __init__(
        self,
        clock: Callable[[], float],
        *,
        stamped: bool,
        time_of_day: Callable[[], float] = time.time,
    ) -> None:
        self._clock = clock
        self._stamped = stamped
        self._time_of_day = time_of_day
        self._empty_s = self._last_s = clock()
        self._behind = False

    def begin(self) -> None:
        """Note that the reader starts to read the queue."""
        self._behind = self._behind or self._clock() - self._empty_s > _AWAY_S

    def emptied(self) -> None:
        """Note that the reader has found the queue empty."""
        self._empty_s = self._clock()
        self._behind = False

    def at_s(self, stamp_s: float, now_s: float) -> float:
        """Return the time at which a frame was received, by the program's clock.

        Args:
            stamp_s: The time stamp of the back-end.
            now_s: The time at which the frame was read.
        """
        received_s = self._empty_s if self._behind else now_s
        if self._stamped:
            age_s = self._time_of_day() - stamp_s
            if age_s >= -_EARLY_S:
                received_s = max(self._clock() - age_s, self._empty_s)
        # A backlog may show only after some of its frames were read, and taken as new.
        self._last_s = min(max(received_s, self._last_s), now_s)
        return self._last_s
