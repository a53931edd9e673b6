"""Figures of the windows of 轨迹库."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from armui.ui import format as fmt

_HOUR_S: Final = 3600
_MINUTE_S: Final = 60
_MOST_NAMES: Final = 5


def duration(seconds: float | None) -> str:
    """A length of time as ``7.5 s``, ``12:30`` or ``1:05:00``."""
    if seconds is None:
        return fmt.NOTHING
    if seconds < _MINUTE_S:
        return f"{seconds:.1f} s"
    whole = round(seconds)
    hours, rest = divmod(whole, _HOUR_S)
    minutes, left = divmod(rest, _MINUTE_S)
    return f"{hours}:{minutes:02}:{left:02}" if hours else f"{minutes}:{left:02}"


def name_list(names: Sequence[str]) -> str:
    """Names in a row; of many only the first, and how many more there are."""
    shown = ", ".join(names[:_MOST_NAMES])
    more = len(names) - _MOST_NAMES
    return f"{shown} … (+{more})" if more > 0 else shown
