"""夹爪设置: the gripper's stroke limit and what the teaching handle keeps (0x47D, generation 2)."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtWidgets import QWidget

from armui.arm.parameters import Group
from armui.ui.panels.parameters.listed_parameters import ListedParameters
from armui.ui.panels.parameters.setting_cell import SettingCell

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController


class GripperSettingsPanel(ListedParameters):
    """Three values; the arm has no factory reset for them."""

    def __init__(
        self,
        controller: ArmController,
        open_backup: Callable[[], object],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(
            controller,
            "gripper_settings",
            Group.TEACHING,
            open_backup,
            can_reset=False,
            parent=parent,
        )

    def title(self) -> str:
        """夹爪设置."""
        return self.tr("Gripper settings")

    def remark(self, cell: SettingCell) -> str:
        """What can be chosen where there are few values."""
        choices = cell.parameter.kind.choices
        return " / ".join(f"{choice:g}" for choice in choices)
