"""The table of events: its columns, as wide as their words."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QTableView

from armui.telemetry.events import Asker, EventKind
from armui.ui.watch.events.event_cells import EventColumn, column_title
from armui.ui.widgets.plain_table import list_rows
from armui.ui.words import event_log as words

if TYPE_CHECKING:
    from PySide6.QtGui import QResizeEvent

    from armui.telemetry.events import EventEntry
    from armui.ui.watch.events.event_model import EventModel

_ROW_PX: Final = 28
_SAMPLES: Final = {
    EventColumn.BEGIN: "00:00:00.000",
    EventColumn.END: "00:00:00.000",
    EventColumn.ANSWER: "✓ 00.00 s",
    EventColumn.RESULT: "✓ 00.00 s",
    EventColumn.COUNT: "× 00,000",
}
_SIGN_PX: Final = 26
_PAD_PX: Final = 22
_TEXT_PX: Final = 240
"""What happened is read without opening it; less is what goes first, where there is no room."""
_GOES_FIRST: Final = (EventColumn.END, EventColumn.COUNT)
"""Both are told below the table, too."""


class EventTable(QTableView):
    """Shows events.

    Args:
        model: The events.
    """

    def __init__(self, model: EventModel) -> None:
        super().__init__()
        self._events = model
        self._widths: dict[EventColumn, int] = {}
        self.setObjectName("event_table")
        self.setModel(model)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setAlternatingRowColors(True)
        self.setWordWrap(False)
        down = self.verticalHeader()
        down.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        down.setDefaultSectionSize(_ROW_PX)
        list_rows(self).setSectionResizeMode(EventColumn.TEXT, QHeaderView.ResizeMode.Stretch)

    def chosen(self) -> list[EventEntry]:
        """The rows that are selected, from top to bottom."""
        rows = sorted(index.row() for index in self.selectionModel().selectedRows())
        return [self._events.entry(row) for row in rows]

    def current(self) -> EventEntry | None:
        """The row that was chosen last."""
        index = self.selectionModel().currentIndex()
        return self._events.entry(index.row()) if index.isValid() else None

    def fit_columns(self) -> None:
        """Wide enough for every word there is, so that nothing moves while events come."""
        metrics, across = self.fontMetrics(), self.horizontalHeader()
        texts = {
            **{column: [sample] for column, sample in _SAMPLES.items()},
            EventColumn.KIND: [words.event_kind(kind) for kind in EventKind],
            EventColumn.WHO: [words.asker(who) for who in Asker],
        }
        for column, samples in texts.items():
            widest = max(metrics.horizontalAdvance(t) for t in (*samples, column_title(column)))
            sign = _SIGN_PX if column is EventColumn.BEGIN else 0
            self._widths[column] = widest + sign + _PAD_PX
            across.resizeSection(column, self._widths[column])
        self._share_room()

    def _share_room(self) -> None:
        """Show as many columns as leave what happened readable."""
        if not self._widths:
            return
        room_px = self.viewport().width() - sum(self._widths.values())
        for column in _GOES_FIRST:
            narrow = room_px < _TEXT_PX
            self.setColumnHidden(column, narrow)
            room_px += self._widths[column] if narrow else 0

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Share the new room."""
        self._share_room()
        super().resizeEvent(event)
