"""The signals of one message over time: every sample of half an hour, with its time."""

from __future__ import annotations

import mmap
import struct
from bisect import bisect_left
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from numpy.typing import DTypeLike, NDArray

_WORTH_PAGES = 65_536

BASE_EXPONENT: Final = -4
"""The finest buckets are 2⁻⁴ s = 62.5 ms wide: 12 samples at 200 Hz."""
LEVELS: Final = 4
_LEVEL_STEP: Final = 2
"""The exponent's step between levels: buckets are 62.5 ms, 0.25, 1 and 4 s wide."""
_NONE: Final = np.iinfo(np.int64).min

Extremes = tuple["NDArray[np.float64]", "NDArray[np.float64]"]
"""Minima and maxima, one row for each signal, one column for each bucket; NaN for none."""

KEPT_S: Final = 1800.0
"""Every sample is kept for this long, if they come at the rate of the protocol."""

_FOLD_EVERY: Final = 512
"""The number of samples added to the pyramid at once: numpy pays off by the hundred."""
_BASE_PER_S: Final = 2.0**-BASE_EXPONENT
_LATEST_TRIES: Final = 3
"""A reader tries again if the sample was overwritten while it was copied."""

Row = tuple[float, ...]


def zeros(shape: tuple[int, ...], kind: np.dtype[Any] | str) -> NDArray[Any]:
    """Return an array of zeros like `numpy.zeros` whose memory returns to the system when freed.

    The heap of the C library would keep the memory of freed arrays in pieces.
    """
    kind = np.dtype(kind)
    count = int(np.prod(shape))
    if count * kind.itemsize < _WORTH_PAGES:
        return np.zeros(shape, kind)
    return np.frombuffer(mmap.mmap(-1, count * kind.itemsize), kind, count).reshape(shape)


@dataclass(frozen=True, slots=True)
class _Level:
    """One level: a ring of buckets.

    Attributes:
        numbers: The number of the bucket at each place of the ring.
        lows, highs: For each block of signals, one row a signal.
    """

    numbers: NDArray[np.int64]
    lows: tuple[NDArray[Any], ...]
    highs: tuple[NDArray[Any], ...]


def firsts(numbers: NDArray[np.int64]) -> NDArray[np.intp]:
    """Return the index at which each run of equal numbers begins; at least one is needed."""
    begins = np.empty(numbers.size, np.bool_)
    begins[0] = True
    np.not_equal(numbers[1:], numbers[:-1], out=begins[1:])
    return begins.nonzero()[0]


