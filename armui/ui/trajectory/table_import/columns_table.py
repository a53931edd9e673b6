"""The first rows of an unknown table, with the meaning of each column above."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from typing import Any, Final

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QColor, QWheelEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QComboBox,
    QFrame,
    QHeaderView,
    QScrollArea,
    QTableView,
    QWidget,
)

from armui.trajectory.columns import (
    UNITS,
    ColumnQuantity,
    Guess,
    Sheet,
    TableColumn,
    likely_unit,
    units_in_doubt,
)
from armui.trajectory.columns.model import JOINTS, POSE
from armui.ui import words
from armui.ui.theme import colors_of
from armui.ui.widgets.buttons import named
from armui.ui.widgets.layouts import STRETCH, in_column, in_row
from armui.ui.widgets.table_model import RIGHT, Index, TableModel
from armui.ui.widgets.text_label import ElidedLabel
from armui.ui.widgets.translated import Translated

_LINE_PX: Final = 20
_MARGIN_PX: Final = 3
_SURE: Final = 1.0
"""The confidence of a guess whose title names quantity and unit."""


class ColumnPicker(Translated, QWidget):
    """The title of a column, its quantity and its unit.

    Args:
        number: The column's number, from 1; messages name it.
        title: The title in the file; "" if there is none.
        guess: The initial guess.

    Attributes:
        guess: As given.
        guessed: True if quantity or unit comes neither from the title nor from the operator.

    Signals:
        quantity_chosen: The operator chose another quantity.
        unit_chosen: The operator chose another unit.
    """

    quantity_chosen = Signal()
    unit_chosen = Signal()

    def __init__(self, number: int, title: str, guess: Guess) -> None:
        super().__init__()
        self._number = number
        self._title_text = title
        self.guess = guess
        self._title = ElidedLabel()
        self._quantity = _Choice(f"column_quantity_{number}")
        for quantity in (None, *ColumnQuantity):
            self._quantity.addItem("", quantity)
        self._unit = _Choice(f"column_unit_{number}")
        self._origin = named(f"column_origin_{number}", ElidedLabel("warning"))
        for label in (self._title, self._origin):  # the same height for Chinese, Latin and no text
            label.setFixedHeight(_LINE_PX)
        parts = (self._title, self._quantity, self._unit, self._origin)
        in_column(*parts, on=self, spacing=4, margins=(_MARGIN_PX, 0, _MARGIN_PX, 0))
        unsure = guess.column is not None and guess.confidence < _SURE
        self.show_column(guess.column, guessed=unsure)
        self._quantity.activated.connect(self._on_quantity)
        self._unit.activated.connect(self._on_unit)
        self.retranslate_ui()

    @property
    def column(self) -> TableColumn | None:
        """The quantity and unit; ``None`` if the column is left out."""
        quantity = self._quantity.currentData()
        if quantity is None:
            return None
        return TableColumn(ColumnQuantity(quantity), self._unit.currentText())

    @property
    def is_titled(self) -> bool:
        """True if its title names its unit."""
        column = self.column
        return column is not None and column.unit == self.guess.titled_unit

    def show_column(self, column: TableColumn | None, *, guessed: bool) -> None:
        """Show the guess, or an earlier choice of the operator.

        Args:
            column: The quantity and unit.
            guessed: True if its unit was guessed.
        """
        place = 0 if column is None else 1 + list(ColumnQuantity).index(column.quantity)
        self._quantity.setCurrentIndex(place)
        self._fill_units()
        if column is not None:
            self.show_unit(column.unit)
        self.guessed = guessed
        self._show_origin()

    def show_unit(self, unit: str) -> None:
        """Show another unit, if its quantity can have it."""
        self._unit.setCurrentText(unit)

    def show_certain(self) -> None:
        """Mark the choice as the operator's own."""
        self.guessed = False
        self._show_origin()

    def _fill_units(self) -> None:
        quantity = self._quantity.currentData()
        units = () if quantity is None else tuple(UNITS[ColumnQuantity(quantity)])
        before = self._unit.currentText()
        self._unit.clear()
        self._unit.addItems(units)
        self._unit.setEnabled(len(units) > 1)
        self.show_unit(before)

    def _on_quantity(self) -> None:
        """Set the unit that the title names, or else a guessed one, which is marked."""
        self._fill_units()
        quantity = self._quantity.currentData()
        self.guessed = False
        if quantity is not None:
            self.show_unit(likely_unit(ColumnQuantity(quantity), self.guess))
            self.guessed = self._unit.isEnabled() and not self.is_titled
        self._show_origin()
        self.quantity_chosen.emit()

    def show_unit_of(self, other: ColumnPicker) -> None:
        """Use the unit of another column of the same kind, unless the title names one."""
        column = other.column
        if column is not None and not self.is_titled:
            self.show_unit(column.unit)

    def _on_unit(self) -> None:
        self.show_certain()
        self.unit_chosen.emit()

    def _show_origin(self) -> None:
        self._origin.show_text(self.tr("Guess: check it") if self.guessed else "")

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        column = self.tr("Column {number}").format(number=self._number)
        titled = f"{self._number}. {self._title_text}"
        self._title.show_text(titled if self._title_text else column)
        short = {ColumnQuantity.WAIT: self.tr("Wait"), ColumnQuantity.GRIPPER: self.tr("Gripper")}
        self._quantity.setItemText(0, self.tr("Ignored"))
        for place, quantity in enumerate(ColumnQuantity, start=1):
            full = words.point_figure(quantity.value)
            self._quantity.setItemText(place, short.get(quantity, full))
            self._quantity.setItemData(place, full, Qt.ItemDataRole.ToolTipRole)
        self._quantity.setAccessibleName(self.tr("{column}: quantity").format(column=column))
        self._unit.setAccessibleName(self.tr("{column}: unit").format(column=column))
        self._show_origin()


