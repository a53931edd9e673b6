"""All feedback and commands of the last half hour."""

from __future__ import annotations

import math
import threading
from collections.abc import Callable, Mapping, Sequence
from datetime import datetime
from typing import TYPE_CHECKING, Final

import numpy as np

from armui.protocol.codec import Message
from armui.protocol.codes import MotorAction, StopCommand, TrajectoryCommand
from armui.protocol.frame import Frame, FrameFlag
from armui.system.clock import steady_s, wall_clock
from armui.telemetry.listener import Listener
from armui.telemetry.quantities import (
    BUS,
    QUANTITIES,
    RECORDS,
    TOOL_POSE,
    Quantity,
    Record,
    Source,
    Space,
)
from armui.telemetry.series import KEPT_S, Row, Series
from armui.telemetry.series_columns import NOT_OF_THE_ARM, ColumnWriter, row_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from armui.protocol.codec import Codec
    from armui.protocol.generation import Generation
    from armui.telemetry.listener import ReceivedFrame
    from armui.telemetry.series_columns import FrameColumns

_BUS_EVERY_S: Final = 0.1
_ROUNDING_S: Final = 1e-4
_PAUSE_S: Final = 1.0
"""After a longer pause in counting the next count starts from zero."""
_FRAME_BITS: Final = 47
"""The bits of a classic frame without its payload and stuff bits, with the gap behind it."""
DEFAULT_BITRATE: Final = 1_000_000
_SHAPES: Final = {record.name: record.shape for record in RECORDS}

ENDS: Final = {
    "EmergencyStop": frozenset({StopCommand.EMERGENCY_STOP, StopCommand.RESUME}),
    "TrajectoryCommand": frozenset(
        {
            TrajectoryCommand.CLEAR_CURRENT,
            TrajectoryCommand.CLEAR_ALL,
            TrajectoryCommand.ABORT,
        }
    ),
}
"""The values of 0x150 that end every target in force."""

_Writer = Callable[[Mapping[str, float], float], None]
_POSE_MESSAGES: Final = ("EndPose1", "EndPose2", "EndPose3")


class _ToolPoseWriter:
    """Computes the tool centre point's pose once all three messages of the flange's pose are in.

    Args:
        tool: Its pose in the flange, mm and degrees.
        series: The series to write.
    """

    def __init__(self, tool: Sequence[float], series: Series) -> None:
        from armui.kinematics import poses  # noqa: PLC0415 - loaded when a tool is set

        self._tool, self._series = tool, series
        self._poses = poses
        self._flange: dict[str, float] = {}

    def following(self, write: _Writer) -> _Writer:
        """Wrap the writer of one of the three messages so that it also writes the tool's pose."""

        def write_both(signals: Mapping[str, float], at_s: float) -> None:
            write(signals, at_s)
            flange = self._flange
            flange.update(signals)
            if len(flange) == len(TOOL_POSE.fields):
                pose = [flange[axis] for axis in ("X", "Y", "Z", "RX", "RY", "RZ")]
                self._series.write(at_s, self._poses.tool_pose(pose, self._tool))
                flange.clear()

        return write_both


