"""The button that closes a dialog."""

from __future__ import annotations

from PySide6.QtWidgets import QDialog, QPushButton

from armui.ui.widgets.translated import Translated


class CloseButton(Translated, QPushButton):
    """Names itself.

    Args:
        dialog: What it closes.
        on_enter: Whether Enter presses it wherever in the dialog.
    """

    def __init__(self, dialog: QDialog, *, on_enter: bool = False) -> None:
        super().__init__()
        self.setAutoDefault(on_enter)
        self.setDefault(on_enter)
        self.clicked.connect(dialog.close)
        self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Its word in the operator's language."""
        self.setText(self.tr("Close"))
