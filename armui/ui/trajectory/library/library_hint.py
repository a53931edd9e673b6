"""What stands in the list of the library while it lists nothing."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QTableView

from armui.ui.widgets.buttons import push_button
from armui.ui.widgets.table_model import TableHint


class LibraryHint(TableHint):
    """What to do when there is nothing, or nothing is found.

    Args:
        table: Over which.

    Signals:
        clear_wanted: The operator wants to see everything again.
    """

    clear_wanted = Signal()

    def __init__(self, table: QTableView) -> None:
        self._searched = ""
        self._clear = push_button("library_clear_search", on_enter=False)
        super().__init__(table, "library_hint", self._clear)
        self._clear.clicked.connect(lambda _checked=False: self.clear_wanted.emit())
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
        self.say(title, text)
