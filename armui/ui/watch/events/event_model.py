"""The rows of the page 事件: the log's entries that pass the filter, the oldest first."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, Final

from PySide6.QtCore import QModelIndex, Qt, QTimer
from PySide6.QtGui import QColor, QFont

from armui.telemetry.events import EventEntry, Level
from armui.ui.theme import Colors
from armui.ui.watch.events.event_cells import (
    EventColumn,
    cell_text,
    column_title,
    search_text,
)
from armui.ui.watch.events.event_filter import EventFilter, gravity
from armui.ui.widgets import icons
from armui.ui.widgets.table_model import Index, TableModel

if TYPE_CHECKING:
    from armui.telemetry.events import EventLog

_AT_ONCE: Final = 200
"""So many entries are searched before the window gets its turn again: some 3 ms."""
_ICON_PX: Final = 16
_MUTED: Final = frozenset({EventColumn.KIND, EventColumn.WHO, EventColumn.COUNT})


class EventModel(TableModel):
    """Follows a log when it is told to; whoever shows it decides how often.

    Args:
        log: What has happened.
        colors: Of the theme.
    """

    _columns = len(EventColumn)

    def __init__(self, log: EventLog, colors: Colors) -> None:
        super().__init__()
        self._log = log
        self._revision = 0
        self._filter = EventFilter()
        self._rows: list[EventEntry] = []
        self._texts: dict[int, tuple[EventEntry, str]] = {}
        self._search: Iterator[list[EventEntry] | None] | None = None
        self._searching = QTimer(self)
        self._searching.setInterval(0)
        self._searching.timeout.connect(self._search_on)
        self.recolor(colors)
        self._rebuild()

    # What is shown ----------------------------------------------------------------------------

    @property
    def filter(self) -> EventFilter:
        """What the operator wants to see."""
        return self._filter

    @property
    def searching(self) -> bool:
        """Whether entries are looked through for words: the rows are those of before."""
        return self._search is not None

    @property
    def kept(self) -> int:
        """How many entries the log has, shown or not."""
        return self._log.newest - self._log.oldest + 1

    def set_filter(self, wanted: EventFilter) -> None:
        """Show others."""
        if wanted != self._filter:
            self._filter = wanted
            self._rebuild()

    def entry(self, row: int) -> EventEntry:
        """What a row shows."""
        return self._rows[row]

    def entries(self) -> list[EventEntry]:
        """All that is shown."""
        return list(self._rows)

    def row_of(self, number: int) -> int | None:
        """Where an entry stands; ``None``: it is not shown."""
        row = bisect_left(self._rows, number, key=_number)
        there = row < len(self._rows) and self._rows[row].number == number
        return row if there else None

    def row_at(self, at_s: float) -> int | None:
        """The last row at or before a time, of a log in the order of time; ``None``: no row."""
        row = bisect_right(self._rows, at_s, key=_begin_s) - 1
        return row if row >= 0 else None

    def show_log(self, log: EventLog) -> None:
        """Show another log."""
        self._log = log
        self._texts.clear()
        self._rebuild()

    def follow(self) -> bool:
        """Take in what is new; whether anything was."""
        if self._search is not None or self._log.revision == self._revision:
            return False
        self._revision, changed = self._log.since(self._revision)
        for entry in changed:
            self._take(entry)
        self._drop_oldest()
        return True

    def _take(self, entry: EventEntry) -> None:
        row = self.row_of(entry.number)
        passes = self._filter.passes(entry, self._text)
        if row is not None and passes:
            self._rows[row] = entry
            self.dataChanged.emit(self.index(row, 0), self.index(row, len(EventColumn) - 1))
        elif row is not None:
            self.beginRemoveRows(QModelIndex(), row, row)
            del self._rows[row]
            self.endRemoveRows()
        elif passes:
            row = bisect_left(self._rows, entry.number, key=_number)
            self.beginInsertRows(QModelIndex(), row, row)
            self._rows.insert(row, entry)
            self.endInsertRows()

    def _drop_oldest(self) -> None:
        gone = bisect_left(self._rows, self._log.oldest, key=_number)
        if gone:
            self.beginRemoveRows(QModelIndex(), 0, gone - 1)
            for entry in self._rows[:gone]:
                self._texts.pop(entry.number, None)
            del self._rows[:gone]
            self.endRemoveRows()

    # Searching, in pieces ---------------------------------------------------------------------

    def _rebuild(self) -> None:
        self._search = self._found()
        self._search_on()
        if self._search is not None:
            self._searching.start()

    def _found(self) -> Iterator[list[EventEntry] | None]:
        """The entries that pass, and ``None`` for each piece of the way there."""
        revision, entries = self._log.snapshot()
        wanted = self._filter
        if wanted.everything:
            self._revision = revision
            yield entries
            return
        if len(self._texts) > 2 * len(entries):
            self._texts.clear()
        found: list[EventEntry] = []
        step = _AT_ONCE if wanted.words else len(entries) + 1
        for first in range(0, len(entries), step):
            if first:
                yield None
            piece = entries[first : first + step]
            found += [each for each in piece if wanted.passes(each, self._text)]
        self._revision = revision
        yield found

    def _search_on(self) -> None:
        found = None if self._search is None else next(self._search)
        if found is not None:
            self._search = None
            self._searching.stop()
            self.beginResetModel()
            self._rows = found
            self.endResetModel()

    def _text(self, entry: EventEntry) -> str:
        known = self._texts.get(entry.number)
        if known is None or known[0] is not entry:
            known = self._texts[entry.number] = entry, search_text(entry)
        return known[1]

    # What Qt asks -----------------------------------------------------------------------------

    def titles(self) -> list[str]:
        """Of :class:`EventColumn`."""
        return [column_title(column) for column in EventColumn]

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """What stands in a cell, and how it looks."""
        entry, column = self._rows[index.row()], EventColumn(index.column())
        if role == Qt.ItemDataRole.DisplayRole:
            return cell_text(entry, column)
        if role == Qt.ItemDataRole.ForegroundRole:
            return self._ink(entry, column)
        if role == Qt.ItemDataRole.DecorationRole and column is EventColumn.BEGIN:
            return self._icons[gravity(entry)]
        if role == Qt.ItemDataRole.FontRole and entry.goes_on and entry.level is Level.FAULT:
            return self._bold
        return None

    def _ink(self, entry: EventEntry, column: EventColumn) -> QColor | None:
        if column is EventColumn.RESULT and entry.result is not None:
            return self._inks.get(entry.result.level)
        if column in {EventColumn.TEXT, EventColumn.END, EventColumn.BEGIN}:
            return self._inks.get(entry.level) if entry.level is not Level.DONE else None
        return self._faint if column in _MUTED else None

    def recolor(self, colors: Colors) -> None:
        """Take on the colours of a theme."""
        self._inks = {
            Level.DONE: QColor(colors.ok),
            Level.WARNING: QColor(colors.warn),
            Level.FAULT: QColor(colors.stop_ink),
        }
        self._faint = QColor(colors.muted)
        self._bold = QFont()
        self._bold.setBold(True)
        self._icons = {
            Level.INFO: icons.icon("info", colors.muted, _ICON_PX),
            Level.DONE: icons.icon("done", colors.ok, _ICON_PX),
            Level.WARNING: icons.icon("warning", colors.warn, _ICON_PX),
            Level.FAULT: icons.icon("warning", colors.stop_ink, _ICON_PX),
        }
        self.redraw()

    def retranslate(self) -> None:
        """Everything reads otherwise now."""
        self._texts.clear()
        if self._filter.words:
            self._rebuild()
        super().retranslate()


def _number(entry: EventEntry) -> int:
    return entry.number


def _begin_s(entry: EventEntry) -> float:
    return entry.at_s
