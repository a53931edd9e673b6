"""How far something is that takes long, and the button that calls it off."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtWidgets import QProgressBar, QWidget

from armui.ui.widgets.buttons import push_button
from armui.ui.widgets.layouts import in_row
from armui.ui.widgets.translated import Translated

if TYPE_CHECKING:
    from collections.abc import Callable

_STEPS: Final = 1000


class CallableOff(Translated, QWidget):
    """A progress bar with a button; hidden while nothing goes on.

    Args:
        call_off: Called by the button; until that has come to its end the button cannot be pressed.
    """

    def __init__(self, call_off: Callable[[], object], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._call_off = call_off
        self._is_called_off = False
        self.progress = QProgressBar()
        self.progress.setTextVisible(False)
        self.button = push_button(on_enter=False)
        self.button.clicked.connect(self._on_clicked)
        in_row((self.progress, 1), self.button, on=self, spacing=12, margins=0)
        self.retranslate_ui()
        self.hide()

    def show_progress(self, *, making: bool, share: float | None) -> None:
        """Show how far it is.

        Args:
            making: Whether anything goes on.
            share: From 0 to 1; ``None``: nobody knows.
        """
        self._is_called_off = self._is_called_off and making
        self.button.setEnabled(not self._is_called_off)
        self.progress.setRange(0, 0 if share is None else _STEPS)
        self.progress.setValue(0 if share is None else round(_STEPS * share))
        self.setVisible(making)

    def _on_clicked(self) -> None:
        self._is_called_off = True
        self.button.setEnabled(False)
        self._call_off()

    def retranslate_ui(self) -> None:
        """Put the word into the operator's language."""
        self.button.setText(self.tr("Cancel"))
