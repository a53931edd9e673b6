"""The thread that turns the bus thread's frames into rows for ring and files: pure."""

from __future__ import annotations

import logging
import threading
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from armui.session.recording.rows import EMPTY, ROW, FrameRows, in_order, joined, rows_of
from armui.telemetry.series import zeros

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from armui.session.recording.lane import FrameLane

# Keeps the last minutes of all frames on the bus in memory, within a limit.

KEPT_S: Final = 300.0
"""The time for which frames are kept in the ring."""
MOST_BYTES: Final = 22_000_000
"""The ring's size: five minutes at 3,000 frames/s; with more traffic it reaches back less far."""
_SLAB_ROWS: Final = 16_384
"""The ring consists of slabs of this many frames, the oldest of which is dropped as a whole."""
_SLAB_BYTES: Final = _SLAB_ROWS * ROW.itemsize
_LONG_BYTES: Final = 256
"""The most memory for the data of a CAN FD frame, Python's overhead included."""
_MOST_LONG: Final = 2_048
"""The most CAN FD frames of a slab: a slab full of them would be too much to drop at once."""
_LONG_AT_ONCE: Final = 512

_LOG: Final = logging.getLogger(__name__)

LOOK_S: Final = 0.1
"""The period at which the collector takes out waiting frames."""
_YOUNG_S: Final = 0.05
"""Sent and received frames come in two ways: a younger frame may still have to be sorted in."""

Sink = Callable[[FrameRows], None]
"""Receives frames in the order of time; it must not block."""


@dataclass(slots=True)
class _Slab:
    """Rows that are only added, never changed: reading known ones needs no lock."""

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
    """The last frames in memory; written by one thread, read by any.

    Args:
        keep_s: The time for which frames are kept, by their own times.
        most_bytes: The most memory it takes, whatever the traffic.
    """

    def __init__(self, keep_s: float = KEPT_S, most_bytes: int = MOST_BYTES) -> None:
        self.keep_s = keep_s
        least = 2 * (_SLAB_BYTES + _LONG_BYTES * (_MOST_LONG + _LONG_AT_ONCE))
        self.most_bytes = max(most_bytes, least)
        self._slabs: deque[_Slab] = deque()
        self._bytes = 0
        self._lock = threading.Lock()

    def append(self, rows: FrameRows) -> None:
        """Add frames; the oldest are dropped."""
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
        """Drop the oldest slabs: those too old, and those beyond the memory limit."""
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

    def clear(self) -> None:
        """Drop all frames."""
        with self._lock:
            self._slabs.clear()
            self._bytes = 0

    @property
    def bytes_kept(self) -> int:
        """The memory in use, in bytes."""
        return self._bytes

    def snapshot(self) -> list[FrameRows]:
        """Return all kept frames, the oldest first, not copied; later frames are not in it."""
        with self._lock:
            parts = [slab.rows() for slab in self._slabs if slab.count]
        if not parts:
            return []
        oldest_s = float(parts[-1].times_s[-1]) - self.keep_s
        first = parts[0]
        begin = int(first.times_s.searchsorted(oldest_s))
        return [first.part(begin, len(first)), *parts[1:]]

    def span(self) -> tuple[int, float]:
        """Return the number of kept frames, and the seconds from the first to the last."""
        parts = self.snapshot()
        if not parts:
            return 0, 0.0
        frames = sum(map(len, parts))
        return frames, float(parts[-1].times_s[-1] - parts[0].times_s[0]) if frames else 0.0


class Sorter:
    """Merges frames that come in two ways into the order of time.

    Attributes:
        late: The number of frames that came after younger ones had been passed on; they got the
            time of those.
    """

    def __init__(self) -> None:
        self._young = EMPTY
        self._last_s = -np.inf
        self.late = 0

    def sort(self, rows: FrameRows, *, everything: bool = False) -> FrameRows:
        """Return the frames that can be passed on by now.

        Args:
            rows: The frames since the last call.
            everything: True to hold nothing back.
        """
        before = self._young
        rows = in_order(joined([before, rows]))
        if not len(rows):
            return EMPTY
        newest_s = float(rows.times_s[-1])
        until_s = newest_s - _YOUNG_S
        if len(before):
            until_s = max(until_s, float(before.times_s[-1]))
        end = len(rows) if everything else int(rows.times_s.searchsorted(until_s, "right"))
        if end == 0:
            self._young = rows
            return EMPTY
        self._young = rows.part(end, len(rows))
        return self._put_right(rows.part(0, end))

    def _put_right(self, rows: FrameRows) -> FrameRows:
        if rows.times_s[0] < self._last_s:
            table = rows.table.copy()
            self.late += int((table["time_s"] < self._last_s).sum())
            np.maximum(table["time_s"], self._last_s, out=table["time_s"])
            rows = FrameRows(table, rows.long_data)
        self._last_s = float(rows.times_s[-1])
        return rows


class Collector:
    """Feeds the ring, and the recordings in progress.

    Args:
        lane: The source of frames.
        ring: Keeps the last minutes.
    """

    def __init__(self, lane: FrameLane, ring: FrameRing) -> None:
        self._lane = lane
        self._ring = ring
        self._sorter = Sorter()
        self._sinks: tuple[Sink, ...] = ()
        self._leaving: deque[tuple[Sink, Callable[[], None]]] = deque()
        self._turn = threading.Lock()
        self._wake = threading.Event()
        self._ending = False
        self._thread: threading.Thread | None = None

    @property
    def late(self) -> int:
        """The number of frames whose time was corrected; see `Sorter`."""
        return self._sorter.late

    def start(self) -> None:
        """Start the thread, unless it runs."""
        if self._thread is None:
            self._ending = False
            self._thread = threading.Thread(target=self._run, name="armui-ring", daemon=True)
            self._thread.start()

    def end(self) -> None:
        """End the thread after passing on the waiting frames."""
        thread, self._thread = self._thread, None
        if thread is not None:
            self._ending = True
            self._wake.set()
            thread.join()

    def add(self, sink: Sink) -> None:
        """Pass frames to a sink from now on."""
        with self._turn:
            self._sinks = (*self._sinks, sink)

    def remove(self, sink: Sink, then: Callable[[], None] = lambda: None) -> None:
        """Pass on the frames up to now, and then no more.

        Args:
            sink: The sink that was added.
            then: Called afterwards, in the collector's thread if it runs.
        """
        self._leaving.append((sink, then))
        if self._thread is None:
            self.collect(everything=True)
            self._remove_sinks()
        else:
            self._wake.set()

    def collect(self, *, everything: bool = False) -> None:
        """Pass on waiting frames; the thread does so ten times a second, others may, too."""
        with self._turn:
            rows = self._sorter.sort(rows_of(self._lane.take_frames()), everything=everything)
            if not len(rows):
                return
            self._ring.append(rows)
            for sink in self._sinks:
                sink(rows)

    def _remove_sinks(self) -> None:
        while self._leaving:
            sink, then = self._leaving.popleft()
            with self._turn:
                self._sinks = tuple(each for each in self._sinks if each != sink)
            then()

    def _run(self) -> None:
        while not self._ending:
            self._wake.wait(LOOK_S)
            self._wake.clear()
            leaving = bool(self._leaving)
            self._collect_safely(everything=leaving)
            if leaving:
                self._remove_sinks()
        self._collect_safely(everything=True)
        self._remove_sinks()

    def _collect_safely(self, *, everything: bool = False) -> None:
        try:
            self.collect(everything=everything)
        except Exception:  # noqa: BLE001 - whatever it was: what comes next is kept
            _LOG.exception("Frames were not kept")
