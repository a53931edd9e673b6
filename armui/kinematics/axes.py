"""The axes of a pose and the frames to jog in; apart from `poses`, which loads numpy."""

from __future__ import annotations

import enum
from typing import Final

AXES: Final = ("X", "Y", "Z", "RX", "RY", "RZ")
"""The names of a pose's six values, in their order."""

LINEAR_AXES: Final = 3
"""The first three are lengths in mm; the others are angles in degrees."""


class JogFrame(enum.Enum):
    """The frame whose axes a jog step follows."""

    BASE = "base"
    TOOL = "tool"
