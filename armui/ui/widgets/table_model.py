"""What the models of the program's tables share: rows of one kind under titled columns."""

from __future__ import annotations

from collections.abc import Collection, Sequence, Sized
from typing import Any, Final

from PySide6.QtCore import QAbstractTableModel, QModelIndex, QPersistentModelIndex, Qt

Index = QModelIndex | QPersistentModelIndex

RIGHT: Final = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
LEFT: Final = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter


class TableModel(QAbstractTableModel):
    """Counts rows and columns, names the columns, and tells the view to read all cells again."""

    _columns: int
    _figures: Collection[int] = ()
    """Columns of figures: they stand at the right, and their titles with them."""
    _rows: Sized = ()

    def titles(self) -> Sequence[str]:
        """Of the columns, in the operator's language; none, if they have none."""
        return ()

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008, N802 - Qt's signature
        """How many rows there are."""
        return 0 if parent.isValid() else len(self._rows)

    def columnCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008, N802 - as above
        """How many columns there are."""
        return 0 if parent.isValid() else self._columns

    def headerData(  # noqa: N802 - Qt's name
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        """The titles of the columns."""
        if orientation is not Qt.Orientation.Horizontal:
            return None
        if role == Qt.ItemDataRole.TextAlignmentRole and section in self._figures:
            return RIGHT
        if role != Qt.ItemDataRole.DisplayRole:
            return None
        titles = self.titles()
        return titles[section] if section < len(titles) else None

    def redraw(self) -> None:
        """Tell the view that every cell may read or look otherwise."""
        rows = self.rowCount()
        if rows:
            self.dataChanged.emit(self.index(0, 0), self.index(rows - 1, self._columns - 1))

    def retranslate(self) -> None:
        """Titles and cells in another language."""
        self.headerDataChanged.emit(Qt.Orientation.Horizontal, 0, self._columns - 1)
        self.redraw()