class _Choice(QComboBox):
    """A box that ignores the wheel, which is meant to scroll the table."""

    def __init__(self, name: str) -> None:
        super().__init__()
        self.setObjectName(name)
        self.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Leave the wheel to the widget behind."""
        event.ignore()


_COLUMN_PX: Final = 103
_ROW_PX: Final = 26
_ROWS: Final = 10
_MOST_COLUMNS: Final = 60
"""The most columns shown beside those that a title names."""
_LONGEST_CELL: Final = 200
"""The most characters of a cell that are shown."""
_KIN: Final = (JOINTS, POSE[:3], POSE[3:])
"""The quantities that share a unit in most files."""

ChosenColumns = Mapping[int, tuple[TableColumn | None, bool]]


class ColumnsTable(QScrollArea):
    """The columns side by side, each with a unit of its own.

    Args:
        sheet: The table's layout, with its first rows and the guesses.
        chosen: The :attr:`chosen` of a table that was shown before.

    Attributes:
        chosen: The operator's own choices by index, each with whether its unit was guessed.

    Signals:
        changed: The operator chose another quantity or unit.
    """

    changed = Signal()

    def __init__(self, sheet: Sheet, chosen: ChosenColumns | None = None) -> None:
        super().__init__()
        self._width = sheet.width
        self._places = _shown(sheet)
        self._pickers: list[ColumnPicker] = []
        self.chosen = dict(chosen or {})
        titles = sheet.header or ("",) * sheet.width
        for place in self._places:
            picker = ColumnPicker(place + 1, titles[place], sheet.guesses[place])
            picker.setFixedWidth(_COLUMN_PX)
            if place in self.chosen:
                column, guessed = self.chosen[place]
                picker.show_column(column, guessed=guessed)
            picker.quantity_chosen.connect(lambda picker=picker: self._on_quantity(picker))
            picker.unit_chosen.connect(lambda picker=picker: self._note([picker]))
            self._pickers.append(picker)
        self._model = _Preview(sheet.preview[:_ROWS], self._places, self._is_used, self._muted)
        self._lay_out()

    def _lay_out(self) -> None:
        above = in_row(*self._pickers, STRETCH, spacing=0, margins=0)
        inner = QWidget()
        in_column(above, _rows_of(self._model), STRETCH, on=inner, margins=0)
        self.setWidget(inner)
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)

    @property
    def columns(self) -> tuple[TableColumn | None, ...]:
        """The operator's quantity and unit of each column; hidden ones are left out."""
        columns: list[TableColumn | None] = [None] * self._width
        for place, picker in zip(self._places, self._pickers, strict=True):
            columns[place] = picker.column
        return tuple(columns)

    @property
    def hidden_count(self) -> int:
        """The number of columns that are not shown, because there are too many."""
        return self._width - len(self._places)

    def _asking(
        self, needed: Collection[ColumnQuantity]
    ) -> tuple[list[ColumnPicker], tuple[str, ...]]:
        """Return columns of angles whose unit neither titles nor figures show, and likely units."""
        angles = [each for each in self._pickers if each.column and each.column.quantity in needed]
        unsaid = [each for each in angles if each.guessed and not each.is_titled]
        if not unsaid or any(each.is_titled for each in angles):
            return [], ()
        units = units_in_doubt(
            [(each.column.quantity, each.guess) for each in angles if each.column]
        )
        return (unsaid, units) if units else ([], ())

    def in_doubt(self, needed: Collection[ColumnQuantity]) -> tuple[list[int], tuple[str, ...]]:
        """Return the numbers of columns whose unit only the operator knows, and the likely units.

        Args:
            needed: The quantities to be imported.
        """
        asking, units = self._asking(needed)
        return [1 + self._places[self._pickers.index(each)] for each in asking], units

    def set_unit(self, needed: Collection[ColumnQuantity], unit: str) -> None:
        """Set the unit of those columns by the operator's answer."""
        asking, _units = self._asking(needed)
        for picker in asking:
            picker.show_unit(unit)
            picker.show_certain()
        self._note(asking)

    def _on_quantity(self, chosen: ColumnPicker) -> None:
        """Take over the unit of similar columns, unless the title names another one."""
        for other in self._kin_of(chosen):
            chosen.show_unit_of(other)
        self._note([chosen])

    def _kin_of(self, chosen: ColumnPicker) -> list[ColumnPicker]:
        """Return the other columns that are in the same unit."""
        group = _kin(chosen.column)
        return [
            picker
            for picker in self._pickers
            if picker is not chosen and picker.column is not None and _kin(picker.column) & group
        ]

    def _note(self, pickers: Sequence[ColumnPicker]) -> None:
        """Store the choices of these columns as the operator's own."""
        for picker in pickers:
            place = self._places[self._pickers.index(picker)]
            self.chosen[place] = (picker.column, picker.guessed)
        self._model.redraw()
        self.changed.emit()

    def _is_used(self, column: int) -> bool:
        return self._pickers[column].column is not None

    def _muted(self) -> QColor:
        return QColor(colors_of(self).faint)


