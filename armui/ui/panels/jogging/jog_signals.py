"""What a row of targets tells, and whoever holds such rows: steps, holds, and edited targets."""

from __future__ import annotations

from functools import partial

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QWidget

from armui.ui.widgets.jog_button import JogButton
from armui.ui.widgets.translated import Translated


class JogSignals(Translated, QWidget):
    """Tells by the number of a row, and +1 or −1, what the operator wants moved."""

    stepped = Signal(int, int)
    """Jog by one step."""
    repeated = Signal(int, int)
    """The same, from a button that is still held."""
    held = Signal(int, int)
    """Jog until :attr:`let_go`."""
    let_go = Signal()
    unattended = Signal()
    """A held button was let go by itself: the operator gave no sign for too long."""
    edited = Signal(int)
    """The operator changed the target of the row; nothing is sent."""

    def _tell_presses(self, number: int, minus: JogButton, plus: JogButton) -> None:
        """Tell what the two buttons of a row are pressed for."""
        for button, direction in ((minus, -1), (plus, 1)):
            button.stepped.connect(partial(self.stepped.emit, number, direction))
            button.repeated.connect(partial(self.repeated.emit, number, direction))
            button.held.connect(partial(self.held.emit, number, direction))
            button.let_go.connect(self.let_go)
            button.unattended.connect(self.unattended)
