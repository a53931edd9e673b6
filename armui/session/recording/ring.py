"""The last minutes of everything on the bus, in memory: pure, and bounded."""

from __future__ import annotations

import threading
from collections import deque
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Final

from armui.session.recording.rows import ROW, FrameRows
from armui.telemetry.series import zeros

if TYPE_CHECKING:
    from numpy.typing import NDArray

KEPT_S: Final = 300.0
"""How long frames are kept."""
MOST_BYTES: Final = 22_000_000
"""Five minutes at 3,000 frames/s; with more traffic the ring reaches back less far."""
_SLAB_ROWS: Final = 16_384
_SLAB_BYTES: Final = _SLAB_ROWS * ROW.itemsize
_LONG_BYTES: Final = 256
"""What the data of a CAN FD frame takes at most, with what Python keeps around it."""
_MOST_LONG: Final = 2_048
"""Such frames of a slab; those of a whole slab would be more than can be dropped at once."""
_LONG_AT_ONCE: Final = 512


@dataclass(slots=True)
class _Slab:
    """Rows that are only ever added: whoever has seen some of them may read these for ever."""

    table: NDArray[Any]
    count: int = 0
    long_data: dict[int, bytes] = field(default_factory=dict)

    def rows(self) -> FrameRows:
        return FrameRows(self.table[: self.count], dict(self.long_data))

    @property
    def last_s(self) -> float:
        return float(self.table["time_s"][self.count - 1])

    @property
    def size(self) -> int:
        return _SLAB_BYTES + _LONG_BYTES * len(self.long_data)


class FrameRing:
    """Written by one thread, read by any.

    Args:
        keep_s: How long frames are kept, by their own times.
        most_bytes: The memory it takes at most, whatever is on the bus.
    """

    def __init__(self, keep_s: float = KEPT_S, most_bytes: int = MOST_BYTES) -> None:
        self.keep_s = keep_s
        least = 2 * (_SLAB_BYTES + _LONG_BYTES * (_MOST_LONG + _LONG_AT_ONCE))
        self.most_bytes = max(most_bytes, least)
        self._slabs: deque[_Slab] = deque()
        self._bytes = 0
        self._lock = threading.Lock()

    def append(self, rows: FrameRows) -> None:
        """Keep some more; the oldest make room."""
        begin = 0
        while begin < len(rows):
            slab = self._open_slab()
            most = _LONG_AT_ONCE if rows.long_data else _SLAB_ROWS
            taken = min(len(rows) - begin, _SLAB_ROWS - slab.count, most)
            part = rows.part(begin, begin + taken)
            with self._lock:
                slab.table[slab.count : slab.count + taken] = part.table
                for row, data in part.long_data.items():
                    slab.long_data[slab.count + row] = data
                slab.count += taken
                self._bytes += _LONG_BYTES * len(part.long_data)
            begin += taken
            self._make_room(0)

    def _open_slab(self) -> _Slab:
        last = self._slabs[-1] if self._slabs else None
        if last is None or last.count == _SLAB_ROWS or len(last.long_data) >= _MOST_LONG:
            self._make_room(_SLAB_BYTES)
            with self._lock:
                self._slabs.append(_Slab(zeros((_SLAB_ROWS,), ROW)))
                self._bytes += _SLAB_BYTES
        return self._slabs[-1]

    def _make_room(self, for_bytes: int) -> None:
        """Drop the oldest: what is too old, and what is too much."""
        with self._lock:
            slabs = self._slabs
            newest_s = slabs[-1].last_s if slabs and slabs[-1].count else None
            while slabs and (len(slabs) > 1 or for_bytes):
                oldest = slabs[0]
                too_much = self._bytes + for_bytes > self.most_bytes - _LONG_BYTES * _LONG_AT_ONCE
                too_old = newest_s is not None and oldest.last_s < newest_s - self.keep_s
                if not too_much and not too_old:
                    break
                self._bytes -= oldest.size
                slabs.popleft()

    def forget(self) -> None:
        """Let go of everything."""
        with self._lock:
            self._slabs.clear()
            self._bytes = 0

    @property
    def bytes_kept(self) -> int:
        """The memory it takes now."""
        return self._bytes

    def snapshot(self) -> list[FrameRows]:
        """Everything kept, the oldest first, not copied; what comes later is not in it."""
        with self._lock:
            parts = [slab.rows() for slab in self._slabs if slab.count]
        if not parts:
            return []
        oldest_s = float(parts[-1].times_s[-1]) - self.keep_s
        first = parts[0]
        begin = int(first.times_s.searchsorted(oldest_s))
        return [first.part(begin, len(first)), *parts[1:]]

    def span(self) -> tuple[int, float]:
        """How many frames are kept, and from the first to the last so many seconds."""
        parts = self.snapshot()
        if not parts:
            return 0, 0.0
        frames = sum(map(len, parts))
        return frames, float(parts[-1].times_s[-1] - parts[0].times_s[0]) if frames else 0.0
