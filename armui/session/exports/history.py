"""The last frame of each message at any frame of a log, for many frames at once.

It holds the same as a tracker keeps frame by frame, but as columns: for each message the frames of
the present piece, preceded by the last one from before.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final, Protocol

import numpy as np

from armui.arm.state import FRESH_FOR_S
from armui.protocol.codes import MotorAction
from armui.protocol.firmware_version import VERSION_ID
from armui.protocol.signal_columns import payload_words, signal_column
from armui.session.frames import NOT_OF_THE_ARM
from armui.telemetry.series_columns import joined
from armui.telemetry.store import ENDS

if TYPE_CHECKING:
    from collections.abc import Collection, Iterable, Iterator, Mapping

    from numpy.typing import NDArray

    from armui.kinematics.geometry import Geometry
    from armui.protocol.codec import Codec
    from armui.protocol.layout import MessageLayout
    from armui.session.frames import Channel, FrameBatch

# The frames of one arm, in pieces of a size that is worth working on at once.

_ENOUGH: Final = 32_768
"""The least frames of a piece, at which the cost of a piece no longer matters."""


@dataclass(frozen=True, slots=True)
class ArmFrames:
    """Consecutive frames of one channel that an arm or its host may have sent.

    Attributes:
        rows: The number of each within the log, int64.
        times_s: The times as recorded, float64.
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
    """Return a piece without frames."""
    return ArmFrames(
        np.empty(0, np.int64),
        np.empty(0, np.float64),
        np.empty(0, np.uint32),
        np.empty(0, np.uint8),
        np.empty(0, np.uint64),
    )


class ArmFrameReader:
    """Makes pieces of a log's batches.

    Args:
        channel: The channel that is read; `None` if the log has no channels.

    Attributes:
        channel: As above.
        taken: The number of frames of this channel so far.
        of_other_channels: The number of frames of other channels, left out.
        of_other_kinds: The number of frames that no arm sends (error frames, extended ones), left
            out.
        other_channels: The channels left out, in the order of their first frames.
    """

    def __init__(self, channel: Channel) -> None:
        self.channel = channel
        self.taken = self.of_other_channels = self.of_other_kinds = 0
        self.other_channels: dict[Channel, None] = {}

    def pieces(self, batches: Iterable[FrameBatch]) -> Iterator[ArmFrames]:
        """Yield the frames, in the order of the log."""
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


@dataclass(frozen=True, slots=True)
class Samples:
    """Frames of one message, in the order of the log.

    Attributes:
        layout: The message's layout.
        rows: The number of each within the log.
        times_s: Their times as recorded.
        words: Their data, see `payload_words`.
        old: The number of them, 0 or 1, from an earlier piece.
    """

    layout: MessageLayout
    rows: NDArray[np.int64]
    times_s: NDArray[np.float64]
    words: NDArray[np.uint64]
    old: int

    def column(self, signal: str) -> NDArray[Any]:
        """Return the physical values of a signal."""
        return signal_column(self.words, self.layout.signals[signal])

    def bits(self, names: tuple[str, ...]) -> NDArray[np.int64]:
        """Return signals of one bit as one number, the first worth 1; missing ones count as 0."""
        sums = np.zeros(len(self.words), np.int64)
        for place, name in enumerate(names):
            if name in self.layout.signals:
                sums |= (self.column(name) == 1).astype(np.int64) << place
        return sums

    @property
    def new_rows(self) -> NDArray[np.int64]:
        """The numbers of the frames of this piece."""
        return self.rows[self.old :]

    def last_at(self, rows: NDArray[np.int64]) -> NDArray[np.intp]:
        """Return the index of the last sample at each frame of the log; -1 if there was none."""
        return np.searchsorted(self.rows, rows, side="right") - 1

    def fresh_at(
        self, rows: NDArray[np.int64], times_s: NDArray[np.float64]
    ) -> tuple[NDArray[np.intp], NDArray[np.bool_]]:
        """Return the result of `last_at`, and whether each sample was recent enough to count.

        Args:
            rows: Frames of the log.
            times_s: Their times.
        """
        last = self.last_at(rows)
        fresh = (last >= 0) & (np.abs(times_s - self.times_s[last]) <= FRESH_FOR_S)
        return last, fresh


_NEVER: Final = -1


