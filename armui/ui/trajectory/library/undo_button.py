"""The button that undoes what was last done to the library, and says what that is."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QPushButton, QWidget

from armui.ui.actions.keys import key_text, listen_for
from armui.ui.trajectory.library.library_actions import LibraryActions
from armui.ui.widgets.translated import Translated

_WIDEST_PX: Final = 210
_SIDES_PX: Final = 40


class UndoButton(Translated, QPushButton):
    """There while something can be undone; Ctrl+Z in its page presses it.

    Args:
        actions: Undoes.
        page: Where the key counts.
    """

    def __init__(self, actions: LibraryActions, page: QWidget) -> None:
        super().__init__(page)
        self._actions = actions
        self.setObjectName("library_undo")
        self.setAutoDefault(False)
        listen_for("library.undo", page, actions.undo)
        self.clicked.connect(lambda _checked=False: actions.undo())
        actions.undo_changed.connect(self.show_step)
        self.show_step()

    def show_step(self) -> None:
        """Say what would be undone now."""
        text, effect = self._actions.undo_text()
        room_px = _WIDEST_PX - _SIDES_PX
        self.setText(self.fontMetrics().elidedText(text, Qt.TextElideMode.ElideRight, room_px))
        self.setToolTip(f"{text} ({key_text('library.undo')})\n{effect}")
        self.setAccessibleName(text)
        self.setVisible(bool(text))

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self.show_step()
