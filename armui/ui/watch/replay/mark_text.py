"""A mark of the time line in the words of the events."""

from __future__ import annotations

from typing import TYPE_CHECKING

from armui.control.event_log.log_events import entry_of
from armui.ui.format import NOTHING
from armui.ui.watch.events.event_cells import EventColumn, cell_text, column_title
from armui.ui.watch.replay.log_time import wall_time

if TYPE_CHECKING:
    from armui.session.session import SessionMark


def mark_text(mark: SessionMark) -> str:
    """Who, what, what was answered and read back, in the operator's language."""
    entry = entry_of(mark, wall_time)
    parts = [f"{cell_text(entry, EventColumn.WHO)}: {cell_text(entry, EventColumn.TEXT)}"]
    for column in (EventColumn.ANSWER, EventColumn.RESULT):
        text = cell_text(entry, column)
        if text not in {"", NOTHING}:
            parts.append(f"{column_title(column)} {text}")
    if entry.count > 1:
        parts.append(cell_text(entry, EventColumn.COUNT))
    return " · ".join(parts)
