"""From the protocol's units of angle, speed and acceleration to the operator's degrees."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Final

DEGREES_PER: Final[Mapping[str, float]] = {
    "deg": 1.0,
    "rad": math.degrees(1.0),
    "rpm": 6.0,
    "rad/s": math.degrees(1.0),
    "rpm/s": 6.0,
    "rad/s^2": math.degrees(1.0),
}
"""Degrees (per second, per second squared) in one of the units of the DBC files."""
