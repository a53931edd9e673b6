"""The window 参数备份: saves all parameters of the arm to a file, compares and restores them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from datetime import datetime
from functools import partial
from pathlib import Path
from typing import Any, Final

from PySide6.QtCore import QCoreApplication, QSortFilterProxyModel, Qt, Signal
from PySide6.QtGui import QCloseEvent, QShowEvent
from PySide6.QtWidgets import QCheckBox, QHeaderView, QTableView, QWidget

from armui.arm.backup import SUFFIX, Backup, ComparisonRow, ComparisonVerdict, compare
from armui.arm.models import model_data
from armui.arm.parameters import Parameter, factory_bound
from armui.arm.refusal import Reason, Refusal
from armui.arm.state import ArmState
from armui.control.arm_controller import QUESTION_WITHDRAWN, ArmController
from armui.control.events import Level
from armui.control.operating_state import BUSY, OperatingState
from armui.control.parameters.backup_files import backup_of, read_backup, write_backup
from armui.control.parameters.parameter_reader import ParameterReader
from armui.control.parameters.setting_cell import CellState, SettingCellState
from armui.protocol.generation import Generation, PiperModel
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.background import Background, Job
from armui.ui.dialogs.base import ArmDialog, CloseButton
from armui.ui.dialogs.confirm_dialog import confirm
from armui.ui.dialogs.files import choose_file
from armui.ui.widgets.buttons import enable_or_explain, named, push_button
from armui.ui.widgets.layouts import STRETCH, fill, in_row
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.progress import quiet_progress
from armui.ui.widgets.table_model import (
    RIGHT,
    Index,
    TableModel,
    ViewColumn,
    ViewColumns,
    list_rows,
)
from armui.ui.widgets.text_label import text_label
from armui.ui.words.parameters import (
    beyond_danger,
    beyond_factory,
    full_name,
    value_text,
    verdict_word,
)
from armui.ui.words.text import joined, said

BACKUP_NOTHING_READ = Reason(
    "backup_nothing_read", "Nothing has been read from the arm. Press Read first."
)


_SIZE_PX: Final = (860, 640)
_MOST_BEYOND: Final = 8
"""The most values beyond the factory's that the question before restoring lists."""
_NARROWEST_COLUMN_PX: Final = 84
MessageText = tuple[str, Level]
"""A text and its severity."""


def origin_text(backup: Backup | None, path: Path | None) -> str:
    """Return the text on the origin of the file's values, or that there is no file."""
    if backup is None or path is None:
        return QCoreApplication.translate(
            "BackupDialog", "No file is open; the arm's own values are shown."
        )
    text = QCoreApplication.translate(
        "BackupDialog",
        "{name}: saved {time}, {model}, {device}, generation {generation}, {firmware}",
    )
    return text.format(
        name=path.name,
        model=_name(backup.model),
        time=f"{backup.saved_at.astimezone():%Y-%m-%d %H:%M}",
        device=backup.device,
        generation=backup.generation,
        firmware=backup.firmware or fmt.NOTHING,
    )


def difference_text(
    backup: Backup,
    generation: Generation | None,
    firmware: str | None,
    model: PiperModel | None = None,
) -> str:
    """Return the differences between the file's arm and this one; empty if none are known.

    Args:
        backup: The file.
        generation: This arm's generation; ``None`` if not known yet.
        firmware: This arm's version; ``None`` if not named.
        model: The model as which this arm was connected.
    """
    if None not in {backup.model, model} and backup.model is not model:
        text = QCoreApplication.translate(
            "BackupDialog",
            "The file is from a {filed}, this arm is a {here}: the limits of one may be wrong for "
            "the other. Check the values before you restore them.",
        )
        return text.format(filed=_name(backup.model), here=_name(model))
    if generation is None:
        return ""
    if int(generation) != backup.generation:
        text = QCoreApplication.translate(
            "BackupDialog",
            "The file is from an arm of protocol generation {filed}, this one speaks "
            "generation {here}. Parameters that both have can be restored; their resolution "
            "differs.",
        )
        return text.format(filed=backup.generation, here=int(generation))
    if firmware != backup.firmware:
        text = QCoreApplication.translate(
            "BackupDialog",
            "The file is from firmware {filed}, this arm has {here}. Check the values before "
            "you restore them.",
        )
        return text.format(filed=backup.firmware or fmt.NOTHING, here=firmware or fmt.NOTHING)
    return ""