class Telemetry(Listener):
    """Feedback and commands over time; fed by the bus thread, read by any thread.

    It takes about a microsecond for each frame. No reader holds up the bus thread.

    A command holds until another one of its kind, from this or another host, a stop or an abort:
    its series then gets a row of NaN.

    Args:
        clock: Monotonic time in seconds, the same as of the frames.
        keep_s: The time for which every sample is kept.

    Attributes:
        wall_time: Returns the time of day at a time of this clock; a log has its own.
        series: The series by name; see `armui.telemetry.quantities`.
    """

    def __init__(self, clock: Callable[[], float] = steady_s, keep_s: float = KEPT_S) -> None:
        self._clock = clock
        self._keep_s = keep_s
        self.wall_time: Callable[[float], datetime] = wall_clock(clock)
        self.series: Mapping[str, Series] = {
            name: Series(shape, keep_s) for name, shape in _SHAPES.items()
        }
        self._choosing = threading.Lock()
        self._codec: Codec | None = None
        self._columns: ColumnWriter | None = None
        self._generation: Generation | None = None
        self._tool: Sequence[float] = ()
        self._from_others: dict[str, _Writer] = {}
        self._own: dict[str, _Writer] = {}
        self._standing: dict[Space, tuple[object, set[Series]]] = {
            space: (None, set()) for space in Space
        }
        self._bitrate = DEFAULT_BITRATE
        self._frames = self._bits = self._errors = 0
        self._counted_s = self._newest_s = -math.inf

    def now_s(self) -> float:
        """Return the present time by the samples' clock."""
        return self._clock()

    @property
    def bytes_kept(self) -> int:
        """The memory that the samples use now, in bytes."""
        return sum(each.bytes_kept for each in self.series.values())

    @property
    def most_bytes(self) -> int:
        """The most memory they use, in bytes, whatever is heard."""
        return sum(each.most_bytes for each in self.series.values())

    def release(self) -> None:
        """Free the memory of all samples, when nothing is heard or sent any more."""
        for each in self.series.values():
            each.release()
        self._counted_s = -math.inf
        self._standing = {space: (None, set()) for space in Space}

    def alike(
        self, clock: Callable[[], float] | None = None, keep_s: float | None = None
    ) -> Telemetry:
        """Return a store without samples that processes frames as this one does.

        Args:
            clock: Its clock, in seconds; by default this one's.
            keep_s: The time for which it keeps samples; by default this one's.
        """
        other = Telemetry(clock or self._clock, self._keep_s if keep_s is None else keep_s)
        other.wall_time = self.wall_time
        with self._choosing:
            other._generation = self._generation
            codec, other._bitrate = self._codec, self._bitrate
        if codec is not None:
            other.on_codec(codec)
        return other

    def adopt(self, other: Telemetry) -> None:
        """Take over the samples of a store made by `alike`; for the writing thread only."""
        for name, series in self.series.items():
            series.adopt(other.series[name])

    def find(self, key: str) -> tuple[Quantity, Series]:
        """Return a quantity and its series.

        Raises:
            KeyError: No quantity has this key.
        """
        quantity = QUANTITIES[key]
        return quantity, self.series[quantity.series]

    def latest(self, key: str) -> tuple[float, float] | None:
        """Return the time and the value of a quantity's last sample; ``None`` if there is none."""
        quantity, series = self.find(key)
        return series.latest(quantity.field)

    # The arm's generation and tool; any thread ------------------------------------------------

    def know_generation(self, generation: Generation | None) -> None:
        """Set the arm's protocol; with ``None`` only values common to both generations are kept."""
        if generation is not self._generation:
            with self._choosing:
                self._generation = generation
                self._choose()

    def set_tool(self, tool: Sequence[float]) -> None:
        """Keep the pose of a tool centre point beside the flange's from now on.

        Args:
            tool: Its pose in the flange, mm and degrees; with zeros it equals the flange, and is
                not kept.
        """
        wanted = tuple(tool) if any(tool) else ()
        if wanted != self._tool:
            with self._choosing:
                self._tool = wanted
                self._choose()

    # The bus thread ---------------------------------------------------------------------------

    def on_open(self, bitrate: int | None) -> None:
        """Note that a device was opened: earlier commands no longer hold."""
        self._bitrate = bitrate or DEFAULT_BITRATE
        self._end_standing(self._clock())

    def on_codec(self, codec: Codec) -> None:
        """Set the codec that decodes the frames from now on."""
        with self._choosing:
            self._codec = codec
            self._choose()

    def on_heard(self, batch: Sequence[ReceivedFrame]) -> None:
        """Add frames that others sent, in order."""
        self._frames += len(batch)
        self._newest_s = batch[-1][1]
        find, data_bytes = self._from_others.get, 0
        for heard, at_s, (_id, data), _flags in batch:
            data_bytes += len(data)
            message = heard if isinstance(heard, Message) else heard.message
            if message is not None:
                writer = find(message.name)
                if writer is not None:
                    writer(message.signals, at_s)
        self._bits += _FRAME_BITS * len(batch) + 8 * data_bytes

    def on_columns(self, frames: FrameColumns, *, own: NDArray[np.bool_]) -> None:
        """Add many frames of a log in order: the same as `on_heard`, `on_sent` and `on_look`.

        Args:
            frames: The frames of the log.
            own: True for commands that the recording program sent itself.
        """
        with self._choosing:
            codec = self._codec
            if codec is None or not len(frames):
                return
            if self._columns is None:
                proven = codec.generation is self._generation
                self._columns = ColumnWriter(self.series, codec, proven=proven)
            writer = self._columns
        ordinary = (frames.flags & NOT_OF_THE_ARM) == 0
        writer.add_frames(frames.of(ordinary & ~own))
        known = writer.is_feedback[np.minimum(frames.ids, writer.is_feedback.size - 1)]
        for row in np.flatnonzero(ordinary & (own | ~known)).tolist():
            data = frames.payloads[row, : frames.lengths[row]].tobytes()
            said = codec.decode(Frame(int(frames.ids[row]), data))
            message = said if isinstance(said, Message) else said.message
            find = self._own if own[row] else self._from_others
            write = None if message is None else find.get(message.name)
            if write is not None and message is not None:
                write(message.signals, float(frames.times_s[row]))
        self._count_columns(frames)

    def _count_columns(self, frames: FrameColumns) -> None:
        """Add up the frames, bits and errors of each tenth of a second, for the load of the bus."""
        errors = np.cumsum((frames.flags & FrameFlag.ERROR) != 0)
        bits = np.cumsum(_FRAME_BITS + 8 * frames.lengths.astype(np.int64))
        tenths = np.floor(frames.times_s / _BUS_EVERY_S).astype(np.int64)
        last = np.flatnonzero(np.diff(tenths, append=tenths[-1] + 1))
        begin = bits_before = errors_before = 0
        for row in last.tolist():
            self._frames += row + 1 - begin
            self._bits += int(bits[row]) - bits_before
            self._errors += int(errors[row]) - errors_before
            begin, bits_before, errors_before = row + 1, int(bits[row]), int(errors[row])
            if row != last[-1]:
                self.on_look(float(tenths[row] + 1) * _BUS_EVERY_S)

    def on_error_frame(self) -> None:
        """Count an error on the bus that the adapter has reported."""
        self._errors += 1

    def on_sent(self, batch: Sequence[ReceivedFrame]) -> None:
        """Add frames that this program has sent, in order."""
        self._frames += len(batch)
        for said, at_s, frame, _flags in batch:
            self._bits += _FRAME_BITS + 8 * len(frame.data)
            writer = self._own.get(said.name) if isinstance(said, Message) else None
            if writer is not None and isinstance(said, Message):
                writer(said.signals, at_s)

    def on_look(self, now_s: float) -> None:
        """Update the rates; called every few milliseconds while a device is open."""
        newest_s, self._newest_s = self._newest_s, now_s
        # After a delay more frames of the same time may follow: count up to the newest frame only.
        now_s = newest_s if newest_s > self._counted_s else now_s
        passed_s = now_s - self._counted_s
        if passed_s < _BUS_EVERY_S - _ROUNDING_S:
            return
        if passed_s < _PAUSE_S:
            load_percent = 100.0 * self._bits / (passed_s * self._bitrate)
            row = (self._frames / passed_s, load_percent, self._errors / passed_s)
            self.series[BUS.name].write(now_s, row)
        self._counted_s = now_s
        self._frames = self._bits = self._errors = 0

    # The choice of writers --------------------------------------------------------------------

    def _choose(self) -> None:
        """Choose the writer of each message, by codec and generation."""
        codec = self._codec
        self._columns = None
        if codec is None:
            return
        proven = codec.generation is self._generation
        chosen: dict[Source, dict[str, _Writer]] = {source: {} for source in Source}
        for record in RECORDS:
            writer = self._writer(record, codec, proven=proven)
            if writer is not None:
                chosen[record.source][record.message] = writer
        if self._tool:
            tool_pose = _ToolPoseWriter(self._tool, self.series[TOOL_POSE.name])
            for message in _POSE_MESSAGES:
                measured = chosen[Source.ARM]
                measured[message] = tool_pose.following(measured[message])
        ends: dict[str, _Writer] = {
            "MotionCommand": self._on_motion_command,
            "MotorEnable": self._on_motor_enable,
        }
        self._own = chosen[Source.OWN] | ends
        self._from_others = chosen[Source.ARM] | chosen[Source.OTHER] | ends

    def _writer(self, record: Record, codec: Codec, *, proven: bool) -> _Writer | None:
        row = None if record is BUS else row_of(record, codec, proven=proven)
        if row is None:
            return None
        series = self.series[record.name]
        if record.space is None:
            return lambda signals, at_s: series.write(at_s, row(signals))
        return self._command_writer(record, series, row)

    def _command_writer(
        self, record: Record, series: Series, row: Callable[[Mapping[str, float]], Row]
    ) -> _Writer:
        space = record.space or Space.MOTION
        group = record.source, record.message.rstrip("0123456789")

        def write(signals: Mapping[str, float], at_s: float) -> None:
            standing, which = self._standing[space]
            if standing != group:
                self._end(space, at_s)
                self._standing[space] = (group, {series})
            else:
                which.add(series)
            series.write(at_s, row(signals))

        return write

    def _end(self, space: Space, at_s: float) -> None:
        for series in self._standing[space][1]:
            series.write(at_s, (math.nan,) * len(series.shape.fields))
        self._standing[space] = (None, set())

    def _end_standing(self, at_s: float) -> None:
        for space in (Space.MOTION, Space.GRIPPER):
            self._end(space, at_s)

    def _on_motion_command(self, signals: Mapping[str, float], at_s: float) -> None:
        if any(signals.get(name) in codes for name, codes in ENDS.items()):
            self._end_standing(at_s)

    def _on_motor_enable(self, signals: Mapping[str, float], at_s: float) -> None:
        if signals["Action"] == MotorAction.DISABLE:
            self._end_standing(at_s)
