"""Find and replace in the notes, or in the figures of one column."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QComboBox, QLineEdit, QWidget

from armui.arm.refusal import Refusal
from armui.trajectory.planning.search import NOTE, Search, replaced_everywhere
from armui.trajectory.planning.user_frames import RowsOrRefusal
from armui.trajectory.points import edits
from armui.trajectory.points.program import JOINT_NAMES, POSE_NAMES
from armui.ui import words
from armui.ui.actions.act import Act, ActFamily, HasActs
from armui.ui.trajectory.editor.long_edits import LongEdit, LongEdits
from armui.ui.widgets.buttons import named
from armui.ui.widgets.flow import in_flow
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated

if TYPE_CHECKING:
    from armui.ui.trajectory.editor.document import Document
    from armui.ui.trajectory.editor.points_table import PointsTable


_FIELDS: Final = (NOTE, *JOINT_NAMES, *POSE_NAMES, "speed", "dwell")
_AT_ONCE: Final = 500
"""The most rows replaced at once, in 10 ms; more are left to another process."""


class FindBar(HasActs, Translated, QWidget):
    """The fields for searching and replacing; its owner carries both out.

    Signals:
        next_wanted: +1 the next place, −1 the one before.
        replace_wanted: True for all places, false for the current one.
        closed: The bar was closed.
    """

    next_wanted = Signal(int)
    replace_wanted = Signal(bool)
    closed = Signal()
    _find = ActFamily(
        {-1: Act("Previous", named="find_previous"), 1: Act("Next", named="find_next")}
    )
    _replace = ActFamily(
        {False: Act("Replace", named="replace_one"), True: Act("Replace all", named="replace_all")}
    )
    _close = Act("Close", named="find_close")

    def __init__(self) -> None:
        super().__init__()
        self._field = named("find_field", QComboBox())
        for name in _FIELDS:
            self._field.addItem(name, name)
        self._wanted = named("find_text", QLineEdit())
        self._by = named("replace_text", QLineEdit())
        self._result = text_label("find_result", rank="muted")
        self._lay_out()
        self._wanted.returnPressed.connect(lambda: self.next_wanted.emit(1))
        self._by.returnPressed.connect(lambda: self.replace_wanted.emit(False))
        self._wanted.textChanged.connect(self._result.clear)
        self._wanted.textChanged.connect(self.show_acts)
        self.retranslate_ui()

    def _lay_out(self) -> None:
        of_finding = (self._field, self._wanted, *self._find.values())
        of_replacing = (self._by, *self._replace.values())
        in_flow(*of_finding, *of_replacing, self._result, on=self).push(self._close)

    @_find.why_not
    @_replace.why_not
    def _why_not(self, _which: int) -> str:
        return "" if self._wanted.text() else self.tr("Type what to find first.")

    @_find.pressed
    def _on_find(self, by: int) -> None:
        self.next_wanted.emit(by)

    @_replace.pressed
    def _on_replace(self, everywhere: bool) -> None:
        self.replace_wanted.emit(everywhere)

    def open(self) -> None:
        """Show the bar, and focus the search field."""
        self.show()
        self._wanted.setFocus()
        self._wanted.selectAll()

    @_close.pressed
    def put_away(self) -> None:
        """Hide the bar, and emit `closed`."""
        self.hide()
        self.closed.emit()

    # The search -------------------------------------------------------------------------------

    @property
    def search(self) -> Search:
        """The search, as entered in the fields."""
        return Search(str(self._field.currentData()), self._wanted.text(), self._by.text())

    def show_result(self, result: str | Refusal) -> None:
        """Show the number of matches, or why the search or replacement is not possible."""
        text = words.refusal(result) if isinstance(result, Refusal) else result
        self._result.setText(text)
        self._result.setToolTip(text)

    # Texts and keys ---------------------------------------------------------------------------

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._field.setItemText(0, self.tr("Note"))
        self._field.setItemText(len(_FIELDS) - 2, self.tr("Speed"))
        self._field.setItemText(len(_FIELDS) - 1, self.tr("Dwell"))
        self._field.setAccessibleName(self.tr("Where to search"))
        self._wanted.setPlaceholderText(self.tr("Find"))
        self._by.setPlaceholderText(self.tr("Replace with"))
        self.show_acts()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Close the bar at Escape."""
        if event.key() == Qt.Key.Key_Escape:
            self.put_away()
        else:
            super().keyPressEvent(event)


class Finder(QObject):
    """Carries out searches and replacements of the bar.

    Args:
        document: The document with the points.
        table: Shows the row that is found.
        bar: The bar with the search.
        long_edits: Replaces in many rows.
    """

    def __init__(
        self, document: Document, table: PointsTable, bar: FindBar, long_edits: LongEdits
    ) -> None:
        super().__init__(bar)
        self._document, self._table, self._bar = document, table, bar
        self._long_edits = long_edits
        bar.next_wanted.connect(self._find)
        bar.replace_wanted.connect(self._replace)

    def _find(self, by: int) -> None:
        rows = self._bar.search.rows(self._document.points, self._table.points.tool)
        if isinstance(rows, Refusal) or not rows:
            self._bar.show_result(rows if isinstance(rows, Refusal) else self.tr("Not found"))
            return
        here = self._table.current_row()
        ahead = [row for row in rows if row > here] if by > 0 else [r for r in rows if r < here]
        row = (ahead or rows)[0 if by > 0 else -1]
        self._table.select_row(row)
        self._bar.show_result(
            self.tr("{place} of {count}").format(place=rows.index(row) + 1, count=len(rows))
        )

    def _replace(self, everywhere: bool) -> None:
        points, tool = self._document.points, self._table.points.tool
        search = replace(self._bar.search, limits=self._table.points.limits())
        if everywhere:
            arguments = (search, points, tool)
            edit = LongEdit(len(points), _AT_ONCE, replaced_everywhere, arguments, self._put)
            self._long_edits.begin(edit, self._show_replaced)
            return
        rows, now = search.rows(points, tool), self._table.current_row()
        here = rows if isinstance(rows, Refusal) else [row for row in rows if row == now]
        put = self._put(here if isinstance(here, Refusal) else search.replaced(points, here, tool))
        if isinstance(put, Refusal):
            self._bar.show_result(put)
        else:
            self._find(1)

    def _put(self, changed: RowsOrRefusal) -> int | Refusal:
        """Carry a replacement out; return the number of rows, or why not."""
        if isinstance(changed, Refusal):
            return changed
        points = edits.change(self._document.points, changed)
        self._document.edit(points, self.tr("Replace"))
        return len(changed)

    def _show_replaced(self, replaced: int | Refusal) -> None:
        text = self.tr("{count} replaced").format(count=replaced)
        self._bar.show_result(replaced if isinstance(replaced, Refusal) else text)