class _Preview(TableModel):
    """Cells as they stand in the file; columns that are ignored turn pale."""

    def __init__(
        self,
        rows: Sequence[Sequence[str]],
        places: Sequence[int],
        is_used: Callable[[int], bool],
        pale: Callable[[], QColor],
    ) -> None:
        super().__init__()
        self._rows: Sequence[Sequence[str]] = rows
        self._places = places
        self._columns = len(places)
        self._is_used = is_used
        self._pale = pale

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """Return a cell; nothing if a row is too short."""
        if not index.isValid():
            return None
        row, column = self._rows[index.row()], index.column()
        if role in {Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.ToolTipRole}:
            place = self._places[column]
            return row[place].strip()[:_LONGEST_CELL] if place < len(row) else ""
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return RIGHT
        if role == Qt.ItemDataRole.ForegroundRole and not self._is_used(column):
            return self._pale()
        return None


def _shown(sheet: Sheet) -> list[int]:
    """Return the places of the columns shown: the first ones, and all that hold something."""
    guessed = {place for place, guess in enumerate(sheet.guesses) if guess.column is not None}
    return sorted(guessed.union(range(min(sheet.width, _MOST_COLUMNS))))


def _rows_of(model: _Preview) -> QTableView:
    """Return a table as large as what it shows: it is moved together with the choices above it."""
    table = named("columns_preview", QTableView())
    model.setParent(table)  # a view does not own its model: without a parent Python would delete it
    table.setModel(model)
    table.setSelectionMode(QAbstractItemView.SelectionMode.NoSelection)
    table.setFocusPolicy(Qt.FocusPolicy.NoFocus)
    table.setShowGrid(False)
    table.setAlternatingRowColors(True)
    table.setWordWrap(False)
    table.horizontalHeader().hide()
    table.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
    table.horizontalHeader().setDefaultSectionSize(_COLUMN_PX)
    table.verticalHeader().hide()
    table.verticalHeader().setDefaultSectionSize(_ROW_PX)
    table.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    table.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    frame_px = 2 * table.frameWidth()
    table.setFixedSize(
        model.columnCount() * _COLUMN_PX + frame_px, model.rowCount() * _ROW_PX + frame_px
    )
    return table


def _kin(column: TableColumn | None) -> frozenset[ColumnQuantity]:
    quantity = None if column is None else column.quantity
    return frozenset(next((kin for kin in _KIN if quantity in kin), ()))
