"""The button that opens the window of what was deleted recently."""

from __future__ import annotations

from PySide6.QtWidgets import QPushButton, QWidget

from armui.control.arm_controller import ArmController
from armui.control.events import Level
from armui.ui.trajectory.library.bin_dialog import BinDialog
from armui.ui.trajectory.library.library_actions import LibraryActions
from armui.ui.trajectory.library.library_work import LibraryWork
from armui.ui.widgets.translated import Translated


class BinButton(Translated, QPushButton):
    """Keeps what the window lists up to date while it is open.

    Args:
        controller: Whom the emergency stop in the window tells.
        work: Asks the library what was deleted.
        actions: Brings back, and says what it did.
        window: The window belongs to it.
    """

    def __init__(
        self, controller: ArmController, work: LibraryWork, actions: LibraryActions, window: QWidget
    ) -> None:
        super().__init__(window)
        self._controller = controller
        self._work = work
        self._actions = actions
        self._dialog: BinDialog | None = None
        self.setObjectName("library_bin")
        self.setAutoDefault(False)
        self.clicked.connect(lambda _checked=False: self._open())
        self.retranslate_ui()

    def _open(self) -> None:
        if self._dialog is None:
            self._dialog = BinDialog(self._controller, self.window())
            self._dialog.wanted.connect(self._actions.bring_back)
            self._actions.said.connect(self._dialog.say)
        self._dialog.say("")
        self.refresh()
        self._dialog.open()

    def refresh(self) -> None:
        """List what can be brought back now, if anybody looks."""
        if self._dialog is None:
            return
        self._work.do(
            self._work.library.recently_deleted, self._dialog.show_deleted, self._on_refused
        )

    def _on_refused(self, text: str) -> None:
        if self._dialog is not None:
            self._dialog.show_deleted(())
            self._dialog.say(text, Level.FAULT)

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self.setText(self.tr("Recently deleted…"))
