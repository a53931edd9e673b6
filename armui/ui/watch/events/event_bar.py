"""The bar above the events: search, severity, source, kind; and saving."""

from __future__ import annotations

import csv
import io
from collections.abc import Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QCoreApplication, Signal
from PySide6.QtGui import QFont, QFontMetrics, QGuiApplication
from PySide6.QtWidgets import QLineEdit, QToolButton, QWidget

from armui.arm.refusal import Refusal
from armui.system.atomic import write_whole
from armui.telemetry.event_json import to_json
from armui.telemetry.events import Asker, EventEntry, EventKind, Level
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.actions.act import Act, ActFamily, HasActs, check_box, toggle_button
from armui.ui.actions.command import Command, Target
from armui.ui.background import Job
from armui.ui.dialogs.files import FileExport
from armui.ui.watch.events.event_filter import EventFilter, gravity
from armui.ui.watch.events.event_table import EventColumn
from armui.ui.watch.save_button import SaveButton
from armui.ui.widgets.buttons import drop_down, fold_into, named
from armui.ui.widgets.layouts import in_row
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated
from armui.ui.words.event_log import EVENT_KINDS, asker, event_kind, event_level
from armui.ui.words.text import Text, Texts

if TYPE_CHECKING:
    from pathlib import Path


_LEVELS: Final = (Level.INFO, Level.WARNING, Level.FAULT)
_TOGGLE_PAD_PX: Final = 32
SAVES: Final = Texts("EventBar") | {
    "csv": "Shown events as CSV…",
    "json": "Shown events as JSON…",
    "txt": "Shown events as text…",
    "copy": "Copy shown events",
}


class EventExport(FileExport):
    """Saves events to files, and copies them."""

    def save(self, kind: str, entries: Sequence[EventEntry]) -> None:
        """Let the operator choose a file for events, or copy them.

        Args:
            kind: ``csv``, ``json`` or ``txt``; or ``copy`` for the clipboard.
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
        """Copy events as text for a spreadsheet or a mail."""
        self._background.begin_here(Job(self._on_text), as_text, entries)

    def _on_text(self, result: str | Refusal) -> None:
        if isinstance(result, Refusal):
            self.message_changed.emit(words.refusal(result), Level.FAULT)
            return
        QGuiApplication.clipboard().setText(result)
        self.message_changed.emit(self.tr("Copied"), Level.DONE)


def _write(kind: str, entries: Sequence[EventEntry], path: Path) -> None:
    make = {"csv": as_csv, "json": as_json, "txt": as_text}[kind]
    write_whole(path, make(entries).encode("utf-8", "replace"))


def as_text(entries: Sequence[EventEntry]) -> str:
    """Return a line for each event, with tabs between the columns of the window."""
    rows = [_titles(), *(_cells(each) for each in entries)]
    return "".join("\t".join(row) + "\n" for row in rows)


def as_csv(entries: Sequence[EventEntry]) -> str:
    """Return a CSV text for a spreadsheet, with a byte order mark that shows UTF-8."""
    file = io.StringIO()
    writer = csv.writer(file)
    writer.writerow(_titles())
    writer.writerows(map(_harmless, _cells(each)) for each in entries)
    return "\ufeff" + file.getvalue()


def as_json(entries: Sequence[EventEntry]) -> str:
    """Return a JSON list of what `from_record` reads, one event a line."""
    lines = ",\n".join(to_json(each) for each in entries)
    return f"[\n{lines}\n]\n"


def _titles() -> list[str]:
    level = QCoreApplication.translate("EventTable", "Level")
    titles = [column.title for column in EventColumn]
    return [titles[0], level, *titles[1:]]


def _cells(entry: EventEntry) -> list[str]:
    """Return the cells of a file's row: date and time, the level as a word, the other columns."""
    begin = entry.wall.isoformat(sep=" ", timespec="milliseconds")
    columns = tuple(EventColumn)[1:]
    return [begin, event_level(gravity(entry)), *(each.read(entry) for each in columns)]


def _harmless(text: str) -> str:
    """Quote a text, such as a device's name, that a spreadsheet would run as a formula."""
    return f"'{text}" if text[:1] in {"=", "+", "-", "@"} else text


