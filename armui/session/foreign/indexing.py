"""Reads a log once from beginning to end into columns, in the helper process."""

from __future__ import annotations

import shutil
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from armui.arm.refusal import Reason, Refusal
from armui.protocol.detect import GenerationDetector
from armui.protocol.frame import Frame, FrameFlag
from armui.session.batch_builder import LOG_NO_TIMES
from armui.session.foreign.indexed import (
    COLUMNS,
    LONG_BYTES,
    LONG_DATA,
    LONG_ROWS,
    MOST_FRAMES,
    ORDER,
    SPARE_BYTES,
    LogIndex,
    ReadingProgress,
    column_path,
    group_codes,
    map_progress,
)
from armui.session.frames import LATEST_S, NOT_OF_THE_ARM, NotALogError
from armui.session.log_marks import LogFrames, marks_of
from armui.session.reader import SUFFIXES, LogFile, is_known_kind, is_mf4
from armui.system.files import error_text, open_file

if TYPE_CHECKING:
    from pathlib import Path
    from typing import BinaryIO

    from numpy.typing import DTypeLike, NDArray

    from armui.protocol.generation import Generation
    from armui.session.frames import Channel, FrameBatch
    from armui.session.session import SessionMark

REPLAY_NO_DISK = Reason(
    "replay_no_disk",
    "The log is read into temporary files, and these cannot be written: {text}. Make room on "
    "the disk, or set TMPDIR to a folder with more.",
)
REPLAY_EMPTY = Reason(
    "replay_empty",
    "{name} is a log without a single frame: there is nothing to replay. Record again, with "
    "the arm switched on.",
)
REPLAY_UNREADABLE = Reason(
    "replay_unreadable",
    "{name} cannot be opened: {text}. Look whether it is still there and may be read.",
)
REPLAY_UNKNOWN_KIND = Reason(
    "replay_unknown_kind",
    "By its name {name} is no CAN log. Known endings: {known}, most of them also with .gz "
    "behind. Rename the file, or choose another.",
)
REPLAY_MF4 = Reason(
    "replay_mf4",
    "{name} is an MF4 file, and those are not read. Convert it to .asc or .blf with other "
    "software, for example asammdf, and open what that has written.",
)
REPLAY_ARCHIVE = Reason(
    "replay_archive",
    "{name} is a packed archive, whatever its ending says. Unpack it, and open the log that "
    "was in it.",
)
REPLAY_NOTHING_READ = Reason(
    "replay_nothing_read",
    "Nothing in {name} reads as a frame of a CAN log of its ending. Choose the file that the "
    "recording program has written, with its own ending.",
)
REPLAY_NO_LOG = Reason(
    "replay_no_log",
    "Nothing in {name} reads as a frame of a CAN log ({text}). Choose the file that the "
    "recording program has written, with its own ending.",
)


# Corrects times of a log that run backwards.

_CLOCK_SET_S: Final = 1.0
"""A larger step back shows that the recorder's clock was set back; a smaller one, that frames were
written out of order.
"""

_MOST_GROUPS: Final = 4_096
"""The most identifiers told apart; further ones share the last place."""
_DISK_EVERY: Final = 256
"""The batches between two checks of the free space."""
_GENERATION_FRAMES: Final = 6_000
_MOST_LOOKED_AT: Final = 200_000

_ARCHIVES: Final = (b"PK\x03\x04", b"7z\xbc\xaf\x27\x1c", b"Rar!", b"\x1f\x8b", b"BZh", b"\xfd7zXZ")
"""The first bytes of zip, 7z, rar, gzip, bzip2 and xz files."""


def straightened(
    times_s: NDArray[np.float64], channels: NDArray[np.uint8]
) -> tuple[NDArray[np.float64], int]:
    """Return times fit for sorting, without clock resets and without a single time in the future.

    After a clock reset time goes on as if the clock had stood still, to the end of the calendar at
    most. Each channel is treated separately: they may have been written one after another.

    Args:
        times_s: The times as recorded, finite.
        channels: The channel of each frame.

    Returns:
        The times in seconds, and the number of frames with a time before that of the preceding
        frame on their channel.
    """
    backwards = 0
    result = times_s
    for channel in np.unique(channels).tolist():
        rows = np.flatnonzero(channels == channel)
        own = times_s[rows]
        steps = np.diff(own)
        count = int((steps < 0).sum())
        if count == 0:
            continue
        backwards += count
        if result is times_s:
            result = times_s.copy()
        result[rows] = _continued(_without_strays(own, steps))
    return result, backwards


