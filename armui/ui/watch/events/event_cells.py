"""An event as the texts of a table's row; for the window, the clipboard and files."""

from __future__ import annotations

from enum import IntEnum
from typing import Final

from PySide6.QtCore import QCoreApplication

from armui.telemetry.events import EventEntry, EventOutcome, Level
from armui.ui.format import NOTHING
from armui.ui.words import event_log as words
from armui.ui.words.text import Texts


class EventColumn(IntEnum):
    """A column of the table."""

    BEGIN = 0
    END = 1
    KIND = 2
    WHO = 3
    TEXT = 4
    ANSWER = 5
    RESULT = 6
    COUNT = 7


_TITLES: Final = Texts("EventTable") | {
    EventColumn.BEGIN: "Time",
    EventColumn.END: "Until",
    EventColumn.KIND: "Kind",
    EventColumn.WHO: "Who",
    EventColumn.TEXT: "Event",
    EventColumn.ANSWER: "Answer",
    EventColumn.RESULT: "Read back",
    EventColumn.COUNT: "Count",
}
_GOOD: Final = "✓"
_BAD: Final = "✗"
_CUT: Final = "–"


def column_title(column: EventColumn) -> str:
    """What a column is called."""
    return _TITLES.text(column)


def cell_text(entry: EventEntry, column: EventColumn) -> str:
    """What stands in one cell."""
    if column is EventColumn.BEGIN:
        return clock_text(entry, entry.at_s)
    if column is EventColumn.END:
        return _end(entry)
    if column is EventColumn.KIND:
        return words.event_kind(entry.kind)
    if column is EventColumn.WHO:
        return words.asker(entry.who)
    if column is EventColumn.TEXT:
        return words.entry_text(entry)
    if column is EventColumn.ANSWER:
        return _outcome(entry, entry.answer)
    if column is EventColumn.RESULT:
        return _outcome(entry, entry.result)
    return f"× {entry.count}" if entry.count > 1 else ""


def clock_text(entry: EventEntry, at_s: float) -> str:
    """What the clock on the wall showed at a moment of an event."""
    at = entry.wall_at(at_s)
    return f"{at:%H:%M:%S}.{at.microsecond // 1000:03d}"


def search_text(entry: EventEntry) -> str:
    """Everything that is written of an event, in small letters."""
    parts = [cell_text(entry, column) for column in EventColumn]
    parts += [words.outcome_text(each) for each in (entry.answer, entry.result) if each is not None]
    return " ".join([*parts, entry.code]).casefold()


def details(entry: EventEntry, *, dated: bool = True) -> list[str]:
    """All there is to say of an event, line by line.

    Args:
        entry: It.
        dated: Whether the day is known; a log may only tell times since its beginning.
    """
    begin, last = clock_text(entry, entry.at_s), entry.newest_s
    begin = f"{entry.wall:%Y-%m-%d} {begin}" if dated else begin
    when = begin
    if entry.ended_s is not None:
        text = QCoreApplication.translate("EventTable", "{begin} until {end} ({seconds} s)")
        when = text.format(
            begin=begin,
            end=clock_text(entry, entry.ended_s),
            seconds=f"{max(0.0, entry.ended_s - entry.at_s):.3f}",
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
    for text, outcome in (
        (
            QCoreApplication.translate("EventTable", "Answer after {seconds} s: {text}"),
            entry.answer,
        ),
        (
            QCoreApplication.translate("EventTable", "Read back after {seconds} s: {text}"),
            entry.result,
        ),
    ):
        if outcome is not None:
            after = f"{_after_s(entry, outcome):.3f}"
            lines.append(text.format(seconds=after, text=words.outcome_text(outcome)))
    return lines


def _end(entry: EventEntry) -> str:
    if not entry.lasts:
        return ""
    if entry.ended_s is None:
        return QCoreApplication.translate("EventTable", "goes on")
    if entry.unheard:
        return QCoreApplication.translate("EventTable", "not heard")
    return clock_text(entry, entry.ended_s)


def _after_s(entry: EventEntry, outcome: EventOutcome) -> float:
    return max(0.0, outcome.at_s - entry.newest_s)


def _outcome(entry: EventEntry, outcome: EventOutcome | None) -> str:
    if outcome is None:
        return NOTHING if entry.kind == "command" else ""
    sign = {Level.FAULT: _BAD, Level.DONE: _GOOD}.get(outcome.level, _CUT)
    return f"{sign} {_after_s(entry, outcome):.2f} s"
