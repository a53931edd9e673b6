"""Panels of figures to read, edit and save: 关节设置, 配速设置, 夹爪设置."""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar, Final

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFrame, QLabel

from armui.arm.limits import JOINTS
from armui.arm.parameters import KINDS, Batch, Group, Parameter
from armui.arm.refusal import Refusal
from armui.control.arm_controller import ArmController
from armui.control.operations.started import refusal_of
from armui.control.parameters.arm_settings import ArmSettings
from armui.protocol.generation import Generation
from armui.ui import format as fmt
from armui.ui.panels.parameters.parameter_panel import ParameterPanel
from armui.ui.panels.parameters.setting_cell import FigureCell, SettingCell
from armui.ui.widgets.layouts import empty_grid
from armui.ui.widgets.text_label import text_label
from armui.ui.words.parameters import parameter_name
from armui.ui.words.text import listed

_FIELD_PX: Final = 132
_COLUMNS: Final = ("max_angle_deg", "min_angle_deg", "max_speed_deg_s", "max_acceleration_deg_s2")

_ENDS: Final = ("min_angle_deg", "max_angle_deg")
_AT_LIMIT_DEG: Final = 0.5
"""A joint this close beyond a limit counts as within it, because measured angles fluctuate."""


class JointSettingsPanel(ParameterPanel):
    """Four limits of six joints; the Tab key moves down the columns."""

    buttons = ParameterPanel.buttons_of("joint_settings", ArmSettings.reset_joint_limits)

    def __init__(self, controller: ArmController, open_backup: Callable[[], object]) -> None:
        cells = [FigureCell(Parameter(name, joint)) for name in _COLUMNS for joint in JOINTS]
        super().__init__(controller, "joint_settings", cells, open_backup)
        self._heads = {name: text_label(rank="muted", wraps=True) for name in _COLUMNS}
        card = QFrame()
        grid = empty_grid(card, gaps=(6, 4), margins=(12, 10, 12, 10))
        for column, (name, head) in enumerate(self._heads.items(), start=1):
            head.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignBottom)
            unit = text_label(text=KINDS[name].unit, rank="muted")
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
        self.finish(card)

    def title(self) -> str:
        """Return 关节设置 in the operator's language."""
        return self.tr("Joint settings")

    def reset_question(self) -> tuple[str, str]:
        """Return the question before all six joints get the factory's limits."""
        return (
            self.tr("Factory limits for all joints"),
            self.tr(
                "The angle limits, speeds and accelerations of all six joints become what they "
                "were when the arm left the factory. Limits set for this place, narrower ones "
                "too, are lost: save a backup first if you may need them again."
            ),
        )

    def danger_of_saving(self) -> str:
        """Return the dangers of saving, such as a joint that would be beyond its new limits."""
        state, changes = self._controller.state, self._draft.changes()
        lines = [super().danger_of_saving()]
        for joint, angle in zip(JOINTS, state.angles_deg() or (), strict=False):
            low, high = (changes.get(Parameter(name, joint)) for name in _ENDS)
            below = low is not None and angle < low - _AT_LIMIT_DEG
            if below or (high is not None and angle > high + _AT_LIMIT_DEG):
                text = self.tr(
                    "J{joint} stands at {value}, beyond the limits entered: it can only be moved "
                    "back between them then."
                )
                lines.append(text.format(joint=joint, value=fmt.angle(angle)))
        return "\n".join(filter(None, lines))

    def why_no_reset(self) -> str:
        """Return why 【初始化】 is missing: generation 1 has no command for it."""
        if self._controller.operating_state.generation is Generation.ONE:
            return self.tr(
                "This arm's protocol (generation 1) has no command for it. Enter the values, or "
                "restore a backup."
            )
        return ""

    def reset_to_factory(self) -> Refusal | None:
        """Have the arm restore its factory values."""
        return refusal_of(self._settings.reset_joint_limits())

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        for name, head in self._heads.items():
            head.setText(parameter_name(name))
        super().retranslate_ui()


class ListedParameters(ParameterPanel):
    """A name and a field with its unit for each parameter of a group.

    Args:
        controller: The controller of the arm.
        open_backup: Opens 参数备份.

    Attributes:
        name: The first part of the buttons' names.
        group: The parameters listed.
    """

    name: ClassVar[str]
    group: ClassVar[Group]

    def __init__(self, controller: ArmController, open_backup: Callable[[], object]) -> None:
        cells = [FigureCell(each, each.kind.unit) for each in Batch(self.group).parameters()]
        super().__init__(controller, self.name, cells, open_backup)
        self._labels = {cell.parameter.name: text_label(wraps=True) for cell in cells}
        card = QFrame()
        grid = empty_grid(card, gaps=(12, 6), margins=(16, 14, 16, 10))
        for row, cell in enumerate(cells):
            label = self._labels[cell.parameter.name]
            label.setBuddy(cell.field)
            label.setMinimumHeight(cell.field.height())
            cell.setFixedWidth(_FIELD_PX)
            grid.addWidget(label, row, 0, Qt.AlignmentFlag.AlignTop)
            grid.addWidget(cell, row, 1)
        grid.setColumnStretch(0, 1)
        grid.setRowStretch(len(cells), 1)
        self.finish(card)

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        for name, label in self._labels.items():
            label.setText(parameter_name(name))
        super().retranslate_ui()


class EndLimitsPanel(ListedParameters):
    """Four limits of the end, and 【初始化】."""

    name = "end_limits"
    buttons = ParameterPanel.buttons_of(name, ArmSettings.reset_end_limits)
    group = Group.END_LIMITS

    def title(self) -> str:
        """Return 配速设置 in the operator's language."""
        return self.tr("End speed limits")

    def reset_question(self) -> tuple[str, str]:
        """Return the question before the end gets the factory's limits."""
        return (
            self.tr("Factory limits for the end"),
            self.tr(
                "The greatest speeds and accelerations of the end become what they were when the "
                "arm left the factory: straight lines and arcs may run faster than they do now."
            ),
        )

    def reset_to_factory(self) -> Refusal | None:
        """Have the arm restore its factory values."""
        return refusal_of(self._settings.reset_end_limits())


class GripperSettingsPanel(ListedParameters):
    """Three values; the arm has no factory reset for them."""

    name = "gripper_settings"
    buttons = ParameterPanel.buttons_of(name)
    group = Group.TEACHING

    def title(self) -> str:
        """Return 夹爪设置 in the operator's language."""
        return self.tr("Gripper settings")

    def remark(self, cell: SettingCell) -> str:
        """Return the possible values, if they are few."""
        kind = cell.parameter.kind
        if not kind.choices:
            return ""
        choices = listed(f"{choice:g}" for choice in kind.choices)
        return self.tr("One of {choices}").format(choices=fmt.append_unit(choices, kind.unit))
