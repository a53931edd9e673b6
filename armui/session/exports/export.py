"""Exports a log: from its file to a file that other programs open."""

from __future__ import annotations

import math
from contextlib import closing
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from armui import __version__
from armui.session.exports.csv_files import CsvMessages, CsvTable
from armui.session.exports.exported_arm import NoSuchChannelError, look_at
from armui.session.exports.history import ArmFrameReader, ExportFacts, History, TimeSpan
from armui.session.exports.parquet_table import ParquetTable
from armui.session.exports.request import (
    ExportCancelledError,
    ExportError,
    ExportFormat,
    ExportProblem,
    ExportProgress,
    ExportReport,
)
from armui.session.frames import NotALogError
from armui.session.reader import LogFile
from armui.session.recording.episodes import episodes_of
from armui.session.recording.recorded_session import RecordedSession
from armui.system.atomic import WholeFile, WholeFolder, remove_abandoned
from armui.system.files import error_text

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Mapping, Sequence
    from pathlib import Path
    from typing import Any

    from armui.arm.refusal import Refusal
    from armui.session.exports.exported_arm import ExportedArm
    from armui.session.exports.history import Sink
    from armui.session.exports.request import ExportRequest
    from armui.session.frames import Channel, Damage, FrameBatch
    from armui.session.session import Session


class FileSource:
    """A log file, read once from its beginning to its end.

    Args:
        path: The file, in any format that `LogFile` reads.

    Raises:
        NotALogError: It cannot be opened, or is no log.
    """

    lines: Sequence[Mapping[str, Any]] = ()
    """The sidecar's lines; always empty, because only recordings of this program have one."""

    def __init__(self, path: Path) -> None:
        self._log = LogFile(path, pipes=True)

    @property
    def frames(self) -> int:
        """The number of frames read so far."""
        return self._log.frames

    @property
    def done(self) -> float | None:
        """The share of the bytes read, 0 to 1; `None` if not known."""
        return min(self._log.position / self._log.size, 1.0) if self._log.size else None

    @property
    def damages(self) -> Sequence[Damage]:
        """The damaged places met so far, bounded."""
        return self._log.damages.since(0)

    @property
    def notes(self) -> Sequence[Refusal]:
        """What else is to be known of the log."""
        return self._log.damages.notes

    @property
    def damage_count(self) -> int:
        """The number of all damaged places."""
        return self._log.damages.count

    def batches(self) -> Iterator[FrameBatch]:
        """Return the frames; this can be called only once."""
        return self._log.batches()

    def close(self) -> None:
        """Close the log's file."""
        self._log.close()


class SessionSource:
    """A session with all its files, with the interface of `FileSource`.

    Args:
        session: The session; closed with this object.
    """

    def __init__(self, session: Session) -> None:
        self._session = session
        self._at_s = session.start_s
        self.lines: Sequence[Mapping[str, Any]] = getattr(session, "lines", ())
        self.notes: Sequence[Refusal] = getattr(session, "notes", ())
        self.frames = 0

    @property
    def done(self) -> float | None:
        """The share of the session's time read, 0 to 1; `None` if not known."""
        length_s = self._session.end_s - self._session.start_s
        return min((self._at_s - self._session.start_s) / length_s, 1.0) if length_s > 0 else None

    @property
    def damages(self) -> Sequence[Damage]:
        """The damaged places met so far, bounded."""
        return self._session.damages

    @property
    def damage_count(self) -> int:
        """The number of all damaged places."""
        return self._session.damage_count

    def batches(self) -> Iterator[FrameBatch]:
        """Yield the frames; this can be called only once."""
        for batch in self._session.frames_between(-math.inf, math.inf):
            self.frames += len(batch)
            self._at_s = float(batch.times_s[-1])
            yield batch

    def close(self) -> None:
        """Close the session and its files."""
        self._session.close()


ExportSource = FileSource | SessionSource


def open_source(path: Path) -> ExportSource:
    """Open a log: all files of one of this program's, or any log.

    Raises:
        NotALogError: It cannot be opened, or is no log.
    """
    try:
        return SessionSource(RecordedSession(path))
    except NotALogError:
        return FileSource(path)


def export_log(
    request: ExportRequest,
    on_progress: Callable[[ExportProgress], object] = lambda _progress: None,
    is_wanted: Callable[[], bool] = lambda: True,
    begun: Callable[[Path], object] = lambda _unfinished: None,
    open_recording: Callable[[Path], ExportSource] = open_source,
) -> ExportReport:
    """Export a log with bounded memory, whatever the log holds.

    Args:
        request: The log, the target and the options.
        on_progress: Called with the progress after each piece of the log.
        is_wanted: Called as often; if it returns false, the export is cancelled.
        begun: Called with the name of the unfinished file, which must be removed by whoever kills
            this process.
        open_recording: Opens the log; raises `NotALogError` if it cannot.

    Raises:
        ExportError: Nothing was written.
        ExportCancelledError: `is_wanted` returned false.
    """
    if request.log.resolve() == request.target.resolve():
        raise ExportError(ExportProblem.SAME_FILE, str(request.target))
    try:
        with closing(open_recording(request.log)) as source:
            return _Export(request, source, on_progress, is_wanted, begun).run()
    except NotALogError as error:
        raise ExportError(ExportProblem.NO_LOG, error_text(error)) from error
    except NoSuchChannelError as error:
        raise ExportError(ExportProblem.NO_CHANNEL, str(error)) from error
    except FileExistsError as error:
        raise ExportError(ExportProblem.EXISTS, str(request.target)) from error
    except OSError as error:
        raise ExportError(ExportProblem.CANNOT_WRITE, error_text(error)) from error


