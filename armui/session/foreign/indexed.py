"""A log of another program after indexing, with access to any place."""

from __future__ import annotations

import mmap
import os
import struct
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from armui.protocol.frame import FrameFlag
from armui.session.frames import CLASSIC_BYTES, FrameBatch
from armui.session.session import REMEMBERED, REMEMBERED_IDS, DataRows
from armui.system.files import open_file

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from numpy.typing import NDArray

    from armui.arm.refusal import Refusal
    from armui.session.frames import Channel, Damage
    from armui.session.session import SessionMark

# Where the columns of an indexed log lie on the disk, and what else is known of it.

COLUMNS: Final[Mapping[str, np.dtype[Any]]] = {
    "times_s": np.dtype(np.float64),
    "ids": np.dtype(np.uint32),
    "flags": np.dtype(np.uint8),
    "lengths": np.dtype(np.uint8),
    "payloads": np.dtype((np.uint8, (8,))),
    "channels": np.dtype(np.uint8),
}
"""The columns: one file each, one element for each frame, in the order of time."""
ORDER: Final = "order"
"""The column of frame numbers, sorted by channel, kind and identifier and then by time; uint32."""
LONG_ROWS: Final = "long_rows"
LONG_DATA: Final = "long_data"
LONG_BYTES: Final = 64
"""The data bytes kept for each frame with more than 8; their numbers are kept as uint32."""

MOST_FRAMES: Final = 40_000_000
"""The most frames read: 3.7 hours of an arm at 3,000 frames a second, 1.1 GB of the disk."""
SPARE_BYTES: Final = 256 << 20
"""The space on the disk that is left free for others."""

PROGRESS: Final = "progress"
_PROGRESS: Final = struct.Struct("<qqq")
PROGRESS_BYTES: Final = _PROGRESS.size

_ROWS: Final = 4_096
_NOT_DATA: Final = FrameFlag.EXTENDED | FrameFlag.REMOTE | FrameFlag.ERROR


def map_progress(folder: Path) -> mmap.mmap:
    """Return the memory with the progress, shared by the processes that map it.

    Raises:
        OSError: The disk does not allow it.
    """
    path = folder / PROGRESS
    with open_file(path, "r+b" if path.exists() else "x+b") as file:
        if not os.fstat(file.fileno()).st_size:
            file.write(bytes(PROGRESS_BYTES))
            file.flush()
        return mmap.mmap(file.fileno(), PROGRESS_BYTES)


@dataclass(frozen=True, slots=True)
class ReadingProgress:
    """The progress of reading a log.

    Attributes:
        position, size: The bytes read, and the bytes of the file; 0 if not known.
        frames: The number of frames found.
    """

    position: int = 0
    size: int = 0
    frames: int = 0

    @property
    def share(self) -> float | None:
        """The share read, 0 to 1; ``None`` if not known."""
        return min(1.0, self.position / self.size) if self.size > 0 else None

    def write_to(self, memory: bytearray | memoryview | mmap.mmap) -> None:
        """Write it to shared memory for another process."""
        _PROGRESS.pack_into(memory, 0, self.position, self.size, self.frames)

    @classmethod
    def read_from(cls, memory: bytes | memoryview) -> ReadingProgress:
        """Return the progress that another process has written."""
        return cls(*_PROGRESS.unpack_from(memory, 0))


@dataclass(frozen=True, slots=True)
class LogIndex:
    """The index of a log; the columns are in files beside it.

    Attributes:
        frames: The number of frames.
        channels: The channels in the order of their first frames.
        groups: The beginning of each identifier's frames in `ORDER`, and at the end their number.
        marks: The marks found in the frames, in the order of time.
        damages: Damaged places, bounded.
        damage_count: The number of all damaged places.
        notes: Further remarks on the log.
        reversed_times: The number of frames whose time was before that of the preceding one.
        cut: The reason why the rest of the log was not read: ``"frames"``, too many, or ``"disk"``,
            it is full; "" if all was read.
    """

    frames: int
    channels: tuple[Channel, ...]
    groups: tuple[int, ...]
    marks: tuple[SessionMark, ...]
    damages: tuple[Damage, ...]
    damage_count: int
    notes: tuple[Refusal, ...]
    reversed_times: int
    cut: str


def group_codes(
    ids: NDArray[np.uint32], flags: NDArray[np.uint8], channels: NDArray[np.uint8]
) -> NDArray[np.uint64]:
    """Return one number for each combination of channel, kind of frame and identifier."""
    kinds = (flags & 0b111).astype(np.uint64)  # extended, remote, error
    high = (channels.astype(np.uint64) << np.uint64(3)) | kinds
    codes: NDArray[np.uint64] = (high << np.uint64(32)) | ids.astype(np.uint64)
    return codes


def column_path(folder: Path, name: str) -> Path:
    """Return the path of a column's file."""
    return folder / f"{name}.column"


