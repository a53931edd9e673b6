"""Finds faults, stops and commands in the frames of a log: the marks on its time line: pure."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from armui.protocol.addressing import OFFSETS, Addressing
from armui.protocol.codec import Codec
from armui.protocol.codes import AT_WORK, ArmStatusCode, MotorAction, StopCommand
from armui.protocol.frame import FrameFlag
from armui.protocol.signal_columns import payload_words, signal_column
from armui.session.gripper_jumps import GRIPPER, GripperJumps
from armui.session.session import DataRows, MarkKind, SessionMark

if TYPE_CHECKING:
    from collections.abc import Callable, Collection, Iterator, Mapping

    from numpy.typing import NDArray

    from armui.protocol.generation import Generation
    from armui.protocol.layout import MessageLayout
    from armui.session.frames import Channel, FrameBatch
    from armui.session.session import Session

MOST_MARKS: Final = 5_000
"""The most marks of one kind; a log with more is noise, and further ones are left out."""
SILENT_S: Final = 0.5
"""An arm not heard for longer counts as silent, as in the running program."""
_BURST_S: Final = 0.5
"""Commands of one kind that follow each other faster are one stream, marked at its beginning."""

_JOINT_FAULTS: Final = (
    "Undervoltage",
    "MotorOvertemperature",
    "Overcurrent",
    "DriverOvertemperature",
    "SensorFault",
    "CollisionProtection",
    "DriverFault",
    "StallProtection",
)
"""The bits of 0x261–0x266 that name a fault in one of the generations."""
_DRIVERS: Final = tuple(f"DriverSlow{joint}" for joint in range(1, 7))
_FAST: Final = tuple(f"DriverFast{joint}" for joint in range(1, 7))
_TARGETS: Final = ("JointTarget12", "CartesianTarget1", "MitControl1", "GripperCommand")

_IDS: Final = 0x800


@dataclass(frozen=True, slots=True)
class LogFrames:
    """The frames in which marks are searched.

    Attributes:
        channels: The channels of the log.
        rows: Returns times and payloads, shape (rows, 8), of the data frames of one identifier on
            one channel; ``None`` if there are none.
        timed: False if the times are made up, so that no speed can be told from them.
    """

    channels: tuple[Channel, ...]
    rows: Callable[[Channel, int], tuple[NDArray[np.float64], NDArray[np.uint8]] | None]
    timed: bool = True


def marks_of(frames: LogFrames, generation: Generation) -> list[SessionMark]:
    """Return faults with their ends, stops, and beginnings of commands, in the order of time.

    An entry has "code" and "channel", and as needed "status", "joint", "what" and "message";
    lasting ones have "ended_s" in log time, ``None`` if they go on to the end.
    """
    marks: list[SessionMark] = []
    for channel in frames.channels:
        for offset in OFFSETS:
            codec = Codec(generation, Addressing(offset, offset))
            finder = _Finder(frames, codec, channel)
            marks += finder.of_status()
            marks += finder.of_stops()
            marks += finder.of_targets()
            marks += finder.of_gripper() if frames.timed else ()
        finder = _Finder(frames, Codec(generation), channel)
        marks += finder.of_joints()
        marks += finder.of_motors()
        marks += finder.of_silence()
    return sorted(marks, key=lambda mark: mark.at_s)


def marked_ids(generation: Generation) -> tuple[frozenset[int], frozenset[int]]:
    """Return the identifiers needed for marks: those read completely, and those only as heard."""
    names = {"ArmStatus", "MotionCommand", "MotorEnable", GRIPPER, *_TARGETS, *_DRIVERS}
    every, heard = set(), set()
    for offset in OFFSETS:
        layouts = Codec(generation, Addressing(offset, offset)).layouts.items()
        every |= {wire_id for wire_id, layout in layouts if layout.name in names}
        heard |= {wire_id for wire_id, layout in layouts if layout.name in _FAST}
        heard |= {0x2A1 + offset, 0x2A5 + offset}
    return frozenset(every), frozenset(heard)


class _Finder:
    """Looks for marks on one channel, under one offset of the identifiers."""

    def __init__(self, frames: LogFrames, codec: Codec, channel: Channel) -> None:
        self._frames = frames
        self._channel = channel
        self._where: dict[str, object] = {"channel": channel}
        self._ids = {layout.name: (wire_id, layout) for wire_id, layout in codec.layouts.items()}

    def words(
        self, message: str
    ) -> tuple[NDArray[np.float64], NDArray[np.uint64], MessageLayout] | None:
        """Return times and payloads of a message, or ``None`` if there are none."""
        if message not in self._ids:
            return None
        wire_id, layout = self._ids[message]
        found = self._frames.rows(self._channel, wire_id)
        if found is None:
            return None
        return found[0], payload_words(found[1]), layout

    def of_status(self) -> Iterator[SessionMark]:
        found = self.words("ArmStatus")
        if found is None:
            return
        times_s, words, layout = found
        codes = signal_column(words, layout.signals["Status"])
        for first, behind, code in _runs(codes):
            if code in AT_WORK:
                continue
            stopped = code == ArmStatusCode.EMERGENCY_STOP
            kind = MarkKind.STOP if stopped else MarkKind.FAULT
            yield self._mark(
                times_s, first, behind, kind, code="stopped" if stopped else "status", status=code
            )
        for name, signal in layout.signals.items():
            for suffix, what in (
                ("LimitExceeded", "beyond_limit"),
                ("CommunicationFault", "no_communication"),
            ):
                if name.endswith(suffix):
                    yield from self._flagged(
                        times_s, signal_column(words, signal), code=what, joint=int(name[1])
                    )

    def of_joints(self) -> Iterator[SessionMark]:
        for joint in range(1, 7):
            found = self.words(f"DriverSlow{joint}")
            if found is None:
                continue
            times_s, words, layout = found
            for name in _JOINT_FAULTS:
                if name in layout.signals:
                    values = signal_column(words, layout.signals[name])
                    yield from self._flagged(times_s, values, code="joint", joint=joint, what=name)

    def of_stops(self) -> Iterator[SessionMark]:
        found = self.words("MotionCommand")
        if found is None:
            return
        times_s, words, layout = found
        stops = signal_column(words, layout.signals["EmergencyStop"])
        stop, command = MarkKind.STOP, MarkKind.COMMAND
        yield from self._sent(times_s, stops == StopCommand.EMERGENCY_STOP, stop, code="stop_sent")
        yield from self._sent(times_s, stops == StopCommand.RESUME, stop, code="resume_sent")
        others = (stops == StopCommand.NO_ACTION) & (words != 0)
        yield from self._sent(times_s, others, command, code="motion_command")

    def of_targets(self) -> Iterator[SessionMark]:
        for message in _TARGETS:
            found = self.words(message)
            if found is not None:
                every = np.ones(found[0].size, np.bool_)
                command = MarkKind.COMMAND
                yield from self._sent(found[0], every, command, code="target", message=message)

    def of_motors(self) -> Iterator[SessionMark]:
        found = self.words("MotorEnable")
        if found is None:
            return
        times_s, words, layout = found
        actions = signal_column(words, layout.signals["Action"])
        command = MarkKind.COMMAND
        yield from self._sent(times_s, actions == MotorAction.ENABLE, command, code="enable_sent")
        yield from self._sent(times_s, actions == MotorAction.DISABLE, command, code="disable_sent")

    def of_gripper(self) -> Iterator[SessionMark]:
        """Yield the jumps of the gripper's reading."""
        wire_id, layout = self._ids[GRIPPER]
        found = self._frames.rows(self._channel, wire_id)
        if found is not None:
            for place, jump in GripperJumps().found(layout, *found)[:MOST_MARKS]:
                told = {"code": "gripper_jump", **jump._asdict()}
                yield self._mark(found[0], place, None, MarkKind.NOTE, **told)

    def of_silence(self) -> Iterator[SessionMark]:
        """Yield the stretches in which nothing of the arm is heard, under any offset."""
        ids = [self._ids[name][0] for name in _FAST]
        ids += [0x2A1 + offset for offset in OFFSETS]
        ids += [0x2A5 + offset for offset in OFFSETS]
        rows = [found[0] for each in ids if (found := self._frames.rows(self._channel, each))]
        if not rows:
            return
        times_s = np.sort(np.concatenate(rows))
        for place in np.flatnonzero(np.diff(times_s) > SILENT_S)[:MOST_MARKS].tolist():
            entry = {"code": "silent", "ended_s": float(times_s[place + 1])}
            yield SessionMark(float(times_s[place]), MarkKind.FAULT, entry | self._where)

    def _sent(
        self,
        times_s: NDArray[np.float64],
        which: NDArray[np.bool_],
        kind: MarkKind,
        **entry: object,
    ) -> Iterator[SessionMark]:
        """Return where streams of commands begin."""
        for place in _bursts(times_s, np.flatnonzero(which)):
            yield self._mark(times_s, place, None, kind, **entry)

    def _flagged(
        self, times_s: NDArray[np.float64], flags: NDArray[Any], **entry: object
    ) -> Iterator[SessionMark]:
        for first, behind, value in _runs(flags):
            if value:
                yield self._mark(times_s, first, behind, MarkKind.FAULT, **entry)

    def _mark(
        self,
        times_s: NDArray[np.float64],
        first: int,
        behind: int | None,
        kind: MarkKind,
        **entry: object,
    ) -> SessionMark:
        if behind is not None:
            entry["ended_s"] = float(times_s[behind]) if behind < times_s.size else None
        return SessionMark(float(times_s[first]), kind, entry | self._where)


