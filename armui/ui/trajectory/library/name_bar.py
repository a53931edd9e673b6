"""A line that asks for the name of something new, which is made once the name is given."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QHideEvent, QKeyEvent
from PySide6.QtWidgets import QLabel, QLineEdit, QWidget

from armui.arm.refusal import Refusal
from armui.control.events import Level
from armui.ui import words
from armui.ui.actions.act import Act, HasActs
from armui.ui.widgets.buttons import named
from armui.ui.widgets.flow import in_flow
from armui.ui.widgets.message_line import MessageLine, Words
from armui.ui.widgets.translated import Translated

_NAME_PX: Final = 200


@dataclass(frozen=True, slots=True)
class NameQuestion:
    """A question for a name.

    Attributes:
        label: Says what is named.
        act: Says what the name does, on the button.
        suggest: Returns the initial name; "" for none.
        why_not: Returns the reason against a name.
        give: Called with the name that the operator has chosen.
    """

    label: Callable[[], str]
    act: Callable[[], str]
    suggest: Callable[[], str]
    why_not: Callable[[str], Refusal | None]
    give: Callable[[str], object]


class NameBar(HasActs, Translated, QWidget):
    """Asks for a name in a line that is hidden otherwise; Enter gives it, Escape cancels.

    The line stays until :meth:`put_away`: whoever gets the name may refuse it, and says so here.

    Signals:
        closed: It was put away.
    """

    closed = Signal()
    _give = Act("", named="library_name_give", primary=True)
    _cancel = Act("Cancel", named="library_name_cancel")

    def __init__(self) -> None:
        super().__init__()
        self._question: NameQuestion | None = None
        self._given = False
        self._label = QLabel()
        self._field = named("library_name", QLineEdit())
        self._field.setMinimumWidth(_NAME_PX)
        self._label.setBuddy(self._field)
        self._message = named("library_name_message", MessageLine(keeps_room=False))
        in_flow(self._label, self._field, self._give, self._cancel, self._message, on=self)
        self._field.textChanged.connect(self._show_usable)
        self._field.returnPressed.connect(self._on_given)
        self.hide()
        self.retranslate_ui()

    def ask(self, question: NameQuestion) -> None:
        """Show the line with the suggested name, which can be typed over."""
        self._question, self._given = question, False
        self._field.setText(question.suggest())
        self.retranslate_ui()
        self.show()
        self._field.setFocus()
        self._field.selectAll()

    def refresh_suggestion(self) -> None:
        """Renew a suggestion that nobody has changed: the names taken may be others now."""
        if self._question is None or self._given:
            return
        suggested = self._question.suggest()
        if not self._field.isModified() and suggested != self._field.text():
            self._field.setText(suggested)
            self._field.selectAll()
        elif self._question.why_not(self._name()) is not None:
            self._show_usable()

    def refuse(self, text: Words) -> None:
        """Say beside the field why the name did not do; another one can be typed."""
        self._given = False
        self._show_usable()
        self._message.show_message(text, Level.WARNING)
        self._field.setFocus()

    @_cancel.pressed
    def put_away(self) -> None:
        """Hide the line; the name typed is dropped."""
        if self._question is None:
            return
        self._question, self._given = None, False
        self.hide()
        self.closed.emit()

    @_give.pressed
    def _on_given(self) -> None:
        question = self._question
        if question is None or self._given or question.why_not(self._name()) is not None:
            return
        self._given = True  # a second press has no effect
        self._show_usable()
        question.give(self._name())

    def _name(self) -> str:
        return self._field.text().strip()

    def _show_usable(self) -> None:
        self.show_acts()
        begun = bool(self._name()) or self._field.isModified()  # an empty field is no mistake yet
        self._message.show_message(self._why_not_give() if begun else "", Level.WARNING)
        self._field.setReadOnly(self._given)
        if self._given:
            self._give.setEnabled(False)

    @_give.text
    def _what_gives(self) -> str:
        return "" if self._question is None else self._question.act()

    @_give.why_not
    def _why_not_give(self) -> str:
        return "" if self._question is None else words.why_not(self._question.why_not(self._name()))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Hide the line at Escape, and do nothing else; the field handles Enter."""
        if event.key() == Qt.Key.Key_Escape:
            self.put_away()
        elif event.key() not in {Qt.Key.Key_Return, Qt.Key.Key_Enter}:
            super().keyPressEvent(event)
            return
        event.accept()

    def hideEvent(self, event: QHideEvent) -> None:
        """Drop the question when the page is left."""
        if not event.spontaneous():
            self.put_away()
        super().hideEvent(event)

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        if self._question is not None:
            self._label.setText(self._question.label())
            self._field.setAccessibleName(self._question.label())
        self._show_usable()
