"""The question before an editor is closed with changes that are not saved."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QPushButton, QWidget

from armui.ui.dialogs.confirm import ConfirmDialog

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController


class LeaveQuestion(ConfirmDialog):
    """Save, discard, or stay.

    Args:
        controller: Whom the emergency stop tells.
        parent: The editor.
        name: Of the trajectory.

    Signals:
        save_wanted: The changes shall be saved; accepted alone, they shall be discarded.
    """

    save_wanted = Signal()

    def __init__(self, controller: ArmController, parent: QWidget, name: str) -> None:
        super().__init__(controller, parent, title="", text="", action_label="")
        self.set_title(self.tr("Changes are not saved"))
        self._text.setText(
            self.tr("What you changed in “{name}” has not been saved.").format(name=name)
        )
        self.action_button.setText(self.tr("Discard changes"))
        self.save_button = QPushButton(self.tr("Save"))
        self.save_button.setProperty("primary", True)
        self.save_button.setAutoDefault(False)
        self.save_button.clicked.connect(self._on_save)
        self.footer.insertWidget(self.footer.count() - 1, self.save_button)

    def _on_save(self) -> None:
        self.reject()
        self.save_wanted.emit()
