"""How lengths, sizes and moments of recordings are written."""

from __future__ import annotations

from typing import Final

from armui.system.clock import local_time
from armui.ui import format as fmt

_HOUR_S: Final = 3600


def length(seconds: float | None) -> str:
    """A length of time: ``1:05``, ``2:03:04``."""
    if seconds is None:
        return fmt.NOTHING
    whole = int(seconds)
    minutes, rest = divmod(whole % _HOUR_S, 60)
    if whole >= _HOUR_S:
        return f"{whole // _HOUR_S}:{minutes:02}:{rest:02}"
    return f"{minutes}:{rest:02}"


def size(count: int) -> str:
    """Bytes: ``12 kB``, ``3.4 MB``, ``1.20 GB``."""
    if count < 1e6:
        return f"{count / 1e3:.0f} kB"
    return f"{count / 1e6:.1f} MB" if count < 1e9 else f"{count / 1e9:.2f} GB"


def count(number: int) -> str:
    """A number of things, its digits in groups of three."""
    return f"{number:,}".replace(",", "\u202f")


def moment(unix_s: float) -> str:
    """A local time, to the second; of 0, which stands for one that nobody knows, none."""
    at = local_time(unix_s) if unix_s else None
    return fmt.NOTHING if at is None else f"{at:%Y-%m-%d %H:%M:%S}"
