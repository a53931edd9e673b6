"""The last frames on the bus in order of time, in arrays."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from armui.telemetry.bus_senders import Sender
    from armui.telemetry.listener import ReceivedFrame

TRACE_FRAMES: Final = 10_000
"""Some three seconds of an arm; a view takes too long for more."""
_BYTES: Final = 8


class TracedFrame(NamedTuple):
    """One frame of the trace.

    Attributes:
        at_s: The time of reception or sending.
        arbitration_id: The identifier on the wire.
        flags: Its kind, `FrameFlag` bits.
        sender: Its sender.
        data: Its first eight bytes.
        length: Its length in bytes.
        changed: Those bytes that differ from the frame before of this identifier and sender.
    """

    at_s: float
    arbitration_id: int
    flags: int
    sender: Sender
    data: bytes
    length: int
    changed: tuple[bool, ...]


@dataclass(frozen=True, slots=True)
class TraceSnapshot:
    """Frozen frames of the trace, the oldest first.

    Attributes:
        times_s: The time of each.
        numbers: The row of each in the statistics.
        words: The first eight bytes of each.
        differences: Bits that differ from the frame before of the same row.
        lengths: The lengths of the payloads.
        names: The identity of each row, by its number.
    """

    times_s: NDArray[np.float64]
    numbers: NDArray[np.int32]
    words: NDArray[np.uint64]
    differences: NDArray[np.uint64]
    lengths: NDArray[np.uint8]
    names: tuple[tuple[int, int, Sender], ...]

    def __len__(self) -> int:
        return len(self.times_s)

    def selected(
        self, allowed: Collection[int], *, only_changed: bool = False, most: int = TRACE_FRAMES
    ) -> TraceSnapshot:
        """Return a selection of the frames.

        Args:
            allowed: The numbers of the rows whose frames are wanted.
            only_changed: True for only the frames that differ from the one before.
            most: The most frames, counted from the end.
        """
        wanted = np.zeros(max(len(self.names), 1), np.bool_)
        wanted[[each for each in allowed if each < len(self.names)]] = True
        kept = wanted[self.numbers]
        if only_changed:
            kept &= self.differences != 0
        places = np.flatnonzero(kept)[-most:]
        return TraceSnapshot(
            self.times_s[places],
            self.numbers[places],
            self.words[places],
            self.differences[places],
            self.lengths[places],
            self.names,
        )

    def frame(self, place: int) -> TracedFrame:
        """Return the frame at a place, and which of its bytes have changed."""
        arbitration_id, flags, sender = self.names[int(self.numbers[place])]
        length = int(self.lengths[place])
        data = int(self.words[place]).to_bytes(_BYTES, "big")[:length]
        differs = int(self.differences[place]).to_bytes(_BYTES, "big")[:length]
        at_s = float(self.times_s[place])
        changed = tuple(each != 0 for each in differs)
        return TracedFrame(at_s, arbitration_id, flags, sender, data, length, changed)


class BusTrace:
    """Keeps the last frames; the oldest are dropped."""

    def __init__(self, most: int = TRACE_FRAMES) -> None:
        self._most = most
        self._times_s = np.empty(most)
        self._numbers = np.empty(most, np.int32)
        self._words = np.empty(most, np.uint64)
        self._differences = np.empty(most, np.uint64)
        self._lengths = np.empty(most, np.uint8)
        self._names: list[tuple[int, int, Sender]] = []
        self._count = 0

    def clear(self) -> None:
        """Drop all frames."""
        self._names = []
        self._count = 0

    def name(self, number: int, arbitration_id: int, flags: int, sender: Sender) -> None:
        """Set the identity of the next row of the statistics; rows are numbered from 0."""
        assert number == len(self._names), "rows are named one after another"  # noqa: S101
        self._names.append((arbitration_id, flags, sender))

    def extend(
        self,
        batch: Sequence[ReceivedFrame],
        numbers: Sequence[int],
        words: Sequence[int],
        differences: Sequence[int],
    ) -> None:
        """Add frames in order: their rows, their bytes, and the bits that have changed."""
        count = len(batch)
        if not count:
            return
        if count > self._most:
            batch, numbers = batch[-self._most :], numbers[-self._most :]
            words, differences = words[-self._most :], differences[-self._most :]
            self._count += count - self._most
            count = self._most
        places = np.arange(self._count, self._count + count) % self._most
        self._times_s[places] = [at_s for _heard, at_s, _frame, _flags in batch]
        self._numbers[places] = numbers
        self._words[places] = words
        self._differences[places] = differences
        self._lengths[places] = [min(len(frame[1]), 255) for _heard, _at_s, frame, _ in batch]
        self._count += count

    def snapshot(self) -> TraceSnapshot:
        """Return a copy of the trace, in the order of time."""
        places = np.arange(max(0, self._count - self._most), self._count) % self._most
        # sent frames are added a little later than received ones
        places = places[np.argsort(self._times_s[places], kind="stable")]
        return TraceSnapshot(
            self._times_s[places],
            self._numbers[places],
            self._words[places],
            self._differences[places],
            self._lengths[places],
            tuple(self._names),
        )
