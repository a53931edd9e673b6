"""The way of a motion: where it begins, what the joints do between, where it ends."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np
import numpy.typing as npt

from armui.kinematics import trapezoids

Array = npt.NDArray[np.float64]

_STILL: Final = (0.0,) * 6
_STEPS: Final = 24
"""The number of steps in time for a motion of the joints, beside the ends of its ramps."""
_SAME_DEG: Final = 0.02
"""Joints that are off an even turn by no more than this turn evenly."""
_SLOWEST: Final = 0.05
"""Limits of 0 are replaced by this many °/s and °/s²."""


@dataclass(frozen=True, slots=True, eq=False)
class Way:
    """The way of a motion through the joints' angles, as every rule sees it.

    Attributes:
        joints_deg: (n, 6) the poses on it, at least one; between two of them the joints turn
            evenly.
        spread_deg: (6,) how far each joint may be off at its beginning, which fades evenly to
            nothing at its end: an arm that brakes while it turns to another target is not exactly
            where it was measured.
        is_joint_move: True if the arm is told the last pose only, and turns its joints there by
            itself: each with its own ramps, see :func:`with_ramps`.
        beside_deg: (n, 6) how far each joint may be off at each pose; ``None`` if none is.
    """

    joints_deg: Array
    spread_deg: tuple[float, ...] = _STILL
    is_joint_move: bool = False
    beside_deg: Array | None = None

    @property
    def begin_deg(self) -> tuple[float, ...]:
        """The six angles at which it begins."""
        return tuple(self.joints_deg[0].tolist())

    @property
    def end_deg(self) -> tuple[float, ...]:
        """The six angles at which it ends."""
        return tuple(self.joints_deg[-1].tolist())

    @property
    def spreads_deg(self) -> Array:
        """(n, 6) how far each joint may be off at each pose, for one reason or the other."""
        shares = np.linspace(1.0, 0.0, len(self.joints_deg))[:, None]
        fading: Array = shares * np.array(self.spread_deg)
        return fading if self.beside_deg is None else fading + self.beside_deg

    def travel_mm(self, reaches_mm: Sequence[float]) -> float:
        """Return how far any part moves on it at most, what it may be off at first included.

        Args:
            reaches_mm: (6,) how far each joint moves any part at most for a radian.
        """
        turns_deg = np.abs(np.diff(self.joints_deg, axis=0)).sum(axis=0) / 2.0
        off_deg = self.spreads_deg.max(axis=0)
        return 2.0 * float(np.radians(turns_deg + off_deg) @ np.array(reaches_mm))

    @property
    def turn_deg(self) -> float:
        """The angle by which the joint that turns most turns on it."""
        return float(np.abs(np.diff(self.joints_deg, axis=0)).sum(axis=0).max(initial=0.0))


def straight_way(
    begin_deg: Sequence[float], end_deg: Sequence[float], spread_deg: Sequence[float] = _STILL
) -> Way:
    """Return the way of joints that turn evenly from six angles to six others."""
    return Way(np.array((begin_deg, end_deg), dtype=float), tuple(spread_deg))


def lagging_way(
    begin_deg: Sequence[float], end_deg: Sequence[float], lag_deg: Sequence[float]
) -> Way:
    """Return the way of joints that may each be anywhere between it and some angle behind it."""
    half = np.array(lag_deg, dtype=float) / 2.0
    way = np.array((begin_deg, end_deg), dtype=float) - half
    return Way(way, beside_deg=np.abs(np.stack((half, half))))


def joint_way(begin_deg: Sequence[float], end_deg: Sequence[float]) -> Way:
    """Return the way of an arm that is told six angles, as by MOVE J, and turns there by itself."""
    return replace(straight_way(begin_deg, end_deg), is_joint_move=True)


def with_ramps(way: Way, speeds: Sequence[float], accelerations: Sequence[float]) -> Way:
    """Return a way with the deviations that the joints' ramps may cause.

    The joints start and arrive together, but one that turns far accelerates and brakes for longer:
    the others are ahead of it at first, and behind it at the end. The maker documents neither that
    nor its extent at a lower speed. So each joint is checked wherever it may be between an even
    turn and one with its own ramps at full speed.

    Args:
        way: The way; one that is no motion of the joints stays as it is.
        speeds: The highest speeds of the joints in °/s.
        accelerations: Their highest accelerations in °/s².
    """
    if not way.is_joint_move:
        return way
    begin, end = way.joints_deg[0], way.joints_deg[-1]
    turns = np.abs(end - begin)
    tops, ramps = (np.maximum(each, _SLOWEST) for each in (speeds, accelerations))
    lasting_s = float(trapezoids.durations(turns, tops, ramps).max())
    if not (np.isfinite(lasting_s) and lasting_s > 0.0):
        return way
    even = trapezoids.even_speeds(turns, lasting_s, ramps)
    ends_s = np.minimum(even / ramps, lasting_s / 2.0)
    times_s = np.linspace(0.0, lasting_s, _STEPS + 1)
    times_s = np.unique(np.concatenate((times_s, ends_s, lasting_s - ends_s)))
    places = trapezoids.places(times_s[:, None], lasting_s, even, ramps)
    shares = np.clip(places / np.where(turns > 0.0, turns, 1.0), 0.0, 1.0)
    # The way follows the joint with the longest ramps; the others deviate from it.
    longest = shares[:, [int(np.argmax(ends_s))]]
    beside_deg = np.abs(shares - longest) * turns / 2.0
    if beside_deg.max() <= _SAME_DEG:
        return way
    beside_deg[[0, -1]] = 0.0
    joints_deg = begin + (shares + longest) / 2.0 * (end - begin)
    joints_deg[0], joints_deg[-1] = begin, end
    return replace(way, joints_deg=joints_deg, beside_deg=beside_deg)


def rest_of(way: Way, begin_deg: Sequence[float]) -> Way:
    """Return the rest of a way for an arm that stands at six angles on it."""
    begin = np.array(begin_deg, dtype=float)
    nearest = int(np.abs(way.joints_deg - begin).max(axis=1).argmin())
    ahead = way.joints_deg[min(nearest + 1, len(way.joints_deg) - 1) :]
    return Way(np.vstack((begin[None], ahead)), is_joint_move=way.is_joint_move)
