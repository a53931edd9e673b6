"""The question before something is left with changes that are not saved."""

from __future__ import annotations

from PySide6.QtCore import QCoreApplication, Signal
from PySide6.QtWidgets import QWidget

from armui.control.arm_controller import ArmController
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from armui.ui.widgets.buttons import push_button
from armui.ui.widgets.enable_or_explain import enable_or_explain


class SaveQuestion(ConfirmDialog):
    """Save, discard, or stay.

    Args:
        controller: Whom the emergency stop tells.
        parent: The window that asks.
        text: What has not been saved.
        concerns_arm: It would be saved to the arm.

    Signals:
        save_wanted: The changes shall be saved; accepted alone, they shall be discarded.
    """

    save_wanted = Signal()

    def __init__(
        self, controller: ArmController, parent: QWidget, text: str, *, concerns_arm: bool
    ) -> None:
        super().__init__(
            controller,
            parent,
            title=QCoreApplication.translate("SaveQuestion", "Changes are not saved"),
            text=text,
            action_label=QCoreApplication.translate("SaveQuestion", "Discard changes"),
            concerns_arm=concerns_arm,
        )
        self.save_button = push_button("", self.tr("Save"), primary=True, on_enter=False)
        self.save_button.clicked.connect(self._on_save)
        self.footer.insertWidget(self.footer.count() - 1, self.save_button)

    def allow_saving(self, reason: str) -> None:
        """Offer to save, or say in the button's tooltip why that cannot be done now."""
        enable_or_explain(self.save_button, reason)

    def _on_save(self) -> None:
        if self.holds():
            self.reject()
            self.save_wanted.emit()
