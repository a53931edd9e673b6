"""The shape that stands for a tool in checks."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

Height = Any
"""A plain number, or an array of them."""


@dataclass(frozen=True, slots=True)
class ToolCapsule:
    """The shape that stands for a tool: a rod with round ends that touch flange and tip.

    Attributes:
        tip_mm: The tool centre point in the flange; not the flange's centre itself.
        radius_mm: The radius; 0 for a line.
    """

    tip_mm: tuple[float, float, float]
    radius_mm: float = 0.0

    @property
    def ends(self) -> tuple[float, float]:
        """The shares of the way from flange to tip at which the capsule's axis begins and ends."""
        share = min(0.5, self.radius_mm / math.hypot(*self.tip_mm))
        return share, 1.0 - share

    def lowest(self, flange_mm: Height, tip_mm: Height) -> Height:
        """Return the lowest height of flange, tip and capsule, from the heights of the first two.

        Args:
            flange_mm: The height of the flange's centre: a number, or an array of them.
            tip_mm: The height of the tip, likewise.
        """
        rises = tip_mm - flange_mm
        low, high = (flange_mm + share * rises - self.radius_mm for share in self.ends)
        return np.minimum(np.minimum(flange_mm, tip_mm), np.minimum(low, high))
