"""Below the plots: what is dropped here gets a plot of its own."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QLabel, QWidget

from armui.ui.watch.carrying import from_mime
from armui.ui.widgets.translated import Translated

if TYPE_CHECKING:
    from PySide6.QtGui import QDragEnterEvent, QDropEvent


class DropStrip(Translated, QLabel):
    """Takes quantities.

    Signals:
        dropped: Their keys, and the plot they come from or ``None``.
    """

    dropped = Signal(object, object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("drop_strip")
        self.setProperty("rank", "muted")
        self.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.setWordWrap(True)
        self.setAcceptDrops(True)
        self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """What it is for, in the operator's language."""
        self.setText(self.tr("Drag a quantity into a plot, or here for a plot of its own"))

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        """Quantities may be dropped here."""
        if from_mime(event.mimeData())[0]:
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        """A plot of their own."""
        keys, plot = from_mime(event.mimeData())
        if keys:
            event.acceptProposedAction()
            self.dropped.emit(keys, plot)
