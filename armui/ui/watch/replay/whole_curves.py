"""The curves of a whole recording, with a cursor at the replay's time."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QWidget

from armui.control.events import Level
from armui.ui.watch.curves_item import Missing
from armui.ui.watch.plot_layout import SETS
from armui.ui.watch.plots_area import PlotsArea
from armui.ui.widgets.layouts import in_column

if TYPE_CHECKING:
    from PySide6.QtGui import QShowEvent

    from armui.control.arm_controller import ArmController
    from armui.control.log_replay import LogReplay
    from armui.ui.background import Background

LONGEST_S: Final = 3600.0
"""The longest stretch, the last hour of a recording: an hour of an arm takes 272 MB at most."""
_LEAST_S: Final = 0.05


class WholeCurves(QWidget):
    """Curves that are read when first shown; the cursor follows the replay, and can be dragged.

    Args:
        replay: The replay.
        live: The controller of the connected arm, for the stop in file choosers.
        background: Writes files.

    Attributes:
        area: The plots; ``None`` before they are first shown.

    Signals:
        wanted: The log time to go to.
    """

    wanted = Signal(float)
    _read = Signal()

    def __init__(self, replay: LogReplay, live: ArmController, background: Background) -> None:
        super().__init__()
        self._replay = replay
        self._live = live
        self._background = background
        self._at_s = replay.session.start_s
        self.area: PlotsArea | None = None
        self._column = in_column(on=self, margins=(8, 8, 8, 6))
        self._read.connect(self._on_read)

    @property
    def is_loading(self) -> bool:
        """True if some curves are still being read."""
        history = self._replay.whole
        return history is not None and not history.is_over

    def showEvent(self, event: QShowEvent) -> None:
        """Start reading the curves."""
        super().showEvent(event)
        if self.area is None:
            self._begin()
        self.show_position(self._replay.position_s)

    def _begin(self) -> None:
        history = self._replay.read_whole(LONGEST_S, self._read.emit)
        area = self.area = PlotsArea(history.telemetry, self._live, self._background)
        board = area.board
        board.show_plots(SETS["follow"])
        board.frame.stand(history.end_s, max(history.end_s - history.begin_s, _LEAST_S))
        board.cursors_changed.connect(self._on_cursors)
        # the plots stand still; their cursor is the replay's time, at which values are shown
        board.values_at_cursor = True
        area.cursor_table.is_wanted = False
        area.bar.pause.hide()
        area.bar.cursors.hide()
        area.bar.refresh()
        self._column.addWidget(area)
        if history.begin_s > self._replay.session.start_s:
            area.show_message(self.tr("The log is long: its last hour is shown."), Level.INFO)

    def show_position(self, at_s: float) -> None:
        """Set the replay's time."""
        area, history = self.area, self._replay.whole
        if area is None or history is None or not self.isVisible():
            return
        board = area.board
        if self.is_loading:
            share = (history.reached_s - history.begin_s) / (history.end_s - history.begin_s)
            text = self.tr("Loading: {percent} %").format(percent=round(100.0 * share))
            board.show_missing(Missing(history.reached_s, history.end_s, text))
            board.draw_soon()
        if board.cursors_s[0] != at_s:
            self._at_s = board.cursors_s[0] = at_s
            board.draw_soon()

    def _on_cursors(self) -> None:
        """The operator has moved the cursor."""
        cursor_s = None if self.area is None else self.area.board.cursors_s[0]
        if cursor_s is not None and cursor_s != self._at_s:
            self._at_s = cursor_s
            self.wanted.emit(cursor_s)

    def _on_read(self) -> None:
        if self.area is not None:
            self.area.board.show_missing(None)
            self.area.board.draw_soon()