def _name(model: PiperModel | None) -> str:
    return fmt.NOTHING if model is None else model_data(model).name


def saved_text(path: Path, count: int, missing: int) -> MessageText:
    """Return the text that a file was written, with the number of parameters missing in it."""
    text = QCoreApplication.translate("BackupDialog", "Saved {count} parameters to {path}.")
    if missing > 0:
        rest = QCoreApplication.translate(
            "BackupDialog", "{missing} could not be read from the arm and are not in the file."
        )
        text = joined(text, rest)
    text = text.format(count=count, path=path, missing=missing)
    return text, Level.WARNING if missing > 0 else Level.DONE


def restored_text(count: int, failed: Sequence[Refusal | None]) -> MessageText:
    """Return the text on the result of restoring.

    Args:
        count: The number of parameters to be restored.
        failed: The reason, if known, for each one that was not restored.
    """
    if not failed:
        text = QCoreApplication.translate(
            "BackupDialog", "Restored {count} parameters; reading them back gave the same values."
        )
        return text.format(count=count), Level.DONE
    text = QCoreApplication.translate(
        "BackupDialog", "{failed} of {count} parameters were not restored."
    )
    text = text.format(failed=len(failed), count=count)
    return joined(text, words.why_not(failed[0])), Level.FAULT


_Column = ViewColumn[Callable[["BackupModel", ComparisonRow], str]]


class BackupColumn(ViewColumns):
    """The columns of the comparison."""

    NAME = _Column("Parameter", lambda _, row: full_name(row.parameter))
    FILED = _Column("In the file", lambda _, row: _value(row, row.filed), figures=True)
    HELD = _Column("In the arm", lambda _, row: _value(row, row.held), figures=True)
    STATE = _Column("Comparison", lambda model, row: model.state(row))


def _value(row: ComparisonRow, value: float | None) -> str:
    return fmt.NOTHING if value is None else value_text(row.parameter.name, value)


