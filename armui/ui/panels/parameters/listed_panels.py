"""What 配速设置 and 夹爪设置 share: the parameters of one group, a line each."""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar, Final

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFrame, QLabel

from armui.arm.parameters import Batch, Group
from armui.arm.refusal import Refusal
from armui.control.arm_controller import ArmController
from armui.ui.panels.parameters.parameter_panel import ParameterPanel
from armui.ui.panels.parameters.setting_cell import FigureCell, SettingCell
from armui.ui.widgets.layouts import empty_grid
from armui.ui.words.parameters import parameter_name

_FIELD_PX: Final = 132
_TALLEST_CARD_PX: Final = 260


class ListedParameters(ParameterPanel):
    """A name and a field with its unit for each parameter of a group.

    Args:
        controller: Whom to ask.
        open_backup: Opens 参数备份.

    Attributes:
        name: For the names of the buttons.
        group: What is listed.
        can_reset: Whether there is a 【初始化】.
    """

    name: ClassVar[str]
    group: ClassVar[Group]
    can_reset: ClassVar[bool]

    def __init__(self, controller: ArmController, open_backup: Callable[[], object]) -> None:
        cells = [FigureCell(each, each.kind.unit) for each in Batch(self.group).parameters()]
        super().__init__(controller, self.name, cells, open_backup, can_reset=self.can_reset)
        self._labels = {cell.parameter.name: QLabel() for cell in cells}
        card = QFrame()
        grid = empty_grid(card, gaps=(12, 6), margins=(16, 14, 16, 10))
        for row, cell in enumerate(cells):
            label = self._labels[cell.parameter.name]
            label.setWordWrap(True)
            label.setBuddy(cell.field)
            label.setMinimumHeight(cell.field.height())
            cell.setFixedWidth(_FIELD_PX)
            grid.addWidget(label, row, 0, Qt.AlignmentFlag.AlignTop)
            grid.addWidget(cell, row, 1)
        grid.setColumnStretch(0, 1)
        grid.setRowStretch(len(cells), 1)
        self.finish(card, tallest_px=_TALLEST_CARD_PX)

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        for name, label in self._labels.items():
            label.setText(parameter_name(name))
        super().retranslate_ui()


class EndLimitsPanel(ListedParameters):
    """Four limits of the end, and 【初始化】."""

    name = "end_limits"
    group = Group.END_LIMITS
    can_reset = True

    def title(self) -> str:
        """配速设置."""
        return self.tr("End speed limits")

    def reset_question(self) -> tuple[str, str]:
        """Before the end gets the factory's limits."""
        return (
            self.tr("Factory limits for the end"),
            self.tr(
                "The greatest speeds and accelerations of the end become what they were when the "
                "arm left the factory: straight lines and arcs may run faster than they do now."
            ),
        )

    def reset_to_factory(self) -> Refusal | None:
        """Ask the arm for its factory values."""
        return self._settings.reset_end_limits()


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
