"""What was last heard of each message at any frame of a log, many frames at once.

The same that a tracker keeps frame by frame, as columns: of each message the frames of the piece
under way, and in front of them the last one of before.
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
    """Return a piece without any."""
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
        """Return the frames, in the order of the log."""
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


_NEVER: Final = -1


@dataclass(frozen=True, slots=True)
class Samples:
    """Frames of one message, in the order of the log.

    Attributes:
        layout: What they hold.
        rows: The number of each within the log.
        times_s: As recorded.
        words: Their data, see `payload_words`.
        old: How many of them, 0 or 1, are of an earlier piece.
    """

    layout: MessageLayout
    rows: NDArray[np.int64]
    times_s: NDArray[np.float64]
    words: NDArray[np.uint64]
    old: int

    def column(self, signal: str) -> NDArray[Any]:
        """Physical values of a signal."""
        return signal_column(self.words, self.layout.signals[signal])

    def bits(self, names: tuple[str, ...]) -> NDArray[np.int64]:
        """Signals of one bit as one number, the first worth 1; what there is not counts as 0."""
        sums = np.zeros(len(self.words), np.int64)
        for place, name in enumerate(names):
            if name in self.layout.signals:
                sums |= (self.column(name) == 1).astype(np.int64) << place
        return sums

    @property
    def new_rows(self) -> NDArray[np.int64]:
        """The frames of this piece."""
        return self.rows[self.old :]

    def last_at(self, rows: NDArray[np.int64]) -> NDArray[np.intp]:
        """Which of the samples was the last one at frames of the log; -1 where there was none."""
        return np.searchsorted(self.rows, rows, side="right") - 1

    def fresh_at(
        self, rows: NDArray[np.int64], times_s: NDArray[np.float64]
    ) -> tuple[NDArray[np.intp], NDArray[np.bool_]]:
        """As `last_at`, and whether that sample was young enough to stand for the present.

        Args:
            rows: Frames of the log.
            times_s: Their times.
        """
        last = self.last_at(rows)
        fresh = (last >= 0) & (np.abs(times_s - self.times_s[last]) <= FRESH_FOR_S)
        return last, fresh


class History:
    """Takes the pieces of a log in turn.

    Args:
        codec: Speaks the generation of the recorded arm, with its identifier offsets.

    Attributes:
        codec: As above.
        frames: The newest piece.
        not_understood: Frames so far that are in no table, or of another length.
        questions: Those so far by which a host asked an arm of generation 1 for its firmware; it
            has no such message.
    """

    def __init__(self, codec: Codec) -> None:
        self.codec = codec
        self.frames = no_frames()
        self.not_understood = 0
        self.questions = 0
        self._samples: dict[str, Samples] = {}
        self._stops = np.empty(0, np.int64)

    def add_frames(self, frames: ArmFrames) -> None:
        """Go on to the next piece."""
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
        """Return where every target is ended: by a stop, an abort or disabled motors."""
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
        """Return the frames of a message; ``None`` while none was heard."""
        return self._samples.get(message)

    def heard(self) -> Collection[Samples]:
        """Return the frames of every message that was heard so far."""
        return self._samples.values()

    def ended_at(
        self, rows: NDArray[np.int64], by: tuple[str, ...], *, by_stops: bool
    ) -> NDArray[np.int64]:
        """Return the last frame, as of some, that ended a command; -1 where none did.

        Args:
            rows: Frames of the log.
            by: The messages that end it.
            by_stops: Whether a stop, an abort and disabled motors end it, too.
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
    """What a format may have to know of the recorded arm, and what it tells of it.

    Attributes:
        codec: Speaks its generation.
        geometry: Of the arm.
        gripper_turned_deg: How its gripper is mounted, about the flange's Z axis.
        start_s: When the log's first frame was recorded.
        notes: In words: source, generation, firmware; for the file's metadata.
    """

    codec: Codec
    geometry: Geometry
    gripper_turned_deg: float
    start_s: float
    notes: Mapping[str, str]


class TimeSpan:
    """A stretch of a log.

    Args:
        begin_s: From there on, as recorded; minus infinity for everything.
        end_s: Up to there, itself included; infinity for everything.
    """

    def __init__(self, begin_s: float, end_s: float) -> None:
        self.begin_s = begin_s
        self.end_s = end_s

    def holds(self, times_s: NDArray[np.float64]) -> NDArray[np.bool_]:
        """Which times lie in it."""
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
            history: Has just taken the piece.
            span: Only what lies in it is written.

        Raises:
            OSError: The disk does not take it.
        """

    def finish(self) -> None:
        """Write what comes at the end of the file.

        Raises:
            OSError: The disk does not take it.
        """

    def abandon(self) -> None:
        """Let go of the file, which nobody wants any more; never fails."""
