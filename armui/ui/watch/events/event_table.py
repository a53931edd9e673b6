"""The table of events: its rows and cells, its columns as wide as their texts."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any, Final

from PySide6.QtCore import QCoreApplication, QModelIndex, Qt, QTimer
from PySide6.QtGui import QColor, QFont
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QTableView

from armui.telemetry.events import Asker, EventEntry, EventKind, EventOutcome, Level
from armui.ui import format as fmt
from armui.ui.format import NOTHING
from armui.ui.theme import Colors
from armui.ui.watch.events.event_filter import EventFilter, gravity
from armui.ui.widgets import icons
from armui.ui.widgets.table_model import (
    Index,
    TableModel,
    ViewColumn,
    ViewColumns,
    chosen_rows,
    list_rows,
)
from armui.ui.words import event_log as words
from armui.ui.words.text import Text

if TYPE_CHECKING:
    from PySide6.QtGui import QResizeEvent

    from armui.telemetry.events import EventLog


def _end(entry: EventEntry) -> str:
    if not entry.lasts:
        return ""
    if entry.ended_s is None:
        return QCoreApplication.translate("EventTable", "ongoing")
    if entry.unheard:
        return QCoreApplication.translate("EventTable", "not heard")
    return clock_text(entry, entry.ended_s)


_Column = ViewColumn[Callable[[EventEntry], str]]


class EventColumn(ViewColumns):
    """The columns; that of what happened takes the rest of the width."""

    BEGIN = _Column("Time", lambda entry: clock_text(entry, entry.at_s), sample="00:00:00.000")
    END = _Column("Until", _end, sample="00:00:00.000")
    KIND = _Column("Kind", lambda entry: words.event_kind(entry.kind))
    WHO = _Column("Who", lambda entry: words.asker(entry.who))
    TEXT = _Column("Event", words.entry_text)
    ANSWER = _Column("Answer", lambda entry: _outcome(entry, entry.answer), sample="✓ 00.00 s")
    RESULT = _Column("Read back", lambda entry: _outcome(entry, entry.result), sample="✓ 00.00 s")
    COUNT = _Column(
        "Count", lambda entry: f"× {entry.count}" if entry.count > 1 else "", sample="× 00,000"
    )


_GOOD: Final = "✓"
_BAD: Final = "✗"
_CUT: Final = "⚠"


def clock_text(entry: EventEntry, at_s: float) -> str:
    """Return the time of day at a moment of an event."""
    at = entry.wall_at(at_s)
    return f"{at:%H:%M:%S}.{at.microsecond // 1000:03d}"


def search_text(entry: EventEntry) -> str:
    """Return all text of an event, in lower case."""
    parts = [column.read(entry) for column in EventColumn]
    parts += [words.outcome_text(each) for each in (entry.answer, entry.result) if each is not None]
    return " ".join([*parts, entry.code]).casefold()


def details(entry: EventEntry, *, dated: bool = True) -> list[str]:
    """Return all facts on an event, line by line.

    Args:
        entry: The event.
        dated: True if the day is known; a log may only hold times since its beginning.
    """
    begin, last = clock_text(entry, entry.at_s), entry.newest_s
    begin = f"{entry.wall:%Y-%m-%d} {begin}" if dated else begin
    when = begin
    if entry.ended_s is not None:
        text = QCoreApplication.translate("EventTable", "{begin} until {end} ({duration})")
        when = text.format(
            begin=begin,
            end=clock_text(entry, entry.ended_s),
            duration=fmt.duration(max(0.0, entry.ended_s - entry.at_s), 3),
        )
        if entry.unheard:
            when += QCoreApplication.translate("EventTable", "; its end was not heard")
    elif entry.lasts:
        when = QCoreApplication.translate("EventTable", "since {begin}").format(begin=begin)
    if entry.count > 1:
        text = QCoreApplication.translate("EventTable", "{count} times, the last at {last}")
        when += "; " + text.format(count=entry.count, last=clock_text(entry, last))
    sorts = (words.event_level(entry.level), words.event_kind(entry.kind), words.asker(entry.who))
    head = " · ".join([when, *dict.fromkeys(sorts)])
    lines = [words.entry_text(entry), head]
    for said, outcome in (
        (Text("EventTable", "Answer after {seconds} s: {text}"), entry.answer),
        (Text("EventTable", "Read back after {seconds} s: {text}"), entry.result),
    ):
        if outcome is not None:
            after = f"{_after_s(entry, outcome):.3f}"
            lines.append(said.text().format(seconds=after, text=words.outcome_text(outcome)))
    return lines


def _after_s(entry: EventEntry, outcome: EventOutcome) -> float:
    return max(0.0, outcome.at_s - entry.newest_s)


def _outcome(entry: EventEntry, outcome: EventOutcome | None) -> str:
    if outcome is None:
        return NOTHING if entry.kind == "command" else ""
    sign = {Level.FAULT: _BAD, Level.DONE: _GOOD}.get(outcome.level, _CUT)
    return f"{sign} {_after_s(entry, outcome):.2f} s"


_ROW_PX: Final = 24
_SIGN_PX: Final = 26
_PAD_PX: Final = 22
_TEXT_PX: Final = 240
"""The least width of the event's text; the columns below give way to it if there is no room."""
_GOES_FIRST: Final = (EventColumn.END, EventColumn.COUNT)
"""The columns hidden first; their content is shown beside the table, too."""
_AT_ONCE: Final = 200
"""The number of entries searched in one go, in some 3 ms."""
_ICON_PX: Final = 16
_MUTED: Final = frozenset({EventColumn.KIND, EventColumn.WHO, EventColumn.COUNT})


