"""The base of table models, the looks of tables, and a hint for an empty one."""

from __future__ import annotations

import enum
from collections.abc import Callable, Sequence, Sized
from dataclasses import dataclass
from typing import Any, Final, Generic, TypeVar

from PySide6.QtCore import (
    QAbstractTableModel,
    QCoreApplication,
    QEvent,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    QSize,
    Qt,
)
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QPushButton,
    QTableView,
    QTableWidget,
    QWidget,
)

from armui.ui.widgets.buttons import named
from armui.ui.widgets.layouts import STRETCH, in_column
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated

_Read = TypeVar("_Read", bound=Callable[..., object])
Index = QModelIndex | QPersistentModelIndex

RIGHT: Final = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
LEFT: Final = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
_WIDEST_PX: Final = 520
_SIDE_PX: Final = 24
_GAP_PX: Final = 10


class TableHint(Translated, QWidget):
    """Covers the rows with a title, a text, and buttons.

    Args:
        table: The table.
        name: The name of its text; the title is named ``<name>_title``.
        buttons: The buttons of possible actions.
    """

    def __init__(self, table: QAbstractItemView, name: str, *buttons: QPushButton) -> None:
        super().__init__(table.viewport())
        self._table, self._viewport = table, table.viewport()
        self._title = text_label(f"{name}_title", rank="title", wraps=True, plain=True)
        self._text = text_label(name, rank="muted", wraps=True, plain=True)
        for label in (self._title, self._text):
            label.setAlignment(Qt.AlignmentFlag.AlignHCenter)
        self._choices = QWidget()
        choices = in_column(on=self._choices, spacing=_GAP_PX, margins=0)
        for button in buttons:
            choices.addWidget(button, 0, Qt.AlignmentFlag.AlignHCenter)
        layout = in_column(STRETCH, on=self, spacing=_GAP_PX, margins=0)
        for widget in (self._title, self._text, self._choices):
            layout.addWidget(widget, 0, Qt.AlignmentFlag.AlignHCenter)
        layout.addStretch(2)
        table.viewport().installEventFilter(self)
        self.hide()

    def set_texts(self, title: str, text: str) -> None:
        """Set title and text."""
        self._title.setText(title)
        self._text.setText(text)
        self._fit()

    def _fit(self) -> None:
        width = max(1, min(_WIDEST_PX, self._viewport.width() - 2 * _SIDE_PX))
        for label in (self._title, self._text):
            # a layout does not give a centred label the height of its wrapped lines
            label.setFixedSize(width, label.heightForWidth(width))
        # in a low table the buttons are hidden first, as the bar has them, too, and then the text
        room = self._viewport.height() - self._title.height()
        for widget, needed in (
            (self._text, self._text.height()),
            (self._choices, self._choices.sizeHint().height()),
        ):
            room -= needed + _GAP_PX
            widget.setVisible(room >= 0)

    def setVisible(self, visible: bool) -> None:  # noqa: N802 - Qt's name
        """Show or hide it; the horizontal scroll bar is off while it is shown."""
        super().setVisible(visible)
        never, needed = Qt.ScrollBarPolicy.ScrollBarAlwaysOff, Qt.ScrollBarPolicy.ScrollBarAsNeeded
        self._table.setHorizontalScrollBarPolicy(never if visible else needed)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Follow the size of the rows' area."""
        if watched is self._viewport and event.type() == QEvent.Type.Resize:
            self.setGeometry(self._viewport.rect())
            self._fit()
        return super().eventFilter(watched, event)

    def changeEvent(self, event: QEvent) -> None:
        """Fit again after a change of font."""
        if event.type() == QEvent.Type.FontChange:
            self._fit()
        super().changeEvent(event)


def chosen_rows(view: QAbstractItemView) -> list[int]:
    """Return the rows with selected cells, in order, without asking every cell."""
    ranges = view.selectionModel().selection().toList()
    return sorted({row for each in ranges for row in range(each.top(), each.bottom() + 1)})


def rows_hint(table: QTableView, count: int) -> QSize:
    """Return the least size of a table that shows so many whole rows below its titles."""
    rows_px = count * table.verticalHeader().defaultSectionSize() + 2 * table.frameWidth()
    bar_px = table.horizontalScrollBar().sizeHint().height()
    return QSize(0, table.horizontalHeader().sizeHint().height() + rows_px + bar_px)


