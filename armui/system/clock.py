"""The one clock of the program: it never goes back, and it also runs while the computer sleeps.

What was heard before a sleep must be old afterwards. Python's :func:`time.monotonic` does not
promise that, and on Linux and macOS it stands still (``CLOCK_MONOTONIC``, ``mach_absolute_time``).
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable


def _steady_clock() -> Callable[[], float]:
    system: str = sys.platform
    if system == "linux":
        return lambda: time.clock_gettime(time.CLOCK_BOOTTIME)
    if system == "darwin":
        # unlike CLOCK_UPTIME_RAW, this one "will continue to increment while the system is asleep"
        return lambda: time.clock_gettime(time.CLOCK_MONOTONIC)
    # QueryPerformanceCounter counts "the time when the machine was in a sleep state" as well
    return time.perf_counter


steady_s: Callable[[], float] = _steady_clock()
"""Seconds since some moment in the past; only differences mean something."""
