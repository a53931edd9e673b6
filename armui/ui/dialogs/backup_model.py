"""The table of the window 参数备份: each parameter in the file and in the arm."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from PySide6.QtCore import (
    QSortFilterProxyModel,
    Qt,
    Signal,
)

from armui.arm.backup import ComparisonRow, ComparisonVerdict
from armui.arm.parameters import Parameter
from armui.arm.refusal import Refusal
from armui.control.parameters.setting_cell import CellState, SettingCellState
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.widgets.table_model import RIGHT, Index, TableModel
from armui.ui.words.parameters import full_name, value_text, verdict_word

NAME, FILED, HELD, STATE = range(4)


class BackupModel(TableModel):
    """Rows with a tick; only what can be restored, and would change something, can have one.

    Args:
        cell: How a parameter stands between the program and the arm.

    Signals:
        ticked: Other rows have a tick.
    """

    ticked = Signal()
    _columns = 4
    _figures = frozenset({FILED, HELD})

    def __init__(self, cell: Callable[[Parameter], SettingCellState]) -> None:
        super().__init__()
        self._cell = cell
        self._rows: list[ComparisonRow] = []
        self._told: list[tuple[ComparisonRow, SettingCellState]] = []
        self._chosen: set[Parameter] = set()
        self._restored: set[Parameter] = set()

    # What the dialog does ---------------------------------------------------------------------

    @property
    def rows(self) -> Sequence[ComparisonRow]:
        """The comparison shown."""
        return self._rows

    @property
    def chosen(self) -> dict[Parameter, float]:
        """What has a tick, with the file's values."""
        return {
            row.parameter: row.filed
            for row in self._rows
            if row.parameter in self._chosen and row.filed is not None and row.restorable
        }

    def show_rows(self, rows: Sequence[ComparisonRow]) -> None:
        """Show another comparison; ticks stay where the parameters do."""
        same = [row.parameter for row in rows] == [row.parameter for row in self._rows]
        if not same:
            self.beginResetModel()
        told, self._told = self._told, [(row, self._cell(row.parameter)) for row in rows]
        self._rows = list(rows)
        if not same:
            self.endResetModel()
        elif other := [at for at, what in enumerate(self._told) if what != told[at]]:
            end = self._columns - 1  # the view measures every cell that it is told of
            self.dataChanged.emit(self.index(other[0], 0), self.index(other[-1], end))
        self.ticked.emit()

    def choose(self, wanted: Callable[[ComparisonRow], bool]) -> None:
        """Tick the rows that are wanted and can be restored, and no others."""
        self._chosen = {row.parameter for row in self._rows if row.restorable and wanted(row)}
        self.redraw()
        self.ticked.emit()

    def follow(self, restored: Sequence[Parameter]) -> None:
        """Show how saving these ends; an empty list ends it."""
        if set(restored) != self._restored:
            self._restored = set(restored)
            self.redraw()

    # What Qt asks -----------------------------------------------------------------------------

    def flags(self, index: Index) -> Qt.ItemFlag:
        """Only what can be restored can be ticked."""
        flags = Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable
        if index.column() == NAME and self._rows[index.row()].restorable:
            flags |= Qt.ItemFlag.ItemIsUserCheckable
        return flags

    def titles(self) -> Sequence[str]:
        """Name, file, arm, and how the two compare."""
        return (
            self.tr("Parameter"),
            self.tr("In the file"),
            self.tr("In the arm"),
            self.tr("Comparison"),
        )

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """The words of a cell, its tick, and in the tooltip what there is to say."""
        row = self._rows[index.row()]
        if role == Qt.ItemDataRole.CheckStateRole and index.column() == NAME:
            if not row.restorable:
                return None
            ticked = row.parameter in self._chosen
            return Qt.CheckState.Checked if ticked else Qt.CheckState.Unchecked
        if role == Qt.ItemDataRole.DisplayRole:
            return self._text(row, index.column())
        if role == Qt.ItemDataRole.ToolTipRole:
            reason = self._reason(row)
            return "" if reason is None else words.refusal(reason)
        if role == Qt.ItemDataRole.TextAlignmentRole and index.column() in self._figures:
            return RIGHT
        return None

    def setData(  # noqa: N802 - the name Qt calls
        self, index: Index, value: Any, role: int = Qt.ItemDataRole.EditRole
    ) -> bool:
        """Take a tick."""
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

    def _text(self, row: ComparisonRow, column: int) -> str:
        if column == NAME:
            return full_name(row.parameter)
        if column == STATE:
            return self._state(row)
        value = row.filed if column == FILED else row.held
        return fmt.NOTHING if value is None else value_text(row.parameter.name, value)

    def _state(self, row: ComparisonRow) -> str:
        """The comparison; or, of what is being restored, how far that is."""
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
        return row.against or self._cell(row.parameter).reason


class DifferencesOnly(QSortFilterProxyModel):
    """Hides what is the same in the file and in the arm, if wanted."""

    def __init__(self, model: BackupModel) -> None:
        super().__init__()
        self._model = model
        self._only = False
        self.setSourceModel(model)

    def show_only_differences(self, wanted: bool) -> None:
        """Hide what is the same, or show it again."""
        self._only = wanted
        self.invalidate()

    def filterAcceptsRow(  # noqa: N802 - the name Qt calls
        self, source_row: int, _parent: Index
    ) -> bool:
        """Whether a row is shown."""
        return not self._only or self._model.rows[source_row].verdict is not ComparisonVerdict.SAME
