"""The line in 轨迹库 that says that another program has the library open, too."""

from __future__ import annotations

from collections.abc import Sequence

from armui.control.events import Level
from armui.ui.trajectory.text import name_list
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.translated import Translated


class LibraryCompany(Translated, MessageLine):
    """Not there while this program is alone."""

    def __init__(self) -> None:
        super().__init__()
        self._others: Sequence[str] = ()
        self.setObjectName("library_company")
        self.hide()

    def show_others(self, others: Sequence[str]) -> None:
        """Name the other programs, each by its computer and process."""
        if tuple(others) != tuple(self._others):
            self._others = tuple(others)
            self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self.setVisible(bool(self._others))
        if not self._others:
            self.show_message("")
            return
        text = self.tr(
            "Another program has this library open, too ({names}). What it saves appears in this "
            "list. Do not edit the same trajectory in both."
        )
        self.show_message(text.format(names=name_list(list(self._others))), Level.WARNING)
