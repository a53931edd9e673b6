"""Find and replace: in the notes, or a figure of one column."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QComboBox, QLineEdit, QWidget

from armui.arm.refusal import Refusal
from armui.trajectory.points import edits
from armui.trajectory.points.cells import figure
from armui.trajectory.points.program import JOINT_NAMES, POSE_NAMES, Waypoint
from armui.ui import words
from armui.ui.widgets.buttons import named, push_button
from armui.ui.widgets.flow import in_flow
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated

_NOTE: Final = "note"
_FIELDS: Final = (_NOTE, *JOINT_NAMES, *POSE_NAMES, "speed", "dwell")


class FindBar(Translated, QWidget):
    """Asks for what to find and by what to replace it; its owner goes there and does it.

    Signals:
        next_wanted: +1 the next place, −1 the one before.
        replace_wanted: Whether at all places, or at the current one.
        closed: It was put away.
    """

    next_wanted = Signal(int)
    replace_wanted = Signal(bool)
    closed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._field = named("find_field", QComboBox())
        for name in _FIELDS:
            self._field.addItem(name, name)
        self._wanted = named("find_text", QLineEdit())
        self._by = named("replace_text", QLineEdit())
        self._result = text_label("find_result", rank="muted")
        self._next = push_button("find_next", on_enter=False)
        self._previous = push_button("find_previous", on_enter=False)
        self._replace = push_button("replace_one", on_enter=False)
        self._replace_all = push_button("replace_all", on_enter=False)
        self._close = push_button("find_close", on_enter=False)
        self._lay_out()
        self._next.clicked.connect(lambda: self.next_wanted.emit(1))
        self._previous.clicked.connect(lambda: self.next_wanted.emit(-1))
        self._replace.clicked.connect(lambda: self.replace_wanted.emit(False))
        self._replace_all.clicked.connect(lambda: self.replace_wanted.emit(True))
        self._close.clicked.connect(self._put_away)
        self._wanted.returnPressed.connect(lambda: self.next_wanted.emit(1))
        self._by.returnPressed.connect(lambda: self.replace_wanted.emit(False))
        self._wanted.textChanged.connect(self._result.clear)
        self.retranslate_ui()

    def _lay_out(self) -> None:
        of_finding = (self._field, self._wanted, self._previous, self._next)
        of_replacing = (self._by, self._replace, self._replace_all)
        in_flow(*of_finding, *of_replacing, self._result, on=self).push(self._close)

    def open(self) -> None:
        """Show it and wait for what to find."""
        self.show()
        self._wanted.setFocus()
        self._wanted.selectAll()

    def _put_away(self) -> None:
        self.hide()
        self.closed.emit()

    # The search -------------------------------------------------------------------------------

    def found(self, points: Sequence[Waypoint]) -> list[int] | Refusal:
        """The rows that hold what is looked for, or why nothing can be looked for."""
        field, text = str(self._field.currentData()), self._wanted.text()
        if field == _NOTE:
            return list(edits.find_text(points, text, match_case=True)) if text else []
        value = figure(field, text)
        if isinstance(value, Refusal):
            return value
        return list(edits.find_figure(points, edits.FigureQuery(field, value)))

    def replaced(self, point: Waypoint) -> Waypoint | Refusal:
        """A point that holds it with the other text or figure in its place."""
        field, by = str(self._field.currentData()), self._by.text()
        if field == _NOTE:
            return edits.replace_text(point, self._wanted.text(), by)
        value = figure(field, by)
        return value if isinstance(value, Refusal) else (edits.replace_figure(point, field, value))

    def show_result(self, text: str) -> None:
        """Say how many there are, or that there are none."""
        self._result.setText(text)

    def show_refusal(self, reason: Refusal) -> None:
        """Say why nothing could be looked for or replaced."""
        self._result.setText(words.refusal(reason))
        self._result.setToolTip(words.refusal(reason))

    # Words and keys ---------------------------------------------------------------------------

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self._field.setItemText(0, self.tr("Note"))
        self._field.setItemText(len(_FIELDS) - 2, self.tr("Speed"))
        self._field.setItemText(len(_FIELDS) - 1, self.tr("Dwell"))
        self._field.setAccessibleName(self.tr("Where to look"))
        self._wanted.setPlaceholderText(self.tr("Find"))
        self._by.setPlaceholderText(self.tr("Replace by"))
        self._next.setText(self.tr("Next"))
        self._previous.setText(self.tr("Previous"))
        self._replace.setText(self.tr("Replace"))
        self._replace_all.setText(self.tr("Replace all"))
        self._close.setText(self.tr("Close"))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Escape puts it away and nothing else."""
        if event.key() == Qt.Key.Key_Escape:
            self._put_away()
        else:
            super().keyPressEvent(event)
