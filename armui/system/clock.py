"""The one clock of the program: it never goes back, and it also runs while the computer sleeps.

What was heard before a sleep must be old afterwards. Python's :func:`time.monotonic` does not
promise that, and on Linux and macOS it stands still (``CLOCK_MONOTONIC``, ``mach_absolute_time``).
"""

from __future__ import annotations

import platform
import time
from collections.abc import Callable
from datetime import datetime, timedelta


def _steady_clock() -> Callable[[], float]:
    system = platform.system()
    if system == "Linux":
        return lambda: time.clock_gettime(time.CLOCK_BOOTTIME)
    if system == "Darwin":
        # unlike CLOCK_UPTIME_RAW, this one "will continue to increment while the system is asleep"
        return lambda: time.clock_gettime(time.CLOCK_MONOTONIC)
    # QueryPerformanceCounter counts "the time when the machine was in a sleep state" as well
    return time.perf_counter


steady_s: Callable[[], float] = _steady_clock()
"""Seconds since some moment in the past; only differences mean something."""


def wall_clock(clock: Callable[[], float]) -> Callable[[float], datetime]:
    """What the clock on the wall showed at a moment of another clock, with its time zone.

    Args:
        clock: Seconds; the moments asked for are its own.
    """
    return lambda at_s: datetime.now().astimezone() - timedelta(seconds=clock() - at_s)
