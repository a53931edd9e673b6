"""The values of every curve at the two cursors, and how far they are apart."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QEvent, Qt
from PySide6.QtWidgets import QTableWidgetItem, QWidget

from armui.arm.state import is_fresh
from armui.telemetry.quantities import QUANTITIES
from armui.ui import format as fmt
from armui.ui.watch.curves_item import CURSOR_NAMES
from armui.ui.watch.plot_board import clock_time
from armui.ui.widgets.layouts import in_column
from armui.ui.widgets.table_model import plain_table
from armui.ui.widgets.text_label import text_label
from armui.ui.words import quantities as names

if TYPE_CHECKING:
    from armui.telemetry.quantities import Quantity
    from armui.telemetry.store import Telemetry
    from armui.ui.watch.plot_board import PlotBoard

_HEIGHT_PX: Final = 168
_RIGHT: Final = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter


class CursorTable(QWidget):
    """The values of the curves at the cursors, visible together with them.

    Args:
        board: The board with the curves and cursors.
        telemetry: Gives the values.

    Attributes:
        is_wanted: True if it is shown together with the cursors.
    """

    def __init__(
        self, board: PlotBoard, telemetry: Telemetry, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._board = board
        self._telemetry = telemetry
        self.is_wanted = True
        self._times = text_label("cursor_times")
        self._times.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.table = plain_table("cursor_table", 4, wide=0)
        in_column(self._times, self.table, on=self, spacing=4, margins=0)
        self.setFixedHeight(_HEIGHT_PX)
        board.cursors_changed.connect(self.refresh)
        board.plots_changed.connect(self.refresh)
        self.refresh()

    def refresh(self) -> None:
        """Show the values at the cursors, or hide the table if there are none."""
        self.setVisible(self.is_wanted and self._board.has_cursors)
        if not self._board.has_cursors:
            return
        self._show_times()
        keys = list(dict.fromkeys(key for plot in self._board.plot_layout.plots for key in plot))
        self.table.setHorizontalHeaderLabels([self.tr("Quantity"), *CURSOR_NAMES, "B − A"])
        for column in range(1, self.table.columnCount()):
            title = self.table.horizontalHeaderItem(column)
            if title is not None:
                title.setTextAlignment(_RIGHT)
        self.table.setRowCount(len(keys))
        for row, key in enumerate(keys):
            for column, text in enumerate(self._texts(QUANTITIES[key])):
                item = QTableWidgetItem(text)
                if column:
                    item.setTextAlignment(_RIGHT)
                self.table.setItem(row, column, item)
        self.table.resizeColumnsToContents()  # the column of the names takes the rest

    def text(self) -> str:
        """Return the whole table as text for a spreadsheet."""
        rows = [[self.tr("Quantity"), *CURSOR_NAMES, "B − A"]]
        for row in range(self.table.rowCount()):
            items = [self.table.item(row, column) for column in range(4)]
            rows.append([item.text() if item is not None else "" for item in items])
        return "\n".join([self._times.text(), *("\t".join(row) for row in rows)])

    def _show_times(self) -> None:
        first_s, second_s = self._board.cursors_s
        wall_time = self._telemetry.wall_time
        texts = [
            f"{name} {fmt.NOTHING if at_s is None else clock_time(wall_time(at_s))}"
            for name, at_s in zip(CURSOR_NAMES, (first_s, second_s), strict=True)
        ]
        if first_s is not None and second_s is not None:
            texts.append(f"B − A {second_s - first_s:.3f} s")
        self._times.setText("      ".join(texts))

    def _texts(self, what: Quantity) -> list[str]:
        values = [self._value(what, at_s) for at_s in self._board.cursors_s]
        first, second = values
        difference = None if first is None or second is None else second - first
        return [
            names.quantity(what),
            *(names.quantity_value(what, value) for value in values),
            names.quantity_difference(what, difference),
        ]

    def _value(self, what: Quantity, at_s: float | None) -> float | None:
        """Return the value at a time; ``None`` if there was no sample for half a second before."""
        if at_s is None:
            return None
        found = self._telemetry.series[what.series].value_at(what.field, at_s)
        if found is None or not (what.held or is_fresh(found[0], at_s)):
            return None
        return found[1]

    def changeEvent(self, event: QEvent) -> None:
        """Update the texts after a change of language."""
        if event.type() == QEvent.Type.LanguageChange:
            self.refresh()
        super().changeEvent(event)
