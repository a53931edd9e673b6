"""The axes of a pose and the frames they belong to, apart from `poses`, which loads numpy."""

from __future__ import annotations

import enum
from typing import Final

AXES: Final = ("X", "Y", "Z", "RX", "RY", "RZ")
"""Of a pose, in the order of its figures."""

LINEAR_AXES: Final = 3
"""So many of them are lengths in mm; the others are angles in degrees."""


class JogFrame(enum.Enum):
    """Whose axes a step goes along."""

    BASE = "base"
    TOOL = "tool"
