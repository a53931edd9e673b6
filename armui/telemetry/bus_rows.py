"""What was counted of each identifier, frozen, and the figures of its cycle."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Final

from armui.protocol.frame import FrameFlag

if TYPE_CHECKING:
    from armui.protocol.codec import InvalidFrame
    from armui.telemetry.bus_senders import Sender

BUS_CYCLES: Final = 256
"""So many of the last cycles are looked at, at most."""
RECENT_S: Final = 3.0
"""Cycles of so long a time before the last frame give its rate and its jitter …"""
_FEWEST: Final = 8
"""… but at least so many, for frames that come seldom."""
SILENT_S: Final = 0.5
"""A periodic frame that is missing for so long, and for three cycles, has fallen silent."""
_SILENT_CYCLES: Final = 3.0


@dataclass(frozen=True, slots=True)
class Cycle:
    """How regularly a frame comes.

    Attributes:
        rate_hz: Of the recent cycles.
        deviation_s: How far they are from their mean, on average.
    """

    rate_hz: float
    deviation_s: float


@dataclass(frozen=True, slots=True)
class FrameRow:
    """Frames of one identifier and one sender.

    Attributes:
        number: Its own, as long as the statistics are not cleared.
        arbitration_id: As seen on the wire.
        flags: What sort of frame it is, `FrameFlag` bits; 0: a data frame with 11 bits.
        sender: Who sends it.
        count: How many were counted.
        last_s: When the last one came.
        data: Its payload.
        changed_s: When each of the first eight bytes was last seen to change, or minus infinity.
        times_s: When the last ones came, without a break between them.
        max_gap_s: The longest cycle; ``None`` before there was one.
        invalid: The last one that does not follow the protocol.
        invalid_count: How many do not.
        invalid_length: How many bytes that one has.
        invalid_s: When that one came.
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
        """Rows are shown by identifier, error frames last."""
        error = bool(self.flags & FrameFlag.ERROR)
        return error, self.arbitration_id, self.flags, self.sender

    def cycle(self) -> Cycle | None:
        """Of the recent frames; ``None`` if there were fewer than two."""
        return cycle_of(self.times_s)

    def is_silent(self, now_s: float) -> bool:
        """Whether frames that came regularly come no more."""
        away_s = now_s - self.last_s
        if away_s <= SILENT_S or len(self.times_s) < 3:
            return False
        cycle = self.cycle()
        return cycle is not None and away_s * cycle.rate_hz > _SILENT_CYCLES

    def changed_since(self, at_s: float) -> bool:
        """Whether a byte was seen to change after a time."""
        return max(self.changed_s) > at_s


@dataclass(frozen=True, slots=True)
class BusSnapshot:
    """All that was counted up to a moment.

    Attributes:
        at_s: When it was taken.
        since_s: When the counting began.
        rows: By identifier.
        frames: All of them, error frames included.
        error_frames: What the adapter reported as errors.
        left_out: Frames that were never counted, because nobody looked for too long.
        beyond: Frames of identifiers that are more than there are rows for.
    """

    at_s: float
    since_s: float
    rows: tuple[FrameRow, ...]
    frames: int = 0
    error_frames: int = 0
    left_out: int = 0
    beyond: int = 0


def cycle_of(times_s: Sequence[float]) -> Cycle | None:
    """How regularly frames came at these times; ``None`` if it can't be told.

    Of those within 3 s before the last one, or of the last nine.
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
