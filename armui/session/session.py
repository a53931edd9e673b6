"""A recording that any place of can be reached at once: what replay and exports are given."""

from __future__ import annotations

import enum
from typing import TYPE_CHECKING, Any, Final, NamedTuple, Protocol, runtime_checkable

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence

    import numpy as np
    from numpy.typing import NDArray

    from armui.session.frames import Channel, Damage, FrameBatch


REMEMBERED_IDS: Final = frozenset({0x473, 0x47C, 0x4AF})
"""Limits and accelerations, whose payload says of which joint they are, and the version, whose text
takes several frames: the last one alone says too little."""
REMEMBERED: Final = 16
"""So many of their last frames belong to a snapshot."""


class MarkKind(enum.Enum):
    """What sort of moment a mark names."""

    FAULT = enum.auto()
    STOP = enum.auto()
    COMMAND = enum.auto()
    NOTE = enum.auto()
    """Any other event, or what the operator marked."""


class SessionMark(NamedTuple):
    """A moment worth going to.

    Attributes:
        at_s: Log time.
        kind: What sort of moment it is.
        entry: What happened, as a record of JSON values, as an event of the program's is written.
    """

    at_s: float
    kind: MarkKind
    entry: Mapping[str, object]


class Session(Protocol):
    """A recording, indexed.

    Log time is in seconds as the recording has it, since 1970 or since its beginning. It never runs
    backwards here: times that do in the file were put right, and `reversed_times` counts them.
    Every method may be called from any thread, also several at once. `open_session` makes one.

    Attributes:
        start_s, end_s: Log time of the first and of the last frame; both 0 without any.
        frames: How many there are.
        channels: The channels that occur, in the order of their first frames.
        marks: In the order of time; of a log without events what its frames tell.
        damages: Damaged places, in the order of the file, bounded.
        damage_count: All of them.
        reversed_times: Frames whose time was before that of the frame in front of them.
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
        """Return the frames with t0_s <= time < t1_s, in the order of time.

        A batch's `first` is the number of its first frame within the whole session.
        """

    def snapshot_at(self, t_s: float) -> FrameBatch:
        """Return the last frame of each identifier and channel up to a time, in order.

        Of those in `REMEMBERED_IDS` the last `REMEMBERED`. Its rows are no neighbours in the log:
        `first` is 0 and means nothing.
        """

    def close(self) -> None:
        """Let go of files and memory; nothing may be asked afterwards."""


class DataRows(NamedTuple):
    """All data frames of one identifier on one channel, in the order of time.

    Attributes:
        numbers: Within the whole session, shape (rows,).
        times_s: Log time, shape (rows,).
        lengths: Bytes of the payloads, shape (rows,).
        payloads: Zeros behind the end of shorter ones, shape (rows, 8).
    """

    numbers: NDArray[np.int64]
    times_s: NDArray[np.float64]
    lengths: NDArray[np.uint8]
    payloads: NDArray[np.uint8]

    def of(self, rows: NDArray[Any] | slice) -> DataRows:
        """Some of them."""
        numbers, times_s, lengths, payloads = self
        return DataRows(numbers[rows], times_s[rows], lengths[rows], payloads[rows])


@runtime_checkable
class KeepsCounts(Protocol):
    """A `Session` beside which its numbers of faults and stops are kept."""

    @property
    def lacks_counts(self) -> bool:
        """True if nobody has counted them yet."""

    def keep_counts(self, marks: Sequence[SessionMark]) -> None:
        """Keep how many the marks tell of; waits for a disk."""


@runtime_checkable
class HasDataRows(Protocol):
    """A `Session` that has the frames of each identifier at hand."""

    def data_rows(self, channel: Channel, arbitration_id: int) -> DataRows | None:
        """Return frames with 11-bit identifiers that carry data; ``None``: there are none."""
