"""Times of a log as text: pure."""

from __future__ import annotations

import contextlib
from datetime import UTC, datetime, timedelta
from typing import Final

from armui.system.clock import local_time

_SINCE_1970_S: Final = 500_000_000.0
"""A log with smaller times (1985) counts from its own beginning."""
_BEGINNING: Final = datetime(1970, 1, 1, tzinfo=UTC)


def has_date(start_s: float) -> bool:
    """Return whether a log's times are dates, or only count from its beginning."""
    return start_s > _SINCE_1970_S


def wall_time(at_s: float) -> datetime:
    """Return a log time as date and time; without a date as time since the beginning.

    Times that no calendar has, from damaged places, become its beginning.
    """
    if has_date(at_s):
        return local_time(at_s) or _BEGINNING
    with contextlib.suppress(OverflowError, ValueError):
        return _BEGINNING + timedelta(seconds=at_s)
    return _BEGINNING


def moment(at_s: float) -> str:
    """Return a log time as text, with its date if it has one."""
    at = wall_time(at_s)
    text = f"{at:%H:%M:%S}.{at.microsecond // 1000:03d}"
    return f"{at:%Y-%m-%d} {text}" if has_date(at_s) else text