class EventBar(HasActs, Translated, QWidget):
    """The controls of the filter.

    Signals:
        filter_changed: An `EventFilter`.
        follow_changed: True to keep the newest event visible.
    """

    filter_changed = Signal(object)
    follow_changed = Signal(bool)
    commands = (
        Command("events.save", Text("SaveButton", "Save")),
        *(Command(f"events.{name}", SAVES.entry(name)) for name in SAVES),
    )
    all_kinds = Act("All kinds", named="event_all_kinds", key="events.all_kinds", kind=check_box)
    follow = Act("Follow", named="event_follow", key="events.follow", kind=toggle_button)
    kinds = ActFamily(
        {
            kind: Act(
                EVENT_KINDS.entry(kind),
                named=f"event_kind_{kind}",
                key=f"events.kind_{kind}",
                kind=check_box,
            )
            for kind in EventKind
        }
    )

    def __init__(self) -> None:
        super().__init__()
        self.search = named("event_search", QLineEdit(clearButtonEnabled=True))
        self.levels = drop_down("event_levels")
        self.askers = drop_down("event_askers")
        self.chosen_kinds = named("event_kinds", QToolButton())
        self.follow.setChecked(True)
        self.count = text_label("event_count", rank="muted")
        self.save = SaveButton("event", SAVES)
        fold_into(self.chosen_kinds, self.all_kinds, *self.kinds.values())
        wanted = (self.levels, self.askers, self.chosen_kinds, self.follow)
        in_row((self.search, 1), *wanted, self.count, self.save, on=self, spacing=8, margins=0)
        for button in self.kinds.values():
            button.setChecked(True)
        self.search.textChanged.connect(self._on_filter_changed)
        self.levels.activated.connect(self._on_filter_changed)
        self.askers.activated.connect(self._on_filter_changed)
        self.follow.toggled.connect(self.follow_changed)
        self.retranslate_ui()

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each command, by the command's name."""
        return {**super().command_targets(), **self.save.targets("events")}

    def _fit_follow(self) -> None:
        """Make the button wide enough for its name in bold, which it has while it is on."""
        bold = QFont(self.follow.font())
        bold.setBold(True)
        text_px = QFontMetrics(bold).horizontalAdvance(self.follow.text())
        self.follow.setMinimumWidth(text_px + _TOGGLE_PAD_PX)

    @property
    def wanted(self) -> EventFilter:
        """The filter as set by the controls."""
        return EventFilter(
            kinds=frozenset(kind for kind, button in self.kinds.items() if button.isChecked()),
            who=self.askers.currentData(),
            least=self.levels.currentData() or Level.INFO,
            words=tuple(self.search.text().casefold().split()),
        )

    def show_all(self) -> None:
        """Show all events again."""
        self.levels.setCurrentIndex(0)
        self.search.clear()
        self.show_only()

    def show_only(self, kind: EventKind | None = None, who: Asker | None = None) -> None:
        """Show one kind, or one source, alone."""
        for each, button in self.kinds.items():
            button.setChecked(kind in {None, each})
        self.askers.setCurrentIndex(max(0, self.askers.findData(who)))
        self._on_filter_changed()

    @all_kinds.pressed
    def _on_all_kinds(self) -> None:
        """Tick all kinds, or none to choose some from; the filter of the source stays."""
        for each in self.kinds.values():
            each.setChecked(self.all_kinds.isChecked())
        self._on_filter_changed()

    def show_count(self, shown: int, kept: int) -> None:
        """Show how many events pass the filter, and how many the log has."""
        text = self.tr("{shown} of {kept}").format(shown=fmt.count(shown), kept=fmt.count(kept))
        if self.count.text() != text:
            self.count.setText(text)

    @kinds.pressed
    def _on_filter_changed(self, *_: object) -> None:
        self._show_kinds()
        self.filter_changed.emit(self.wanted)

    def _show_kinds(self) -> None:
        """Say beside the other choices which kinds are shown."""
        kinds = [kind for kind, box in self.kinds.items() if box.isChecked()]
        self.all_kinds.setChecked(len(kinds) == len(self.kinds))
        some = self.tr("{count} kinds").format(count=len(kinds))
        text = event_kind(kinds[0]) if len(kinds) == 1 else some
        self.chosen_kinds.setText(self.tr("All kinds") if self.all_kinds.isChecked() else text)

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        level, who = self.levels.currentIndex(), self.askers.currentIndex()
        self.search.setPlaceholderText(self.tr("Search"))
        self.search.setAccessibleName(self.tr("Search"))
        self.levels.clear()
        texts = (
            self.tr("Every level"),
            self.tr("Warnings and faults"),
            self.tr("Faults"),
        )
        for text, least in zip(texts, _LEVELS, strict=True):
            self.levels.addItem(text, least)
        self.levels.setCurrentIndex(max(0, level))
        self.levels.setAccessibleName(self.tr("Level"))
        self.askers.clear()
        self.askers.addItem(self.tr("All sources"), None)
        for each in Asker:
            self.askers.addItem(asker(each), each)
        self.askers.setCurrentIndex(max(0, who))
        self.askers.setAccessibleName(self.tr("Who asked for it, or reports it"))
        self.show_acts()
        self._fit_follow()
        self._show_kinds()

    @follow.text
    def _follow_text(self) -> str:
        return self.tr("Follow")

    @follow.tip
    def _follow_tip(self) -> str:
        return self.tr("Keep the newest event in sight")