def list_rows(table: QTableView) -> QHeaderView:
    """Make a table look like a list: whole rows are selected, without grid and row titles.

    Returns:
        The header of its columns, aligned to the left.
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
    """Return an empty table.

    Args:
        name: Its object name.
        columns: The number of columns.
        wide: The column that takes the rest of the width.
    """
    table = named(name, QTableWidget(0, columns))
    table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
    table.setAlternatingRowColors(True)
    table.setTextElideMode(Qt.TextElideMode.ElideMiddle)
    list_rows(table).setSectionResizeMode(wide, QHeaderView.ResizeMode.Stretch)
    return table


def _alike(*_: object) -> None:
    """Return ``None``: all cells sort alike."""


@dataclass(frozen=True)
class ViewColumn(Generic[_Read]):
    """A column of a table, with all that belongs to it; see :class:`ViewColumns`.

    Attributes:
        title: Its English title.
        read: Returns what a cell shows, of an object given by the table.
        order: Returns the sort key of a cell; by default all are equal.
        tip: The English tooltip of its title.
        width_px: Its initial width; 0 if it is set otherwise.
        sample: The longest text, if the width is made for it.
        figures: True for figures, which are aligned to the right with their title.
    """

    title: str
    read: _Read
    order: Callable[..., Any] = _alike
    tip: str = ""
    width_px: int = 0
    sample: str = ""
    figures: bool = False


class ViewColumns(enum.IntEnum):
    """The columns of a table from left to right: a member for each, whose number is its place.

    Their texts are translated in the context of the class.
    """

    declared: ViewColumn[Any]

    def __new__(cls, declared: ViewColumn[Any]) -> ViewColumns:
        """Number a column."""
        column = int.__new__(cls, len(cls.__members__))
        column._value_ = int(column)
        column.declared = declared
        return column

    @property
    def title(self) -> str:
        """Its title in the operator's language."""
        return QCoreApplication.translate(type(self).__name__, self.declared.title)

    def read(self, *of: object) -> Any:
        """Return what a cell shows, of an object given by the table."""
        return self.declared.read(*of)

    def header(self, role: int) -> Any:
        """Return its title, the tooltip of that or its alignment, as Qt asks for them."""
        if role == Qt.ItemDataRole.DisplayRole:
            return self.title
        if role == Qt.ItemDataRole.ToolTipRole and self.declared.tip:
            return QCoreApplication.translate(type(self).__name__, self.declared.tip)
        right = role == Qt.ItemDataRole.TextAlignmentRole and self.declared.figures
        return RIGHT if right else None


def set_widths(table: QTableView, columns: type[ViewColumns]) -> None:
    """Set the widths of the columns that declare one."""
    for column in columns:
        if column.declared.width_px:
            table.setColumnWidth(column, column.declared.width_px)


class TableModel(QAbstractTableModel):
    """Counts rows and columns, names the columns, and can report that all cells have changed."""

    _table: Sequence[ViewColumns] = ()
    """The columns; a table of another kind counts them, and names them if they have titles."""
    _columns: int
    _rows: Sized = ()

    def titles(self) -> Sequence[str]:
        """Return the titles of the columns in the operator's language, if they have any."""
        return ()

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008, N802 - Qt's signature
        """Return the number of rows."""
        return 0 if parent.isValid() else len(self._rows)

    def columnCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008, N802 - as above
        """Return the number of columns."""
        return 0 if parent.isValid() else self._columns

    def headerData(  # noqa: N802 - Qt's name
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        """Return the titles of the columns."""
        if orientation is not Qt.Orientation.Horizontal:
            return None
        if self._table:
            return self._table[section].header(role)
        if role != Qt.ItemDataRole.DisplayRole:
            return None
        titles = self.titles()
        return titles[section] if section < len(titles) else None

    def redraw(self) -> None:
        """Report to the view that every cell may have changed."""
        rows = self.rowCount()
        if rows:
            self.dataChanged.emit(self.index(0, 0), self.index(rows - 1, self._columns - 1))

    def retranslate(self) -> None:
        """Update titles and cells after a change of language."""
        self.headerDataChanged.emit(Qt.Orientation.Horizontal, 0, self._columns - 1)
        self.redraw()