class Pyramid:
    """Minima and maxima over buckets of time, in a few levels of rising width.

    Written by one thread, read by any number, without a lock. Buckets are aligned to absolute time:
    a bucket's number is its time divided by its width. A scrolling curve keeps its buckets, and its
    shape.

    Each place of a ring holds the number of its bucket: buckets older than the ring, or just being
    written, are read as empty.

    Args:
        blocks: The number of signals and their type for each block of signals.
        keep_s: The time for which a bucket is kept.
    """

    def __init__(self, blocks: Sequence[tuple[int, DTypeLike]], keep_s: float) -> None:
        self._blocks = tuple((count, np.dtype(kind)) for count, kind in blocks)
        self._levels = tuple(
            self._level(int(keep_s / 2.0 ** (BASE_EXPONENT + _LEVEL_STEP * place)) + 2)
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
        """The memory in use, in bytes."""
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
        """Add buckets of the finest level; for the writing thread only.

        Args:
            numbers: The buckets' numbers, ascending, none before the last one added.
            lows: For each block, one row for each signal.
            highs: As above.
        """
        for level in self._levels:
            numbers, lows, highs = _merged(level, numbers, lows, highs)
            _store(level, numbers, lows, highs)
            parents = numbers >> _LEVEL_STEP
            first = firsts(parents)
            numbers = parents[first]
            lows = [np.fmin.reduceat(low, first, axis=1) for low in lows]
            highs = [np.fmax.reduceat(high, first, axis=1) for high in highs]

    def read(
        self, exponent: int, begin: int, end: int, block: int, rows: Sequence[int]
    ) -> tuple[NDArray[np.bool_], Extremes]:
        """Return a range of buckets.

        Args:
            exponent: Buckets are 2^exponent seconds wide, no finer than the finest level.
            begin: Number of the first bucket, of this width.
            end: Number of the bucket behind the last.
            block: The block of signals.
            rows: The signals in the block.

        Returns:
            The mask of buckets that hold data, and their extremes.
        """
        place = min((exponent - BASE_EXPONENT) // _LEVEL_STEP, LEVELS - 1)
        ratio: int = 1 << (exponent - BASE_EXPONENT - _LEVEL_STEP * place)
        level = self._levels[place]
        wanted = np.arange(begin * ratio, end * ratio)
        slots = wanted % level.numbers.size
        there = level.numbers[slots] == wanted
        low, high = (
            side[block][np.asarray(rows)[:, np.newaxis], slots].astype(np.float64)
            for side in (level.lows, level.highs)
        )
        # once more: the writer may have replaced them meanwhile
        there &= level.numbers[slots] == wanted
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
    """Return the buckets to store, the first merged with its stored part, if there is one."""
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


@dataclass(frozen=True, slots=True)
class Shape:
    """The content of a series.

    Attributes:
        name: The name of the series.
        rate_hz: The protocol's highest rate of samples.
        figures: Names of its figures, kept as 32-bit floats; NaN if not reported.
        codes: Names of its codes, whole numbers of 0–255.
        held: True for commands, whose value holds until the next one, or until a row of NaN.
    """

    name: str
    rate_hz: float
    figures: tuple[str, ...]
    codes: tuple[str, ...] = ()
    held: bool = False

    @property
    def fields(self) -> tuple[str, ...]:
        """The names of all figures and codes, in the order of a row."""
        return (*self.figures, *self.codes)


@dataclass(frozen=True, slots=True)
class Envelope:
    """The smallest and largest values in buckets of time.

    Attributes:
        exponent: Each bucket is 2^exponent seconds wide.
        begin: The number of the first bucket.
        heard: True for buckets with samples; for a held series, with a value in force.
        low, high: One row for each field, NaN without a value.
    """

    exponent: int
    begin: int
    heard: NDArray[np.bool_]
    low: NDArray[np.float64]
    high: NDArray[np.float64]


class Series:
    """A ring of samples and their pyramid.

    One thread writes, and publishes the count after the data. Readers copy their range, and then
    check whether it was overwritten meanwhile. No thread waits for another.

    No memory is allocated before the first sample.

    Args:
        shape: The content of the series.
        keep_s: The time for which samples are kept.

    Attributes:
        shape: As given.
        write: Adds a sample: monotonic time in seconds, then the figures and codes in the order of
            `Shape.fields`; the writing thread only. A time before the last one counts as that one.
        replaced: The number of times its whole content was replaced.
    """

    def __init__(self, shape: Shape, keep_s: float = KEPT_S) -> None:
        self.shape = shape
        self._keep_s = keep_s
        self._capacity = max(_FOLD_EVERY * 2, round(shape.rate_hz * keep_s))
        layout, self._type = _layout(shape.figures, shape.codes)
        self._pack = layout.pack_into
        self._size = layout.size
        self.write: Callable[[float, Row], None]
        self.replaced = -1  # becomes 0 at the first release
        self.release()

    def release(self) -> None:
        """Free the memory and all samples; nothing may be written meanwhile."""
        self._count = self._folded = self._ahead = 0
        self.replaced += 1
        self._fold_at = _FOLD_EVERY
        self._newest_s = -np.inf
        self._buffer = memoryview(bytearray())
        self._samples = np.empty(0, self._type)
        self._times_s: NDArray[np.float64] = self._samples["time_s"]
        self._pyramid: Pyramid | None = None
        self.write = self._write_first

    def adopt(self, other: Series) -> None:
        """Take over the content of another series of the same shape, if it holds any.

        For the writing thread only; the other series must not be used any more. A reader may get
        samples of both once: `replaced` shows that they must be read again.
        """
        if other._pyramid is None:
            return
        self._samples, self._times_s = other._samples, other._times_s
        self._buffer, self._pyramid = other._buffer, other._pyramid
        self._newest_s, self._folded, self._fold_at = other._newest_s, other._folded, other._fold_at
        self._count = other._count
        self.write = self._write
        self.replaced += 1

    # The writing thread -----------------------------------------------------------------------

    def _write_first(self, at_s: float, row: Row) -> None:
        samples = zeros((self._capacity,), self._type)
        self._buffer = memoryview(samples.view(np.uint8).data)
        self._times_s = samples["time_s"]
        self._samples = samples
        self._pyramid = Pyramid(self._blocks(), self._keep_s)
        self.write = self._write
        self._write(at_s, row)

    def _blocks(self) -> list[tuple[int, str]]:
        return [(len(self.shape.figures), "f4"), (len(self.shape.codes), "u1")]

    def _write(self, at_s: float, row: Row) -> None:
        if at_s > self._newest_s:
            self._newest_s = at_s
        else:
            at_s = self._newest_s
        count = self._count
        self._pack(self._buffer, count % self._capacity * self._size, at_s, *row)
        self._count = count = count + 1
        if count >= self._fold_at:
            self._fold()

    def extend(self, times_s: NDArray[np.float64], columns: Mapping[str, NDArray[Any]]) -> None:
        """Add many samples at once, as `write` adds one; for the writing thread only.

        Args:
            times_s: The times, ascending.
            columns: The values of every field, by name.
        """
        most = self._capacity // 4
        for begin in range(0, times_s.size, most):
            piece = slice(begin, begin + most)
            self._extend(times_s[piece], {name: each[piece] for name, each in columns.items()})

    def _extend(self, times_s: NDArray[np.float64], columns: Mapping[str, NDArray[Any]]) -> None:
        begin = 0
        if self._pyramid is None:
            self.write(float(times_s[0]), tuple(columns[name][0] for name in self.shape.fields))
            begin = 1
        self._ahead = times_s.size - begin
        places = (self._count + np.arange(self._ahead)) % self._capacity
        times_s = np.maximum.accumulate(np.maximum(times_s[begin:], self._newest_s))
        self._samples["time_s"][places] = times_s
        for name in self.shape.fields:
            self._samples[name][places] = columns[name][begin:]
        if times_s.size:
            self._newest_s = float(times_s[-1])
        self._count += self._ahead
        self._ahead = 0
        if self._count >= self._fold_at:
            self._fold()

    def _fold(self) -> None:
        """Take every bucket that is complete into the pyramid."""
        self._fold_at = self._count + _FOLD_EVERY
        samples = self._span(self._folded, self._count)
        numbers = np.floor(samples["time_s"] * _BASE_PER_S).astype(np.int64)
        complete = int(np.searchsorted(numbers, numbers[-1]))
        if complete == 0 and samples.size < self._capacity // 2:
            return  # all samples lie in one bucket: wait until it is complete
        complete = complete or samples.size
        samples, numbers = samples[:complete], numbers[:complete]
        numbers, low, high = self._extremes(samples, numbers)
        if self._pyramid is not None:
            self._pyramid.put(numbers, low, high)
        self._folded += complete

    def _extremes(
        self, samples: NDArray[Any], numbers: NDArray[np.int64]
    ) -> tuple[NDArray[np.int64], list[NDArray[Any]], list[NDArray[Any]]]:
        """Return the extremes of each bucket, for each block of signals."""
        first = firsts(numbers)
        lows, highs = [], []
        for names, kind in ((self.shape.figures, "f4"), (self.shape.codes, "u1")):
            values = np.empty((len(names), samples.size), kind)
            for place, name in enumerate(names):
                values[place] = samples[name]
            lows.append(np.fmin.reduceat(values, first, axis=1))
            highs.append(np.fmax.reduceat(values, first, axis=1))
        return numbers[first], lows, highs

    # Any thread -------------------------------------------------------------------------------

    @property
    def count(self) -> int:
        """The number of samples ever added."""
        return self._count

    @property
    def newest_s(self) -> float | None:
        """The time of the last sample; ``None`` before the first."""
        count = self._count
        return float(self._times_s[(count - 1) % self._capacity]) if count else None

    @property
    def bytes_kept(self) -> int:
        """The memory in use, in bytes."""
        pyramid = self._pyramid
        return 0 if pyramid is None else self._samples.nbytes + pyramid.bytes_kept

    @property
    def most_bytes(self) -> int:
        """The most memory it will use, in bytes."""
        return self._capacity * self._size + Pyramid(self._blocks(), self._keep_s).bytes_kept

    def latest(self, field: str) -> tuple[float, float] | None:
        """Return the time of the last sample and one of its values; ``None`` before the first."""
        for _ in range(_LATEST_TRIES):
            count = self._count
            if count == 0:
                return None
            sample = self._samples[(count - 1) % self._capacity].copy()
            if self._count - count < self._capacity - 1:
                break
        return float(sample["time_s"]), float(sample[field])

    def samples(self, begin_s: float, end_s: float, *, around: bool = False) -> NDArray[Any]:
        """Return the samples from one time to another, both included.

        Args:
            begin_s: Monotonic time.
            end_s: As above.
            around: True to include the last one before and the first one after.

        Returns:
            A structured array with ``time_s`` and the fields' names, oldest first: a copy.
        """
        first = self._place(begin_s)
        last = self._place(np.nextafter(end_s, np.inf))
        if around:
            first, last = first - 1, last + 1
        return self._span(first, last)

    def count_between(self, begin_s: float, end_s: float) -> int:
        """Return the number of samples from one time up to another."""
        return self._place(end_s) - self._place(begin_s)

    def value_at(self, field: str, at_s: float) -> tuple[float, float] | None:
        """Return the last sample up to a time, like `latest`; ``None`` if it is no longer kept."""
        place = self._place(np.nextafter(at_s, np.inf)) - 1
        found = self._span(place, place + 1)
        return (float(found["time_s"][0]), float(found[field][0])) if found.size else None

    def envelope(self, exponent: int, begin: int, end: int, fields: Sequence[str]) -> Envelope:
        """Return minima and maxima in buckets of time.

        Args:
            exponent: The buckets are 2^exponent seconds wide.
            begin: The number of the first one.
            end: The number of the one behind the last.
            fields: The names of figures or of codes, not of both.
        """
        size = max(0, end - begin)
        heard = np.zeros(size, np.bool_)
        low = np.full((len(fields), size), np.nan)
        high = low.copy()
        folded, pyramid = self._folded, self._pyramid
        if size and exponent >= BASE_EXPONENT and pyramid is not None:
            names = self.shape.figures
            block = 0 if fields and fields[0] in names else 1
            rows = [(names, self.shape.codes)[block].index(field) for field in fields]
            heard, (low, high) = pyramid.read(exponent, begin, end, block, rows)
            samples = self._span(folded, self._place(end * 2.0**exponent))
        else:
            samples = self._span(
                self._place(begin * 2.0**exponent), self._place(end * 2.0**exponent)
            )
        envelope = Envelope(exponent, begin, heard, low, high)
        self._add(samples, fields, envelope)
        if self.shape.held:
            self._hold(fields, envelope)
        return envelope

    @staticmethod
    def _add(samples: NDArray[Any], fields: Sequence[str], into: Envelope) -> None:
        """Take samples into buckets."""
        numbers = np.floor(samples["time_s"] * 2.0**-into.exponent).astype(np.int64) - into.begin
        inside = (numbers >= 0) & (numbers < into.heard.size)
        if not inside.all():
            numbers, samples = numbers[inside], samples[inside]
        if numbers.size == 0:
            return
        first = firsts(numbers)
        numbers = numbers[first]
        into.heard[numbers] = True
        low, high = into.low, into.high
        for row, field in enumerate(fields):
            values = samples[field].astype(np.float64)
            low[row, numbers] = np.fmin(low[row, numbers], np.fmin.reduceat(values, first))
            high[row, numbers] = np.fmax(high[row, numbers], np.fmax.reduceat(values, first))

    def _hold(self, fields: Sequence[str], into: Envelope) -> None:
        """Fill buckets without a sample with the last one before them."""
        edges = np.flatnonzero(np.diff(into.heard, prepend=True, append=True))
        for first, behind in zip(edges[::2], edges[1::2], strict=True):
            place = self._place((into.begin + int(first)) * 2.0**into.exponent) - 1
            before = self._span(place, place + 1)
            if before.size == 0:
                continue
            for row, field in enumerate(fields):
                into.low[row, first:behind] = into.high[row, first:behind] = before[field][0]
            into.heard[first:behind] = not np.isnan(before[fields[0]][0])

    def _place(self, time_s: float) -> int:
        """Return the number of the first sample not before a time, counted from the first ever."""
        count, capacity, times_s = self._count, self._capacity, self._times_s
        oldest = max(0, count + self._ahead - capacity + 1)
        return oldest + bisect_left(
            range(oldest, count), time_s, key=lambda place: float(times_s[place % capacity])
        )

    def _span(self, first: int, behind: int) -> NDArray[Any]:
        """Return a copy of the samples between two places, as far as they are still there."""
        first = max(first, self._count + self._ahead - self._capacity + 1, 0)
        behind = min(behind, self._count)
        if behind <= first:
            return np.empty(0, self._type)
        samples, capacity = self._samples, self._capacity
        begin, end = first % capacity, (behind - 1) % capacity + 1
        if begin < end:
            copy = samples[begin:end].copy()
        else:
            copy = np.concatenate((samples[begin:], samples[:end]))
        lost = self._count + self._ahead - capacity + 1 - first
        return copy[lost:] if lost > 0 else copy


@cache
def _layout(
    figures: tuple[str, ...], codes: tuple[str, ...]
) -> tuple[struct.Struct, np.dtype[np.void]]:
    """Return how a sample lies in memory, as it is written and as it is read."""
    fields: list[tuple[str, str]] = [("time_s", "<f8")]
    fields += [(name, "<f4") for name in figures]
    fields += [(name, "u1") for name in codes]
    return struct.Struct(f"<d{len(figures)}f{len(codes)}B"), np.dtype(fields)
