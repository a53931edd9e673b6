"""How figures are written, in one place, so that columns of them stand still."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final

NOTHING: Final = "—"
"""Stands where nothing has been heard from the arm."""

DECIMALS: Final = 3
"""Of angles and lengths: the resolution of the bus."""

_HOUR_S: Final = 3600
_MINUTE_S: Final = 60
_MOST_NAMES: Final = 5


def number(value: float | None, decimals: int = DECIMALS) -> str:
    """A figure without its unit, with a fixed number of decimals and never a negative zero."""
    if value is None or not math.isfinite(value):
        return NOTHING
    text = f"{value:.{decimals}f}"
    return text.lstrip("-") if float(text) == 0 else text


def with_unit(value: float | None, unit: str, decimals: int = DECIMALS) -> str:
    """A figure with its unit; a degree sign stands close to it."""
    return NOTHING if value is None else append_unit(number(value, decimals), unit)


def append_unit(figure: str, unit: str) -> str:
    """Return a written figure with its unit, if it has one; ``12°``, ``3°/s``, but ``40 °C``."""
    close = not unit or (unit.startswith("°") and unit != "°C")
    return f"{figure}{unit}" if close else f"{figure} {unit}"


def angle(value_deg: float | None) -> str:
    """An angle with its unit."""
    return with_unit(value_deg, "°")


def short_angle(value_deg: float) -> str:
    """An angle with as many decimals as it needs, for the ends of a scale."""
    text = number(value_deg)
    return f"{text.rstrip('0').rstrip('.')}°"


def percent(value: float | None) -> str:
    """A percentage without decimals."""
    return with_unit(value, "%", 0)


def count(number: int) -> str:
    """A number of things, its digits in groups of three."""
    return f"{number:,}"


def joints(numbers: list[int]) -> str:
    """Joint numbers as they are listed in a line: ``J1, J3``."""
    return ", ".join(f"J{joint}" for joint in numbers)


def joint_spans(numbers: list[int]) -> str:
    """The same where there is little room, three and more in a row as one: ``J1, J3–J6``."""
    spans: list[list[int]] = []
    for joint in sorted(numbers):
        if spans and joint == spans[-1][-1] + 1:
            spans[-1].append(joint)
        else:
            spans.append([joint])
    texts = (
        f"J{span[0]}–J{span[-1]}" if len(span) > 2 else ", ".join(f"J{joint}" for joint in span)
        for span in spans
    )
    return ", ".join(texts)


def size_text(count: int) -> str:
    """Return bytes in words: ``12 kB``, ``3.4 MB``, ``1.20 GB``."""
    if count < 1e6:
        return f"{count / 1e3:.0f} kB"
    return f"{count / 1e6:.1f} MB" if count < 1e9 else f"{count / 1e9:.2f} GB"


def duration(seconds: float | None) -> str:
    """Write how long a motion lasts: ``7.5 s``, ``12:30`` or ``1:05:00``."""
    if seconds is None:
        return NOTHING
    if seconds < _MINUTE_S:
        return f"{seconds:.1f} s"
    whole = round(seconds)
    hours, rest = divmod(whole, _HOUR_S)
    minutes, left = divmod(rest, _MINUTE_S)
    return f"{hours}:{minutes:02}:{left:02}" if hours else f"{minutes}:{left:02}"


def name_list(names: Sequence[str]) -> str:
    """List names in a line; of more than five the first five, and how many more there are."""
    shown = ", ".join(names[:_MOST_NAMES])
    more = len(names) - _MOST_NAMES
    return f"{shown} … (+{more})" if more > 0 else shown


def parse_number(text: str) -> float | None:
    """The figure an operator typed, or ``None`` if it is none.

    A unit sign behind it, a decimal comma and the typographic minus are understood.
    """
    plain = text.strip().removesuffix("°").strip().replace("−", "-").replace(",", ".")
    try:
        value = float(plain)
    except ValueError:
        return None
    return value if math.isfinite(value) else None