def _without_strays(own: NDArray[np.float64], steps: NDArray[np.float64]) -> NDArray[np.float64]:
    """Replace a single time far off both its neighbours with that of the frame before it."""
    ahead = (steps[:-1] > _CLOCK_SET_S) & (steps[1:] < -_CLOCK_SET_S)
    behind = (steps[:-1] < -_CLOCK_SET_S) & (steps[1:] > _CLOCK_SET_S)
    places = np.flatnonzero((ahead | behind) & (own[2:] >= own[:-2])) + 1
    own[places] = own[places - 1]
    if own.size > 1 and own[0] > own[1] + _CLOCK_SET_S and np.all(own[1:] < own[0]):
        own[0] = own[1]
    return own


def _continued(own: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the times, continued without a step where the recorder's clock was set back."""
    steps = np.diff(own)
    moved = np.where(steps < -_CLOCK_SET_S, -steps, 0.0)
    if moved.any():
        own[1:] = np.minimum(own[1:] + np.cumsum(moved), LATEST_S)
    return own


def index_log(path: Path, folder: Path, most_frames: int = MOST_FRAMES) -> LogIndex:
    """Read a log into columns.

    Args:
        path: The log.
        folder: The folder for the columns; `PROGRESS` in it holds the progress meanwhile.
        most_frames: The most frames to read.

    Raises:
        NotALogError: The file cannot be opened, or nothing in it is a frame.
        OSError: The columns cannot be written.
    """
    with LogFile(path) as log, _Columns(folder) as columns, map_progress(folder) as memory:
        cut = ""
        for number, batch in enumerate(log.batches()):
            columns.add(batch)
            ReadingProgress(log.position, log.size, columns.frames).write_to(memory)
            if columns.frames >= most_frames:
                cut = "frames"
            elif number % _DISK_EVERY == 0 and _is_disk_full(folder, columns.frames):
                cut = "disk"
            if cut:
                break
        damages, damage_count = log.damages.since(0), log.damages.count
        notes = tuple(log.damages.notes)
    reversed_times = _put_in_order(folder)
    groups, marks = _order(folder, columns.channels, timed=LOG_NO_TIMES() not in notes)
    return LogIndex(
        frames=columns.frames,
        channels=columns.channels,
        groups=groups,
        marks=marks,
        damages=tuple(damages),
        damage_count=damage_count,
        notes=notes,
        reversed_times=reversed_times,
        cut=cut,
    )


def index_or_reason(path: Path, folder: Path) -> LogIndex | Refusal:
    """Read a log into columns, or return the reason why there is nothing to replay."""
    name = path.name
    try:
        index = index_log(path, folder)
    except NotALogError as error:
        return _why_not(path, error)
    except OSError as error:
        return REPLAY_NO_DISK(text=error_text(error))
    return index if index.frames else REPLAY_EMPTY(name=name)


def _why_not(path: Path, error: NotALogError) -> Refusal:
    """Return the reason why a file is no log, as far as its name and beginning show it."""
    name = {"name": path.name}
    if isinstance(error.__cause__, OSError):
        return REPLAY_UNREADABLE(**name, text=str(error))
    if is_mf4(path):
        return REPLAY_MF4(**name)
    if not is_known_kind(path):
        known = ", ".join(SUFFIXES)
        return REPLAY_UNKNOWN_KIND(**name, known=known)
    try:
        with open_file(path) as file:
            beginning = file.read(len(max(_ARCHIVES, key=len)))
    except OSError as gone:
        return REPLAY_UNREADABLE(**name, text=error_text(gone))
    if not beginning:
        return REPLAY_EMPTY(**name)
    if path.suffix.lower() != ".gz" and beginning.startswith(_ARCHIVES):
        return REPLAY_ARCHIVE(**name)
    text = str(error).removeprefix("no CAN log: ")
    if text.startswith("nothing in it reads") and text.endswith(" file"):  # no detail follows
        return REPLAY_NOTHING_READ(**name)
    return REPLAY_NO_LOG(**name, text=text)


class _Columns:
    """The files of the columns, as they grow; use it in a ``with`` statement.

    Attributes:
        frames: The number of frames written so far.
        channels: The channels found so far.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._files: dict[str, BinaryIO] = {}
        self.frames = 0
        self.channels: tuple[Channel, ...] = ()

    def __enter__(self) -> _Columns:
        for name in (*COLUMNS, LONG_ROWS, LONG_DATA):
            self._files[name] = open_file(column_path(self._folder, name), "wb")
        return self

    def __exit__(self, *_error: object) -> None:
        for file in self._files.values():
            file.close()

    def add(self, batch: FrameBatch) -> None:
        """Write the frames of a batch."""
        for name, kind in COLUMNS.items():
            column: NDArray[Any] = getattr(batch, name)
            self._files[name].write(np.ascontiguousarray(column, kind.base).data)
        for row, data in batch.long_data.items():
            self._files[LONG_ROWS].write(np.uint32(self.frames + row).tobytes())
            self._files[LONG_DATA].write(data[:LONG_BYTES].ljust(LONG_BYTES, b"\0"))
        self.frames += len(batch)
        self.channels = batch.channel_names


def _is_disk_full(folder: Path, frames: int) -> bool:
    """Return whether writing the remaining files would leave less than :data:`SPARE_BYTES`."""
    return shutil.disk_usage(folder).free < SPARE_BYTES + frames * (4 + 8)


def _read(folder: Path, name: str) -> NDArray[Any]:
    return _values(folder, name, COLUMNS[name].base).reshape(-1, *COLUMNS[name].shape)


def _values(folder: Path, name: str, kind: DTypeLike) -> NDArray[Any]:
    with open_file(column_path(folder, name)) as file:
        return np.fromfile(file, kind)


def _write(folder: Path, name: str, values: NDArray[Any]) -> None:
    with open_file(column_path(folder, name), "wb") as file:
        values.tofile(file)


def _put_in_order(folder: Path) -> int:
    """Sort the columns by time; return how many frames went back in time."""
    raw_s = _read(folder, "times_s")
    times_s, backwards = straightened(raw_s, _read(folder, "channels"))
    if bool((np.diff(times_s) >= 0).all()):
        if backwards:
            _write(folder, "times_s", times_s)
        return backwards
    order = np.argsort(times_s, kind="stable")
    _write(folder, "times_s", times_s[order])
    for name in COLUMNS:
        if name != "times_s":
            _write(folder, name, _read(folder, name)[order])
    rows = _values(folder, LONG_ROWS, np.uint32)
    if rows.size:
        places = np.empty(order.size, np.uint32)
        places[order] = np.arange(order.size, dtype=np.uint32)
        moved = places[rows]
        sequence = np.argsort(moved)
        data = _values(folder, LONG_DATA, np.uint8).reshape(-1, LONG_BYTES)
        _write(folder, LONG_ROWS, moved[sequence])
        _write(folder, LONG_DATA, data[sequence])
    return backwards


def _order(
    folder: Path, channels: tuple[Channel, ...], *, timed: bool
) -> tuple[tuple[int, ...], tuple[SessionMark, ...]]:
    """Write the frame numbers by identifier; return where each group begins, and the marks."""
    ids, flags, places = (_read(folder, name) for name in ("ids", "flags", "channels"))
    codes = group_codes(ids, flags, places)
    known: NDArray[np.uint64] = np.unique(codes)[: _MOST_GROUPS - 1]
    numbers = np.searchsorted(known, codes).astype(np.uint16)
    order = np.argsort(numbers, kind="stable").astype(np.uint32)
    _write(folder, ORDER, order)
    starts = np.searchsorted(numbers, np.arange(len(known) + 2), sorter=order)
    times_s, payloads = _read(folder, "times_s"), _read(folder, "payloads")

    def rows(channel: Channel, arbitration_id: int) -> Any:
        code = np.uint64((channels.index(channel) << 35) | arbitration_id)
        group = int(np.searchsorted(known, code))
        if group == len(known) or known[group] != code:
            return None
        numbers = order[starts[group] : starts[group + 1]]
        numbers = numbers[(flags[numbers] & FrameFlag.IMPOSSIBLE) == 0]
        return (times_s[numbers], payloads[numbers]) if numbers.size else None

    generation = _generation(ids, flags, payloads, times_s)
    marks = marks_of(LogFrames(channels, rows, timed), generation)
    # An empty group begins where the next one does, and is left out.
    return tuple(dict.fromkeys(starts.tolist())), tuple(marks)


def _generation(
    ids: NDArray[np.uint32],
    flags: NDArray[np.uint8],
    payloads: NDArray[np.uint8],
    times_s: NDArray[np.float64],
) -> Generation:
    """Return the generation of the protocol that the first frames show."""
    detector = GenerationDetector()
    ordinary = np.flatnonzero((flags[:_MOST_LOOKED_AT] & NOT_OF_THE_ARM) == 0)
    for count, row in enumerate(ordinary.tolist()):
        detector.feed(Frame(int(ids[row]), payloads[row].tobytes()), float(times_s[row]))
        if detector.certain or (count >= _GENERATION_FRAMES and detector.has_evidence):
            break
    return detector.verdict().generation