class History:
    """Processes the pieces of a log in turn.

    Args:
        codec: A codec of the recorded arm's generation, with its identifier offsets.

    Attributes:
        codec: As above.
        frames: The newest piece.
        not_understood: The number of frames that are in no table, or of another length.
        questions: The number of frames by which a host asked an arm of generation 1 for its
            firmware, a message it lacks.
    """

    def __init__(self, codec: Codec) -> None:
        self.codec = codec
        self.frames = no_frames()
        self.not_understood = 0
        self.questions = 0
        self._samples: dict[str, Samples] = {}
        self._stops = np.empty(0, np.int64)

    def add_frames(self, frames: ArmFrames) -> None:
        """Process the next piece."""
        self.frames = frames
        for name, samples in self._samples.items():
            self._samples[name] = _last_of(samples)
        order = np.argsort(frames.ids, kind="stable")
        ends = np.flatnonzero(np.diff(frames.ids[order])) + 1
        for places in np.split(order, ends) if len(order) else ():
            layout = self.codec.layout(int(frames.ids[places[0]]))
            if layout is None and frames.ids[places[0]] == VERSION_ID:
                self.questions += len(places)
                continue
            if layout is None:
                self.not_understood += len(places)
                continue
            sound = np.isin(frames.lengths[places], np.array(layout.lengths, np.uint8))
            self.not_understood += len(places) - int(np.count_nonzero(sound))
            self._add(layout, frames, places[sound])
        self._stops = np.concatenate((self._stops[-1:], self._new_stops()))

    def _add(self, layout: MessageLayout, frames: ArmFrames, places: NDArray[np.intp]) -> None:
        before = self._samples.get(layout.name)
        rows, times_s, words = frames.rows[places], frames.times_s[places], frames.words[places]
        if before is not None:
            rows = np.concatenate((before.rows, rows))
            times_s = np.concatenate((before.times_s, times_s))
            words = np.concatenate((before.words, words))
        if len(rows):
            old = 0 if before is None else 1
            self._samples[layout.name] = Samples(layout, rows, times_s, words, old)

    def _new_stops(self) -> NDArray[np.int64]:
        """Return the rows that end every target: a stop, an abort or disabled motors."""
        stops = []
        commands = self._samples.get("MotionCommand")
        if commands is not None:
            ended = np.zeros(len(commands.rows), np.bool_)
            for signal, codes in ENDS.items():
                ended |= np.isin(commands.column(signal), [int(code) for code in codes])
            stops.append(commands.rows[commands.old :][ended[commands.old :]])
        motors = self._samples.get("MotorEnable")
        if motors is not None:
            disabled = motors.column("Action") == MotorAction.DISABLE
            stops.append(motors.rows[motors.old :][disabled[motors.old :]])
        return np.sort(np.concatenate(stops)) if stops else np.empty(0, np.int64)

    def samples(self, message: str) -> Samples | None:
        """Return the frames of a message, or ``None`` if none was heard yet."""
        return self._samples.get(message)

    def all_samples(self) -> Collection[Samples]:
        """Return the samples of every message heard so far."""
        return self._samples.values()

    def ended_at(
        self, rows: NDArray[np.int64], by: tuple[str, ...], *, by_stops: bool
    ) -> NDArray[np.int64]:
        """Return for each frame the last one that ended a command before it; -1 if none did.

        Args:
            rows: Frames of the log.
            by: The messages that end it.
            by_stops: True if a stop, an abort and disabled motors end it as well.
        """
        others = [self._samples[name].rows for name in by if name in self._samples]
        ends = np.concatenate([[_NEVER], *others, *([self._stops] if by_stops else [])])
        ends.sort()
        last: NDArray[np.int64] = ends[np.searchsorted(ends, rows, side="right") - 1]
        return last


def _last_of(samples: Samples) -> Samples:
    return Samples(samples.layout, samples.rows[-1:], samples.times_s[-1:], samples.words[-1:], 1)


@dataclass(frozen=True, slots=True)
class ExportFacts:
    """The facts on the recorded arm that a format may need.

    Attributes:
        codec: A codec of its generation.
        geometry: The arm's geometry.
        gripper_turned_deg: The gripper's turn about the flange's Z axis.
        start_s: The time of the log's first frame.
        notes: Texts on source, generation and firmware for the file's metadata.
    """

    codec: Codec
    geometry: Geometry
    gripper_turned_deg: float
    start_s: float
    notes: Mapping[str, str]


class TimeSpan:
    """A stretch of a log.

    Args:
        begin_s: The beginning, as recorded; minus infinity for everything.
        end_s: The end, included; infinity for everything.
    """

    def __init__(self, begin_s: float, end_s: float) -> None:
        self.begin_s = begin_s
        self.end_s = end_s

    def holds(self, times_s: NDArray[np.float64]) -> NDArray[np.bool_]:
        """Return which of some times lie in it."""
        inside: NDArray[np.bool_] = (times_s >= self.begin_s) & (times_s <= self.end_s)
        return inside


class Sink(Protocol):
    """A file of one format, being written.

    Attributes:
        items: Rows or messages written so far.
    """

    items: int

    def write_span(self, history: History, span: TimeSpan) -> None:
        """Write what a piece of the log adds.

        Args:
            history: The history, which has just processed the piece.
            span: Only frames within it are written.

        Raises:
            OSError: The disk does not take it.
        """

    def finish(self) -> None:
        """Write the end part of the file.

        Raises:
            OSError: The disk does not take it.
        """

    def abandon(self) -> None:
        """Release the file, which is no longer wanted; never fails."""