_MOST_DAMAGES_TOLD: Final = 20
_LATER_S: Final = 1.0
"""Reading ends once a whole piece of the log is this long after the wanted end."""


@dataclass(eq=False, repr=False)
class _Export:
    request: ExportRequest
    source: ExportSource
    on_progress: Callable[[ExportProgress], object]
    is_wanted: Callable[[], bool]
    begun: Callable[[Path], object]

    def run(self) -> ExportReport:
        request = self.request
        with _whole(request) as target:
            self.begun(target.unfinished)
            arm, batches = look_at(self.source.batches(), request.wishes, self.source.lines)
            if arm is None:
                raise ExportError(ExportProblem.NO_FRAMES)
            sink = self._sink(target, _facts(request, arm))
            reader, history = ArmFrameReader(arm.channel), History(arm.codec)
            try:
                self._write(arm, batches, sink, reader, history)
                sink.finish()
            except BaseException:
                sink.abandon()
                raise
            target.finish()
        return self._report(arm, sink, reader, history)

    def _sink(self, target: WholeFile | WholeFolder, facts: ExportFacts) -> Sink:
        request = self.request
        try:
            if request.format is ExportFormat.LEROBOT:
                from armui.session.exports.lerobot.episodes import (  # noqa: PLC0415 - pyarrow
                    LeRobotDataset,
                )

                marked = episodes_of(self.source.lines)
                return LeRobotDataset(target.unfinished, facts, request.episodes, marked)
            if isinstance(target, WholeFolder):
                return CsvMessages(target.unfinished, facts)
            if request.format is ExportFormat.CSV:
                return CsvTable(target.stream, facts)
            if request.format is ExportFormat.PARQUET:
                return ParquetTable(target.stream, facts)
        except ImportError as error:
            raise ExportError(ExportProblem.NO_PYARROW, str(error)) from error
        from armui.session.exports.ros.mcap_file import McapFile  # noqa: PLC0415 - the packages mcap, zstandard, lz4

        return McapFile(target.stream, facts)

    def _write(
        self,
        arm: ExportedArm,
        batches: Iterator[FrameBatch],
        sink: Sink,
        reader: ArmFrameReader,
        history: History,
    ) -> None:
        request = self.request
        span = TimeSpan(arm.start_s + request.begin_s, arm.start_s + request.end_s)
        for frames in reader.pieces(self._watched(batches)):
            history.add_frames(frames)
            sink.write_span(history, span)
            if len(frames) and frames.times_s.min() > span.end_s + _LATER_S:
                break
        if not sink.items:
            raise ExportError(_why_nothing(request, reader, history))

    def _watched(self, batches: Iterator[FrameBatch]) -> Iterator[FrameBatch]:
        for batch in batches:
            if not self.is_wanted():
                raise ExportCancelledError
            yield batch
            self.on_progress(ExportProgress(self.source.done, self.source.frames))

    def _report(
        self, arm: ExportedArm, sink: Sink, reader: ArmFrameReader, history: History
    ) -> ExportReport:
        return ExportReport(
            items=sink.items,
            frames=self.source.frames,
            generation=int(arm.codec.generation),
            why_generation=arm.why_generation,
            firmware=arm.firmware,
            model=arm.model.name,
            why_model=arm.why_model,
            pose_fits=arm.pose_fits,
            offset=arm.codec.addressing.feedback_offset,
            channel=_name(arm.channel),
            other_channels=tuple(_name(each) for each in reader.other_channels),
            of_other_channels=reader.of_other_channels,
            not_understood=history.not_understood + reader.of_other_kinds,
            questions=history.questions,
            without_stamp=getattr(sink, "without_stamp", 0),
            damages=tuple(self.source.damages[:_MOST_DAMAGES_TOLD]),
            damage_count=self.source.damage_count,
            notes=(*self.source.notes, *getattr(sink, "notes", ())),
        )


def _facts(request: ExportRequest, arm: ExportedArm) -> ExportFacts:
    words = f"{arm.model.name}, generation {int(arm.codec.generation)}"
    notes = {
        "program": f"armui {__version__}",
        "source": request.log.name,
        "arm": f"{words}, {arm.firmware}" if arm.firmware else words,
        "channel": _name(arm.channel),
        "start_s": f"{arm.start_s:.6f}",
    }
    return ExportFacts(arm.codec, arm.geometry, arm.model.gripper.turned_deg, arm.start_s, notes)


def _whole(request: ExportRequest) -> WholeFile | WholeFolder:
    remove_abandoned(request.target.parent)
    if request.format is ExportFormat.LEROBOT:
        return WholeFolder(request.target, "", replace=False)
    if request.format.is_folder:
        return WholeFolder(request.target, ".csv", replace=request.replace)
    return WholeFile(request.target, replace=request.replace)


def _why_nothing(request: ExportRequest, reader: ArmFrameReader, history: History) -> ExportProblem:
    if reader.taken == reader.of_other_kinds + history.not_understood + history.questions:
        return ExportProblem.NO_ARM
    if request.begin_s > 0.0 or request.end_s < math.inf:
        return ExportProblem.NOTHING_THEN
    return ExportProblem.NO_ARM if request.format.is_folder else ExportProblem.NO_ANGLES


def _name(channel: Channel) -> str:
    return "" if channel is None else str(channel)