class IndexedLog:
    """The columns of a log as a `Session`; they stay on the disk and are read as needed.

    Args:
        index: The index of the log.
        folder: The folder of its columns.
        remove: Removes the folder as far as that is possible; called at once, for systems where
            open files may lose their names, and at `close`.

    Attributes:
        frames, channels, marks, damages, damage_count, notes, reversed_times, cut: See `LogIndex`.
    """

    def __init__(self, index: LogIndex, folder: Path, remove: Callable[[], object]) -> None:
        self.frames, self.channels, self.marks = index.frames, index.channels, index.marks
        self.damages, self.damage_count = index.damages, index.damage_count
        self.notes = index.notes
        self.reversed_times, self.cut = index.reversed_times, index.cut
        self._folder = folder
        self._remove = remove
        self._columns: dict[str, NDArray[Any]] = {
            name: self._map(name, kind) for name, kind in COLUMNS.items()
        }
        self._times_s: NDArray[np.float64] = self._columns["times_s"]
        self._order: NDArray[np.uint32] = self._map(ORDER, np.dtype(np.uint32))
        self._groups = np.array(index.groups, np.int64)
        self._long_rows: NDArray[np.uint32] = self._map(LONG_ROWS, np.dtype(np.uint32))
        self._long_data = self._map(LONG_DATA, np.dtype((np.uint8, (LONG_BYTES,))))
        self._remove()

    def _map(self, name: str, kind: np.dtype[Any]) -> NDArray[Any]:
        path = column_path(self._folder, name)
        if path.stat().st_size == 0:
            return np.empty((0, *kind.shape), kind.base)
        # A plain array over the file's map: reading a row of a memmap costs far more.
        with open_file(path) as file:
            flat: NDArray[Any] = np.asarray(np.memmap(file, kind.base, "r"))
        return flat.reshape(-1, *kind.shape)

    @property
    def start_s(self) -> float:
        """Log time of the first frame."""
        return float(self._times_s[0]) if self._times_s.size else 0.0

    @property
    def end_s(self) -> float:
        """Log time of the last frame."""
        return float(self._times_s[-1]) if self._times_s.size else 0.0

    def frames_between(self, t0_s: float, t1_s: float) -> Iterator[FrameBatch]:
        """Yield the frames with t0_s <= time < t1_s, in the order of time."""
        first, behind = (int(each) for each in np.searchsorted(self._times_s, (t0_s, t1_s)))
        for begin in range(first, behind, _ROWS):
            yield self._batch(begin, min(begin + _ROWS, behind))

    def snapshot_at(self, t_s: float) -> FrameBatch:
        """Return the last frame of each identifier and channel up to a time; see `Session`."""
        behind = int(np.searchsorted(self._times_s, t_s, side="right"))
        rows: list[int] = []
        ids = self._columns["ids"]
        for first, end in zip(self._groups[:-1].tolist(), self._groups[1:].tolist(), strict=True):
            numbers = self._order[first:end]
            place = int(np.searchsorted(numbers, behind))
            if place:
                kept = REMEMBERED if int(ids[numbers[0]]) in REMEMBERED_IDS else 1
                rows += numbers[max(0, place - kept) : place].tolist()
        return self._chosen(np.array(sorted(rows), np.int64))

    def data_rows(self, channel: Channel, arbitration_id: int) -> DataRows | None:
        """Return the data frames of an identifier on a channel, or ``None`` if there are none."""
        columns, order = self._columns, self._order
        if channel not in self.channels or not order.size:
            return None
        place = self.channels.index(channel)
        groups = list(zip(self._groups[:-1].tolist(), self._groups[1:].tolist(), strict=True))
        for first, end in groups:
            row = int(order[first])
            here = columns["ids"][row] == arbitration_id and columns["channels"][row] == place
            if here and not columns["flags"][row] & _NOT_DATA:
                numbers = order[first:end].astype(np.int64)
                # the last group holds whatever there was no room for
                own = columns["ids"][numbers] == arbitration_id
                own &= (columns["flags"][numbers] & (_NOT_DATA | FrameFlag.IMPOSSIBLE)) == 0
                numbers = numbers[own & (columns["channels"][numbers] == place)]
                chosen = [columns[name][numbers] for name in ("times_s", "lengths", "payloads")]
                return DataRows(numbers, *chosen) if numbers.size else None
        return None

    def _batch(self, begin: int, end: int) -> FrameBatch:
        first, last = np.searchsorted(self._long_rows, (begin, end)).tolist()
        return FrameBatch(
            first=begin,
            channel_names=self.channels,
            long_data=self._long(range(first, last), begin),
            **{name: column[begin:end] for name, column in self._columns.items()},
        )

    def _chosen(self, rows: NDArray[np.int64]) -> FrameBatch:
        columns = {name: column[rows] for name, column in self._columns.items()}
        long_data = {}
        for row in np.flatnonzero(columns["lengths"] > CLASSIC_BYTES).tolist():
            place = int(np.searchsorted(self._long_rows, rows[row]))
            if place < self._long_rows.size and self._long_rows[place] == rows[row]:
                data = self._long_data[place].tobytes()
                long_data[row] = data[: int(columns["lengths"][row])]
        return FrameBatch(first=0, channel_names=self.channels, long_data=long_data, **columns)

    def _long(self, places: range, begin: int) -> dict[int, bytes]:
        found = {}
        for place in places:
            row = int(self._long_rows[place])
            length = int(self._columns["lengths"][row])
            found[row - begin] = self._long_data[place].tobytes()[:length]
        return found

    def close(self) -> None:
        """Release the columns and remove their files."""
        empty = np.empty(0)
        self._columns = {}
        self._times_s, self._order, self._long_rows = empty, empty, empty  # type: ignore[assignment]
        self._long_data = empty
        self._remove()
