"""The formats of all figures, in one place, so that columns of them do not jitter."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Final

from PySide6.QtCore import QCoreApplication

NOTHING: Final = "—"
"""The text for a value that the arm has not reported."""

DECIMALS: Final = 3
"""The decimals of angles and lengths: the resolution of the bus."""

_MINUTE_S: Final = 60
_MOST_NAMES: Final = 5
_SHORT: Final = 14


def number(value: float | None, decimals: int = DECIMALS) -> str:
    """Return a figure without its unit, with fixed decimals and never a negative zero."""
    if value is None or not math.isfinite(value):
        return NOTHING
    text = f"{value:.{decimals}f}"
    return text.lstrip("-") if float(text) == 0 else text


def with_unit(value: float | None, unit: str, decimals: int = DECIMALS) -> str:
    """Return a figure with its unit; a degree sign follows without a space."""
    return NOTHING if value is None else append_unit(number(value, decimals), unit)


def append_unit(figure: str, unit: str) -> str:
    """Return a formatted figure with its unit, if it has one; ``12°``, ``3°/s``, but ``40 °C``."""
    close = not unit or (unit.startswith("°") and unit != "°C")
    return f"{figure}{unit}" if close else f"{figure} {unit}"


def angle(value_deg: float | None) -> str:
    """Return an angle with its unit."""
    return with_unit(value_deg, "°")


def short_number(value: float, decimals: int = DECIMALS) -> str:
    """Return a figure without its unit and with only the decimals it needs."""
    return number(value, decimals).rstrip("0").rstrip(".")


def short_angle(value_deg: float) -> str:
    """Return an angle with only the decimals it needs, for the ends of a scale."""
    return f"{short_number(value_deg)}°"


def spoken(values: Sequence[float]) -> list[str]:
    """Return the figures of one sentence without their units.

    They have at most one decimal. Figures below 1 have the decimals of the bus, and so have all if
    two would look alike, such as an angle and the limit it exceeds.
    """
    large = {value for value in values if abs(value) >= 1}
    alike = len({number(value, 1) for value in large}) < len(large)
    return [short_number(value, DECIMALS if alike or abs(value) < 1 else 1) for value in values]


def pose(figures: Sequence[float], decimals: int) -> str:
    """Return the six figures of a pose with their names and units; no line ends within one."""
    x, y, z, rx, ry, rz = (number(each, decimals) for each in figures)
    pairs = (f"X {x}", f"Y {y}", f"Z {z} mm", f"RX {rx}°", f"RY {ry}°", f"RZ {rz}°")
    return "  ".join(pair.replace(" ", "\N{NO-BREAK SPACE}") for pair in pairs)


def percent(value: float | None) -> str:
    """Return a percentage without decimals."""
    return with_unit(value, "%", 0)


def count(number: int) -> str:
    """Return a number of things, its digits in groups of three."""
    return f"{number:,}"


def listed(texts: Iterable[str]) -> str:
    """Return texts as a list in a line, with the commas of the operator's language."""
    return QCoreApplication.translate("Format", ", ").join(texts)


def joints(numbers: list[int]) -> str:
    """Return joint numbers as a list in a line: ``J1, J3``."""
    return listed(f"J{joint}" for joint in numbers)


def joint_spans(numbers: list[int]) -> str:
    """Return the same for narrow places, with three and more in a row as one: ``J1, J3–J6``."""
    spans: list[list[int]] = []
    for joint in sorted(numbers):
        if spans and joint == spans[-1][-1] + 1:
            spans[-1].append(joint)
        else:
            spans.append([joint])
    texts = (
        f"J{span[0]}–J{span[-1]}" if len(span) > 2 else listed(f"J{joint}" for joint in span)
        for span in spans
    )
    return listed(texts)


def duration(seconds: float | None, decimals: int = 1) -> str:
    """Return how long something takes as text: ``7.5 s``, ``12:30`` or ``1:05:00``.

    Args:
        seconds: The time; ``None`` if it is not known.
        decimals: Those of a time below a minute; 0 for one that is counted while it is seen.
    """
    if seconds is None or round(seconds, decimals) < _MINUTE_S:
        return with_unit(seconds, "s", decimals)
    return clock(seconds)


def clock(seconds: float, decimals: int = 0) -> str:
    """Return a place on a line of time as text: ``0:07``, ``12:30.5`` or ``1:05:00``."""
    whole, part = divmod(max(0, round(seconds * 10**decimals)), 10**decimals)
    minutes, second = divmod(whole, _MINUTE_S)
    hours, minute = divmod(minutes, _MINUTE_S)
    head = f"{hours}:{minute:02}" if hours else f"{minute}"
    return f"{head}:{second:02}" + (f".{part:0{decimals}}" if decimals else "")


def short(name: str) -> str:
    """Return a name given by the operator, shortened to fit on a button."""
    return name if len(name) <= _SHORT else f"{name[: _SHORT - 1]}…"


def name_list(names: Sequence[str]) -> str:
    """Return names as a list in a line: at most five, and the number of the others."""
    shown = listed(names[:_MOST_NAMES])
    more = len(names) - _MOST_NAMES
    return f"{shown} … (+{more})" if more > 0 else shown


def parse_number(text: str) -> float | None:
    """Return the figure an operator typed, or ``None`` if it is none.

    A unit sign behind it, a decimal comma and the typographic minus are understood.
    """
    plain = text.strip().removesuffix("°").strip().replace("−", "-").replace(",", ".")
    try:
        value = float(plain)
    except ValueError:
        return None
    return value if math.isfinite(value) else None