def _runs(values: NDArray[Any]) -> Iterator[tuple[int, int, int]]:
    """Yield begin, end and value of each stretch of equal values; the end is behind the last."""
    edges = np.flatnonzero(np.diff(values)) + 1
    edges = edges[: 2 * MOST_MARKS]
    starts = [0, *edges.tolist()]
    ends = [*edges.tolist(), values.size]
    for first, behind in zip(starts, ends, strict=True):
        if behind > first:
            yield first, behind, int(values[first])


def _bursts(times_s: NDArray[np.float64], places: NDArray[np.int64]) -> list[int]:
    """Return where streams of commands begin."""
    if places.size == 0:
        return []
    began = np.diff(times_s[places], prepend=-np.inf) > _BURST_S
    begins: list[int] = places[began][:MOST_MARKS].tolist()
    return begins


# Keeps the frames of some identifiers, collected in one pass through the session.


_NOT_DATA: Final = FrameFlag.EXTENDED | FrameFlag.REMOTE | FrameFlag.ERROR | FrameFlag.IMPOSSIBLE
_HARDLY_S: Final = 0.05
"""Where only silences are searched, frames are thinned to this time."""


class IdRows:
    """Keeps the frames of some identifiers in memory: 30 bytes a frame.

    Args:
        session: The session, which is read once.
        channel: The channel to read.
        ids: The identifiers of which every data frame is kept.
        heard: The identifiers of which enough is kept to find silences: the first and last frame of
            each twentieth of a second.
        is_wanted: Called now and then; if it returns false, the rest is left out.
    """

    def __init__(
        self,
        session: Session,
        channel: Channel,
        ids: Collection[int],
        heard: Collection[int],
        is_wanted: Callable[[], bool] = lambda: True,
    ) -> None:
        self._channel = channel
        self._kept = _among(ids)
        self._heard = _among(heard) & ~self._kept
        ids_found: list[NDArray[np.uint32]] = []
        pieces: list[DataRows] = []
        for batch in session.frames_between(-np.inf, np.inf):
            rows = self._rows(batch)
            if rows.size:
                ids_found.append(batch.ids[rows])
                times_s, lengths, payloads = batch.times_s, batch.lengths, batch.payloads
                pieces.append(
                    DataRows(batch.first + rows, times_s[rows], lengths[rows], payloads[rows])
                )
            if not is_wanted():
                break
        self._found: Mapping[int, DataRows] = {}
        if pieces:
            found = DataRows(*map(np.concatenate, zip(*pieces, strict=True)))
            self._found = _by_id(np.concatenate(ids_found), found)

    def data_rows(self, channel: Channel, arbitration_id: int) -> DataRows | None:
        """Return the data frames of an identifier, or ``None``, also if it was not requested."""
        return self._found.get(arbitration_id) if channel == self._channel else None

    def times_and_payloads(
        self, channel: Channel, arbitration_id: int
    ) -> tuple[NDArray[np.float64], NDArray[np.uint8]] | None:
        """Return times and payloads as `armui.session.log_marks.LogFrames` needs them."""
        found = self.data_rows(channel, arbitration_id)
        return None if found is None else (found.times_s, found.payloads)

    def _rows(self, batch: FrameBatch) -> NDArray[np.int64]:
        names = batch.channel_names
        if self._channel not in names:
            return np.empty(0, np.int64)
        data = (batch.flags & _NOT_DATA) == 0
        if len(names) > 1:
            data &= batch.channels == names.index(self._channel)
        rows = np.flatnonzero(data & (batch.ids < _IDS))
        ids = batch.ids[rows]
        kept = self._kept[ids]
        heard = np.flatnonzero(self._heard[ids])
        if heard.size:
            parts = np.floor(batch.times_s[rows[heard]] / _HARDLY_S)
            edges = np.flatnonzero(np.diff(parts))
            kept[heard[np.concatenate([[0], edges, edges + 1, [heard.size - 1]])]] = True
        return rows[kept]


def _among(ids: Collection[int]) -> NDArray[np.bool_]:
    table = np.zeros(_IDS, np.bool_)
    table[list(ids)] = True
    return table


def _by_id(ids: NDArray[np.uint32], rows: DataRows) -> dict[int, DataRows]:
    order = np.argsort(ids, kind="stable")
    ids, rows = ids[order], rows.of(order)
    edges = np.flatnonzero(np.diff(ids)) + 1
    begins, ends = [0, *edges.tolist()], [*edges.tolist(), ids.size]
    return {
        int(ids[begin]): rows.of(slice(begin, end)) for begin, end in zip(begins, ends, strict=True)
    }
