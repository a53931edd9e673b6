"""The program's clock: it never goes back, and also runs while the computer sleeps.

Values received before a sleep must count as old afterwards. Python's :func:`time.monotonic` does
not promise that, and on Linux and macOS it stands still (``CLOCK_MONOTONIC``,
``mach_absolute_time``).
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from datetime import datetime, timedelta

if sys.platform == "linux":

    def _steady_clock() -> Callable[[], float]:
        return lambda: time.clock_gettime(time.CLOCK_BOOTTIME)

elif sys.platform == "darwin":

    def _steady_clock() -> Callable[[], float]:
        # unlike CLOCK_UPTIME_RAW, this one "will continue to increment while the system is asleep"
        return lambda: time.clock_gettime(time.CLOCK_MONOTONIC)

else:

    def _steady_clock() -> Callable[[], float]:
        # QueryPerformanceCounter counts "the time when the machine was in a sleep state" as well
        return time.perf_counter


steady_s: Callable[[], float] = _steady_clock()
"""The function that returns seconds since some moment in the past; only differences have a meaning.
"""


_CALENDAR_S = 1e10
"""The year 2286; Python and the systems differ for times far beyond."""


def local_time(unix_s: float) -> datetime | None:
    """Return a time since 1970 as local time, or ``None`` if no calendar has it.

    Args:
        unix_s: Seconds, from any source: a file may hold any number, even NaN.
    """
    if in_calendar_s(unix_s) != unix_s:
        return None
    return datetime.fromtimestamp(unix_s).astimezone()


def in_calendar_s(unix_s: float) -> float:
    """Return the nearest time since 1970 that every calendar has; 0 for NaN."""
    return min(unix_s, _CALENDAR_S) if unix_s > 0.0 else 0.0


def wall_clock(clock: Callable[[], float]) -> Callable[[float], datetime]:
    """Return a function that converts a moment of a clock to the time of day with its time zone.

    Args:
        clock: The clock, in seconds, of the moments to convert.
    """
    return lambda at_s: datetime.now().astimezone() - timedelta(seconds=clock() - at_s)
