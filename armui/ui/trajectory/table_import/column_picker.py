"""What one column of an unknown table is, and in which unit: said above its figures."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import QComboBox, QWidget

from armui.trajectory.columns import (
    UNITS,
    ColumnQuantity,
    Guess,
    TableColumn,
    exceeds_radians,
    likely_unit,
    looks_like_radians,
)
from armui.ui import words
from armui.ui.widgets.buttons import named
from armui.ui.widgets.layouts import in_column
from armui.ui.widgets.text_label import ElidedLabel
from armui.ui.widgets.translated import Translated

_MARGIN_PX: Final = 3
_SURE: Final = 1.0
"""The confidence of a guess whose title says quantity and unit."""


class ColumnPicker(Translated, QWidget):
    """The title of a column, its quantity and its unit.

    Args:
        number: Of the column, from 1; messages name it.
        title: In the file; "" where it has none.
        guess: What it begins with.

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
        self._guess = guess
        self._guessed = guess.column is not None and guess.confidence < _SURE
        self._title = ElidedLabel()
        self._quantity = _Choice(f"column_quantity_{number}")
        for quantity in (None, *ColumnQuantity):
            self._quantity.addItem("", quantity)
        self._unit = _Choice(f"column_unit_{number}")
        self._origin = named(f"column_origin_{number}", ElidedLabel())
        self._origin.setProperty("rank", "warning")
        parts = (self._title, self._quantity, self._unit, self._origin)
        in_column(*parts, on=self, spacing=4, margins=(_MARGIN_PX, 0, _MARGIN_PX, 0))
        if guess.column is not None:
            self._quantity.setCurrentIndex(1 + list(ColumnQuantity).index(guess.column.quantity))
        self._fill_units()
        if guess.column is not None:
            self.show_unit(guess.column.unit)
        self._quantity.activated.connect(self._on_quantity)
        self._unit.activated.connect(self._on_unit)
        self.retranslate_ui()

    @property
    def column(self) -> TableColumn | None:
        """What it holds; ``None`` if it is left out."""
        quantity = self._quantity.currentData()
        if quantity is None:
            return None
        return TableColumn(ColumnQuantity(quantity), self._unit.currentText())

    @property
    def guessed(self) -> bool:
        """Whether its unit, or what it holds, is neither the title's word nor the operator's."""
        return self._guessed

    @property
    def looks_like_radians(self) -> bool:
        """Whether its figures may be radians."""
        return looks_like_radians(self._guess.figures)

    @property
    def exceeds_radians(self) -> bool:
        """Whether a figure of it is more than any joint turns in radians."""
        return exceeds_radians(self._guess.figures)

    @property
    def is_titled(self) -> bool:
        """Whether its title names its unit."""
        column = self.column
        return column is not None and column.unit == self._guess.titled_unit

    def show_column(self, column: TableColumn | None, *, guessed: bool) -> None:
        """Show what the operator has said before.

        Args:
            column: What it holds.
            guessed: Whether its unit was guessed.
        """
        place = 0 if column is None else 1 + list(ColumnQuantity).index(column.quantity)
        self._quantity.setCurrentIndex(place)
        self._fill_units()
        if column is not None:
            self.show_unit(column.unit)
        self._guessed = guessed
        self._show_origin()

    def show_unit(self, unit: str) -> None:
        """Show another unit, if its quantity can have it."""
        place = self._unit.findText(unit)
        if place >= 0:
            self._unit.setCurrentIndex(place)

    def show_certain(self) -> None:
        """What it says comes from the operator now."""
        self._guessed = False
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
        """The unit that the title names wins; another is guessed, and marked."""
        self._fill_units()
        quantity = self._quantity.currentData()
        self._guessed = False
        if quantity is not None:
            self.show_unit(likely_unit(ColumnQuantity(quantity), self._guess))
            self._guessed = self._unit.isEnabled() and not self.is_titled
        self._show_origin()
        self.quantity_chosen.emit()

    def show_unit_of(self, other: ColumnPicker) -> None:
        """Take the unit of another column of the kind, unless the title names one."""
        column = other.column
        if column is not None and not self.is_titled:
            self.show_unit(column.unit)

    def _on_unit(self) -> None:
        self.show_certain()
        self.unit_chosen.emit()

    def _show_origin(self) -> None:
        self._origin.show_text(self.tr("Guessed: check it") if self._guessed else "")

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
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
    """Not turned by a wheel that was meant to move the table."""

    def __init__(self, name: str) -> None:
        super().__init__()
        self.setObjectName(name)
        self.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Leave it to what is behind."""
        event.ignore()
