"""The frames of one arm, in pieces of a size that is worth working on at once."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np

from armui.protocol.columns import payload_words
from armui.session.frames import NOT_OF_THE_ARM
from armui.telemetry.columns import joined

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from numpy.typing import NDArray

    from armui.session.frames import Channel, FrameBatch

_ENOUGH: Final = 32_768
"""Frames of a piece at least: then the cost of a piece no longer counts."""


@dataclass(frozen=True, slots=True)
class ArmFrames:
    """Consecutive frames of one channel that an arm or its host may have sent.

    Attributes:
        rows: The number of each within the log, int64.
        times_s: As recorded, float64.
        ids: Identifiers on the wire, uint32.
        lengths: Bytes of data, uint8.
        words: The data as a big-endian number, uint64.
    """

    rows: NDArray[np.int64]
    times_s: NDArray[np.float64]
    ids: NDArray[np.uint32]
    lengths: NDArray[np.uint8]
    words: NDArray[np.uint64]

    def __len__(self) -> int:
        return len(self.rows)


def no_frames() -> ArmFrames:
    """A piece without any."""
    return ArmFrames(
        np.empty(0, np.int64),
        np.empty(0, np.float64),
        np.empty(0, np.uint32),
        np.empty(0, np.uint8),
        np.empty(0, np.uint64),
    )


class ArmFrameReader:
    """Makes the pieces of a log's batches.

    Args:
        channel: Whose frames are taken; `None` where the log has no channels.

    Attributes:
        channel: As above.
        taken: Frames of this channel so far.
        of_other_channels: Frames left out so far because of their channel.
        of_other_kinds: Frames left out because no arm sends such: error frames, extended ones.
        other_channels: The channels left out, in the order of their first frames.
    """

    def __init__(self, channel: Channel) -> None:
        self.channel = channel
        self.taken = self.of_other_channels = self.of_other_kinds = 0
        self.other_channels: dict[Channel, None] = {}

    def pieces(self, batches: Iterable[FrameBatch]) -> Iterator[ArmFrames]:
        """The frames, in the order of the log."""
        waiting: list[ArmFrames] = []
        for batch in batches:
            waiting.append(self._of_the_arm(batch))
            if sum(map(len, waiting)) >= _ENOUGH:
                yield joined(waiting)
                waiting.clear()
        if waiting:
            yield joined(waiting)

    def _of_the_arm(self, batch: FrameBatch) -> ArmFrames:
        here = np.array([name == self.channel for name in batch.channel_names], np.bool_)
        mine = here[batch.channels]
        if not mine.all():
            self.of_other_channels += int(np.count_nonzero(~mine))
            for place in np.unique(batch.channels[~mine]).tolist():
                self.other_channels[batch.channel_names[place]] = None
        plain = (batch.flags & NOT_OF_THE_ARM) == 0
        self.taken += int(np.count_nonzero(mine))
        self.of_other_kinds += int(np.count_nonzero(mine & ~plain))
        rows = np.flatnonzero(mine & plain)
        return ArmFrames(
            batch.first + rows.astype(np.int64),
            batch.times_s[rows],
            batch.ids[rows],
            batch.lengths[rows],
            payload_words(batch.payloads[rows]),
        )
