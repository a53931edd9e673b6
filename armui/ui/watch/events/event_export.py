"""Saving and copying events; put into words and written in another thread."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication
from PySide6.QtGui import QGuiApplication

from armui.arm.refusal import Refusal
from armui.control.events import Level
from armui.system.atomic import write_whole
from armui.telemetry.event_json import to_json
from armui.telemetry.events import EventEntry
from armui.ui import words
from armui.ui.background import Job
from armui.ui.dialogs.file_export import FileExport
from armui.ui.watch.events.event_cells import EventColumn, cell_text, column_title
from armui.ui.watch.events.event_filter import gravity
from armui.ui.words.event_log import event_level

if TYPE_CHECKING:
    from pathlib import Path


class EventExport(FileExport):
    """Files and clipboard."""

    def save(self, kind: str, entries: Sequence[EventEntry]) -> None:
        """Let the operator say where to, and write it there.

        Args:
            kind: ``csv``, ``json`` or ``txt``; or ``copy``: into the clipboard.
            entries: What to save.
        """
        if kind == "copy":
            self.copy(entries)
            return
        on_chosen = partial(self.write, kind, entries)
        self._choose(self.tr("Save the events"), "armui-events", kind, on_chosen)

    def write(self, kind: str, entries: Sequence[EventEntry], path: Path) -> None:
        """Write events to a file."""
        self._background.begin_here(self._job(path), _write, kind, entries, path)

    def copy(self, entries: Sequence[EventEntry]) -> None:
        """Put events into the clipboard, as text for a spreadsheet or a mail."""
        self._background.begin_here(Job(self._on_text), as_text, entries)

    def _on_text(self, result: str | Refusal) -> None:
        if isinstance(result, Refusal):
            self.said.emit(words.refusal(result), Level.FAULT)
            return
        QGuiApplication.clipboard().setText(result)
        self.said.emit(self.tr("Copied"), Level.DONE)


def _write(kind: str, entries: Sequence[EventEntry], path: Path) -> None:
    make = {"csv": as_csv, "json": as_json, "txt": as_text}[kind]
    write_whole(path, make(entries).encode("utf-8", "replace"))


def as_text(entries: Sequence[EventEntry]) -> str:
    """A line each, its columns apart by tabs, as the window has them."""
    rows = [_titles(), *(_cells(each) for each in entries)]
    return "".join("\t".join(row) + "\n" for row in rows)


def as_csv(entries: Sequence[EventEntry]) -> str:
    """For a spreadsheet, which takes the mark at the beginning for the sign of UTF-8."""
    file = io.StringIO()
    writer = csv.writer(file)
    writer.writerow(_titles())
    writer.writerows(map(_harmless, _cells(each)) for each in entries)
    return "\ufeff" + file.getvalue()


def as_json(entries: Sequence[EventEntry]) -> str:
    """A list of what `from_json` reads, an event a line."""
    lines = ",\n".join(to_json(each) for each in entries)
    return f"[\n{lines}\n]\n"


def _titles() -> list[str]:
    level = QCoreApplication.translate("EventTable", "Level")
    titles = [column_title(column) for column in EventColumn]
    return [titles[0], level, *titles[1:]]


def _cells(entry: EventEntry) -> list[str]:
    """With the date, and the level, which the window shows by a sign."""
    begin = entry.wall.isoformat(sep=" ", timespec="milliseconds")
    columns = tuple(EventColumn)[1:]
    return [begin, event_level(gravity(entry)), *(cell_text(entry, each) for each in columns)]


def _harmless(text: str) -> str:
    """A device may be called what a spreadsheet would take for a formula."""
    return f"'{text}" if text[:1] in {"=", "+", "-", "@"} else text
