"""碰撞等级: how the arm watches each joint for collisions (manual section 1.0.7.6)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from armui.arm.parameters import Group, heard
from armui.control.arm_controller import ArmController
from armui.ui import format as fmt
from armui.ui.panels.parameters.levels_panel import LevelsPanel
from armui.ui.panels.parameters.setting_cell import SettingCell

_NO_DETECTION: Final = 0
_TALLEST_CARD_PX: Final = 420


class CollisionPanel(LevelsPanel):
    """Warns of joints without detection."""

    def __init__(self, controller: ArmController, open_backup: Callable[[], object]) -> None:
        super().__init__(controller, Group.COLLISION, open_backup, tallest_px=_TALLEST_CARD_PX)

    def title(self) -> str:
        """碰撞等级."""
        return self.tr("Collision level")

    def note(self) -> str:
        """Which levels watch."""
        return self.tr("Levels 1 to 8 watch for collisions; level 0 does not watch at all.")

    def danger(self) -> str:
        """Joints that would not notice, or do not notice, what they hit."""
        blind = [cell.parameter.joint for cell in self._levels if cell.value == _NO_DETECTION]
        if not blind:
            return ""
        return self.tr(
            "Level 0 – no collision detection: {joints} will not stop when they hit something or "
            "someone."
        ).format(joints=fmt.joints(blind))

    def danger_of_saving(self) -> str:
        """Joints whose detection would be switched off now."""
        state = self._controller.state
        blind = [
            parameter.joint
            for parameter, level in self._draft.changes().items()
            if level == _NO_DETECTION
            and ((known := heard(state, parameter)) is None or known.value != _NO_DETECTION)
        ]
        if not blind:
            return ""
        return self.tr(
            "This switches the collision detection of {joints} off: the arm will not stop when "
            "they hit something or someone. Keep everyone out of its reach."
        ).format(joints=fmt.joints(blind))

    def remark(self, cell: SettingCell) -> str:
        """A joint without detection says so, beside its number."""
        return self.tr("no detection") if cell.value == _NO_DETECTION else ""
