"""The question before what was entered in a panel and not saved is lost."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication
from PySide6.QtWidgets import QWidget

from armui.ui.dialogs.save_question import SaveQuestion
from armui.ui.shell.unsaved import KeepsDraft, unsaved

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController


class UnsavedQuestion(SaveQuestion):
    """Save to the arm, discard, or stay; withdrawn once there is nothing left to lose.

    Args:
        controller: Whom the emergency stop tells.
        parent: The window that asks.
        panels: Those in which something is not saved.
    """

    def __init__(
        self, controller: ArmController, parent: QWidget, panels: Sequence[KeepsDraft]
    ) -> None:
        super().__init__(
            controller,
            parent,
            QCoreApplication.translate(
                "UnsavedQuestion",
                "What you entered has not been saved to the arm. If you discard it, the arm keeps "
                "what it holds now.",
            ),
            concerns_arm=True,
        )
        self._panels = panels
        controller.operating_state_changed.connect(self._follow)
        controller.settings.changed.connect(self._follow)
        self._follow()

    def holds(self) -> bool:
        """Stay while no arm is heard: nothing can be saved then, and the button says why."""
        return not self._controller.mark.heard or super().holds()

    def _follow(self) -> None:
        left = unsaved(self._panels)
        reasons = (panel.why_no_saving() for panel in left)
        self.allow_saving(next((each for each in reasons if each), ""))
        if not left and self.isVisible():
            self.reject()
