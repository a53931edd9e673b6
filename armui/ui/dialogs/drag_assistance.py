"""拖动助力 in a window of its own, beside 示教."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from PySide6.QtWidgets import QWidget

from armui.control.arm_controller import ArmController
from armui.ui.dialogs.base import ArmDialog
from armui.ui.panels.parameters.levels_panel import DragAssistancePanel

_WIDTH_PX: Final = 520
_HEIGHT_PX: Final = 700


class DragAssistanceDialog(ArmDialog):
    """What was entered and not saved is still there when it is opened again.

    Args:
        controller: Whom to ask.
        open_backup: Opens 参数备份.
        parent: The window it belongs to.
    """

    def __init__(
        self,
        controller: ArmController,
        open_backup: Callable[[], object],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(controller, parent)
        self.setObjectName("drag_assistance_dialog")
        self.panel = DragAssistancePanel(controller, open_backup)
        self.panel.stand_in_dialog()
        self.body.addWidget(self.panel)
        self.resize(_WIDTH_PX, _HEIGHT_PX)
        self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self.set_title(self.panel.title())
