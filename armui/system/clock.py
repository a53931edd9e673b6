"""The one clock of the program: it never goes back, and it also runs while the computer sleeps.

What was heard before a sleep must be old afterwards. Python's :func:`time.monotonic` does not
promise that, and on Linux and macOS it stands still (``CLOCK_MONOTONIC``, ``mach_absolute_time``).
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
"""Seconds since some moment in the past; only differences mean something."""


_CALENDAR_S = 1e10
"""Up to the year 2286; what Python and the system can tell of times far beyond differs."""


def local_time(unix_s: float) -> datetime | None:
    """Return a time since 1970 as local time; ``None`` where no calendar has it.

    Args:
        unix_s: Seconds, from anywhere: a file may hold any number, or none at all.
    """
    if in_calendar_s(unix_s) != unix_s:
        return None
    return datetime.fromtimestamp(unix_s).astimezone()


def in_calendar_s(unix_s: float) -> float:
    """Return the time nearest to one since 1970 that every calendar has; 0 for one that is none."""
    return min(unix_s, _CALENDAR_S) if unix_s > 0.0 else 0.0


def wall_clock(clock: Callable[[], float]) -> Callable[[float], datetime]:
    """Return what the clock on the wall showed at a moment of another clock, with its time zone.

    Args:
        clock: Seconds; the moments asked for are its own.
    """
    return lambda at_s: datetime.now().astimezone() - timedelta(seconds=clock() - at_s)
