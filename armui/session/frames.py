"""The frames of a log in batches of columns, and the damaged places between them."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

import numpy as np

from armui.protocol.frame import Frame, FrameFlag
from armui.system.sentence import Told

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from numpy.typing import NDArray

    from armui.arm.refusal import Refusal

CLASSIC_BYTES = 8
"""The most data bytes of a classic CAN frame."""
MOST_BYTES = 64
"""The most data bytes of a CAN FD frame."""
LATEST_S = 1e10
"""The largest time of a log, from 1970 or from its beginning: the year 2286."""
MOST_DAMAGES = 1_000
"""The number of damaged places that are kept; further ones are only counted."""

Channel: TypeAlias = int | str | None
"""A channel as the log names it: "can0", 1, or None where the format has no channels."""


_REMOTE = int(FrameFlag.REMOTE)
NOT_OF_THE_ARM = ~FrameFlag.TRANSMITTED & 0xFF
"""The flags that a frame of the arm's protocol cannot have."""


class LoggedFrame(NamedTuple):
    """One frame of a log.

    Attributes:
        time_s: The time as recorded: since the start of the log or since 1970, depending on its
            format.
        frame: Identifier and payload; a frame of the arm's protocol only without flags.
        flags: The kind of frame.
        channel: As the log names it.
    """

    time_s: float
    frame: Frame
    flags: FrameFlag
    channel: Channel


@dataclass(frozen=True, slots=True)
class FrameBatch:
    """Consecutive frames of a log, one row each.

    Attributes:
        first: Number of the first frame within the log, from 0.
        times_s: Time of each frame as recorded, float64.
        ids: Identifiers, uint32.
        flags: `FrameFlag` bits, uint8.
        lengths: Bytes of data, uint8; of a remote frame the bytes it asks for.
        payloads: The first 8 bytes of data, zeros behind its end; uint8, shape (rows, 8).
        channels: Index into `channel_names`, uint8.
        channel_names: The channels of the log so far.
        long_data: Data of the frames with more than 8 bytes, by row.
    """

    first: int
    times_s: NDArray[np.float64]
    ids: NDArray[np.uint32]
    flags: NDArray[np.uint8]
    lengths: NDArray[np.uint8]
    payloads: NDArray[np.uint8]
    channels: NDArray[np.uint8]
    channel_names: tuple[Channel, ...]
    long_data: Mapping[int, bytes] = field(default_factory=dict)

    def __len__(self) -> int:
        return len(self.ids)

    def data(self, row: int) -> bytes:
        """Return the data of one frame; empty for a remote frame."""
        if self.flags[row] & _REMOTE:
            return b""
        whole = self.long_data.get(row)
        return self.payloads[row, : self.lengths[row]].tobytes() if whole is None else whole

    def frame(self, row: int) -> LoggedFrame:
        """Return one row as an object."""
        return LoggedFrame(
            float(self.times_s[row]),
            Frame(int(self.ids[row]), self.data(row)),
            FrameFlag(int(self.flags[row])),
            self.channel_names[self.channels[row]],
        )

    def __iter__(self) -> Iterator[LoggedFrame]:
        return map(self.frame, range(len(self)))


class Damage(NamedTuple):
    """A place in a log that could not be read, or only with a contradiction.

    Attributes:
        place: The place: "line 12", "byte 4711", "frame 3".
        reason: The reason, or the text found there.
        before_frame: The number, from 0, of the frame before or in which it is.
        frame_given: True if the frame was read all the same, and is marked as impossible.
    """

    place: str
    reason: str
    before_frame: int
    frame_given: bool = False

    def text(self) -> Told:
        """Return the place and the reason as one text."""
        figures = {"place": self.place, "reason": self.reason}
        if self.frame_given:
            return Told("{place} contradicts itself: {reason}", **figures)
        return Told("{place} cannot be read: {reason}", **figures)


class DamageList:
    """The damaged places of a log in the order they were met; bounded, then only counted.

    Attributes:
        count: The number of all damaged places, also of those not kept.
        notes: Remarks on the log that are no damage, each once.
    """

    def __init__(self) -> None:
        self._kept: list[Damage] = []
        self.count = 0
        self.notes: list[Refusal] = []

    def remark(self, note: Refusal) -> None:
        """Add to the notes."""
        if note not in self.notes:
            self.notes.append(note)

    def add(self, damage: Damage) -> None:
        """Keep one more damaged place, or only count it if there are too many."""
        self.count += 1
        if len(self._kept) < MOST_DAMAGES:
            self._kept.append(damage)

    def __len__(self) -> int:
        return len(self._kept)

    def since(self, index: int) -> list[Damage]:
        """Return the kept places from an index on."""
        return self._kept[index:]

    @property
    def full(self) -> bool:
        """True if further places are only counted."""
        return len(self._kept) >= MOST_DAMAGES

    @property
    def not_kept(self) -> int:
        """The number of places that were only counted."""
        return self.count - len(self._kept)


class NotALogError(Exception):
    """The file cannot be opened, or holds no frame; a `Told` of one line tells which."""
