"""What stands in a table while it has no rows: what that means, and what to do first."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtWidgets import QAbstractItemView, QPushButton, QWidget

from armui.ui.widgets.layouts import STRETCH, in_column
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated

_WIDEST_PX: Final = 520
_SIDE_PX: Final = 24
_GAP_PX: Final = 10


class TableHint(Translated, QWidget):
    """Lies over the rows: a title, some words, and buttons below them.

    Args:
        table: Over which.
        name: Of its text; the title is called ``<name>_title``.
        buttons: What can be done at once.
    """

    def __init__(self, table: QAbstractItemView, name: str, *buttons: QPushButton) -> None:
        super().__init__(table.viewport())
        self._viewport = table.viewport()
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

    def say(self, title: str, text: str) -> None:
        """Show other words."""
        self._title.setText(title)
        self._text.setText(text)
        self._fit()

    def _fit(self) -> None:
        width = max(1, min(_WIDEST_PX, self._viewport.width() - 2 * _SIDE_PX))
        for label in (self._title, self._text):
            # in the middle of a layout a label does not get the height of its lines by itself
            label.setFixedSize(width, label.heightForWidth(width))
        # in a low table the title comes first, and the buttons, which the bar has too, last
        room = self._viewport.height() - self._title.height()
        for widget, needed in (
            (self._text, self._text.height()),
            (self._choices, self._choices.sizeHint().height()),
        ):
            room -= needed + _GAP_PX
            widget.setVisible(room >= 0)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Be as large as the rows' place."""
        if watched is self._viewport and event.type() == QEvent.Type.Resize:
            self.setGeometry(self._viewport.rect())
            self._fit()
        return super().eventFilter(watched, event)

    def changeEvent(self, event: QEvent) -> None:
        """Follow the font, too."""
        if event.type() == QEvent.Type.FontChange:
            self._fit()
        super().changeEvent(event)
