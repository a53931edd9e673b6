"""A recording with access to any place; replay and exports use it."""

from __future__ import annotations

import enum
from typing import TYPE_CHECKING, Any, Final, NamedTuple, Protocol, runtime_checkable

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence

    import numpy as np
    from numpy.typing import NDArray

    from armui.session.frames import Channel, Damage, FrameBatch


REMEMBERED_IDS: Final = frozenset({0x473, 0x47C, 0x4AF})
"""Limits and accelerations, whose payload names the joint, and the version, whose text takes
several frames: the last frame alone is not enough.
"""
REMEMBERED: Final = 16
"""The number of their last frames in a snapshot."""


class MarkKind(enum.Enum):
    """The kind of moment at a mark."""

    FAULT = enum.auto()
    STOP = enum.auto()
    COMMAND = enum.auto()
    NOTE = enum.auto()
    """Any other event, or what the operator marked."""
    EPISODE = enum.auto()
    """An episode that the operator marked, from its beginning to its end."""
    DISCARDED = enum.auto()
    """The same, which the operator does not want."""


class SessionMark(NamedTuple):
    """A notable moment of a session.

    Attributes:
        at_s: Log time.
        kind: The kind of moment.
        entry: The event as a record of JSON values.
    """

    at_s: float
    kind: MarkKind
    entry: Mapping[str, object]


class Session(Protocol):
    """A recording with an index.

    Log time is in seconds as the recording has it, since 1970 or since its beginning. It never runs
    backwards: such times in the file were corrected, and `reversed_times` counts them. Every method
    may be called from any thread, also several at once. `RecordedSession` and
    `IndexedLog` implement it.

    Attributes:
        start_s, end_s: Log time of the first and of the last frame; both 0 without any.
        frames: The number of frames.
        channels: The channels that occur, in the order of their first frames.
        marks: The marks in the order of time; for a log without events those found in its frames.
        damages: The damaged places in the order of the file, bounded.
        damage_count: The number of all damaged places.
        reversed_times: The number of frames whose time was before that of the preceding one.
    """

    @property
    def start_s(self) -> float: ...  # noqa: D102 - said above

    @property
    def end_s(self) -> float: ...  # noqa: D102 - said above

    @property
    def frames(self) -> int: ...  # noqa: D102 - said above

    @property
    def channels(self) -> tuple[Channel, ...]: ...  # noqa: D102 - said above

    @property
    def marks(self) -> Sequence[SessionMark]: ...  # noqa: D102 - said above

    @property
    def damages(self) -> Sequence[Damage]: ...  # noqa: D102 - said above

    @property
    def damage_count(self) -> int: ...  # noqa: D102 - said above

    @property
    def reversed_times(self) -> int: ...  # noqa: D102 - said above

    def frames_between(self, t0_s: float, t1_s: float) -> Iterator[FrameBatch]:
        """Yield the frames with t0_s <= time < t1_s, in the order of time.

        A batch's `first` is the number of its first frame within the whole session.
        """

    def snapshot_at(self, t_s: float) -> FrameBatch:
        """Return the last frame of each identifier and channel up to a time, in order.

        Of those in `REMEMBERED_IDS` it holds the last `REMEMBERED`. Its rows are not consecutive in
        the log, so `first` is 0 and has no meaning.
        """

    def close(self) -> None:
        """Release files and memory; no other method may be called afterwards."""


class DataRows(NamedTuple):
    """All data frames of one identifier on one channel, in the order of time.

    Attributes:
        numbers: The frames' numbers within the whole session, shape (rows,).
        times_s: Log time, shape (rows,).
        lengths: Bytes of the payloads, shape (rows,).
        payloads: Zeros behind the end of shorter ones, shape (rows, 8).
    """

    numbers: NDArray[np.int64]
    times_s: NDArray[np.float64]
    lengths: NDArray[np.uint8]
    payloads: NDArray[np.uint8]

    def of(self, rows: NDArray[Any] | slice) -> DataRows:
        """Return the chosen rows, by index, mask or slice, in a new object."""
        numbers, times_s, lengths, payloads = self
        return DataRows(numbers[rows], times_s[rows], lengths[rows], payloads[rows])


@runtime_checkable
class KeepsCounts(Protocol):
    """A `Session` that stores its numbers of faults and stops."""

    @property
    def lacks_counts(self) -> bool:
        """True if they have not been counted yet."""

    def keep_counts(self, marks: Sequence[SessionMark]) -> None:
        """Store the numbers of faults and stops among the marks; waits for a disk."""


@runtime_checkable
class HasDataRows(Protocol):
    """A `Session` with direct access to the frames of each identifier."""

    def data_rows(self, channel: Channel, arbitration_id: int) -> DataRows | None:
        """Return data frames with an 11-bit identifier, or ``None`` if there are none."""
