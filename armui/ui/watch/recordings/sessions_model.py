"""The recordings of a folder as a table."""

from __future__ import annotations

import enum
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Final

from PySide6.QtCore import (
    QT_TRANSLATE_NOOP,
    QCoreApplication,
    QObject,
    Qt,
    Signal,
)

from armui.ui import format as fmt
from armui.ui.watch.recordings import figures
from armui.ui.widgets.table_model import LEFT, RIGHT, Index, TableModel
from armui.ui.words.text import Texts

if TYPE_CHECKING:
    from armui.session.recording.folder import RecordingEntry

ENTRY_ROLE: Final = Qt.ItemDataRole.UserRole
"""The :class:`RecordingEntry` of a row."""
SORT_ROLE: Final = Qt.ItemDataRole.UserRole + 1

_KINDS: Final = Texts("SessionKind") | {
    "operator": "recorded",
    "command": "by armui record",
    "ring": "saved from memory",
    "fault": "saved at a fault",
    "stop": "saved at a stop",
}
_STATES: Final = Texts("SessionState") | {
    "under way": "under way",
    "whole": "whole",
    "cut off": "cut off: readable to its last second",
    "failed": "ended early: {text}",
    "empty": "empty",
    "damaged": "what stands beside it cannot be read: {text}",
}
_TITLES: Final = (
    QT_TRANSLATE_NOOP("SessionsModel", "Name"),
    QT_TRANSLATE_NOOP("SessionsModel", "Begun"),
    QT_TRANSLATE_NOOP("SessionsModel", "Length"),
    QT_TRANSLATE_NOOP("SessionsModel", "Size"),
    QT_TRANSLATE_NOOP("SessionsModel", "Faults"),
    QT_TRANSLATE_NOOP("SessionsModel", "Stops"),
    QT_TRANSLATE_NOOP("SessionsModel", "Kind"),
    QT_TRANSLATE_NOOP("SessionsModel", "State"),
)


class SessionColumn(enum.IntEnum):
    """From left to right."""

    NAME = 0
    BEGUN = 1
    LENGTH = 2
    SIZE = 3
    FAULTS = 4
    STOPS = 5
    KIND = 6
    STATE = 7


_FIGURES: Final = frozenset(
    {SessionColumn.LENGTH, SessionColumn.SIZE, SessionColumn.FAULTS, SessionColumn.STOPS}
)


class SessionsModel(TableModel):
    """Shows the recordings it is given; a name typed anew is handed on.

    Signals:
        rename_wanted: The name of a recording and its new one.
    """

    rename_wanted = Signal(str, str)
    _columns = len(_TITLES)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._rows: Sequence[RecordingEntry] = ()
        self._written: frozenset[str] = frozenset()

    def show(self, entries: Sequence[RecordingEntry], written: frozenset[str]) -> bool:
        """Show other recordings.

        Args:
            entries: Of the folder.
            written: The names of those that are being written.

        Returns:
            Whether they are others: what stands there already is left alone.
        """
        if (tuple(entries), written) == (self._rows, self._written):
            return False
        self.beginResetModel()
        self._rows, self._written = tuple(entries), written
        self.endResetModel()
        return True

    def is_written(self, name: str) -> bool:
        """Whether a recording is still being written."""
        return name in self._written

    # What Qt asks -----------------------------------------------------------------------------

    def titles(self) -> Sequence[str]:
        """From left to right."""
        return [QCoreApplication.translate("SessionsModel", str(title)) for title in _TITLES]

    def headerData(  # noqa: N802 - as Qt has it
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        """The titles stand as the cells below them do."""
        if role == Qt.ItemDataRole.TextAlignmentRole and orientation is Qt.Orientation.Horizontal:
            return RIGHT if SessionColumn(section) in _FIGURES else LEFT
        return super().headerData(section, orientation, role)

    def flags(self, index: Index) -> Qt.ItemFlag:
        """A name can be edited, unless its files are being written."""
        flags = super().flags(index)
        entry = self._rows[index.row()]
        if index.column() == SessionColumn.NAME and not self.is_written(entry.name):
            flags |= Qt.ItemFlag.ItemIsEditable
        return flags

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """What a cell shows."""
        entry, column = self._rows[index.row()], SessionColumn(index.column())
        if role == ENTRY_ROLE:
            return entry
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return RIGHT if column in _FIGURES else None
        if role == Qt.ItemDataRole.EditRole:
            return entry.name
        if role == SORT_ROLE:
            return self._sort_key(entry, column)
        if role == Qt.ItemDataRole.DisplayRole:
            return self._text(entry, column)
        if role == Qt.ItemDataRole.ToolTipRole and column in {
            SessionColumn.NAME,
            SessionColumn.STATE,
        }:
            return self._text(entry, column)
        return None

    def setData(  # noqa: N802 - as Qt has it
        self,
        index: Index,
        value: Any,
        role: int = Qt.ItemDataRole.EditRole,
    ) -> bool:
        """Hand on a name typed anew; what becomes of it is shown when it is done."""
        name, new_name = self._rows[index.row()].name, str(value).strip()
        if role == Qt.ItemDataRole.EditRole and new_name != name:
            self.rename_wanted.emit(name, new_name)
        return False

    def _text(self, entry: RecordingEntry, column: SessionColumn) -> str:
        if column is SessionColumn.NAME:
            return entry.name
        if column is SessionColumn.BEGUN:
            return figures.moment(entry.begun_unix_s)
        if column is SessionColumn.LENGTH:
            return figures.length(entry.length_s)
        if column is SessionColumn.SIZE:
            return figures.size(entry.total_bytes)
        if column is SessionColumn.FAULTS:
            return fmt.NOTHING if entry.faults is None else str(entry.faults)
        if column is SessionColumn.STOPS:
            return fmt.NOTHING if entry.stops is None else str(entry.stops)
        if column is SessionColumn.KIND:
            return _KINDS.word(entry.reason)
        return self._state(entry)

    def _state(self, entry: RecordingEntry) -> str:
        if self.is_written(entry.name):
            key = "under way"
        elif entry.damage:
            return _STATES.text("damaged", {"text": entry.damage})
        elif entry.failure:
            key = "failed"
        elif not entry.ended:
            key = "cut off"
        else:
            key = "whole" if entry.path is not None else "empty"
        return _STATES.text(key, {"text": entry.failure})

    def _sort_key(self, entry: RecordingEntry, column: SessionColumn) -> Any:
        keys: dict[SessionColumn, Any] = {
            SessionColumn.BEGUN: entry.begun_unix_s,
            SessionColumn.LENGTH: -1.0 if entry.length_s is None else entry.length_s,
            SessionColumn.SIZE: float(entry.total_bytes),
            SessionColumn.FAULTS: -1 if entry.faults is None else entry.faults,
            SessionColumn.STOPS: -1 if entry.stops is None else entry.stops,
        }
        return keys.get(column, self._text(entry, column).casefold())
