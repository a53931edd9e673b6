"""夹爪设置: the gripper's stroke limit and what the teaching handle keeps (0x47D, generation 2)."""

from __future__ import annotations

from armui.arm.parameters import Group
from armui.ui.panels.parameters.listed_parameters import ListedParameters
from armui.ui.panels.parameters.setting_cell import SettingCell


class GripperSettingsPanel(ListedParameters):
    """Three values; the arm has no factory reset for them."""

    name = "gripper_settings"
    group = Group.TEACHING
    can_reset = False

    def title(self) -> str:
        """夹爪设置."""
        return self.tr("Gripper settings")

    def remark(self, cell: SettingCell) -> str:
        """What can be chosen where there are few values."""
        choices = cell.parameter.kind.choices
        unit = f" {cell.parameter.kind.unit}" if choices else ""
        return " / ".join(f"{choice:g}" for choice in choices) + unit
