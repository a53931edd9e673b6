"""The question before the program is closed while it moves the arm."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QPushButton, QWidget

from armui.ui.dialogs.confirm_dialog import ConfirmDialog

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController


class CloseQuestion(ConfirmDialog):
    """End the motion and close, let it finish and close, or stay.

    Args:
        controller: Whom the emergency stop tells.
        parent: The main window.

    Signals:
        let_finish: The program shall be closed and the arm go on to its target; accepted, the
            motion shall be ended before.
    """

    let_finish = Signal()

    def __init__(self, controller: ArmController, parent: QWidget) -> None:
        super().__init__(controller, parent, title="", text="", action_label="")
        self.set_title(self.tr("The arm is moving"))
        self.show_text(
            self.tr(
                "If the motion is ended, the arm comes to rest where it is; its motors stay "
                "enabled. If it is let finish, it goes on to its target, and this program cannot "
                "stop it any more. Press the emergency stop if it must not move."
            )
        )
        self.action_button.setText(self.tr("End the motion and close"))
        self.action_button.setProperty("primary", True)
        self.let_finish_button = QPushButton(self.tr("Let it finish and close"))
        self.let_finish_button.setAutoDefault(False)
        self.let_finish_button.clicked.connect(self._on_let_finish)
        self.footer.insertWidget(self.footer.count() - 1, self.let_finish_button)

    def _on_let_finish(self) -> None:
        self.reject()
        self.let_finish.emit()
