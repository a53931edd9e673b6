"""Which geometry an arm has, by its firmware."""

from __future__ import annotations

import re
from typing import Final

from armui.kinematics.geometry import Geometry

_NEW_ZEROS_SINCE: Final = (1, 6, 3)
"""From this firmware on joints 2 and 3 have their zeros 2° elsewhere."""


def geometry_of(version: str) -> Geometry:
    """Where joints 2 and 3 have their zero; in a version that cannot be read, as of today."""
    numbers = re.fullmatch(r"S-V(\d+)\.(\d+)-(\d+)", version)
    if numbers is None or tuple(map(int, numbers.groups())) >= _NEW_ZEROS_SINCE:
        return Geometry.CURRENT
    return Geometry.BEFORE_V1_6_3
