"""拖动助力: how much each joint helps the hand in drag teaching (0x487, from S-V1.8-1)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from armui.arm.parameters import Group
from armui.control.arm_controller import ArmController
from armui.ui.panels.parameters.levels_panel import LevelsPanel

_TALLEST_CARD_PX: Final = 470


class DragAssistancePanel(LevelsPanel):
    """Levels from no help at all to the most."""

    def __init__(self, controller: ArmController, open_backup: Callable[[], object]) -> None:
        group = Group.DRAG_ASSISTANCE
        super().__init__(controller, group, open_backup, tallest_px=_TALLEST_CARD_PX)

    def title(self) -> str:
        """拖动助力."""
        return self.tr("Drag assistance")

    def stand_in_dialog(self) -> None:
        """The dialog has the title and the margins."""
        layout = self.layout()
        if layout is not None:
            layout.setContentsMargins(0, 0, 0, 0)
        policy = self._title.sizePolicy()
        policy.setRetainSizeWhenHidden(True)  # the button beside it stays at the right
        self._title.setSizePolicy(policy)
        self._title.hide()

    def note(self) -> str:
        """What the levels do."""
        return self.tr(
            "From 0, the joint does not help the hand, to 10, it helps most. Read and set with "
            "the arm at rest; keep a hand on it when it is led for the first time afterwards."
        )