class BackupModel(TableModel):
    """Rows with a tick; only parameters that can be restored, and would change, can be ticked.

    Args:
        cell: Gives the state of a parameter between program and arm.

    Signals:
        ticked: The ticks have changed.
    """

    ticked = Signal()
    _table = tuple(BackupColumn)
    _columns = len(BackupColumn)

    def __init__(self, cell: Callable[[Parameter], SettingCellState]) -> None:
        super().__init__()
        self._cell = cell
        self._rows: list[ComparisonRow] = []
        self._shown_cells: list[tuple[ComparisonRow, SettingCellState]] = []
        self._chosen: set[Parameter] = set()
        self._restored: set[Parameter] = set()

    # What the dialog does ---------------------------------------------------------------------

    @property
    def rows(self) -> Sequence[ComparisonRow]:
        """The comparison shown."""
        return self._rows

    @property
    def chosen(self) -> dict[Parameter, float]:
        """The ticked parameters with the file's values."""
        return {
            row.parameter: row.filed
            for row in self._rows
            if row.parameter in self._chosen and row.filed is not None and row.restorable
        }

    def show_rows(self, rows: Sequence[ComparisonRow]) -> None:
        """Show another comparison; the same parameters stay ticked."""
        same = [row.parameter for row in rows] == [row.parameter for row in self._rows]
        if not same:
            self.beginResetModel()
        told, self._shown_cells = (
            self._shown_cells,
            [(row, self._cell(row.parameter)) for row in rows],
        )
        self._rows = list(rows)
        if not same:
            self.endResetModel()
        elif other := [at for at, what in enumerate(self._shown_cells) if what != told[at]]:
            end = self._columns - 1  # only changed rows are reported, as the view measures each
            self.dataChanged.emit(self.index(other[0], 0), self.index(other[-1], end))
        self.ticked.emit()

    def choose(self, wanted: Callable[[ComparisonRow], bool]) -> None:
        """Tick exactly the rows that are wanted and can be restored."""
        self._chosen = {row.parameter for row in self._rows if row.restorable and wanted(row)}
        self.redraw()
        self.ticked.emit()

    def follow(self, restored: Sequence[Parameter]) -> None:
        """Show the progress of restoring these parameters; an empty list ends it."""
        if set(restored) != self._restored:
            self._restored = set(restored)
            self.redraw()

    # The model's interface for Qt -------------------------------------------------------------

    def flags(self, index: Index) -> Qt.ItemFlag:
        """Return the flags of a cell; only parameters that can be restored can be ticked."""
        flags = Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable
        if index.column() == BackupColumn.NAME and self._rows[index.row()].restorable:
            flags |= Qt.ItemFlag.ItemIsUserCheckable
        return flags

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """Return the text of a cell, its tick, or its tooltip."""
        row = self._rows[index.row()]
        if role == Qt.ItemDataRole.CheckStateRole and index.column() == BackupColumn.NAME:
            if not row.restorable:
                return None
            ticked = row.parameter in self._chosen
            return Qt.CheckState.Checked if ticked else Qt.CheckState.Unchecked
        if role == Qt.ItemDataRole.DisplayRole:
            return self._table[index.column()].read(self, row)
        if role == Qt.ItemDataRole.ToolTipRole:
            reason = self._reason(row)
            return "" if reason is None else words.refusal(reason)
        if (
            role == Qt.ItemDataRole.TextAlignmentRole
            and self._table[index.column()].declared.figures
        ):
            return RIGHT
        return None

    def setData(  # noqa: N802 - the name Qt calls
        self, index: Index, value: Any, role: int = Qt.ItemDataRole.EditRole
    ) -> bool:
        """Set a tick, and return whether that was possible."""
        row = self._rows[index.row()]
        if role != Qt.ItemDataRole.CheckStateRole or not row.restorable:
            return False
        if Qt.CheckState(value) is Qt.CheckState.Checked:
            self._chosen.add(row.parameter)
        else:
            self._chosen.discard(row.parameter)
        self.dataChanged.emit(index, index)
        self.ticked.emit()
        return True

    def state(self, row: ComparisonRow) -> str:
        """Return the comparison of a row in words, or the progress of its restoring."""
        cell = self._cell(row.parameter)
        if cell.state is CellState.READING:
            return self.tr("… reading")
        if row.parameter in self._restored:
            if cell.state is CellState.SAVING:
                return self.tr("… restoring")
            if cell.state is CellState.SAVED:
                return self.tr("✓ restored")
            if cell.state is CellState.REFUSED:
                return self.tr("✗ not restored")
        if row.against is not None:
            return self.tr("≠ cannot be restored")
        return verdict_word(row.verdict)

    def _reason(self, row: ComparisonRow) -> Refusal | None:
        return row.against or self._cell(row.parameter).refusal


class DifferencesOnly(QSortFilterProxyModel):
    """Hides parameters that are equal in the file and in the arm, if wanted."""

    def __init__(self, model: BackupModel) -> None:
        super().__init__()
        self._model = model
        self._only = False
        self.setSourceModel(model)

    def show_only_differences(self, wanted: bool) -> None:
        """Hide or show equal parameters."""
        self._only = wanted
        self.invalidate()

    def filterAcceptsRow(  # noqa: N802 - the name Qt calls
        self, source_row: int, _parent: Index
    ) -> bool:
        """Return whether a row differs, or all rows are wanted."""
        return not self._only or self._model.rows[source_row].verdict is not ComparisonVerdict.SAME


