"""The question before an editor is closed with changes that are not saved."""

from __future__ import annotations

from PySide6.QtCore import QCoreApplication
from PySide6.QtWidgets import QWidget

from armui.control.arm_controller import ArmController
from armui.ui.dialogs.confirm_dialog import SaveQuestion


class LeaveQuestion(SaveQuestion):
    """Save a trajectory, discard what was changed in it, or stay.

    Args:
        controller: Whom the emergency stop tells.
        parent: The editor.
        name: Of the trajectory.
    """

    def __init__(self, controller: ArmController, parent: QWidget, name: str) -> None:
        text = QCoreApplication.translate(
            "LeaveQuestion", "What you changed in “{name}” has not been saved."
        )
        super().__init__(controller, parent, text.format(name=name), concerns_arm=False)
