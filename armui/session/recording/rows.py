"""Frames as rows of one typed array: pure."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Final

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from armui.protocol.frame import Frame

CLASSIC_BYTES: Final = 8
ROW: Final = np.dtype(
    [
        ("time_s", "<f8"),
        ("id", "<u4"),
        ("flags", "u1"),
        ("length", "u1"),
        ("data", "u1", (CLASSIC_BYTES,)),
    ]
)
"""A frame: time in seconds, identifier, `FrameFlag` bits, length of data, the first 8 bytes of it.
"""

RecordedFrame = tuple[object, float, "Frame", int]
"""A frame from the bus thread: decoded, time in seconds, the frame, `FrameFlag` bits."""


@dataclass(frozen=True, slots=True)
class FrameRows:
    """Frames as rows of a table.

    Attributes:
        table: The frames, one `ROW` each.
        long_data: The data of frames with more than 8 bytes, by row.
    """

    table: NDArray[Any]
    long_data: Mapping[int, bytes] = field(default_factory=dict)

    def __len__(self) -> int:
        return len(self.table)

    @property
    def times_s(self) -> NDArray[np.float64]:
        """(n,) the frames' times, in s, as they are in the table."""
        times: NDArray[np.float64] = self.table["time_s"]
        return times

    def data(self, row: int) -> bytes:
        """Return the payload of a frame, also one of more than eight bytes (CAN FD)."""
        whole = self.long_data.get(row)
        if whole is not None:
            return whole
        length = int(self.table["length"][row])
        piece: bytes = self.table["data"][row, :length].tobytes()
        return piece

    def part(self, begin: int, end: int) -> FrameRows:
        """Return some of the rows, without copying."""
        kept = {row - begin: data for row, data in self.long_data.items() if begin <= row < end}
        return FrameRows(self.table[begin:end], kept)

    def shifted(self, by_s: float) -> FrameRows:
        """Return a copy with shifted times."""
        table = self.table.copy()
        table["time_s"] += by_s
        return FrameRows(table, self.long_data)


EMPTY: Final = FrameRows(np.zeros(0, ROW))


def rows_of(taken: Sequence[RecordedFrame]) -> FrameRows:
    """Return frames of the bus thread as rows, in their order."""
    count = len(taken)
    if not count:
        return EMPTY
    table = np.zeros(count, ROW)
    _decoded, times, frames, flags = zip(*taken, strict=True)
    ids, data = zip(*frames, strict=True)
    table["time_s"] = times
    table["id"] = ids
    table["flags"] = flags
    lengths = list(map(len, data))
    table["length"] = lengths
    if min(lengths) == CLASSIC_BYTES == max(lengths):
        joined = b"".join(data)
    else:
        joined = b"".join([each[:CLASSIC_BYTES].ljust(CLASSIC_BYTES, b"\0") for each in data])
    table["data"] = np.frombuffer(joined, np.uint8).reshape(-1, CLASSIC_BYTES)
    long_data = (
        {row: bytes(each) for row, each in enumerate(data) if len(each) > CLASSIC_BYTES}
        if max(lengths) > CLASSIC_BYTES
        else {}
    )
    return FrameRows(table, long_data)


def joined(parts: Sequence[FrameRows]) -> FrameRows:
    """Return several tables joined into one."""
    parts = [part for part in parts if len(part)]
    if len(parts) < 2:
        return parts[0] if parts else EMPTY
    long_data: dict[int, bytes] = {}
    begin = 0
    for part in parts:
        long_data.update({begin + row: data for row, data in part.long_data.items()})
        begin += len(part)
    return FrameRows(np.concatenate([part.table for part in parts]), long_data)


def in_order(rows: FrameRows) -> FrameRows:
    """Return the rows in the order of time; rows of equal time keep their order."""
    times_s = rows.times_s
    if len(rows) < 2 or bool((times_s[1:] >= times_s[:-1]).all()):
        return rows
    order = np.argsort(times_s, kind="stable")
    if not rows.long_data:
        return FrameRows(rows.table[order])
    places = {int(row): place for place, row in enumerate(order)}
    long_data = {places[row]: data for row, data in rows.long_data.items()}
    return FrameRows(rows.table[order], long_data)
