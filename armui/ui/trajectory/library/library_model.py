"""The list of the library as a table: name, points, length in time, last change, check mark."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any, Final

from PySide6.QtCore import QObject, QSortFilterProxyModel, Qt, Signal

from armui.arm.models import ArmModel
from armui.arm.refusal import Refusal
from armui.control.run.replay import RUN_EMPTY, RUN_UNSAVED
from armui.trajectory.library.folders import shown_folder
from armui.trajectory.library.store import Check, IndexEntry
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.trajectory.running.run_estimate import estimate_tip
from armui.ui.widgets.table_model import RIGHT, Index, TableModel, ViewColumn, ViewColumns

ENTRY_ROLE: Final = Qt.ItemDataRole.UserRole
"""The :class:`IndexEntry` of a row."""

_DIGITS: Final = re.compile(r"([0-9]{1,18})")
_URGENCY: Final = ("damaged", "errors", "draft", "warnings", None, "ok")
"""The order of the check marks in their column."""


_Column = ViewColumn[Callable[["LibraryModel", IndexEntry], str]]


class LibraryColumn(ViewColumns):
    """The columns; the note takes the rest of the width, too."""

    NAME = _Column("Name", lambda model, entry: model.name(entry), width_px=112)
    POINTS = _Column(
        "Points",
        lambda model, entry: model.count(entry),
        lambda entry: entry.count,
        width_px=106,
        figures=True,
    )
    LENGTH = _Column(
        "Duration\nat 100 %",
        lambda model, entry: model.length(entry),
        lambda entry: -1.0 if entry.length_s is None else entry.length_s,
        tip="At a speed of 100 % at the top: at the points' own or as recorded, without the way "
        "to the first point. How long a run takes at its speed stands beside Run.",
        width_px=76,
        figures=True,
    )
    MODIFIED = _Column(
        "Last change",
        lambda _, entry: f"{entry.modified.astimezone():%Y-%m-%d %H:%M}",
        lambda entry: entry.modified.timestamp(),
        width_px=124,
    )
    CHECK = _Column(
        "Check",
        lambda model, entry: model.check(entry),
        lambda entry: _URGENCY.index(_state(entry)),
        width_px=82,
    )
    NOTE = _Column(
        "Note",
        lambda _, entry: " ".join(entry.note.split()),
        lambda entry: entry.note.casefold(),
        width_px=60,
    )


class LibraryModel(TableModel):
    """Shows entries; a changed name is emitted.

    Signals:
        rename_wanted: The name of a trajectory and its new one.
    """

    rename_wanted = Signal(str, str)
    _table = tuple(LibraryColumn)
    _columns = len(LibraryColumn)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._rows: Sequence[IndexEntry] = ()
        self._drafts: frozenset[str] = frozenset()
        self._arm: ArmModel | None = None
        self._kind = ""
        self._fingerprints: dict[tuple[str, ...], str] = {}
        self._shows_folders = True
        self._found_of = ""
        self._sort_keys: dict[tuple[int, int], tuple[Any, ...]] = {}

    @property
    def names(self) -> frozenset[str]:
        """All names, also those of trajectories that only have unsaved changes."""
        return self._drafts.union(entry.name for entry in self._rows)

    def why_empty(self, entry: IndexEntry) -> Refusal | None:
        """Return why there is nothing of it to run, or ``None``."""
        if entry.count:
            return None
        return (RUN_UNSAVED if entry.name in self._drafts else RUN_EMPTY)(name=entry.name)

    def is_unsaved(self, name: str) -> bool:
        """Return whether a trajectory consists only of unsaved changes."""
        return any(entry.name == name and entry.kind == "draft" for entry in self._rows)

    def has_unsaved(self, name: str) -> bool:
        """Return whether a saved trajectory has unsaved changes, too."""
        return name in self._drafts and not self.is_unsaved(name)

    def show(self, entries: Sequence[IndexEntry], drafts: Sequence[str]) -> bool:
        """Show other entries; ``drafts`` are those with unsaved changes.

        Returns:
            True if they differ from the present ones.
        """
        wanted = tuple(entries), frozenset(drafts)
        if wanted == (self._rows, self._drafts):
            return False
        self.beginResetModel()
        self._rows, self._drafts = wanted
        self._sort_keys.clear()
        self.endResetModel()
        return True

    def show_folders(self, *, shown: bool) -> None:
        """Show the folder beside each name, or not: then all are in the same one."""
        if shown == self._shows_folders:
            return
        self._shows_folders = shown
        self._redraw(LibraryColumn.NAME)

    def show_for(self, arm: ArmModel) -> None:
        """Show only check marks of checks for one arm, and mark what was taught on another."""
        if arm == self._arm:
            return
        self._arm, self._kind = arm, arm.kind
        self._fingerprints.clear()
        self._sort_keys.clear()
        self._redraw(LibraryColumn.CHECK)

    def note_found(self, name: str) -> None:
        """Note the trajectory whose last check has findings, also on the way to its first point."""
        if name == self._found_of:
            return
        self._found_of = name
        self._redraw(LibraryColumn.CHECK)

    def _redraw(self, column: LibraryColumn) -> None:
        if self._rows:
            self.dataChanged.emit(self.index(0, column), self.index(len(self._rows) - 1, column))

    def _mark(self, entry: IndexEntry) -> Check | None:
        """Return the result of the check, if it is valid for this arm."""
        return entry.check if entry.checked_for == self._holds_for(entry) else None

    def has_findings(self, entry: IndexEntry) -> bool:
        """Return whether the check that holds for this arm has found something."""
        return self._mark(entry) in {"warnings", "errors"}

    def has_errors(self, entry: IndexEntry) -> bool:
        """Return whether a check that is valid for this arm forbids a run."""
        return self._mark(entry) == "errors"

    def _holds_for(self, entry: IndexEntry) -> str:
        """Return the fingerprint of arm and frames for which a check or an estimate is valid."""
        if self._arm is None:
            return ""
        if entry.frames not in self._fingerprints:
            self._fingerprints[entry.frames] = self._arm.fingerprint_of(entry.frames)
        return self._fingerprints[entry.frames]

    def length_s(self, entry: IndexEntry) -> float | None:
        """Return how long it takes, recorded or estimated; ``None`` where that is not known."""
        if entry.length_s is not None:
            return entry.length_s
        return entry.estimated_s if entry.estimated_for == self._holds_for(entry) else None

    def unestimated(self) -> list[str]:
        """Return the names of those whose length nobody has worked out for this arm."""
        return [
            entry.name
            for entry in self._rows
            if entry.kind == "points"
            and entry.damage is None
            and entry.length_s is None
            and entry.estimated_for != self._holds_for(entry)
        ]

    def note_estimates(self, estimates: Mapping[str, float | None], arm: ArmModel) -> None:
        """Show how long some will take.

        Args:
            estimates: Seconds by name; ``None`` where it is not known.
            arm: The arm they were made for.
        """
        rows = list(self._rows)
        for row, entry in enumerate(rows):
            if entry.name in estimates:
                seconds = estimates[entry.name]
                holds_for = arm.fingerprint_of(entry.frames)
                rows[row] = replace(entry, estimated_s=seconds, estimated_for=holds_for)
                self._sort_keys.pop((row, LibraryColumn.LENGTH), None)
        self._rows = tuple(rows)
        self._redraw(LibraryColumn.LENGTH)

    def sort_key(self, row: int, column: int) -> tuple[Any, ...]:
        """Return the sort key of a cell within its column."""
        if (row, column) not in self._sort_keys:
            entry, order = self._rows[row], self._table[column].declared.order
            entry = replace(entry, check=self._mark(entry), length_s=self.length_s(entry))
            self._sort_keys[row, column] = order(entry), _natural(entry.name), entry.name
        return self._sort_keys[row, column]

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """Return what a cell shows."""
        if not index.isValid():
            return None
        entry, column = self._rows[index.row()], self._table[index.column()]
        if role in {Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.AccessibleTextRole}:
            return column.read(self, entry)
        if role == Qt.ItemDataRole.EditRole:
            return entry.name
        if role == ENTRY_ROLE:
            return entry
        if role == Qt.ItemDataRole.ToolTipRole:
            tip = self._length_tip(entry) if column is LibraryColumn.LENGTH else ""
            if column is LibraryColumn.CHECK and self.has_findings(entry):
                tip = self.tr("Click: checks it, and lists below what is found.")
            return tip or "\n".join(filter(None, (self._folder_tip(entry), self._tip(entry))))
        if role == Qt.ItemDataRole.TextAlignmentRole and column.declared.figures:
            return RIGHT
        return None

    def name(self, entry: IndexEntry) -> str:
        """Return its name, with a star for unsaved changes, and its folder."""
        name = f"{entry.name} *" if entry.name in self._drafts else entry.name
        folder = shown_folder(entry.folder) if self._shows_folders else ""
        return f"{name} · {folder}" if folder else name

    def count(self, entry: IndexEntry) -> str:
        """Return how many points or samples it has."""
        if entry.damage is not None:
            return fmt.NOTHING
        count = fmt.count(entry.count)
        if not entry.count and entry.name in self._drafts:
            return self.tr("none saved")
        is_recording = entry.kind == "recording"
        return self.tr("{count} samples").format(count=count) if is_recording else count

    def _folder_tip(self, entry: IndexEntry) -> str:
        folder = shown_folder(entry.folder)
        return self.tr("Folder: {name}").format(name=folder) if folder else ""

    def _tip(self, entry: IndexEntry) -> str:
        if entry.damage is not None:
            return words.file_error(entry.damage)
        if entry.kind == "draft":
            return self.tr(
                "Unsaved changes of a trajectory that was never saved, or whose file is gone. Open "
                "it to save it, or delete it."
            )
        if self._is_of_other_arm(entry):
            text = self.tr("This was taught on another arm: {taught}. Chosen is {arm}.")
            told = text.format(
                taught=words.arm_kind(entry.taught_on), arm=words.arm_kind(self._kind)
            )
            return "\n".join(filter(None, (told, entry.note)))
        return entry.note

    def length(self, entry: IndexEntry) -> str:
        """Return how long it takes; an estimate has a sign."""
        seconds = self.length_s(entry)
        sign = "≈ " if entry.length_s is None and seconds is not None else ""
        return sign + fmt.duration(seconds)

    def _length_tip(self, entry: IndexEntry) -> str:
        """Return the tooltip of the length: what it is based on, or why there is none."""
        if entry.kind != "points" or entry.damage is not None or entry.length_s is not None:
            return ""
        if (empty := self.why_empty(entry)) is not None:
            return words.refusal(empty)
        if entry.estimated_for != self._holds_for(entry):
            return self.tr("It is being worked out.")
        return estimate_tip(known=entry.estimated_s is not None, in_list=True)

    def _is_of_other_arm(self, entry: IndexEntry) -> bool:
        return bool(entry.taught_on and self._kind) and entry.taught_on != self._kind

    def check(self, entry: IndexEntry) -> str:
        """Return its state as a sign and a word, since colours and signs alone are ambiguous."""
        words_of = {
            "ok": self.tr("✓ checked"),
            "warnings": self.tr("! warnings"),
            "errors": self.tr("✕ errors"),
        }
        if entry.damage is not None:
            return self.tr("✕ damaged")
        if entry.kind == "draft":
            return self.tr("! not saved")
        mark = self._mark(entry)
        if mark is None:
            return self.tr("! other arm") if self._is_of_other_arm(entry) else fmt.NOTHING
        if mark == "ok" and entry.name == self._found_of:
            mark = "warnings"  # the finding is on the way to its first point
        return words_of[mark]

    def flags(self, index: Index) -> Qt.ItemFlag:
        """Return the flags of a cell; names can be edited."""
        flags = super().flags(index)
        named = index.isValid() and index.column() == LibraryColumn.NAME
        return flags | Qt.ItemFlag.ItemIsEditable if named else flags

    def setData(  # noqa: N802 - Qt's name
        self, index: Index, value: Any, role: int = Qt.ItemDataRole.EditRole
    ) -> bool:
        """Emit a changed name."""
        if role != Qt.ItemDataRole.EditRole or not index.isValid():
            return False
        name, new = self._rows[index.row()].name, str(value).strip()
        if new != name:
            self.rename_wanted.emit(name, new)
        return True


class LibraryFilter(QSortFilterProxyModel):
    """Shows entries whose name or note contains a text, or those of a folder, sorted by a column.

    A text is searched for in all folders.
    """

    def __init__(self, source: LibraryModel, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._entries = source
        self._folder = ""
        self.setSourceModel(source)
        self.setFilterCaseSensitivity(Qt.CaseSensitivity.CaseInsensitive)

    def show_folder(self, folder: str) -> None:
        """Show the entries of a sub-folder alone; "" for all."""
        self._folder = folder
        self.invalidate()

    def filterAcceptsRow(self, row: int, parent: Index) -> bool:  # noqa: N802 - Qt's name
        """Return whether the text is in the name or the note, or the file in the folder."""
        entry: IndexEntry = self.sourceModel().index(row, 0, parent).data(ENTRY_ROLE)
        wanted = self.filterRegularExpression()
        if not wanted.pattern() and self._folder not in ("", entry.folder):
            return False
        return any(wanted.match(text).hasMatch() for text in (entry.name, entry.note))

    def lessThan(self, left: Index, right: Index) -> bool:  # noqa: N802 - Qt's name
        """Compare by the column, then by name."""
        key = self._entries.sort_key
        return key(left.row(), left.column()) < key(right.row(), right.column())


def _state(entry: IndexEntry) -> str | None:
    if entry.damage is not None:
        return "damaged"
    return "draft" if entry.kind == "draft" else entry.check


def _natural(name: str) -> list[tuple[int, str]]:
    """Return a name so that 9 comes before 10; case counts nothing."""
    parts = _DIGITS.split(name.casefold())
    return [(int(part) if place % 2 else -1, part) for place, part in enumerate(parts)]
