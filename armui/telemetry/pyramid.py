"""Minima and maxima over buckets of time, in a few levels, each coarser than the one below.

Buckets are aligned to absolute time: a bucket's number is its time divided by its width. A curve
that scrolls keeps its buckets, and its shape.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import DTypeLike, NDArray

from armui.telemetry.memory import zeros

BASE_EXPONENT: Final = -4
"""The finest buckets are 2⁻⁴ s = 62.5 ms wide: 12 samples at 200 Hz."""
LEVELS: Final = 4
_STEP: Final = 2
"""A level's buckets are 2² times as wide as those of the level below: 62.5 ms, 0.25, 1 and 4 s."""
_NONE: Final = np.iinfo(np.int64).min

Extremes = tuple["NDArray[np.float64]", "NDArray[np.float64]"]
"""Minima and maxima, one row a signal, one column a bucket; NaN where there are none."""


@dataclass(frozen=True, slots=True)
class _Level:
    """One level: a ring of buckets.

    Attributes:
        numbers: Which bucket a place of the ring holds.
        lows, highs: For each block of signals, one row a signal.
    """

    numbers: NDArray[np.int64]
    lows: tuple[NDArray[Any], ...]
    highs: tuple[NDArray[Any], ...]


def firsts(numbers: NDArray[np.int64]) -> NDArray[np.intp]:
    """Where each run of equal numbers begins; there must be one."""
    begins = np.empty(numbers.size, np.bool_)
    begins[0] = True
    np.not_equal(numbers[1:], numbers[:-1], out=begins[1:])
    return begins.nonzero()[0]


class Pyramid:
    """Written by one thread, read by any number, without a lock.

    A place of a ring says which bucket it holds: what is older than the ring, or just being
    written, is read as empty.

    Args:
        blocks: For each block of signals how many they are, and their type.
        keep_s: How long a bucket is kept.
    """

    def __init__(self, blocks: Sequence[tuple[int, DTypeLike]], keep_s: float) -> None:
        self._blocks = tuple((count, np.dtype(kind)) for count, kind in blocks)
        self._levels = tuple(
            self._level(int(keep_s / 2.0 ** (BASE_EXPONENT + _STEP * place)) + 2)
            for place in range(LEVELS)
        )

    def _level(self, buckets: int) -> _Level:
        return _Level(
            np.full(buckets, _NONE, np.int64),
            tuple(zeros((count, buckets), kind) for count, kind in self._blocks),
            tuple(zeros((count, buckets), kind) for count, kind in self._blocks),
        )

    @property
    def bytes_kept(self) -> int:
        """How much memory it takes."""
        arrays = [
            array for level in self._levels for array in (level.numbers, *level.lows, *level.highs)
        ]
        return sum(array.nbytes for array in arrays)

    def put(
        self,
        numbers: NDArray[np.int64],
        lows: Sequence[NDArray[Any]],
        highs: Sequence[NDArray[Any]],
    ) -> None:
        """Take in buckets of the finest level; the writing thread only.

        Args:
            numbers: Which, ascending, none before the last one put in.
            lows: For each block, one row a signal.
            highs: As above.
        """
        for level in self._levels:
            numbers, lows, highs = _merged(level, numbers, lows, highs)
            _store(level, numbers, lows, highs)
            parents = numbers >> _STEP
            first = firsts(parents)
            numbers = parents[first]
            lows = [np.fmin.reduceat(low, first, axis=1) for low in lows]
            highs = [np.fmax.reduceat(high, first, axis=1) for high in highs]

    def read(
        self, exponent: int, begin: int, end: int, block: int, rows: Sequence[int]
    ) -> tuple[NDArray[np.bool_], Extremes]:
        """The buckets from one number up to another.

        Args:
            exponent: Buckets are 2^exponent seconds wide, no finer than the finest level.
            begin: Number of the first bucket, of this width.
            end: Number of the one behind the last.
            block: Of which signals.
            rows: Which ones of them.

        Returns:
            Which buckets hold anything, and their extremes.
        """
        place = min((exponent - BASE_EXPONENT) // _STEP, LEVELS - 1)
        ratio: int = 1 << (exponent - BASE_EXPONENT - _STEP * place)
        level = self._levels[place]
        wanted = np.arange(begin * ratio, end * ratio)
        slots = wanted % level.numbers.size
        there = level.numbers[slots] == wanted
        low, high = (
            side[block][np.asarray(rows)[:, np.newaxis], slots].astype(np.float64)
            for side in (level.lows, level.highs)
        )
        there &= level.numbers[slots] == wanted  # written over meanwhile
        low[:, ~there] = np.nan
        high[:, ~there] = np.nan
        if ratio > 1:
            there = there.reshape(-1, ratio).any(axis=1)
            low = np.fmin.reduce(low.reshape(len(rows), -1, ratio), axis=2)
            high = np.fmax.reduce(high.reshape(len(rows), -1, ratio), axis=2)
        return there, (low, high)


def _merged(
    level: _Level,
    numbers: NDArray[np.int64],
    lows: Sequence[NDArray[Any]],
    highs: Sequence[NDArray[Any]],
) -> tuple[NDArray[np.int64], Sequence[NDArray[Any]], Sequence[NDArray[Any]]]:
    """What is to be stored: the first bucket may be one that is there already, and has grown."""
    if numbers.size > level.numbers.size:  # more than the ring holds
        newest = slice(-level.numbers.size, None)
        numbers = numbers[newest]
        lows, highs = [low[:, newest] for low in lows], [high[:, newest] for high in highs]
    slot = numbers[0] % level.numbers.size
    if level.numbers[slot] == numbers[0]:
        lows, highs = [low.copy() for low in lows], [high.copy() for high in highs]
        for low, high, old_low, old_high in zip(lows, highs, level.lows, level.highs, strict=True):
            low[:, 0] = np.fmin(low[:, 0], old_low[:, slot])
            high[:, 0] = np.fmax(high[:, 0], old_high[:, slot])
    return numbers, lows, highs


def _store(
    level: _Level,
    numbers: NDArray[np.int64],
    lows: Sequence[NDArray[Any]],
    highs: Sequence[NDArray[Any]],
) -> None:
    slots = numbers % level.numbers.size
    level.numbers[slots] = _NONE
    for place, (low, high) in enumerate(zip(lows, highs, strict=True)):
        if not low.size:
            continue
        level.lows[place][:, slots] = low
        level.highs[place][:, slots] = high
    level.numbers[slots] = numbers
