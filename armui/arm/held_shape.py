"""The shape that stands in checks for what the hand holds."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

Height = Any
"""A plain number, or an array of them."""


@dataclass(frozen=True, slots=True)
class Rod:
    """All places within a distance of a straight line.

    Attributes:
        start_mm, end_mm: The ends of the line in the flange.
        radius_mm: The distance.
    """

    start_mm: tuple[float, ...]
    end_mm: tuple[float, ...]
    radius_mm: float


@dataclass(frozen=True, slots=True)
class HeldShape:
    """The shape of what the hand holds.

    Attributes:
        hull: Together they enclose it.
        edges: They reach as far as it does in every direction, and no further.
    """

    hull: tuple[Rod, ...]
    edges: tuple[Rod, ...]

    def lowest(self, flange_mm: Height, ups: Sequence[Height]) -> Height:
        """Return the height of its lowest place.

        Args:
            flange_mm: The height of the flange's centre: a number, or an array of them.
            ups: How much each axis of the flange rises, likewise.
        """
        heights = [
            flange_mm - rod.radius_mm + sum(part * up for part, up in zip(end, ups, strict=True))
            for rod in self.edges
            for end in (rod.start_mm, rod.end_mm)
        ]
        return np.min(heights, axis=0)
