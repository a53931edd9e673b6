"""Everything that is marked on the time line, as a list; a click goes there."""

from __future__ import annotations

from bisect import bisect_right
from typing import TYPE_CHECKING, Any, Final

from PySide6.QtCore import QAbstractTableModel, QModelIndex, QPersistentModelIndex, Qt, Signal
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QTableView, QVBoxLayout, QWidget

from armui.session.session import MarkKind
from armui.ui.theme import colors_of
from armui.ui.watch.replay.log_time import duration, moment
from armui.ui.watch.replay.mark_search import end_of
from armui.ui.widgets.translated import Translated
from armui.ui.words.log_marks import log_mark

if TYPE_CHECKING:
    from collections.abc import Sequence

    from armui.session.session import SessionMark

_Index = QModelIndex | QPersistentModelIndex
_COLUMNS: Final = 4


class MarkModel(QAbstractTableModel):
    """Time, time since the beginning, how long, what.

    Args:
        marks: In the order of time.
        span_s: Log time of the beginning and of the end.
    """

    def __init__(
        self, marks: Sequence[SessionMark], span_s: tuple[float, float], owner: QWidget
    ) -> None:
        super().__init__(owner)
        self._marks = marks
        self._start_s, self._end_s = span_s
        self._owner = owner

    def rowCount(self, parent: _Index | None = None) -> int:  # noqa: N802 - the name Qt calls
        """One row a mark."""
        return 0 if parent is not None and parent.isValid() else len(self._marks)

    def columnCount(self, _parent: _Index | None = None) -> int:  # noqa: N802 - the name Qt calls
        """See the class."""
        return _COLUMNS

    def headerData(  # noqa: N802 - the name Qt calls
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        """What the columns are."""
        if role != Qt.ItemDataRole.DisplayRole or orientation is Qt.Orientation.Vertical:
            return None
        return (
            self.tr("Time"),
            self.tr("Since the beginning"),
            self.tr("Lasting"),
            self.tr("What happened"),
        )[section]

    def data(self, index: _Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """A cell."""
        mark = self._marks[index.row()]
        if role == Qt.ItemDataRole.ForegroundRole and mark.kind is not MarkKind.COMMAND:
            colors = colors_of(self._owner)
            return QColor(colors.muted if mark.kind is MarkKind.NOTE else colors.stop)
        if role != Qt.ItemDataRole.DisplayRole:
            return None
        if index.column() == 0:
            return moment(mark.at_s)
        if index.column() == 1:
            return duration(mark.at_s - self._start_s)
        if index.column() == 2:
            ended_s = end_of(mark, self._end_s)
            return "" if ended_s is None else duration(ended_s - mark.at_s)
        return log_mark(mark)

    def retranslate(self) -> None:
        """Every word anew."""
        self.headerDataChanged.emit(Qt.Orientation.Horizontal, 0, _COLUMNS - 1)
        if self._marks:
            self.dataChanged.emit(self.index(0, 0), self.index(len(self._marks) - 1, _COLUMNS - 1))


class MarkTable(Translated, QWidget):
    """Shows the marks; the one that the replay has passed last is chosen.

    Signals:
        wanted: Log time that the operator wants to be at.
    """

    wanted = Signal(float)

    def __init__(
        self,
        marks: Sequence[SessionMark],
        span_s: tuple[float, float],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._marks = marks
        self._times_s = [each.at_s for each in marks]
        self.model = MarkModel(marks, span_s, self)
        self.table = QTableView()
        self.table.setObjectName("replay_marks")
        self.table.setModel(self.model)
        self.table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.table.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.table.setShowGrid(False)
        self.table.setAlternatingRowColors(True)
        self.table.verticalHeader().hide()
        across = self.table.horizontalHeader()
        across.setHighlightSections(False)
        across.setSectionResizeMode(_COLUMNS - 1, QHeaderView.ResizeMode.Stretch)
        across.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        self.table.clicked.connect(self._on_chosen)
        self.table.activated.connect(self._on_chosen)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 8, 0, 0)
        layout.addWidget(self.table)
        self.retranslate_ui()

    def _on_chosen(self, index: QModelIndex) -> None:
        self.wanted.emit(self._times_s[index.row()])

    def show_position(self, at_s: float) -> None:
        """The replay is here."""
        row = bisect_right(self._times_s, at_s + 1e-4) - 1
        if self.isVisible() and row != self.table.currentIndex().row():
            self.table.setCurrentIndex(self.model.index(row, 0) if row >= 0 else QModelIndex())

    def retranslate_ui(self) -> None:
        """Put the words into the operator's language."""
        self.table.setAccessibleName(self.tr("Faults, stops and commands of the recording"))
        self.model.retranslate()
        for column in range(_COLUMNS - 1):
            self.table.horizontalHeader().setSectionResizeMode(
                column, QHeaderView.ResizeMode.Interactive
            )
            metrics = self.table.fontMetrics()
            sample = ("0000-00-00 00:00:00.000", "00:00:00.000", "0:00:00.000")[column]
            heading = str(self.model.headerData(column, Qt.Orientation.Horizontal))
            width = max(metrics.horizontalAdvance(sample), metrics.horizontalAdvance(heading))
            self.table.setColumnWidth(column, width + 28)
