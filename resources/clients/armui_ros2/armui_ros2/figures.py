"""Names and units of ROS: radians and metres, as the maker's description of the arm has them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final

ARM_JOINTS: Final = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
"""The joints of the arm in the maker's description ``piper_description``."""
FINGERS: Final = ("joint7", "joint8")
"""Its joints of the gripper's fingers; each moves by half of the opening."""
BASE: Final = "base_link"
FLANGE: Final = "flange"


def radians(values_deg: Sequence[float]) -> list[float]:
    """Return angles or speeds in radians."""
    return [math.radians(each) for each in values_deg]


def fingers_m(opening_mm: float) -> list[float]:
    """Return the places of the two fingers in m: the description counts the first one down."""
    half = opening_mm / 2000.0
    return [0.0 - half, half]


def metres(values_mm: Sequence[float]) -> list[float]:
    """Return lengths in metres."""
    return [each / 1000.0 for each in values_mm]


def quaternion(turned_deg: Sequence[float]) -> tuple[float, float, float, float]:
    """Return x, y, z, w of a rotation about the fixed axes X, then Y, then Z."""
    (sx, sy, sz), (cx, cy, cz) = zip(
        *(
            (math.sin(math.radians(each) / 2), math.cos(math.radians(each) / 2))
            for each in turned_deg
        ),
        strict=True,
    )
    return (
        sx * cy * cz - cx * sy * sz,
        cx * sy * cz + sx * cy * sz,
        cx * cy * sz - sx * sy * cz,
        cx * cy * cz + sx * sy * sz,
    )
