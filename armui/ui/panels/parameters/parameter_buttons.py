"""The row of buttons below a panel of parameters: read, initialise, edit or cancel, save."""

from __future__ import annotations

from typing import Final

from PySide6.QtWidgets import QWidget

from armui.ui.actions.keys import keys_of
from armui.ui.widgets.buttons import caption, push_button
from armui.ui.widgets.layouts import in_row

SAVE_KEY: Final = keys_of("parameters.save")
"""Of 【保存】, to be said in its tooltip."""
CANCEL_KEY: Final = keys_of("parameters.cancel")
_HEIGHT_PX: Final = 38
_GAP_PX: Final = 10


class ParameterButtons(QWidget):
    """【编辑】 and 【取消】 share a place: only one of them makes sense at a time.

    Args:
        name: For the names of the buttons: ``<name>_save_button``.
        can_reset: Whether there is a 【初始化】.
    """

    def __init__(self, name: str, *, can_reset: bool) -> None:
        super().__init__()
        self.read = push_button(f"{name}_read_button")
        self.reset = push_button(f"{name}_reset_button")
        self.edit = push_button(f"{name}_edit_button")
        self.cancel = push_button(f"{name}_cancel_button")
        self.save = push_button(f"{name}_save_button", primary=True)
        layout = in_row(on=self, spacing=_GAP_PX, margins=0)
        for button in (self.read, self.reset, self.edit, self.cancel, self.save):
            button.setMinimumHeight(_HEIGHT_PX)
            layout.addWidget(button, 1)
        self.reset.setVisible(can_reset)
        self.show_editing(editing=False)

    def show_editing(self, *, editing: bool) -> None:
        """Show the button that ends editing, or the one that begins it."""
        # the one that goes first: the row must never be wider than the panel
        leaving, coming = (self.edit, self.cancel) if editing else (self.cancel, self.edit)
        leaving.hide()
        coming.show()

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        caption(self.read, self.tr("Read"))
        caption(self.reset, self.tr("Initialise"))
        caption(self.edit, self.tr("Edit"))
        caption(self.cancel, self.tr("Cancel"))
        caption(self.save, self.tr("Save"), key=SAVE_KEY)
