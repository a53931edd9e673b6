"""The question before the program is closed while it moves the arm."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QWidget

from armui.control.arm_controller import ArmController
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from armui.ui.widgets.buttons import push_button


class CloseQuestion(ConfirmDialog):
    """End the motion and close, let it finish and close, or stay.

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
        self.let_finish_button = push_button("", self.tr("Let it finish and close"), on_enter=False)
        self.let_finish_button.clicked.connect(self._on_let_finish)
        self.footer.insertWidget(self.footer.count() - 1, self.let_finish_button)

    def _on_let_finish(self) -> None:
        if self.holds():
            self.reject()
            self.let_finish.emit()
