"""The way of a motion: where it begins, what the joints do between, where it ends."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]

_STILL: Final = (0.0,) * 6


@dataclass(frozen=True, slots=True, eq=False)
class Way:
    """The way of a motion through the joints' angles, as every rule sees it.

    Attributes:
        joints_deg: (n, 6) the poses on it, at least one; between two of them the joints turn
            evenly.
        spread_deg: (6,) how far each joint may be off at its beginning, which fades evenly to
            nothing at its end: an arm that brakes while it turns to another target is not exactly
            where it was measured.
    """

    joints_deg: Array
    spread_deg: tuple[float, ...] = _STILL

    @property
    def begin_deg(self) -> tuple[float, ...]:
        """The six angles at which it begins."""
        return tuple(self.joints_deg[0].tolist())

    @property
    def end_deg(self) -> tuple[float, ...]:
        """The six angles at which it ends."""
        return tuple(self.joints_deg[-1].tolist())

    def travel_mm(self, reaches_mm: Sequence[float]) -> float:
        """Return how far any part moves on it at most, what it may be off at first included.

        Args:
            reaches_mm: (6,) how far each joint moves any part at most for a radian.
        """
        turns_deg = np.abs(np.diff(self.joints_deg, axis=0)).sum(axis=0) / 2.0
        return 2.0 * float(np.radians(turns_deg + self.spread_deg) @ np.array(reaches_mm))

    @property
    def turn_deg(self) -> float:
        """How far the joint that turns most turns on it."""
        return float(np.abs(np.diff(self.joints_deg, axis=0)).sum(axis=0).max(initial=0.0))


def straight_way(
    begin_deg: Sequence[float], end_deg: Sequence[float], spread_deg: Sequence[float] = _STILL
) -> Way:
    """Return the way of joints that turn evenly from six angles to six others."""
    return Way(np.array((begin_deg, end_deg), dtype=float), tuple(spread_deg))


def rest_of(way: Way, begin_deg: Sequence[float]) -> Way:
    """Return what is left of a way for an arm that stands at six angles on it."""
    begin = np.array(begin_deg, dtype=float)
    nearest = int(np.abs(way.joints_deg - begin).max(axis=1).argmin())
    ahead = way.joints_deg[min(nearest + 1, len(way.joints_deg) - 1) :]
    return Way(np.vstack((begin[None], ahead)))
