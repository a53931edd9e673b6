"""碰撞等级: how the arm watches each joint for collisions (manual section 1.0.7.6)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFrame, QLabel

from armui.arm.parameters import Batch, Group, heard
from armui.control.arm_controller import ArmController
from armui.ui import format as fmt
from armui.ui.panels.parameters.level_cell import LevelCell, LevelRow
from armui.ui.panels.parameters.parameter_panel import ParameterPanel
from armui.ui.panels.parameters.setting_cell import SettingCell
from armui.ui.widgets.layouts import empty_grid
from armui.ui.widgets.text_label import text_label

_NO_DETECTION: Final = 0
_LEVELS: Final = range(9)
_TALLEST_CARD_PX: Final = 420


class CollisionPanel(ParameterPanel):
    """A level for each joint, and one click for all of them."""

    def __init__(self, controller: ArmController, open_backup: Callable[[], object]) -> None:
        self._levels = [LevelCell(each) for each in Batch(Group.COLLISION).parameters()]
        super().__init__(controller, "collision", self._levels, open_backup, can_reset=False)
        self._all_label = QLabel()
        self._all = LevelRow(_LEVELS, "collision_all")
        self._all.chosen.connect(self._on_all_chosen)
        self._note = text_label("collision_note", rank="muted", wraps=True)
        card = QFrame()
        grid = empty_grid(card, gaps=(10, 4), margins=(12, 12, 12, 10))
        for row, cell in enumerate(self._levels):
            label = QLabel(f"J{cell.parameter.joint}")
            label.setMinimumHeight(30)
            grid.addWidget(label, row, 0, Qt.AlignmentFlag.AlignTop)
            grid.addWidget(cell, row, 1)
        last = len(self._levels)
        grid.addWidget(self._all_label, last, 0)
        grid.addWidget(self._all, last, 1)
        grid.addWidget(self._note, last + 1, 0, 1, 2)
        grid.setColumnStretch(1, 1)
        grid.setRowStretch(last + 2, 1)
        self.finish(card, tallest_px=_TALLEST_CARD_PX)

    def title(self) -> str:
        """碰撞等级."""
        return self.tr("Collision level")

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

    def _on_all_chosen(self, level: int) -> None:
        self._all.show_level(None)
        for cell in self._levels:
            cell.choose(level)

    def _show_possible(self) -> None:
        super()._show_possible()
        locked = not self._draft.editing or self._saving.running
        self._all.set_locked(locked=locked)

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self._all_label.setText(self.tr("All"))
        self._all.describe(self.tr("All joints: level"))
        self._note.setText(
            self.tr("Levels 1 to 8 watch for collisions; level 0 does not watch at all.")
        )
        super().retranslate_ui()