class BackupDialog(ArmDialog):
    """Reads the arm when it opens, and compares its values with a file's."""

    def __init__(
        self, controller: ArmController, background: Background, parent: QWidget | None = None
    ) -> None:
        super().__init__(controller, parent)
        self._controller = controller
        self._background = background
        self._reading_file: Job[Backup | Refusal] | None = None
        self._settings = controller.settings
        self._reader = ParameterReader(self._settings, self)
        self._backup: Backup | None = None
        self._path: Path | None = None
        self._shown_message: tuple[str, Level] = ("", Level.INFO)
        self._restoring: dict[Parameter, float] = {}
        self._could_read = False
        self._model = BackupModel(self._settings.cell)
        self._shown = DifferencesOnly(self._model)
        self._build()
        self._connect()
        self.resize(*_SIZE_PX)
        self.retranslate_ui()

    # Layout -----------------------------------------------------------------------------------

    def _build(self) -> None:
        self._message = named("backup_message", MessageLine(keeps_room=False))
        self._origin = text_label("backup_origin", wraps=True)
        self.table = QTableView()
        self.table.setModel(self._shown)
        header = list_rows(self.table)
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setSectionResizeMode(BackupColumn.NAME, QHeaderView.ResizeMode.Stretch)
        header.setMinimumSectionSize(_NARROWEST_COLUMN_PX)
        self.only_differences = QCheckBox()
        self.all_button, self.none_button = (push_button(on_enter=False) for _ in range(2))
        self.progress = quiet_progress()
        choice = in_row(self.only_differences, STRETCH, self.all_button, self.none_button)
        fill(self.body, self._origin, choice, (self.table, 1), self.progress, self._message)
        self.read_button, self.save_button = (push_button(on_enter=False) for _ in range(2))
        self.open_button = push_button(on_enter=False)
        self.restore_button = push_button(primary=True, on_enter=False)
        fill(self.footer, self.read_button, STRETCH, self.save_button)
        fill(self.footer, self.open_button, self.restore_button, CloseButton(self))

    def _connect(self) -> None:
        self.only_differences.toggled.connect(self._shown.show_only_differences)
        self.all_button.clicked.connect(lambda: self._model.choose(lambda _row: True))
        self.none_button.clicked.connect(lambda: self._model.choose(lambda _row: False))
        self.read_button.clicked.connect(self._on_read)
        self.save_button.clicked.connect(self._on_save)
        self.open_button.clicked.connect(self._on_open)
        self.restore_button.clicked.connect(self._on_restore)
        self._model.ticked.connect(self._show_possible)
        self._reader.progressed.connect(self._on_progress)
        self._reader.finished.connect(self._on_read_to_the_end)
        self._settings.changed.connect(self._on_settings_changed)
        self._controller.state_changed.connect(self._on_state)
        self._controller.operating_state_changed.connect(self._on_operating_state_changed)

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.set_title(self.tr("Parameter backup"))
        self.table.setAccessibleName(self.tr("Parameters in the file and in the arm"))
        self.only_differences.setText(self.tr("Only differences"))
        self.all_button.setText(self.tr("Select all"))
        self.none_button.setText(self.tr("Select none"))
        self.save_button.setText(self.tr("Save to a file…"))
        self.open_button.setText(self.tr("Open a file…"))
        self.restore_button.setText(self.tr("Restore"))
        self._model.retranslate()
        self._show_all()

    # What the operator does -------------------------------------------------------------------

    def showEvent(self, event: QShowEvent) -> None:
        """Read the arm at each opening."""
        super().showEvent(event)
        # the window system shows it again, as after minimizing: not an opening
        if event.spontaneous():
            return
        if self._restoring:
            self._show_all()
        else:
            self._start_reading()

    def closeEvent(self, event: QCloseEvent) -> None:
        """Stop reading the arm."""
        self._reader.stop()
        self._drop_file()
        super().closeEvent(event)

    def _on_read(self) -> None:
        if self._reader.running:
            self._reader.stop()
            self._show_message(
                self.tr("Reading was stopped; what was read is shown."), Level.WARNING
            )
        else:
            self._start_reading()

    def _start_reading(self) -> None:
        self._restoring = {}
        self._model.follow([])
        self._could_read = bool(self._known())
        # a refusal need not be stored: `_show_all` shows the reason for as long as it holds
        self._reader.start()
        self._show_message("")

    def _on_save(self) -> None:
        backup = self._now()
        if backup is None or not backup.values:
            self._refuse(BACKUP_NOTHING_READ())
            return
        firmware = f"-{backup.firmware}" if backup.firmware else f"-gen{backup.generation}"
        choose_file(
            self,
            self._controller,
            title=self.tr("Save the parameters of the arm"),
            name_filter=self.tr("Parameter backup") + f" (*{SUFFIX})",
            start=self._path,
            new_file=f"{backup.model}{firmware}-{backup.saved_at:%Y%m%d-%H%M%S}{SUFFIX}",
            on_chosen=lambda path: self._write(path, backup),
        )

    def _write(self, path: Path, backup: Backup) -> None:
        job: Job[Refusal | None] = Job(partial(self._on_written, path, backup))
        self._background.begin_here(job, write_backup, path, backup)

    def _on_written(self, path: Path, backup: Backup, refusal: Refusal | None) -> None:
        if refusal is not None:
            self._refuse(refusal)
            return
        self._path = path
        missing = len(self._known()) - len(backup.values)
        self._show_message(*saved_text(path, len(backup.values), missing))

    def _on_open(self) -> None:
        choose_file(
            self,
            self._controller,
            title=self.tr("Open a parameter backup"),
            name_filter=self.tr("Parameter backup") + f" (*{SUFFIX})",
            start=self._path,
            on_chosen=self.open_file,
        )

    def open_file(self, path: Path) -> None:
        """Compare a file with the arm; one that cannot be read changes nothing."""
        self._drop_file()
        self._reading_file = Job(partial(self._on_file, path))
        self._background.begin_here(self._reading_file, read_backup, path)

    def _drop_file(self) -> None:
        """Cancel the reading of a file, because another one or none is wanted."""
        if self._reading_file is not None:
            self._reading_file.wanted = False
            self._reading_file = None

    def _on_file(self, path: Path, backup: Backup | Refusal) -> None:
        self._reading_file = None
        if isinstance(backup, Refusal):
            self._refuse(backup)
            return
        self._backup, self._path = backup, path
        self._restoring = {}
        self._model.follow([])
        self._compare()
        self._model.choose(lambda row: row.verdict is ComparisonVerdict.DIFFERS)
        generation = self._controller.operating_state.generation
        firmware = self._controller.state.firmware
        model = self._controller.operating_state.model
        self._show_message(difference_text(backup, generation, firmware, model), Level.WARNING)

    def _on_restore(self) -> None:
        chosen = self._model.chosen
        text = self.tr(
            "{count} parameters of the arm will be set to the values in the file, limits and "
            "collision levels included if they are ticked. Each is read back and compared."
        ).format(count=len(chosen))
        beyond = self._beyond(chosen)
        if beyond:
            text = "\n".join((text, *beyond[:_MOST_BEYOND], beyond_danger()))
        confirm(
            self,
            self._controller,
            title=self.tr("Restore parameters"),
            text=text,
            action_label=self.tr("Restore"),
            on_confirmed=partial(self._restore_now, chosen),
            hold=bool(beyond),
            still=lambda: self._model.chosen == chosen,
            on_withdrawn=self._on_withdrawn,
        )

    def _on_withdrawn(self, reason: Refusal) -> None:
        question = {"question": self.tr("Restore parameters"), "reason": words.refusal(reason)}
        self._show_message(said(QUESTION_WITHDRAWN, question), Level.WARNING)

    def _beyond(self, chosen: dict[Parameter, float]) -> list[str]:
        """Return a line for each value that goes beyond the factory's values of this model."""
        data = model_data(self._controller.operating_state.model)
        return [
            beyond_factory(parameter, value, bound)
            for parameter, value in chosen.items()
            if (bound := factory_bound(parameter, value, data)) is not None
        ]

    def _restore_now(self, chosen: dict[Parameter, float]) -> None:
        self._drop_file()
        self._restoring = chosen
        self._model.follow(list(chosen))
        answer = self._settings.save(chosen)
        if isinstance(answer, Refusal):
            self._restoring = {}
            self._model.follow([])
            self._refuse(answer)

    # Feedback of the arm ----------------------------------------------------------------------

    def _on_progress(self, done: int, total: int) -> None:
        self.progress.setRange(0, total)
        self.progress.setValue(done)

    def _on_read_to_the_end(self, refusal: Refusal | None) -> None:
        if refusal is not None:
            self._refuse(refusal)
        self._show_all()

    def _on_settings_changed(self) -> None:
        if not self.isVisible():
            return
        if self._restoring and not self._settings.busy:
            self._show_restored()
        self._show_all()

    def _show_restored(self) -> None:
        cells = [self._settings.cell(parameter) for parameter in self._restoring]
        self._restoring = {}
        failed = [cell.refusal for cell in cells if cell.state is not CellState.SAVED]
        self._show_message(*restored_text(len(cells), failed))

    def _on_state(self, _state: ArmState) -> None:
        """Compare again when values arrive that another panel or host has asked the arm for."""
        if self.isVisible() and self._rows() not in ([], self._model.rows):
            self._compare()

    def _on_operating_state_changed(self, _operating_state: OperatingState) -> None:
        """Read the parameters when the arm becomes reachable while the dialog is open."""
        if not self.isVisible():
            return
        could_read, self._could_read = self._could_read, bool(self._known())
        if self._could_read and not could_read and not self._restoring:
            self._reader.start()
        self._show_all()

    # Appearance -------------------------------------------------------------------------------

    def _known(self) -> list[Parameter]:
        batches = self._settings.everything()
        if isinstance(batches, Refusal):
            return []
        return [parameter for batch in batches for parameter in batch.parameters()]

    def _now(self) -> Backup | None:
        operating_state = self._controller.operating_state
        if operating_state.device is None or operating_state.generation is None:
            return None
        device = words.device_name(operating_state.device)
        now = datetime.now().astimezone()
        return backup_of(
            self._controller.state,
            self._known(),
            operating_state.generation,
            device,
            now,
            model=operating_state.model,
        )

    def _rows(self) -> list[ComparisonRow]:
        filed = {} if self._backup is None else self._backup.values
        return compare(filed, self._controller.state, self._known(), self._settings.holds)

    def _compare(self) -> None:
        if rows := self._rows():
            self._model.show_rows(rows)

    def _show_all(self) -> None:
        if not self.isVisible():
            return  # each opening reads and shows everything again
        self._compare()
        self._origin.setText(origin_text(self._backup, self._path))
        self._show_possible()
        unreachable = self._controller.operating_state.unreachable
        text, level = self._shown_message
        if unreachable is not None and not text:
            text, level = words.refusal(unreachable), Level.WARNING
        self._message.show_message(text, level)

    def _show_possible(self) -> None:
        """Enable what can be used now; say in the tooltips of the rest why not."""
        reading = self._reader.running
        self.progress.setVisible(reading)
        self.read_button.setText(self.tr("Stop reading") if reading else self.tr("Read"))
        unreachable = self._controller.operating_state.unreachable
        no_way = words.why_not(unreachable)
        occupied = self._controller.operating_state.occupied
        not_now = words.why_not(occupied)
        busy = words.refusal(BUSY(what="settings"))
        wait = busy if self._settings.busy or reading else ""
        no_file = "" if self._backup is not None else self.tr("Open a file first.")
        nothing = "" if self._model.chosen else self.tr("Tick what differs in the table first.")
        for button, reason in (
            (self.read_button, no_way or ("" if reading else wait)),
            (self.save_button, no_way or wait),
            (self.open_button, ""),
            (self.restore_button, no_file or no_way or not_now or wait or nothing),
            (self.all_button, no_file),
            (self.none_button, no_file),
        ):
            enable_or_explain(button, reason)

    def _refuse(self, refusal: Refusal) -> None:
        self._show_message(words.refusal(refusal), Level.WARNING)

    def _show_message(self, text: str, level: Level = Level.INFO) -> None:
        self._shown_message = (text, level)
        self._show_all()
