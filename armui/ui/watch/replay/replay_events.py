"""The events of a recording in the same rows and words as live; a click goes to one."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QItemSelectionModel, Qt, QTimer, Signal
from PySide6.QtWidgets import QAbstractItemView, QWidget

from armui.telemetry.events import EventLog
from armui.ui.actions.keys import listen_for
from armui.ui.theme import colors_of
from armui.ui.watch.events.event_bar import EventBar, EventExport
from armui.ui.watch.events.event_table import EventModel, EventTable, details
from armui.ui.watch.replay.log_time import has_date
from armui.ui.widgets.buttons import named
from armui.ui.widgets.layouts import in_column
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated

if TYPE_CHECKING:
    from PySide6.QtCore import QModelIndex

    from armui.control.arm_controller import ArmController
    from armui.control.events import Level
    from armui.ui.background import Background

_HERE_S: Final = 1e-4
"""An event this near to the present time is the one the operator has gone to."""
_DETAIL_LINES: Final = 4


class ReplayEventBar(EventBar):
    """An event bar that follows the replay instead of the newest event."""

    def _follow_text(self) -> str:
        return self.tr("Follow the replay")

    def _follow_tip(self) -> str:
        return self.tr("Keep the event of the moment that is shown in sight")


class ReplayEvents(Translated, QWidget):
    """Shows the events; the last one before the replay's time is highlighted.

    Args:
        live: The controller of the connected arm, for the stop in file choosers.
        background: Writes files.

    Signals:
        wanted: The log time to go to.
    """

    wanted = Signal(float)

    def __init__(self, live: ArmController, background: Background) -> None:
        super().__init__()
        self._at_s = 0.0
        self.model = EventModel(EventLog(), colors_of(self))
        self.bar = ReplayEventBar()
        self.table = named("replay_events", EventTable(self.model))
        self.export = EventExport(live, background, self)
        self.detail = text_label("replay_event_detail", wraps=True, plain=True)
        self.detail.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.detail.setAlignment(Qt.AlignmentFlag.AlignTop | Qt.AlignmentFlag.AlignLeft)
        self.message = MessageLine(keeps_room=False)
        parts = (self.bar, (self.table, 1), self.detail, self.message)
        in_column(*parts, on=self, margins=(8, 8, 8, 6))
        self._connect()
        self.retranslate_ui()

    def _connect(self) -> None:
        self.bar.filter_changed.connect(self.model.set_filter)
        self.bar.follow_changed.connect(self._on_follow)
        self.bar.save.wanted.connect(lambda kind: self.export.save(kind, self.model.entries()))
        self.export.message_changed.connect(self._show_message)
        self.table.clicked.connect(self._on_chosen)
        self.table.activated.connect(self._on_chosen)
        self.table.selectionModel().currentRowChanged.connect(self._show_detail)
        self.table.verticalScrollBar().actionTriggered.connect(self._on_scrolled)
        self.model.modelReset.connect(self._on_reset)
        self.model.dataChanged.connect(self._show_detail)
        listen_for("replay.copy", self.table, self.copy_chosen, Qt.ShortcutContext.WidgetShortcut)

    def show_log(self, log: EventLog) -> None:
        """Show events in the order of time."""
        self.model.show_log(log)

    # The replay's position --------------------------------------------------------------------

    def show_position(self, at_s: float) -> None:
        """Set the replay's time."""
        self._at_s = at_s
        if self.isVisible() and self.bar.follow.isChecked():
            self._light()

    def _light(self) -> None:
        """Select the last event before the replay's time, and scroll to it."""
        row = self.model.row_at(self._at_s + _HERE_S)
        current = self.table.currentIndex().row()
        if row is None:
            if current >= 0:
                self.table.setCurrentIndex(self.model.index(-1, -1))
                self.table.clearSelection()
            return
        if current >= 0 and self._is_here(current, row):
            return  # keep the operator's choice among events of the same time
        flags = QItemSelectionModel.SelectionFlag
        index = self.model.index(row, 0)
        self.table.selectionModel().setCurrentIndex(index, flags.ClearAndSelect | flags.Rows)
        self.table.scrollTo(index, QAbstractItemView.ScrollHint.PositionAtCenter)

    def _is_here(self, current: int, row: int) -> bool:
        if current == row:
            return True
        lit_s, last_s = self.model.entry(current).at_s, self.model.entry(row).at_s
        return current < row and last_s - lit_s <= _HERE_S

    def _on_reset(self) -> None:
        self.bar.show_count(self.model.rowCount(), self.model.kept)
        if self.bar.follow.isChecked():
            self._light()
        self._show_detail()

    def _show_detail(self) -> None:
        entry = self.table.current()
        lines = [] if entry is None else details(entry, dated=has_date(entry.at_s))
        text = "\n".join(lines)
        if self.detail.text() != text:
            self.detail.setText(text)

    # What the operator does -------------------------------------------------------------------

    def _on_chosen(self, index: QModelIndex) -> None:
        self.wanted.emit(self.model.entry(index.row()).at_s)

    def _on_follow(self, on: bool) -> None:
        if on:
            self._light()

    def _on_scrolled(self) -> None:
        """Follow the replay only while its event is scrolled into sight."""
        # actionTriggered comes before the bar has moved
        QTimer.singleShot(0, self, self._follow_what_is_seen)

    def _follow_what_is_seen(self) -> None:
        seen = (
            self.table.viewport()
            .rect()
            .intersects(self.table.visualRect(self.table.currentIndex()))
        )
        self.bar.follow.setChecked(seen)

    def copy_chosen(self) -> None:
        """Copy the selected rows."""
        entries = self.table.chosen()
        if entries:
            self.export.copy(entries)

    def _show_message(self, text: str, level: Level) -> None:
        self.message.show_message(text, level)

    # Appearance -------------------------------------------------------------------------------

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.table.setAccessibleName(self.tr("Events of the log"))
        self.table.setToolTip(self.tr("Click: show this moment"))
        self.model.retranslate()
        self.table.fit_columns()
        height = _DETAIL_LINES * self.detail.fontMetrics().lineSpacing() + 8
        self.detail.setFixedHeight(height)
        self.bar.show_count(self.model.rowCount(), self.model.kept)
        self._show_detail()

    def _recolor(self) -> None:
        self.model.recolor(colors_of(self))