class EventModel(TableModel):
    """Follows a log when asked to; its owner decides how often.

    Args:
        log: The log.
        colors: The colours of the theme.
    """

    _table = tuple(EventColumn)
    _columns = len(EventColumn)

    def __init__(self, log: EventLog, colors: Colors) -> None:
        super().__init__()
        self._log = log
        self._revision = 0
        self._filter = EventFilter()
        self._rows: list[EventEntry] = []
        self._texts: dict[int, tuple[EventEntry, str]] = {}
        self._search: Iterator[list[EventEntry] | None] | None = None
        self._searching = QTimer(self, interval=0)
        self._searching.timeout.connect(self._search_on)
        self.recolor(colors)
        self._rebuild()

    # What is shown ----------------------------------------------------------------------------

    @property
    def filter(self) -> EventFilter:
        """The present filter."""
        return self._filter

    @property
    def searching(self) -> bool:
        """True while entries are being searched; the rows are still the old ones."""
        return self._search is not None

    @property
    def kept(self) -> int:
        """The number of entries in the log, shown or not."""
        return self._log.newest - self._log.oldest + 1

    def set_filter(self, wanted: EventFilter) -> None:
        """Search the log again by another filter; the old rows stay until that is done."""
        if wanted != self._filter:
            self._filter = wanted
            self._rebuild()

    def entry(self, row: int) -> EventEntry:
        """Return the event of a row."""
        return self._rows[row]

    def entries(self) -> list[EventEntry]:
        """Return all events shown."""
        return list(self._rows)

    def row_of(self, number: int) -> int | None:
        """Return the row of an entry, or ``None`` if it is not shown."""
        row = bisect_left(self._rows, number, key=_number)
        there = row < len(self._rows) and self._rows[row].number == number
        return row if there else None

    def row_at(self, at_s: float) -> int | None:
        """Return the last row at or before a time, for a log in the order of time, or ``None``."""
        row = bisect_right(self._rows, at_s, key=_begin_s) - 1
        return row if row >= 0 else None

    def show_log(self, log: EventLog) -> None:
        """Show the events of another log, under the present filter."""
        self._log = log
        self._texts.clear()
        self._rebuild()

    def follow(self) -> bool:
        """Add new events, and return whether there were any."""
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
        """Yield ``None`` after each piece of the search, and at last the entries that pass."""
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

    # The model's interface for Qt -------------------------------------------------------------

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """Return the text of a cell, or its looks."""
        entry, column = self._rows[index.row()], self._table[index.column()]
        if role in {Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.ToolTipRole}:
            return column.read(entry)
        if role == Qt.ItemDataRole.ForegroundRole:
            return self._ink(entry, column)
        if role == Qt.ItemDataRole.DecorationRole and column is EventColumn.BEGIN:
            return self._icons[gravity(entry)]
        if role == Qt.ItemDataRole.FontRole and entry.goes_on and entry.level is Level.FAULT:
            return self._bold
        return None

    def _ink(self, entry: EventEntry, column: int) -> QColor | None:
        if column == EventColumn.RESULT and entry.result is not None:
            return self._inks.get(entry.result.level)
        if column in {EventColumn.TEXT, EventColumn.END, EventColumn.BEGIN}:
            return self._inks.get(entry.level) if entry.level is not Level.DONE else None
        return self._faint if column in _MUTED else None

    def recolor(self, colors: Colors) -> None:
        """Apply the colours of a theme."""
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
        """Update all texts after a change of language."""
        self._texts.clear()
        if self._filter.words:
            self._rebuild()
        super().retranslate()


def _number(entry: EventEntry) -> int:
    return entry.number


def _begin_s(entry: EventEntry) -> float:
    return entry.at_s


class EventTable(QTableView):
    """The table of events; its columns are as wide as their longest texts.

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
        """Return the selected rows, from top to bottom."""
        return [self._events.entry(row) for row in chosen_rows(self)]

    def current(self) -> EventEntry | None:
        """Return the row selected last, or ``None``."""
        index = self.selectionModel().currentIndex()
        return self._events.entry(index.row()) if index.isValid() else None

    def fit_columns(self) -> None:
        """Set the widths for the longest texts, so that nothing moves while events come."""
        metrics, across = self.fontMetrics(), self.horizontalHeader()
        texts = {
            **{each: [each.declared.sample] for each in EventColumn if each.declared.sample},
            EventColumn.KIND: [words.event_kind(kind) for kind in EventKind],
            EventColumn.WHO: [words.asker(who) for who in Asker],
        }
        for column, samples in texts.items():
            widest = max(metrics.horizontalAdvance(t) for t in (*samples, column.title))
            sign = _SIGN_PX if column is EventColumn.BEGIN else 0
            self._widths[column] = widest + sign + _PAD_PX
            across.resizeSection(column, self._widths[column])
        self._share_room()

    def _share_room(self) -> None:
        """Hide columns until the text of the event has enough width."""
        if not self._widths:
            return
        room_px = self.viewport().width() - sum(self._widths.values())
        for column in _GOES_FIRST:
            narrow = room_px < _TEXT_PX
            self.setColumnHidden(column, narrow)
            room_px += self._widths[column] if narrow else 0

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Distribute the new width."""
        self._share_room()
        super().resizeEvent(event)
