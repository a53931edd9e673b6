"""What stands in the list of the library while it lists nothing."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtWidgets import QTableView, QWidget

from armui.ui.widgets.buttons import push_button
from armui.ui.widgets.layouts import STRETCH, in_column
from armui.ui.widgets.text_label import text_label

_WIDEST_PX: Final = 520


class LibraryHint(QWidget):
    """Lies over a table without rows: what to do when there is nothing, or nothing is found.

    Args:
        table: Over which.

    Signals:
        clear_wanted: The operator wants to see everything again.
    """

    clear_wanted = Signal()

    def __init__(self, table: QTableView) -> None:
        super().__init__(table.viewport())
        self._searched = ""
        self._title = text_label("library_hint_title", rank="title", wraps=True, plain=True)
        self._text = text_label("library_hint", rank="muted", wraps=True, plain=True)
        for label in (self._title, self._text):
            label.setAlignment(Qt.AlignmentFlag.AlignHCenter)
            label.setFixedWidth(_WIDEST_PX)
        self._clear = push_button("library_clear_search", on_enter=False)
        self._clear.clicked.connect(lambda _checked=False: self.clear_wanted.emit())
        layout = in_column(STRETCH, on=self, spacing=10)
        for widget in (self._title, self._text, self._clear):
            layout.addWidget(widget, 0, Qt.AlignmentFlag.AlignHCenter)
        layout.addStretch(2)
        table.viewport().installEventFilter(self)
        self.hide()
        self.retranslate_ui()

    def show_state(self, shown: int, searched: str) -> None:
        """Fit the words to the list.

        Args:
            shown: How many rows there are.
            searched: For what; "" where everything is listed.
        """
        self._searched = searched
        self.retranslate_ui()
        self.setVisible(shown == 0)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Be as large as the list."""
        viewport = self.parentWidget()
        if watched is viewport and event.type() == QEvent.Type.Resize:
            self.setGeometry(viewport.rect())
        return super().eventFilter(watched, event)

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self._clear.setText(self.tr("Show all"))
        self._clear.setVisible(bool(self._searched))
        if self._searched:
            title = self.tr("Nothing is found for “{text}”").format(text=self._searched)
            text = self.tr("Neither a name nor a note holds this text.")
        else:
            title = self.tr("No trajectories yet")
            text = self.tr(
                "Create one and enter its points, record a motion of the arm, or import files. "
                "Files can also be dropped here."
            )
        for label, words in ((self._title, title), (self._text, text)):
            label.setText(words)
            # in the middle of a layout a label does not get the height of its lines by itself
            label.setFixedHeight(label.heightForWidth(_WIDEST_PX))

    def changeEvent(self, event: QEvent) -> None:
        """Follow the language."""
        if event.type() in {QEvent.Type.LanguageChange, QEvent.Type.FontChange}:
            self.retranslate_ui()
        super().changeEvent(event)
