"""The page 日志: writes a log, saves the last minutes, lists the logs."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from PySide6.QtCore import QEvent, QModelIndex, QObject, QSortFilterProxyModel, Qt, QUrl, Signal
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QSizePolicy,
    QTableView,
    QWidget,
)

from armui.arm.refusal import Reason, Refusal
from armui.control.events import Event, Level
from armui.control.sessions.progress import SESSION_FRAMES_LOST
from armui.control.sessions.session_recorder import (
    RING_NOT_SAVED,
    RING_SAVED,
    SESSION_ENDED,
    SESSION_FAILED_NOTICE,
)
from armui.system.files import size_text
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.actions.act import Act, HasActs
from armui.ui.background import Job
from armui.ui.watch.recordings import recording_files
from armui.ui.watch.recordings.recording_card import RecordingCard, RingCard, moment_text
from armui.ui.widgets.buttons import named
from armui.ui.widgets.flow import in_flow
from armui.ui.widgets.layouts import STRETCH, fill, in_column, in_row
from armui.ui.widgets.message_line import MessageLine, Words
from armui.ui.widgets.page import Page
from armui.ui.widgets.seen_timer import SeenTimer
from armui.ui.widgets.table_model import (
    RIGHT,
    Index,
    TableModel,
    ViewColumn,
    ViewColumns,
    list_rows,
    set_widths,
)
from armui.ui.widgets.text_label import text_label
from armui.ui.words.text import Texts

if TYPE_CHECKING:
    from PySide6.QtGui import QShowEvent

    from armui.control.arm_controller import ArmController
    from armui.session.recording.folder import RecordingEntry
    from armui.settings import SettingsStore
    from armui.ui.background import Background

SESSION_IN_USE = Reason("session_in_use", "“{name}” is still being written. Stop the log first.")
SESSION_REPLAYED = Reason(
    "session_replayed", "“{name}” is open in the replay window. Close that window first."
)


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
    "complete": "complete",
    "cut off": "cut off: readable to its last second",
    "failed": "ended early: {text}",
    "empty": "empty",
    "damaged": "its description file cannot be read: {text}",
}
_Column = ViewColumn[Callable[["SessionsModel", "RecordingEntry"], str]]


class SessionColumn(ViewColumns):
    """The columns; the name takes the rest of the width."""

    NAME = _Column("Name", lambda _, entry: entry.name)
    BEGUN = _Column(
        "Begun",
        lambda _, entry: moment_text(entry.begun_unix_s),
        lambda entry: entry.begun_unix_s,
        width_px=160,
    )
    LENGTH = _Column(
        "Duration",
        lambda _, entry: fmt.duration(entry.length_s, 0),
        lambda entry: -1.0 if entry.length_s is None else entry.length_s,
        width_px=75,
        figures=True,
    )
    SIZE = _Column(
        "Size",
        lambda _, entry: size_text(entry.total_bytes),
        lambda entry: float(entry.total_bytes),
        width_px=90,
        figures=True,
    )
    FAULTS = _Column(
        "Faults",
        lambda _, entry: fmt.NOTHING if entry.faults is None else str(entry.faults),
        lambda entry: -1 if entry.faults is None else entry.faults,
        width_px=65,
        figures=True,
    )
    STOPS = _Column(
        "E-stops",
        lambda _, entry: fmt.NOTHING if entry.stops is None else str(entry.stops),
        lambda entry: -1 if entry.stops is None else entry.stops,
        width_px=65,
        figures=True,
    )
    KIND = _Column("Kind", lambda _, entry: _KINDS.word(entry.reason), width_px=150)
    STATE = _Column("State", lambda model, entry: model.state(entry), width_px=130)


_GROWING: Final = frozenset({SessionColumn.LENGTH, SessionColumn.SIZE})


class SessionsModel(TableModel):
    """Shows recordings; a changed name is emitted.

    Signals:
        rename_wanted: The name of a recording and its new one.
    """

    rename_wanted = Signal(str, str)
    _table = tuple(SessionColumn)
    _columns = len(SessionColumn)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._rows: Sequence[RecordingEntry] = ()
        self._written: frozenset[str] = frozenset()

    def show(self, entries: Sequence[RecordingEntry], written: frozenset[str]) -> bool:
        """Show other recordings.

        Args:
            entries: The recordings of the folder.
            written: The names of those that are being written.

        Returns:
            True if they differ from the present ones.
        """
        if (tuple(entries), written) == (self._rows, self._written):
            return False
        self.beginResetModel()
        self._rows, self._written = tuple(entries), written
        self.endResetModel()
        return True

    def name_of(self, path: Path | None) -> str:
        """Return which recording has a file as its first; "" for none."""
        return next((each.name for each in self._rows if path and each.path == path), "")

    def is_written(self, name: str) -> bool:
        """Return whether a recording is still being written."""
        return name in self._written

    # The model's interface for Qt -------------------------------------------------------------

    def flags(self, index: Index) -> Qt.ItemFlag:
        """Return the flags of a cell; a name can be edited, unless its files are being written."""
        flags = super().flags(index)
        entry = self._rows[index.row()]
        if index.column() == SessionColumn.NAME and not self.is_written(entry.name):
            flags |= Qt.ItemFlag.ItemIsEditable
        return flags

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """Return the content of a cell."""
        entry, column = self._rows[index.row()], self._table[index.column()]
        if role == ENTRY_ROLE:
            return entry
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return RIGHT if column.declared.figures else None
        if role == Qt.ItemDataRole.EditRole:
            return entry.name
        if role == SORT_ROLE:
            key = column.declared.order(entry)
            return column.read(self, entry).casefold() if key is None else key
        if role == Qt.ItemDataRole.DisplayRole:
            # figures of a growing recording would be outdated here; its card above updates them
            grows = column in _GROWING and self.is_written(entry.name)
            return fmt.NOTHING if grows else column.read(self, entry)
        if role == Qt.ItemDataRole.ToolTipRole and column in {
            SessionColumn.NAME,
            SessionColumn.STATE,
        }:
            return column.read(self, entry)
        return None

    def setData(  # noqa: N802 - as Qt has it
        self, index: Index, value: Any, role: int = Qt.ItemDataRole.EditRole
    ) -> bool:
        """Emit a changed name; the result is shown when it is done."""
        name, new_name = self._rows[index.row()].name, str(value).strip()
        if role == Qt.ItemDataRole.EditRole and new_name != name:
            self.rename_wanted.emit(name, new_name)
        return False

    def state(self, entry: RecordingEntry) -> str:
        """Return the words on the state of a recording."""
        if self.is_written(entry.name):
            key = "under way"
        elif entry.damage:
            return _STATES.text("damaged", {"text": entry.damage})
        elif entry.failure:
            key = "failed"
        elif not entry.ended:
            key = "cut off"
        else:
            key = "complete" if entry.path is not None else "empty"
        return _STATES.text(key, {"text": entry.failure})


_ROW_PX: Final = 24
_LEAST_PX: Final = 58
"""The least height of the table: its titles and a row, while a message stands below."""
_GAP_PX: Final = 6
_LOOK_MS: Final = 500
_SAID_HERE: Final = frozenset(
    {
        SESSION_ENDED,
        SESSION_FAILED_NOTICE,
        SESSION_FRAMES_LOST,
        RING_SAVED,
        RING_NOT_SAVED,
    }
)


class SessionsPage(Page):
    """Records sessions, and lists the recordings.

    Args:
        controller: Has the recorder.
        background: Lists, renames and moves files.
        store: The operator's settings.
        replayed: Returns the log that is open in the replay window, or ``None``.

    Signals:
        open_wanted: The path of a recording to be replayed.
        other_wanted: A log from elsewhere is to be replayed.
        export_wanted: The path of a recording to be exported.
    """

    commands = (*RecordingCard.commands, *RingCard.commands)
    open_button = Act("Replay", named="session_open", key="sessions.replay")
    export_button = Act(
        "Export…",
        named="session_export",
        tip="As ROS 2 messages in MCAP, as CSV or as Parquet.",
        key="sessions.export",
    )
    rename_button = Act("Rename", named="session_rename", key="sessions.rename")
    delete_button = Act(
        "Delete",
        named="session_delete",
        tip="Moves the log into the folder “deleted” beside the others.",
        key="sessions.delete",
    )
    other_button = Act(
        "Replay another log…",
        named="session_open_other",
        tip="Any CAN log, also of another program, is shown as if it were live.",
        key="sessions.other",
    )
    folder_button = Act(
        "Show in the file manager", named="session_show_folder", key="sessions.show_folder"
    )
    open_wanted = Signal(object)
    other_wanted = Signal()
    export_wanted = Signal(object)

    def __init__(
        self,
        controller: ArmController,
        background: Background,
        store: SettingsStore,
        replayed: Callable[[], Path | None],
    ) -> None:
        super().__init__("sessions")
        self._replayed = replayed
        self.setObjectName("sessions_page")
        self._sessions = controller.sessions
        self._background = background
        self._listing: Job[list[RecordingEntry] | Refusal] | None = None
        self._choose_next: str | None = None
        self.recording = RecordingCard(controller, store)
        self.ring = RingCard(controller.sessions, store)
        self._model = SessionsModel(self)
        self._shown = QSortFilterProxyModel(self)
        self._shown.setSourceModel(self._model)
        self._shown.setSortRole(SORT_ROLE)
        self.table = _table(self._shown)
        self._hint = text_label(rank="muted")
        self._hint.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._message = named("sessions_message", MessageLine(keeps_room=False, lines=1))
        self._lay_out()
        self._timer = SeenTimer(self, _LOOK_MS, self._refresh_cards)
        self._sessions.changed.connect(self._on_changed)
        controller.noticed.connect(self._on_noticed)
        self._model.rename_wanted.connect(self._rename)
        self.table.selectionModel().selectionChanged.connect(self.show_acts)
        self.table.doubleClicked.connect(lambda _index: self._open_chosen())
        self._model.modelReset.connect(self.show_acts)
        self.first = self.table
        self.retranslate_ui()

    def headers(self) -> Mapping[str, QHeaderView]:
        """Return the heads of its tables by name: the columns' widths and the order are kept."""
        return {"sessions": self.table.horizontalHeader()}

    def act_parts(self) -> Iterable[HasActs]:
        """Return the cards, whose acts the page offers as well."""
        return (self.recording, self.ring)

    def _lay_out(self) -> None:
        self.body.setSpacing(_GAP_PX)
        self.table.setMinimumHeight(_LEAST_PX)
        beside = QWidget()
        beside.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        others = in_row(STRETCH, self.other_button, self.folder_button, spacing=_GAP_PX)
        in_column(self.ring, others, on=beside, spacing=_GAP_PX, margins=0)
        cards = in_flow(self.recording, beside, spacing_px=_GAP_PX)
        for card in (self.recording, beside):
            cards.setAlignment(card, Qt.AlignmentFlag.AlignTop)
        # stacked beside the list: above it they would take height, which is scarce in the drawer
        of_chosen = (self.open_button, self.export_button, self.rename_button, self.delete_button)
        listed = in_row((self.table, 1), in_column(*of_chosen, STRETCH, spacing=0))
        fill(self.body, cards, (listed, 1), self._hint, self._message)

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.set_title(self.tr("Log"))
        self.table.setAccessibleName(self.tr("Log"))
        self._hint.setText(
            self.tr(
                "No logs yet. Start a log, or save what just happened: both can be replayed here "
                "and opened in other CAN tools."
            )
        )
        self._model.retranslate()
        self.show_acts()

    # Listing the recordings -------------------------------------------------------------------

    def showEvent(self, event: QShowEvent) -> None:
        """Read the folder again, and follow the recording in progress."""
        super().showEvent(event)
        self._refresh_cards()
        self.refresh()

    def event(self, event: QEvent) -> bool:
        """Read the folder again when the window is activated."""
        if event.type() == QEvent.Type.WindowActivate:
            self.refresh()
        return super().event(event)

    def _refresh_cards(self) -> None:
        self.recording.refresh()
        self.ring.refresh()

    def refresh(self) -> None:
        """List the present content of the folder."""
        if self._listing is not None:
            self._listing.wanted = False
        self._listing = Job(self._show_listing)
        folder = self._sessions.choices.folder
        self._background.begin_here(self._listing, recording_files.listing, folder)

    def _show_listing(self, entries: list[RecordingEntry] | Refusal) -> None:
        self._listing = None
        if isinstance(entries, Refusal):
            self._show_message(partial(words.refusal, entries), Level.WARNING)
            entries = []
        names = [entry.name for entry in self.chosen()]
        if self._choose_next is not None:
            names, self._choose_next = [self._choose_next], None
        if self._model.show(entries, self._sessions.busy_names()):
            self._choose(names)
        self._hint.setVisible(not entries)
        self.show_acts()

    def _on_changed(self) -> None:
        if self.isVisible():
            self._refresh_cards()
            self.refresh()

    def _on_noticed(self, event: Event) -> None:
        refused = event.params.get("reason")
        ours = event.notice in _SAID_HERE or (
            isinstance(refused, Refusal) and refused.code.startswith("session_")
        )
        if ours and self.isVisible():
            self._show_message(partial(words.event, event), event.level)

    def _show_message(self, text: Words, level: Level) -> None:
        self._message.show_message(text, level)

    def chosen(self) -> list[RecordingEntry]:
        """Return the selected recordings, from top to bottom."""
        rows = self.table.selectionModel().selectedRows()
        return [index.data(ENTRY_ROLE) for index in sorted(rows, key=QModelIndex.row)]

    def _choose(self, names: list[str]) -> None:
        flag = self.table.selectionModel().SelectionFlag
        for row in range(self._shown.rowCount()):
            index = self._shown.index(row, 0)
            if index.data(ENTRY_ROLE).name in names:
                self.table.selectionModel().select(index, flag.Select | flag.Rows)
                self.table.scrollTo(index)

    @open_button.why_not
    @export_button.why_not
    def _why_not_read(self) -> str:
        return self._why_not(lambda one: one.path is not None)

    @rename_button.why_not
    def _why_not_rename(self) -> str:
        return self._why_not(lambda one: not self._model.is_written(one.name))

    def _why_not(self, fits: Callable[[RecordingEntry], bool]) -> str:
        chosen = self.chosen()
        if len(chosen) != 1:
            return self.tr("Choose one log in the list first.")
        return "" if fits(chosen[0]) else self._model.state(chosen[0])

    @delete_button.why_not
    def _why_not_delete(self) -> str:
        free = (each for each in self.chosen() if not self._model.is_written(each.name))
        return "" if any(free) else self._why_not_rename()

    # What the operator does -------------------------------------------------------------------

    @open_button.pressed
    def _open_chosen(self) -> None:
        chosen = self.chosen()
        if len(chosen) == 1 and chosen[0].path is not None:
            self.open_wanted.emit(chosen[0].path)

    @export_button.pressed
    def _export_chosen(self) -> None:
        chosen = self.chosen()
        if len(chosen) == 1 and chosen[0].path is not None:
            self.export_wanted.emit(chosen[0].path)

    @rename_button.pressed
    def _edit_name(self) -> None:
        rows = self.table.selectionModel().selectedRows(SessionColumn.NAME)
        if rows:
            self.table.setFocus()
            self.table.setCurrentIndex(rows[0])
            self.table.edit(rows[0])

    def _rename(self, name: str, new_name: str) -> None:
        if name in self._sessions.busy_names():
            self._refuse(SESSION_IN_USE(name=name))
            return
        if self._refuse_replayed([name]):
            return
        job: Job[str | Refusal] = Job(self._on_renamed)
        folder = self._sessions.choices.folder
        self._background.begin_here(job, recording_files.renamed, folder, name, new_name)

    def _on_renamed(self, result: str | Refusal) -> None:
        if isinstance(result, Refusal):
            self._refuse(result)
        else:
            self._choose_next = result
            self._show_message("", Level.INFO)
        self.refresh()

    @delete_button.pressed
    def _delete(self) -> None:
        busy = self._sessions.busy_names()
        names = tuple(each.name for each in self.chosen() if each.name not in busy)
        if names and not self._refuse_replayed(names):
            job: Job[Path | Refusal] = Job(self._on_deleted)
            folder = self._sessions.choices.folder
            self._background.begin_here(job, recording_files.thrown_away, folder, names)

    def _refuse_replayed(self, names: Sequence[str]) -> bool:
        """Return whether one of these logs is open in the replay window; then that is said."""
        name = self._model.name_of(self._replayed())
        if name not in names:
            return False
        self._refuse(SESSION_REPLAYED(name=name))
        return True

    def _on_deleted(self, result: Path | Refusal) -> None:
        if isinstance(result, Refusal):
            self._refuse(result)
        else:
            text = self.tr("Moved to {folder}. It can be moved back from there.")
            self._show_message(text.format(folder=result), Level.DONE)
        self.refresh()

    @other_button.pressed
    def _on_other(self) -> None:
        self.other_wanted.emit()

    @folder_button.pressed
    def _show_folder(self) -> None:
        folder = self._sessions.choices.folder
        if not QDesktopServices.openUrl(QUrl.fromLocalFile(str(folder))):
            text = self.tr("This computer opens no file manager. The folder is {folder}.")
            self._show_message(text.format(folder=folder), Level.WARNING)

    def _refuse(self, refusal: Refusal) -> None:
        self._show_message(partial(words.refusal, refusal), Level.WARNING)


def _table(shown: QSortFilterProxyModel) -> QTableView:
    table = named("sessions_table", QTableView())
    table.setModel(shown)
    table.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
    table.setEditTriggers(QAbstractItemView.EditTrigger.EditKeyPressed)
    table.setSortingEnabled(True)
    table.sortByColumn(SessionColumn.BEGUN, Qt.SortOrder.DescendingOrder)
    table.setAlternatingRowColors(True)
    table.setWordWrap(False)
    table.verticalHeader().setDefaultSectionSize(_ROW_PX)
    across = list_rows(table)
    across.setSectionResizeMode(SessionColumn.NAME, QHeaderView.ResizeMode.Stretch)
    set_widths(table, SessionColumn)
    return table
