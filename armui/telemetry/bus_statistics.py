"""The traffic on the bus, counted by identifier and sender, and the last frames in order.

The bus thread only queues batches: it neither counts nor waits. The reading thread counts, a
limited number of frames at a time.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import TYPE_CHECKING, Final

from armui.protocol.codec import Message
from armui.protocol.frame import FrameFlag
from armui.system.clock import steady_s
from armui.telemetry.bus_senders import VERSION_ID, Sender, sender_of
from armui.telemetry.bus_trace import BusTrace
from armui.telemetry.listener import Listener

if TYPE_CHECKING:
    from armui.protocol.codec import Codec, InvalidFrame
    from armui.protocol.frame import Frame
    from armui.protocol.generation import Generation
    from armui.telemetry.listener import ReceivedFrame

BUS_CYCLES: Final = 256
"""The most of the last cycles that are evaluated."""
RECENT_S: Final = 3.0
"""Rate and jitter of a frame come from its cycles within this time before the last one …"""
_FEWEST: Final = 8
"""… but from at least this many, for frames that come seldom."""
SILENT_S: Final = 0.5
"""A periodic frame missing for this long, and for three cycles, counts as silent."""
_SILENT_CYCLES: Final = 3.0

MOST_ROWS: Final = 512
"""The most rows; a bus full of noise has more identifiers than anybody can read."""
MOST_WAITING: Final = 40_000
"""The most frames that wait to be counted: some five seconds of a full bus."""
MOST_AT_ONCE: Final = 4_000
"""The frames counted in one call: some milliseconds."""
_BYTES: Final = 8

_ALL_BITS: Final = (1 << 8 * _BYTES) - 1


@dataclass(frozen=True, slots=True)
class Cycle:
    """The regularity of a frame.

    Attributes:
        rate_hz: The rate over the recent cycles.
        deviation_s: Their mean deviation from their average.
    """

    rate_hz: float
    deviation_s: float


@dataclass(frozen=True, slots=True)
class FrameRow:
    """The frames of one identifier and one sender.

    Attributes:
        number: The row's number, unique until the statistics are cleared.
        arbitration_id: The identifier on the wire.
        flags: Its kind, `FrameFlag` bits; 0 for a data frame with an 11-bit identifier.
        sender: Its sender.
        count: The number of frames.
        last_s: The time of the last one.
        data: Its payload.
        changed_s: The time at which each of the first eight bytes last changed, or minus infinity.
        times_s: The times of the last ones without a break between them.
        max_gap_s: The longest cycle; ``None`` before there was one.
        invalid: The last frame that does not follow the protocol.
        invalid_count: The number of such frames.
        invalid_length: The length of the last such frame in bytes.
        invalid_s: The time of the last such frame.
    """

    number: int
    arbitration_id: int
    flags: int
    sender: Sender
    count: int
    last_s: float
    data: bytes
    changed_s: tuple[float, ...]
    times_s: tuple[float, ...]
    max_gap_s: float | None
    invalid: InvalidFrame | None
    invalid_count: int
    invalid_length: int
    invalid_s: float

    def order(self) -> tuple[bool, int, int, str]:
        """Return the sort key of the row: by identifier, error frames last."""
        error = bool(self.flags & FrameFlag.ERROR)
        return error, self.arbitration_id, self.flags, self.sender

    def cycle(self) -> Cycle | None:
        """Return the cycle of the recent frames, or ``None`` if there were fewer than two."""
        return cycle_of(self.times_s)

    def is_silent(self, now_s: float) -> bool:
        """Return whether frames that came regularly have stopped."""
        away_s = now_s - self.last_s
        if away_s <= SILENT_S or len(self.times_s) < 3:
            return False
        cycle = self.cycle()
        return cycle is not None and away_s * cycle.rate_hz > _SILENT_CYCLES

    def changed_since(self, at_s: float) -> bool:
        """Return whether a byte has changed after a time."""
        return max(self.changed_s) > at_s


@dataclass(frozen=True, slots=True)
class BusSnapshot:
    """All counts up to a moment.

    Attributes:
        at_s: The time of the snapshot.
        since_s: The time at which counting began.
        rows: The rows by identifier.
        frames: The number of all frames, error frames included.
        error_frames: The number of errors reported by the adapter.
        left_out: The number of frames never counted, because nobody read them for too long.
        beyond: The number of frames of identifiers for which there was no row left.
    """

    at_s: float
    since_s: float
    rows: tuple[FrameRow, ...]
    frames: int = 0
    error_frames: int = 0
    left_out: int = 0
    beyond: int = 0


def cycle_of(times_s: Sequence[float]) -> Cycle | None:
    """Return the cycle of frames that came at these times, or ``None`` if it can't be told.

    It covers the frames within 3 s before the last one, or the last nine.
    """
    if len(times_s) < 2:
        return None
    recent_s = [each for each in times_s if each >= times_s[-1] - RECENT_S]
    if len(recent_s) <= _FEWEST:
        recent_s = list(times_s[-_FEWEST - 1 :])
    mean_s = (recent_s[-1] - recent_s[0]) / (len(recent_s) - 1)
    if mean_s <= 0.0:
        return None
    gaps_s = [later - earlier for earlier, later in pairwise(recent_s)]
    deviation_s = math.fsum(abs(gap_s - mean_s) for gap_s in gaps_s) / len(gaps_s)
    return Cycle(1.0 / mean_s, deviation_s)


@dataclass(eq=False, slots=True)
class _Series:
    """Frames of one identifier and one sender."""

    number: int
    arbitration_id: int
    data: bytes
    word: int
    flags: int
    sender: Sender
    last_s: float
    count: int = 0
    max_gap_s: float = -math.inf
    times_s: deque[float] = field(default_factory=lambda: deque(maxlen=BUS_CYCLES + 1))
    difference: int = 0
    changed_s: list[float] = field(default_factory=lambda: [-math.inf] * _BYTES)
    invalid: InvalidFrame | None = None
    invalid_count: int = 0
    invalid_length: int = 0
    invalid_s: float = -math.inf
    row: FrameRow | None = None

    def change(self, data: bytes) -> int:
        """Add a payload, and return the bits of its first eight bytes that have changed."""
        word = _word(data)
        difference = word ^ self.word if len(data) == len(self.data) else _ALL_BITS
        self.data, self.word = data, word
        self.difference |= difference
        return difference

    def shown(self, at_s: float) -> FrameRow:
        """Return a frozen row; the same one as before if nothing came."""
        if self.row is not None and self.row.count == self.count:
            return self.row
        difference, self.difference = self.difference, 0
        if difference:
            for place in range(_BYTES):
                if difference >> 8 * (_BYTES - 1 - place) & 0xFF:
                    self.changed_s[place] = at_s
        self.row = FrameRow(
            number=self.number,
            arbitration_id=self.arbitration_id,
            flags=self.flags,
            sender=self.sender,
            count=self.count,
            last_s=self.last_s,
            data=self.data,
            changed_s=tuple(self.changed_s),
            times_s=tuple(self.times_s),
            max_gap_s=self.max_gap_s if self.max_gap_s >= 0.0 else None,
            invalid=self.invalid,
            invalid_count=self.invalid_count,
            invalid_length=self.invalid_length,
            invalid_s=self.invalid_s,
        )
        return self.row


_SORT_SHIFT: Final = 32
_KIND: Final = FrameFlag.EXTENDED | FrameFlag.REMOTE | FrameFlag.ERROR | FrameFlag.FD

_OPENED: Final[list[ReceivedFrame]] = []
"""Marks in the queue that a device was opened: no cycle continues across it."""


class BusStatistics(Listener):
    """A listener on the bus (`armui.bus.notifier.Listener`) that counts its frames.

    The bus thread calls `on_…`, one reading thread the other methods.

    Args:
        clock: Monotonic time in seconds, the same as of the frames.

    Attributes:
        trace: The last frames, in order of time.
    """

    def __init__(self, clock: Callable[[], float] = steady_s) -> None:
        self._clock = clock
        self._waiting: deque[tuple[Sequence[ReceivedFrame], bool]] = deque()
        self._handed_over = self._taken = 0
        self._left_out = self._left_out_before = 0
        self._codec: Codec | None = None
        self._generation: Generation | None = None
        self._spoken: Codec | None = None
        self.trace = BusTrace()
        self.clear()

    # The bus thread ---------------------------------------------------------------------------

    def know_generation(self, generation: Generation | None) -> None:
        """Set the protocol that the arm was found to speak."""
        self._generation = generation

    def on_open(self, _bitrate: int | None) -> None:
        """Note that a device was opened."""
        self._waiting.append((_OPENED, False))

    def on_codec(self, codec: Codec) -> None:
        """Set the codec that decodes the frames from now on."""
        self._codec = codec

    def on_heard(self, batch: Sequence[ReceivedFrame]) -> None:
        """Add frames that others sent."""
        self._hand_over(batch, own=False)

    def on_sent(self, batch: Sequence[ReceivedFrame]) -> None:
        """Add frames that this program sent."""
        self._hand_over(batch, own=True)

    def _hand_over(self, batch: Sequence[ReceivedFrame], *, own: bool) -> None:
        if self._handed_over - self._taken > MOST_WAITING:
            self._left_out += len(batch)
            return
        self._handed_over += len(batch)
        self._waiting.append((batch, own))

    # The reading thread -----------------------------------------------------------------------

    @property
    def codec(self) -> Codec | None:
        """The present codec; ``None`` before the first device."""
        return self._codec

    @property
    def generation_known(self) -> bool:
        """True if the arm is known to speak the codec's generation."""
        return self._codec is not None and self._codec.generation is self._generation

    def clear(self) -> None:
        """Start counting from zero."""
        self._series: dict[tuple[int, Sender], _Series] = {}
        self._heard: dict[int, _Series] = {}
        self._own: dict[int, _Series] = {}
        self._frames = self._error_frames = self._beyond = 0
        self._left_out_before = self._left_out
        self._since_s = self._clock()
        self.trace.clear()

    def forget_waiting(self) -> None:
        """Drop the frames that were not counted yet."""
        while self._waiting:
            self._taken += len(self._waiting.popleft()[0])

    def count_waiting(self, most: int = MOST_AT_ONCE) -> bool:
        """Count waiting frames, up to about `most`; return whether none is left."""
        if self._spoken is not self._codec:
            # With another codec an identifier may belong to another sender.
            self._spoken = self._codec
            self._heard.clear()
        taken = 0
        while self._waiting and taken < most:
            batch, own = self._waiting.popleft()
            self._count(batch, own=own)
            taken += len(batch)
            self._taken += len(batch)
        return not self._waiting

    def snapshot(self) -> BusSnapshot:
        """Return a frozen copy of the counts."""
        now_s = self._clock()
        rows = sorted((each.shown(now_s) for each in self._series.values()), key=FrameRow.order)
        return BusSnapshot(
            at_s=now_s,
            since_s=self._since_s,
            rows=tuple(rows),
            frames=self._frames,
            error_frames=self._error_frames,
            left_out=self._left_out - self._left_out_before,
            beyond=self._beyond,
        )

    def _count(self, batch: Sequence[ReceivedFrame], *, own: bool) -> None:
        if batch is _OPENED:
            for each in self._series.values():
                each.times_s.clear()
            return
        known = self._own if own else self._heard
        find = known.get
        numbers: list[int] = []
        differences: list[int] = []
        words: list[int] = []
        kept: list[ReceivedFrame] = []
        self._frames += len(batch)
        for taken in batch:
            heard, at_s, frame, flags = taken
            series = None if flags and not own else find(frame[0])
            if series is None:
                series = self._find(frame, 0 if own else flags & _KIND, at_s, own=own)
                if series is None:
                    self._beyond += 1
                    continue
            data = frame[1]
            difference = 0 if data == series.data else series.change(data)
            series.count += 1
            times_s = series.times_s
            if times_s:
                gap_s = at_s - series.last_s
                series.max_gap_s = max(series.max_gap_s, gap_s)
            series.last_s = at_s
            times_s.append(at_s)
            if heard.__class__ is not Message:
                series.invalid = heard  # type: ignore[assignment]  # an InvalidFrame here
                series.invalid_count += 1
                series.invalid_length = len(data)
                series.invalid_s = at_s
            numbers.append(series.number)
            differences.append(difference)
            words.append(series.word)
            kept.append(taken)
        self.trace.extend(kept, numbers, words, differences)

    def _find(self, frame: Frame, flags: int, at_s: float, *, own: bool) -> _Series | None:
        if flags & FrameFlag.ERROR:
            self._error_frames += 1
        sender = Sender.OWN if own else self._sender(frame, flags)
        key = frame.arbitration_id | flags << _SORT_SHIFT
        series = self._series.get((key, sender))
        if series is None:
            if len(self._series) >= MOST_ROWS:
                return None
            series = _Series(len(self._series), *frame, _word(frame.data), flags, sender, at_s)
            self._series[key, sender] = series
            self.trace.name(series.number, frame.arbitration_id, flags, sender)
        if own:
            self._own[frame.arbitration_id] = series
        elif not flags and frame.arbitration_id != VERSION_ID:
            self._heard[frame.arbitration_id] = series
        return series

    def _sender(self, frame: Frame, flags: int) -> Sender:
        if self._codec is None:
            return Sender.UNKNOWN
        return sender_of(frame, flags, self._codec.addressing)


def _word(data: bytes) -> int:
    """Return the first eight bytes as one number, zeros behind the end of shorter payloads."""
    return int.from_bytes(data[:_BYTES].ljust(_BYTES, b"\0"), "big")
