"""The table of points as a widget: rows are selected, edited in place and dragged."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import (
    QItemSelection,
    QItemSelectionModel,
    QModelIndex,
    QPoint,
    QRect,
    QSize,
    Qt,
    Signal,
)
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QResizeEvent
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QLabel, QMenu, QTableView, QWidget

from armui.arm.refusal import Refusal
from armui.trajectory.points.cells import PointColumn
from armui.ui import words
from armui.ui.theme import colors_of
from armui.ui.trajectory.editor.point_delegate import CellEditor, PointDelegate, TextEditor
from armui.ui.trajectory.editor.points_model import LOOKS, POSES, PointsModel
from armui.ui.widgets.table_model import chosen_rows, rows_hint

_ROW_PX: Final = 32
_ARC_ROW_PX: Final = 44
"""The height of rows with a middle pose, which has two lines."""
_LEAST_ROWS: Final = 3
"""The least number of visible rows; the page scrolls before."""
_NOTE_PX: Final = 360
_NOTED_PX: Final = 46
"""The width wanted for notes above their minimum, where the window has room."""
_BAR_PX: Final = 3
_SHORTENED_PX: Final = {PointColumn.MIDDLE: 51, PointColumn.GRIPPER: 58}
"""The least widths of columns that are shortened; a tooltip shows the whole text."""


class PointsTable(QTableView):
    """Shows a :class:`PointsModel`.

    Attributes:
        points: The model.

    Signals:
        row_chosen: The current row, −1 if there is none.
    """

    row_chosen = Signal(int)

    def __init__(self, model: PointsModel) -> None:
        super().__init__()
        self.setObjectName("points_table")
        self.setModel(model)
        self.points = model
        self._delegate = delegate = PointDelegate(self)
        self.setItemDelegate(delegate)
        self._untaken: tuple[QModelIndex, Refusal] | None = None
        self._whole_px = {PointColumn.GRIPPER: LOOKS[PointColumn.GRIPPER].width_px}
        self._note = QLabel(self.viewport())
        self._note.setObjectName("cell_problem")
        self._note.setWordWrap(True)
        self._note.setTextFormat(Qt.TextFormat.PlainText)
        self._note.setProperty("problem", True)
        self._note.hide()
        self._set_up()
        delegate.refused.connect(self.show_problem)
        delegate.accepted.connect(self._note.hide)
        model.refused.connect(self.show_problem)
        model.moved.connect(self.select_rows)
        model.dataChanged.connect(self._forget_problem)
        self.verticalScrollBar().valueChanged.connect(self._note.hide)
        self.horizontalScrollBar().valueChanged.connect(self._note.hide)
        self.selectionModel().currentRowChanged.connect(self._on_current)

    def _set_up(self) -> None:
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        trigger = QAbstractItemView.EditTrigger
        self.setEditTriggers(trigger.DoubleClicked | trigger.EditKeyPressed | trigger.AnyKeyPressed)
        self.setDragEnabled(True)
        self.setAcceptDrops(True)
        self.setDragDropMode(QAbstractItemView.DragDropMode.InternalMove)
        self.setDragDropOverwriteMode(False)
        self.setDropIndicatorShown(True)
        self.setWordWrap(False)
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
        down = self.verticalHeader()
        down.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        down.setDefaultSectionSize(_ROW_PX)
        down.setDefaultAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        down.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        down.customContextMenuRequested.connect(self._on_number_menu)
        across = self.horizontalHeader()
        across.setHighlightSections(False)
        # one of its own: with the table's the header would ask every cell whether it is selected
        across.setSelectionModel(QItemSelectionModel(self.points, across))
        across.setResizeContentsPrecision(0)  # only rows in sight are asked how wide they are
        across.setStretchLastSection(True)
        for column, look in LOOKS.items():
            self.setColumnWidth(column, look.width_px)
        self.verticalScrollBar().valueChanged.connect(self._on_scrolled)

    def minimumSizeHint(self) -> QSize:
        """Return room for some whole rows; the page scrolls before."""
        return rows_hint(self, _LEAST_ROWS)

    @property
    def wanted_px(self) -> int:
        """The width at which every column is in sight, also beside a scroll bar, and notes wide."""
        bar_px = self.verticalScrollBar().sizeHint().width()
        beside_px = self.verticalHeader().width() + bar_px + 2 * self.frameWidth()
        return self._columns_px + _NOTED_PX + beside_px

    @property
    def _columns_px(self) -> int:
        """The width of all columns, with nothing shortened but the notes."""
        others = set(PointColumn) - {*self._whole_px, PointColumn.NOTE}
        whole_px = sum(self._whole_px.values()) + LOOKS[PointColumn.NOTE].width_px
        return sum(map(self.columnWidth, others), whole_px)

    def _shorten(self) -> None:
        """Narrow columns until all are visible, or without room for that those before the lamps."""
        over_px = self._columns_px - self.viewport().width()
        if over_px > sum(px - _SHORTENED_PX[each] for each, px in self._whole_px.items()):
            over_px -= self.columnWidth(PointColumn.LIGHT) + LOOKS[PointColumn.NOTE].width_px
        for column, whole_px in sorted(self._whole_px.items()):
            width_px = max(_SHORTENED_PX[column], whole_px - max(0, over_px))
            over_px -= whole_px - width_px
            self.setColumnWidth(column, width_px)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Fit the columns to the new width, and to the rows that are in sight by it."""
        super().resizeEvent(event)
        self.make_room()

    def _on_number_menu(self, at: QPoint) -> None:
        """Show the same actions beside a row's number, for that row."""
        numbers = self.verticalHeader()
        if (row := numbers.logicalIndexAt(at)) not in self.rows():
            self.select_row(row)
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        menu.addActions(self.actions())
        menu.popup(numbers.viewport().mapToGlobal(at))

    def show_middle(self, *, wanted: bool) -> None:
        """Show or hide the column of the arcs' middle poses."""
        self._whole_px.pop(PointColumn.MIDDLE, None)
        if wanted:
            self._whole_px[PointColumn.MIDDLE] = LOOKS[PointColumn.MIDDLE].width_px
        self.setColumnHidden(PointColumn.MIDDLE, not wanted)
        self.verticalHeader().setDefaultSectionSize(_ARC_ROW_PX if wanted else _ROW_PX)

    def make_room(self) -> None:
        """Widen columns for the contents of the visible rows."""
        self._widen()
        widest = f"▶ 00{max(10, self.points.rowCount())}"  # zeros for the style's margins
        self.verticalHeader().setMinimumWidth(self.fontMetrics().horizontalAdvance(widest))
        self._shorten()

    def _on_scrolled(self) -> None:
        if self._widen():  # else widths set by the operator stay
            self._shorten()

    def _widen(self) -> bool:
        """Give columns what they want at most; return whether one wants more than before."""
        grown = False
        for column, look in LOOKS.items():
            if not look.most_px or self.isColumnHidden(column):
                continue
            wanted_px = min(self.sizeHintForColumn(column), look.most_px)
            if wanted_px <= self._whole_px.get(column, self.columnWidth(column)):
                continue
            grown = True
            if column in self._whole_px:
                self._whole_px[column] = wanted_px
            else:
                self.setColumnWidth(column, wanted_px)
        return grown

    def drop_figures(self) -> bool:
        """Close a pose that is being typed, untaken; return whether there was one."""
        editors = self.viewport().findChildren(TextEditor)
        if self.state() != self.State.EditingState or self.currentIndex().column() not in POSES:
            return False
        for editor in editors:
            self.closeEditor(editor, PointDelegate.EndEditHint.RevertModelCache)
        return bool(editors)

    # Rows -------------------------------------------------------------------------------------

    def rows(self) -> list[int]:
        """Return the selected rows, from top to bottom."""
        return chosen_rows(self)

    def current_row(self) -> int:
        """Return the current row; −1 in an empty table."""
        return self.currentIndex().row()

    def select_row(self, row: int) -> None:
        """Select one row, and scroll to it."""
        if 0 <= row < self.points.rowCount():
            self.select_rows(row, 1)

    def select_rows(self, first: int, count: int) -> None:
        """Select consecutive rows, and scroll to the first of them."""
        top = self.points.index(first, 0)
        bottom = self.points.index(first + count - 1, len(PointColumn) - 1)
        column = max(0, self.currentIndex().column())
        flag = QItemSelectionModel.SelectionFlag
        models = self.selectionModel()
        models.setCurrentIndex(self.points.index(first, column), flag.NoUpdate)
        models.select(QItemSelection(top, bottom), flag.ClearAndSelect | flag.Rows)
        self.scrollTo(self.points.index(first, column))

    def _on_current(self, current: QModelIndex, _previous: QModelIndex) -> None:
        self.row_chosen.emit(current.row())

    # Painting ---------------------------------------------------------------------------------

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the cells between the colours of their rows and the marks of the current ones."""
        colors = colors_of(self)
        lit = self.points.current
        painter = QPainter(self.viewport())
        for row in self._rows_within(event.rect().top(), event.rect().bottom()):
            fault = self.points.fault(row)
            if row == lit:
                painter.fillRect(self._band(row), QColor(colors.accent_pale))
            elif fault is not None:
                pale = colors.stop_pale if fault else colors.warn_pale
                painter.fillRect(self._band(row), QColor(pale))
        painter.end()
        super().paintEvent(event)
        painter.begin(self.viewport())
        if lit >= 0:
            bar = self._band(lit)
            bar.setWidth(_BAR_PX)
            painter.fillRect(bar, QColor(colors.accent))
        if self.hasFocus() and self.currentIndex().isValid():
            painter.setPen(QColor(colors.accent))
            painter.drawRect(self.visualRect(self.currentIndex()).adjusted(0, 0, -1, -1))
        painter.end()

    def _rows_within(self, top_px: int, bottom_px: int) -> range:
        first, last = self.rowAt(top_px), self.rowAt(bottom_px)
        if first < 0:
            return range(0)
        return range(first, self.points.rowCount() if last < 0 else last + 1)

    def _band(self, row: int) -> QRect:
        """Return the rectangle of a row over the whole width of the table."""
        top, height = self.rowViewportPosition(row), self.rowHeight(row)
        return QRect(0, top, self.viewport().width(), height)

    # What is wrong with a cell ----------------------------------------------------------------

    def take_entry(self) -> tuple[int, Refusal] | None:
        """Take what is being typed in a cell; return its row, and why that cannot be taken.

        An entry that was refused when its cell was left is returned once: the cell shows the old
        figure again, which the operator did not ask for.
        """
        for editor in self.viewport().findChildren(QWidget):
            if isinstance(editor, CellEditor) and editor.isVisible():
                if not self._delegate.can_take(editor):
                    break
                self.commitData(editor)
                self.closeEditor(editor, PointDelegate.EndEditHint.NoHint)
        untaken, self._untaken = self._untaken, None
        return None if untaken is None else (untaken[0].row(), untaken[1])

    def closeEditor(  # noqa: N802 - Qt's name
        self, editor: QWidget, hint: PointDelegate.EndEditHint
    ) -> None:
        """Close a cell's editor; an entry that is given up holds back nothing."""
        super().closeEditor(editor, hint)
        given_up = hint == PointDelegate.EndEditHint.RevertModelCache
        if given_up and self._untaken is not None and self._untaken[0] == self.currentIndex():
            self._forget_problem()

    def _forget_problem(self) -> None:
        self._note.hide()
        self._untaken = None

    def show_problem(self, index: QModelIndex, reason: Refusal) -> None:
        """Show at a cell why its entry is refused."""
        self._untaken = index, reason
        self._note.setText(words.refusal(reason))
        cell = self.visualRect(index)
        self._note.setFixedWidth(min(_NOTE_PX, self.viewport().width()))
        self._note.adjustSize()
        x = max(0, min(cell.x(), self.viewport().width() - self._note.width()))
        below = cell.bottom() + 2
        fits = below + self._note.height() <= self.viewport().height()
        self._note.move(x, below if fits else max(0, cell.top() - self._note.height() - 2))
        self._note.show()
        self._note.raise_()
