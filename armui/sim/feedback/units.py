"""From degrees to the units in which a generation reports an angle, speed or acceleration.

The DBC file says which unit a signal has; this module converts.
"""

from __future__ import annotations

import math
from typing import Final

PULSES_PER_TURN: Final = 65536
"""Encoder pulses in one turn of a joint; the protocol text gives no number, this is assumed."""

_UNITS_PER_DEGREE: Final = {
    "deg": 1.0,
    "rad": math.radians(1.0),
    "pulse": PULSES_PER_TURN / 360.0,
    "rpm": 1.0 / 6.0,
    "rad/s": math.radians(1.0),
    "rpm/s": 1.0 / 6.0,
    "rad/s^2": math.radians(1.0),
}


def from_degrees(value_deg: float, unit: str) -> float:
    """An angle in degrees, or its first or second derivative, in another unit.

    Raises:
        KeyError: The unit is none of an angle, angular speed or angular acceleration.
    """
    return value_deg * _UNITS_PER_DEGREE[unit]


def to_degrees(value: float, unit: str) -> float:
    """The inverse of `from_degrees`.

    Raises:
        KeyError: As there.
    """
    return value / _UNITS_PER_DEGREE[unit]
