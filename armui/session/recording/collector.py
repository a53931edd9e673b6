"""The thread that turns what the bus thread hands over into rows, for the ring and for files."""

from __future__ import annotations

import logging
import threading
from collections import deque
from collections.abc import Callable
from typing import TYPE_CHECKING, Final

import numpy as np

from armui.session.recording.rows import EMPTY, FrameRows, in_order, joined, rows_of

if TYPE_CHECKING:
    from armui.session.recording.lane import FrameLane
    from armui.session.recording.ring import FrameRing

_LOG: Final = logging.getLogger(__name__)

LOOK_S: Final = 0.1
"""How often it takes out what waits."""
_YOUNG_S: Final = 0.05
"""Frames sent and frames heard come by two ways: a younger one may still find its place in time."""

Sink = Callable[[FrameRows], None]
"""Takes frames in the order of time; it must not wait."""


class Sorter:
    """Puts frames that come by two ways into the order of time.

    Attributes:
        late: Frames that came when younger ones had been passed on; they got the time of those.
    """

    def __init__(self) -> None:
        self._young = EMPTY
        self._last_s = -np.inf
        self.late = 0

    def take(self, rows: FrameRows, *, everything: bool = False) -> FrameRows:
        """What can be passed on by now.

        Args:
            rows: What has come since the last call.
            everything: Whether nothing is held back.
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
    """Feeds the ring, and the recordings that are under way.

    Args:
        lane: Where frames come from.
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
        """Frames whose time was put right; see `Sorter`."""
        return self._sorter.late

    def start(self) -> None:
        """Begin, if it has not."""
        if self._thread is None:
            self._ending = False
            self._thread = threading.Thread(target=self._run, name="armui-ring", daemon=True)
            self._thread.start()

    def end(self) -> None:
        """End the thread; what waits is passed on."""
        thread, self._thread = self._thread, None
        if thread is not None:
            self._ending = True
            self._wake.set()
            thread.join()

    def add(self, sink: Sink) -> None:
        """Have frames passed on from now on."""
        with self._turn:
            self._sinks = (*self._sinks, sink)

    def remove(self, sink: Sink, then: Callable[[], None] = lambda: None) -> None:
        """Pass on what has come by now, and no more.

        Args:
            sink: As it was added.
            then: Called afterwards, by the collector's thread where it has one.
        """
        self._leaving.append((sink, then))
        if self._thread is None:
            self.collect(everything=True)
            self._let_go()
        else:
            self._wake.set()

    def collect(self, *, everything: bool = False) -> None:
        """Pass on what has come; its thread does so ten times a second, any other may, too."""
        with self._turn:
            rows = self._sorter.take(rows_of(self._lane.take()), everything=everything)
            if not len(rows):
                return
            self._ring.append(rows)
            for sink in self._sinks:
                sink(rows)

    def _let_go(self) -> None:
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
                self._let_go()
        self._collect_safely(everything=True)
        self._let_go()

    def _collect_safely(self, *, everything: bool = False) -> None:
        try:
            self.collect(everything=everything)
        except Exception:  # noqa: BLE001 - whatever it was: what comes next is kept
            _LOG.exception("Frames were not kept")
