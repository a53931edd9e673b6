"""关节设置: angle, speed and acceleration limits of the six joints (manual section 1.0.7.4)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFrame, QLabel

from armui.arm.limits import JOINTS
from armui.arm.parameters import KINDS, Parameter
from armui.arm.refusal import Refusal
from armui.control.arm_controller import ArmController
from armui.protocol.generation import Generation
from armui.ui.panels.parameters.parameter_panel import ParameterPanel
from armui.ui.panels.parameters.setting_cell import FigureCell
from armui.ui.widgets.layouts import empty_grid
from armui.ui.words.parameters import parameter_name

_COLUMNS: Final = ("max_angle_deg", "min_angle_deg", "max_speed_deg_s", "max_acceleration_deg_s2")

_TALLEST_CARD_PX: Final = 420


class JointSettingsPanel(ParameterPanel):
    """Six joints by four limits; the Tab key goes down the columns."""

    def __init__(self, controller: ArmController, open_backup: Callable[[], object]) -> None:
        cells = [FigureCell(Parameter(name, joint)) for name in _COLUMNS for joint in JOINTS]
        super().__init__(controller, "joint_settings", cells, open_backup, can_reset=True)
        self._heads = {name: QLabel() for name in _COLUMNS}
        card = QFrame()
        grid = empty_grid(card, gaps=(6, 4), margins=(12, 10, 12, 10))
        for column, (name, head) in enumerate(self._heads.items(), start=1):
            head.setProperty("rank", "muted")
            head.setWordWrap(True)
            head.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignBottom)
            unit = QLabel(KINDS[name].unit)
            unit.setProperty("rank", "muted")
            unit.setAlignment(Qt.AlignmentFlag.AlignRight)
            grid.addWidget(head, 0, column)
            grid.addWidget(unit, 1, column)
            grid.setColumnStretch(column, 1)
        for cell in cells:
            column = _COLUMNS.index(cell.parameter.name) + 1
            grid.addWidget(cell, cell.parameter.joint + 1, column)
        for joint in JOINTS:
            label = QLabel(f"J{joint}")
            label.setFixedHeight(cells[0].field.height())
            grid.addWidget(label, joint + 1, 0, Qt.AlignmentFlag.AlignTop)
        grid.setRowStretch(len(JOINTS) + 2, 1)
        self.finish(card, tallest_px=_TALLEST_CARD_PX)

    def title(self) -> str:
        """关节设置."""
        return self.tr("Joint settings")

    def reset_question(self) -> tuple[str, str]:
        """Before all six joints get the factory's limits."""
        return (
            self.tr("Factory limits for all joints"),
            self.tr(
                "The angle limits, speeds and accelerations of all six joints become what they "
                "were when the arm left the factory. Limits set for this place, narrower ones "
                "too, are lost: save a backup first if you may need them again."
            ),
        )

    def why_no_reset(self) -> str:
        """Generation 1 has no command for it."""
        if self._controller.operating_state.generation is Generation.ONE:
            return self.tr(
                "This arm's protocol (generation 1) has no command for it. Enter the values, or "
                "restore a backup."
            )
        return ""

    def reset_to_factory(self) -> Refusal | None:
        """Ask the arm for its factory values."""
        return self._settings.reset_joint_limits()

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        for name, head in self._heads.items():
            head.setText(parameter_name(name))
        super().retranslate_ui()
