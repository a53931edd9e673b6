"""Where the columns of an indexed log lie on the disk, and what else is known of it."""

from __future__ import annotations

import mmap
import os
import struct
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from armui.system.files import open_file

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

    from numpy.typing import NDArray

    from armui.session.frames import Channel, Damage
    from armui.session.session import SessionMark

COLUMNS: Final[Mapping[str, np.dtype[Any]]] = {
    "times_s": np.dtype(np.float64),
    "ids": np.dtype(np.uint32),
    "flags": np.dtype(np.uint8),
    "lengths": np.dtype(np.uint8),
    "payloads": np.dtype((np.uint8, (8,))),
    "channels": np.dtype(np.uint8),
}
"""One file each, one element a frame, in the order of time."""
ORDER: Final = "order"
"""Frame numbers, sorted by what they tell of and then by time; uint32."""
LONG_ROWS: Final = "long_rows"
LONG_DATA: Final = "long_data"
LONG_BYTES: Final = 64
"""Frames with more than 8 bytes: their numbers, uint32, and their data, 64 bytes each."""

MOST_FRAMES: Final = 40_000_000
"""Further ones are not read: 3.7 hours of an arm at 3,000 frames a second, 1.1 GB of the disk."""
SPARE_BYTES: Final = 256 << 20
"""So much of the disk is left to others."""

PROGRESS: Final = "progress"
_PROGRESS: Final = struct.Struct("<qqq")
PROGRESS_BYTES: Final = _PROGRESS.size


def map_progress(folder: Path) -> mmap.mmap:
    """Return the memory, shared by the processes that map it, where the progress stands.

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
    """How far the reading of a log has come.

    Attributes:
        position, size: Bytes of the file that are read, and all of them; 0: not known.
        frames: How many frames were found.
    """

    position: int = 0
    size: int = 0
    frames: int = 0

    @property
    def share(self) -> float | None:
        """From 0 to 1; ``None`` where nothing tells."""
        return min(1.0, self.position / self.size) if self.size > 0 else None

    def write_to(self, memory: bytearray | memoryview) -> None:
        """Leave it where another process reads it."""
        _PROGRESS.pack_into(memory, 0, self.position, self.size, self.frames)

    @classmethod
    def read_from(cls, memory: bytes | memoryview) -> ReadingProgress:
        """What another process has left."""
        return cls(*_PROGRESS.unpack_from(memory, 0))


@dataclass(frozen=True, slots=True)
class LogIndex:
    """What was found in a log; the columns lie in files beside it.

    Attributes:
        frames: How many.
        channels: In the order of their first frames.
        groups: Where the frames of each identifier begin in `ORDER`, and at the end their number.
        long_frames: How many have more than 8 bytes.
        marks: What the frames tell, in the order of time.
        damages: Damaged places, bounded.
        damage_count: All of them.
        reversed_times: Frames whose time was before that of the frame in front of them.
        cut: Why the rest of the log was not read: ``"frames"``, too many, or ``"disk"``, it is
            full; "" if it was.
    """

    frames: int
    channels: tuple[Channel, ...]
    groups: tuple[int, ...]
    long_frames: int
    marks: tuple[SessionMark, ...]
    damages: tuple[Damage, ...]
    damage_count: int
    reversed_times: int
    cut: str


def group_codes(
    ids: NDArray[np.uint32], flags: NDArray[np.uint8], channels: NDArray[np.uint8]
) -> NDArray[np.uint64]:
    """One number for each channel, sort of frame and identifier."""
    kinds = (flags & 0b111).astype(np.uint64)  # extended, remote, error
    high = (channels.astype(np.uint64) << np.uint64(3)) | kinds
    codes: NDArray[np.uint64] = (high << np.uint64(32)) | ids.astype(np.uint64)
    return codes


def column_path(folder: Path, name: str) -> Path:
    """Where a column lies."""
    return folder / f"{name}.column"
