"""The lengths of the links and the zeros of the joints, from the maker's modified DH table."""

from __future__ import annotations

import enum
import math
from typing import Final

BASE_MM: Final = 123.0
"""From the table to the shoulder, where the axes of joints 1 and 2 cross."""
UPPER_ARM_MM: Final = 285.03
ELBOW_MM: Final = -21.98
"""The forearm's offset from the elbow, square to it in the arm's plane."""
FOREARM_MM: Final = 250.75
HAND_MM: Final = 91.0
"""From the centre of the wrist to the flange."""

ELBOW_TO_WRIST_MM: Final = math.hypot(ELBOW_MM, FOREARM_MM)
ELBOW_TO_WRIST_RAD: Final = math.atan2(FOREARM_MM, ELBOW_MM)
"""The straight line from the elbow to the wrist's centre: its length, its angle in the forearm."""

MIDDLES_DEG: Final = (0.0, 90.0, -85.0)
"""The middles of the factory ranges of joints 1–3; the others' are 0."""


class Geometry(enum.Enum):
    """Where joints 2 and 3 have their zero: the θ offsets of the DH table in degrees."""

    CURRENT = (-172.22, -102.78)
    """Firmware from S-V1.6-3 on."""
    BEFORE_V1_6_3 = (-174.22, -100.78)
    """Older firmware: joint 2 turned by −2°, joint 3 by +2°."""
