"""The index beside a recording: the place of each block of frames, and the last frames up to it.

The file begins with eight bytes, `MAGIC`. Behind them stands one record a block: `_HEAD`, then the
last frame of each identifier up to the end of the block, one `ROW` each, at most once a second (of
a CAN FD frame the first 8 bytes); of `REMEMBERED_IDS` the last few. A truncated record, or one with
a wrong checksum, ends the index: later blocks are searched in the recording itself.
"""

from __future__ import annotations

import struct
import zlib
from collections import deque
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from armui.protocol.frame import FrameFlag
from armui.session.frames import LATEST_S
from armui.session.recording.rows import ROW, FrameRows
from armui.session.session import REMEMBERED, REMEMBERED_IDS

if TYPE_CHECKING:
    from numpy.typing import NDArray

SUFFIX: Final = ".armui.idx"
MAGIC: Final = b"ARMUIIX1"
_HEAD: Final = struct.Struct("<4sLLLQQLdddL")
"""Signature, checksum of the rest, number of the file from 1, rows; byte and first frame of the
block, its frames; times of the first and last; time from which the file counts; bytes of the block.
"""
_SIGN: Final = b"BLCK"
_SUMMED_FROM: Final = 8
_EVERY_S: Final = 1.0
_NOT_KEPT: Final = FrameFlag.ERROR | FrameFlag.IMPOSSIBLE
_KEY_FLAGS: Final = int(FrameFlag.EXTENDED | FrameFlag.TRANSMITTED)

_REMEMBERED: Final = np.array(sorted(REMEMBERED_IDS), np.uint32)


@dataclass(frozen=True, slots=True)
class Block:
    """The place of some frames in a recording.

    Attributes:
        file: Number of the file, from 1.
        byte, size: Its place in the file.
        first, frames: The number of its first frame in the recording, from 0, and the number of its
            frames.
        first_s, last_s: Log times of its first and its last frame.
        file_start_s: Log time from which the file counts.
        standing: The last frame of each identifier up to its end, if the index has them.
    """

    file: int
    byte: int
    size: int
    first: int
    frames: int
    first_s: float
    last_s: float
    file_start_s: float
    standing: NDArray[Any] | None = None

    def record(self) -> bytes:
        """Return the block's record in the index."""
        rows = np.zeros(0, ROW) if self.standing is None else self.standing
        fields = (
            self.file, len(rows), self.byte, self.first, self.frames,
            self.first_s, self.last_s, self.file_start_s, self.size,
        )  # fmt: skip
        body = _HEAD.pack(_SIGN, 0, *fields)[_SUMMED_FROM:] + rows.tobytes()
        return struct.pack("<4sL", _SIGN, zlib.crc32(body)) + body


class StandingFrames:
    """The last frame of each identifier, separately for received and sent ones.

    Of `REMEMBERED_IDS` it keeps the last `REMEMBERED`.
    """

    def __init__(self) -> None:
        self._last: dict[int, Any] = {}
        self._remembered: dict[int, deque[Any]] = {}
        self._reported_s = -np.inf

    def add_rows(self, rows: FrameRows) -> NDArray[np.void] | None:
        """Process some frames.

        Returns:
            The last frames in the order of time about once a second, else ``None``.
        """
        table = rows.table
        if (table["flags"] & _NOT_KEPT).any():
            table = table[table["flags"] & _NOT_KEPT == 0]
        if len(table):
            keys = table["id"].astype(np.uint64) << 8 | table["flags"] & _KEY_FLAGS
            found, places = np.unique(keys[::-1], return_index=True)
            last = table[::-1][places]
            for key, row in zip(found.tolist(), last, strict=True):
                self._last[key] = row
            for place in np.flatnonzero(np.isin(table["id"], _REMEMBERED)).tolist():
                kept = self._remembered.setdefault(int(keys[place]), deque(maxlen=REMEMBERED))
                kept.append(table[place])
        now_s = float(rows.times_s[-1]) if len(rows) else -np.inf
        if now_s - self._reported_s < _EVERY_S:
            return None
        self._reported_s = now_s
        rows_kept = [row for key, row in self._last.items() if key not in self._remembered]
        for kept in self._remembered.values():
            rows_kept += kept
        standing = np.array(rows_kept, ROW)
        return standing[np.argsort(standing["time_s"], kind="stable")]


def read_blocks(data: bytes) -> Iterator[Block]:
    """Yield the blocks of an index, as far as it is intact."""
    if not data.startswith(MAGIC):
        return
    at = len(MAGIC)
    while at + _HEAD.size <= len(data):
        sign, total, file, rows, byte, first, frames, first_s, last_s, start_s, size = (
            _HEAD.unpack_from(data, at)
        )
        end = at + _HEAD.size + rows * ROW.itemsize
        if sign != _SIGN or end > len(data) or zlib.crc32(data[at + _SUMMED_FROM : end]) != total:
            return
        if not (-LATEST_S <= first_s <= last_s <= LATEST_S and abs(start_s) <= LATEST_S):
            return
        standing = np.frombuffer(data, ROW, rows, at + _HEAD.size) if rows else None
        yield Block(file, byte, size, first, frames, first_s, last_s, start_s, standing)
        at = end


def last_block(end: bytes) -> Block | None:
    """Return the last whole block in the last bytes of an index, or None."""
    at = len(end)
    while (at := end.rfind(_SIGN, 0, at)) >= 0:
        block = next(read_blocks(MAGIC + end[at:]), None)
        if block is not None:
            return block
    return None
