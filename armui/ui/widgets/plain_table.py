"""A small table that is only read: no editing, no grid, rows chosen whole."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QTableView, QTableWidget

from armui.ui.widgets.buttons import named


def list_rows(table: QTableView) -> QHeaderView:
    """Have a table show its rows as a list does: chosen whole, without grid and row titles.

    Returns:
        The titles of its columns, at the left.
    """
    table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
    table.setShowGrid(False)
    table.setTabKeyNavigation(False)
    table.verticalHeader().hide()
    across = table.horizontalHeader()
    across.setHighlightSections(False)
    across.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
    return across


def plain_table(name: str, columns: int, *, wide: int) -> QTableWidget:
    """An empty table.

    Args:
        name: Its object name.
        columns: How many.
        wide: The column that takes the room that is left.
    """
    table = named(name, QTableWidget(0, columns))
    table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
    table.setAlternatingRowColors(True)
    table.setTextElideMode(Qt.TextElideMode.ElideMiddle)
    list_rows(table).setSectionResizeMode(wide, QHeaderView.ResizeMode.Stretch)
    return table
