"""The list of the library as a widget."""

from __future__ import annotations

from collections.abc import Collection
from typing import Final

from PySide6.QtCore import QItemSelectionModel, QModelIndex, QSize, Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QAbstractItemView, QTableView

from armui.trajectory.library.store import IndexEntry
from armui.ui.trajectory.library.library_model import ENTRY_ROLE, LibraryColumn, LibraryFilter
from armui.ui.widgets.buttons import push_button
from armui.ui.widgets.table_model import TableHint, list_rows, rows_hint, set_widths

_ROW_PX: Final = 34
_NAME_PX: Final = 190
"""Up to this width a name is shown whole before a note is."""
_LEAST_ROWS: Final = 3
"""The least number of visible rows; the page scrolls before."""


class LibraryTable(QTableView):
    """The list: rows are selected, sorted by a click on a title, and renamed in place.

    Args:
        shown: The filtered entries.
    """

    def __init__(self, shown: LibraryFilter) -> None:
        super().__init__()
        self.setObjectName("library_table")
        self.setModel(shown)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setSortingEnabled(True)
        self.sortByColumn(LibraryColumn.NAME, Qt.SortOrder.AscendingOrder)
        self.setAlternatingRowColors(True)
        self.setWordWrap(False)
        self.verticalHeader().setDefaultSectionSize(_ROW_PX)
        across = list_rows(self)
        across.setStretchLastSection(True)
        across.setResizeContentsPrecision(0)  # only rows in sight are asked how wide they are
        set_widths(self, LibraryColumn)
        shown.modelReset.connect(self._make_room)

    def minimumSizeHint(self) -> QSize:
        """Return room for some whole rows; the page scrolls before."""
        return rows_hint(self, _LEAST_ROWS)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Show names whole as far as the new width allows it."""
        super().resizeEvent(event)
        self._make_room()

    def _make_room(self) -> None:
        """Widen the column of names for the longest one, then by the width that notes leave."""
        name, note = LibraryColumn.NAME, LibraryColumn.NOTE
        missing_px = self.sizeHintForColumn(name) - self.columnWidth(name)
        free_px = self.columnWidth(note) - max(note.declared.width_px, self.sizeHintForColumn(note))
        room_px = max(free_px, _NAME_PX - self.columnWidth(name))
        if missing_px > 0 and room_px > 0:
            self.setColumnWidth(name, self.columnWidth(name) + min(missing_px, room_px))

    def chosen(self) -> list[IndexEntry]:
        """Return the selected entries, from top to bottom."""
        rows = self.selectionModel().selectedRows()
        return [index.data(ENTRY_ROLE) for index in sorted(rows, key=QModelIndex.row)]

    def choose(self, names: Collection[str], *, show: bool = True) -> None:
        """Select exactly the entries of these names, and scroll to the last of them.

        Args:
            names: The names; those not listed are ignored.
            show: True to scroll to it.
        """
        flag = QItemSelectionModel.SelectionFlag
        self.clearSelection()
        for row in range(self.model().rowCount()):
            index = self.model().index(row, 0)
            if index.data(ENTRY_ROLE).name in names:
                self.selectionModel().select(index, flag.Select | flag.Rows)
                self.selectionModel().setCurrentIndex(index, flag.NoUpdate)
                if show:
                    self.scrollTo(index)

    def names(self) -> list[str]:
        """Return all listed names, from top to bottom."""
        model = self.model()
        return [model.index(row, 0).data(ENTRY_ROLE).name for row in range(model.rowCount())]

    @property
    def is_editing(self) -> bool:
        """True if a name is being typed."""
        return self.state() == QAbstractItemView.State.EditingState

    def edit_name(self) -> None:
        """Edit the name in the selected row."""
        rows = self.selectionModel().selectedRows(LibraryColumn.NAME)
        if rows:
            self.setFocus()
            self.setCurrentIndex(rows[0])
            self.edit(rows[0])


class LibraryHint(TableHint):
    """A hint shown when there is nothing, or nothing is found.

    Args:
        table: The table.

    Signals:
        clear_wanted: The operator wants to see everything again.
    """

    clear_wanted = Signal()

    def __init__(self, table: QTableView) -> None:
        self._searched = ""
        self._folder = ""
        self._clear = push_button("library_clear_search", on_enter=False)
        super().__init__(table, "library_hint", self._clear)
        self._clear.clicked.connect(lambda _checked=False: self.clear_wanted.emit())
        self.retranslate_ui()

    def show_state(self, shown: int, searched: str, folder: str = "") -> None:
        """Fit the texts to the list.

        Args:
            shown: The number of rows.
            searched: The text searched for; "" if everything is listed.
            folder: The sub-folder that is listed; "" if all are.
        """
        self._searched = searched
        self._folder = folder
        self.retranslate_ui()
        self.setVisible(shown == 0)

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._clear.setText(self.tr("Show all"))
        self._clear.setVisible(bool(self._searched))
        if self._searched:
            title = self.tr("Nothing found for “{text}”").format(text=self._searched)
            text = self.tr("Neither a name nor a note holds this text.")
        elif self._folder:
            title = self.tr("Nothing in this folder yet")
            text = self.tr(
                "What is created, recorded or imported now comes into it; “Move to…” brings "
                "others here."
            )
        else:
            title = self.tr("No trajectories yet")
            text = self.tr(
                "Create one and enter its points, record a motion of the arm, or import files. "
                "Files can also be dropped here."
            )
        self.set_texts(title, text)
