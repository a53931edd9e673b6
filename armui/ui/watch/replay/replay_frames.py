"""The frames of a recording around the present time; a click goes to one."""

from __future__ import annotations

import math
from functools import partial
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QWidget

from armui.arm.refusal import Refusal
from armui.control.events import Level
from armui.ui import words
from armui.ui.background import Job
from armui.ui.watch.bus.bus_page import TraceList
from armui.ui.watch.bus.frame_model import FrameTexts
from armui.ui.watch.bus.trace_model import TraceModel
from armui.ui.watch.replay.log_time import moment
from armui.ui.widgets.layouts import in_column
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.translated import Translated

if TYPE_CHECKING:
    from PySide6.QtGui import QShowEvent

    from armui.control.log_replay import LogReplay
    from armui.telemetry.bus_statistics import BusStatistics
    from armui.telemetry.bus_trace import TraceSnapshot
    from armui.ui.background import Background
    from armui.ui.widgets.table_model import Index

_SAME_S: Final = 1e-6
"""Times nearer than this are equal but for rounding."""
_SOON_S: Final = 0.05
"""More frames are read when the time is this near to the end of those loaded."""


class ReplayFrames(Translated, QWidget):
    """The frames around the present time, in order; a click goes to one.

    Args:
        replay: The replay.
        background: Reads the log.

    Signals:
        wanted: The log time to go to.
    """

    wanted = Signal(float)

    def __init__(self, replay: LogReplay, background: Background) -> None:
        super().__init__()
        self._replay = replay
        self._background = background
        self._texts = FrameTexts()
        self.model = TraceModel(self._texts, lambda at_s: moment(at_s).rpartition(" ")[2], self)
        self.table = TraceList(self.model)
        self.message = MessageLine(keeps_room=False)
        self._trace: TraceSnapshot | None = None
        self._between_s = (math.inf, -math.inf)
        self._job: Job[tuple[BusStatistics, float, float]] | None = None
        self._at_s = math.nan
        in_column((self.table, 1), self.message, on=self, margins=(8, 8, 8, 6))
        self.table.clicked.connect(self._on_chosen)
        self.table.activated.connect(self._on_chosen)
        self.retranslate_ui()

    def show_position(self, at_s: float) -> None:
        """Set the replay's time."""
        if not self.isVisible() or at_s == self._at_s:
            return
        session, (begin_s, end_s) = self._replay.session, self._between_s
        # frames after the loaded ones are read shortly before the time gets there
        if begin_s <= at_s <= end_s:
            self._at_s = at_s
            self._light()
        near = begin_s <= at_s <= max(begin_s, min(end_s, session.end_s) - _SOON_S)
        if self._job is None and not (near or (begin_s <= at_s and end_s >= session.end_s)):
            self._job = Job(self._on_read)
            self._background.begin_here(self._job, self._replay.read_around, at_s)

    def _on_read(self, read: tuple[BusStatistics, float, float] | Refusal) -> None:
        self._job = None
        if isinstance(read, Refusal):
            self._between_s = (-math.inf, math.inf)  # the same read would fail again
            self.message.show_message(partial(words.refusal, read), Level.FAULT)
            return
        statistics, begin_s, end_s = read
        self._texts.speak(statistics.codec)
        self._between_s = begin_s, end_s
        self._trace = statistics.trace.snapshot()
        self.model.show_trace(self._trace)
        self._at_s = math.nan
        self.show_position(self._replay.position_s)

    def _light(self) -> None:
        """Select the last frame before the replay's time, and keep it in sight."""
        trace = self._trace
        if trace is None or not len(trace):
            return
        row = int(trace.times_s.searchsorted(self._at_s + _SAME_S, side="right")) - 1
        current = self.table.currentIndex().row()
        if 0 <= current < len(trace) and abs(trace.times_s[current] - self._at_s) < _SAME_S:
            return  # keep the operator's choice among frames of the same time
        index = self.model.index(max(row, 0), 0)
        self.table.setCurrentIndex(index)
        self.table.scrollTo(index, TraceList.ScrollHint.PositionAtCenter)

    def _on_chosen(self, index: Index) -> None:
        if self._trace is not None:
            self.wanted.emit(float(self._trace.times_s[index.row()]))

    def end(self) -> None:
        """Cancel reading, because the log is about to be closed."""
        if self._job is not None:
            self._job.wanted = False

    def showEvent(self, event: QShowEvent) -> None:
        """Load the frames at the present time."""
        super().showEvent(event)
        self._at_s = math.nan
        self.show_position(self._replay.position_s)

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.table.setAccessibleName(self.tr("Frames around the moment that is shown"))
        self.table.setToolTip(self.tr("Click: show this moment"))
        self._texts.retranslate()
        self.model.retranslate()
