"""What every dialog of the program shares: the emergency stop, and a change of language."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QContextMenuEvent, QMoveEvent, QShowEvent
from PySide6.QtWidgets import QDialog, QWidget

from armui.control.arm_controller import ArmController
from armui.ui.dialogs.placing import FRAME, place
from armui.ui.widgets.curve_menu import offer_curves
from armui.ui.widgets.halt_button import HaltButton
from armui.ui.widgets.keeps_focus import KeepsFocus
from armui.ui.widgets.layouts import in_column, in_row
from armui.ui.widgets.stop_button import StopButton
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated

_MARGIN_PX: Final = 20
_GAP_PX: Final = 14


class ArmDialog(Translated, KeepsFocus, QDialog):
    """A dialog with its title, halt and emergency stop at the top.

    It never blocks the main window: the stop there stays within reach too. Escape closes it.

    Args:
        controller: Whom the emergency stop tells.
        parent: The window it belongs to and stays in front of.

    Attributes:
        body: Where its own content goes.
        footer: Where its buttons go, from left to right.
    """

    def __init__(self, controller: ArmController, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setModal(False)
        self._moved = False
        self._heading = text_label(rank="title", wraps=True, plain=True)
        self.halt_button = HaltButton(controller, self)
        self.stop_button = StopButton(controller, self)

        self._header = header = in_row((self._heading, 1), spacing=_GAP_PX)
        header.addWidget(self.halt_button, 0, Qt.AlignmentFlag.AlignTop)
        header.addWidget(self.stop_button, 0, Qt.AlignmentFlag.AlignTop)
        self.body = in_column(spacing=_GAP_PX)
        self.footer = in_row(spacing=_GAP_PX // 2)
        in_column(header, (self.body, 1), self.footer, on=self, spacing=_GAP_PX, margins=_MARGIN_PX)

    def add_to_header(self, widget: QWidget) -> None:
        """Put something between the title and the stops."""
        self._header.insertWidget(1, widget, 0, Qt.AlignmentFlag.AlignVCenter)

    def set_title(self, title: str) -> None:
        """Name the dialog, in its frame and at its top."""
        self.setWindowTitle(title)
        self._heading.setText(title)

    def open(self) -> None:
        """Show the dialog in front; unlike Qt's own, without blocking the window behind it."""
        if not self.isVisible() and not self._moved:
            place(self)
        self.show()
        self.raise_()
        self.activateWindow()

    def showEvent(self, event: QShowEvent) -> None:
        """The keyboard goes to the first control of the content, never to halt or stop."""
        super().showEvent(event)
        if not event.spontaneous() and self.focusWidget() in {None, self.halt_button}:
            self.go_on_from(self.stop_button, forward=True)

    def event(self, event: QEvent) -> bool:
        """Grow where text goes on below and would be cut; Qt counts the height of one line only."""
        done = super().event(event)
        if event.type() == QEvent.Type.LayoutRequest and self.isVisible():
            room = self.screen().availableGeometry().marginsRemoved(FRAME)
            layout = self.layout()
            least = 0 if layout is None else layout.minimumHeightForWidth(self.width())
            needed = min(least, room.height())
            if needed > self.height():
                self.resize(self.width(), needed)
                self.move(self.x(), max(room.top(), min(self.y(), room.bottom() - needed)))
        return done

    def moveEvent(self, event: QMoveEvent) -> None:
        """Where the operator has put it, it opens again."""
        super().moveEvent(event)
        if event.spontaneous() and self.isVisible():
            self._moved = True

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language; called anew when that changes."""

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """A figure can be shown as a curve."""
        offer_curves(self, event)
