"""Reads one channel of a log forwards, frame by frame or slice by slice."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final, NamedTuple

import numpy as np

from armui.protocol.frame import Frame
from armui.telemetry.series_columns import FrameColumns, joined

if TYPE_CHECKING:
    from collections.abc import Iterator

    from armui.session.frames import Channel, FrameBatch
    from armui.session.session import Session

_NONE: Final = FrameColumns(
    np.empty(0), np.empty(0, np.uint32), np.empty(0, np.uint8), np.empty(0, np.uint8),
    np.empty((0, 8), np.uint8),
)  # fmt: skip


class LogClock:
    """The clock of a controller that watches a log: it shows log time.

    Args:
        at_s: Log time to begin with, in seconds.
    """

    def __init__(self, at_s: float = 0.0) -> None:
        self._at_s = at_s

    def __call__(self) -> float:
        """Return the log time in seconds; may be called from any thread."""
        return self._at_s

    def set(self, at_s: float) -> None:
        """Set the clock to the place that the replay has reached."""
        self._at_s = at_s


class ReplayedFrame(NamedTuple):
    """A frame of a log.

    Attributes:
        frame: Identifier and payload.
        at_s: Log time.
        flags: `FrameFlag` bits.
        number: Within the whole log, from 0; -1 where it is not known.
    """

    frame: Frame
    at_s: float
    flags: int
    number: int = -1


class LogCursor:
    """The place of a replay in its log; used by one thread.

    Args:
        session: The log.
        channel: Only the frames of this channel are read.
    """

    def __init__(self, session: Session, channel: Channel) -> None:
        self._session = session
        self._channel = channel
        self._batches: Iterator[FrameBatch] = iter(())
        self._batch: FrameBatch | None = None
        self._rows = np.empty(0, np.int64)
        self._place = 0

    def go_behind(self, at_s: float) -> None:
        """Go to the first frame after a time."""
        self._batches = self._session.frames_between(math.nextafter(at_s, math.inf), math.inf)
        self._batch = None
        self._rows, self._place = np.empty(0, np.int64), 0

    def snapshot(self, at_s: float) -> list[ReplayedFrame]:
        """Return the latest frame of each kind at or before a time, in order."""
        batch = self._session.snapshot_at(at_s)
        return [_timed(batch, row)._replace(number=-1) for row in self._own_rows(batch).tolist()]

    def next_frame(self) -> ReplayedFrame | None:
        """Return the next frame, or ``None`` at the end."""
        if not self._fill() or self._batch is None:
            return None
        row = int(self._rows[self._place])
        self._place += 1
        return _timed(self._batch, row)

    def frames_until(self, end_s: float, most: int) -> list[ReplayedFrame]:
        """Return the next frames up to and including a time, and no more than `most`."""
        found: list[ReplayedFrame] = []
        while len(found) < most and self._fill() and self._batch is not None:
            rows = self._rows_until(end_s, most - len(found))
            if not rows.size:
                break
            found += [_timed(self._batch, row) for row in rows.tolist()]
        return found

    def columns_until(self, end_s: float) -> FrameColumns:
        """Return the next frames up to and including a time, as columns."""
        pieces = []
        while self._fill() and self._batch is not None:
            batch, rows = self._batch, self._rows_until(end_s, self._rows.size)
            if not rows.size:
                break
            pieces.append(_columns(batch, rows))
        return joined(pieces) if pieces else _NONE

    def columns_between(self, begin_s: float, end_s: float) -> Iterator[FrameColumns]:
        """Return the frames between two times, the end included; the cursor does not move."""
        until_s = math.nextafter(end_s, math.inf)
        for batch in self._session.frames_between(begin_s, until_s):
            rows = self._own_rows(batch)
            if rows.size:
                yield _columns(batch, rows)

    def _fill(self) -> bool:
        """Return whether there is a next frame."""
        while self._place >= self._rows.size:
            self._batch = next(self._batches, None)
            if self._batch is None:
                return False
            self._rows, self._place = self._own_rows(self._batch), 0
        return True

    def _rows_until(self, end_s: float, most: int) -> np.ndarray:
        assert self._batch is not None  # noqa: S101 - ensured by _fill
        left = self._rows[self._place : self._place + most]
        count = int(np.searchsorted(self._batch.times_s[left], end_s, side="right"))
        self._place += count
        return left[:count]

    def _own_rows(self, batch: FrameBatch) -> np.ndarray:
        names = batch.channel_names
        if len(names) == 1 and names[0] == self._channel:
            return np.arange(len(batch))
        if self._channel not in names:
            return np.empty(0, np.int64)
        return np.flatnonzero(batch.channels == names.index(self._channel))


def _timed(batch: FrameBatch, row: int) -> ReplayedFrame:
    frame = Frame(int(batch.ids[row]), batch.data(row))
    return ReplayedFrame(frame, float(batch.times_s[row]), int(batch.flags[row]), batch.first + row)


def _columns(batch: FrameBatch, rows: np.ndarray) -> FrameColumns:
    return FrameColumns(
        batch.times_s[rows],
        batch.ids[rows],
        batch.flags[rows],
        batch.lengths[rows],
        batch.payloads[rows],
    )
