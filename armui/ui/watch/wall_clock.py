"""Monotonic times as the clock on the wall has them."""

from __future__ import annotations

from datetime import datetime, timedelta


def clock_time(at_s: float, now_s: float) -> str:
    """A monotonic time as the clock on the wall had it."""
    at = datetime.now().astimezone() - timedelta(seconds=now_s - at_s)
    return f"{at:%H:%M:%S}.{at.microsecond // 1000:03d}"
