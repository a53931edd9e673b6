"""配速设置: how fast the end of the arm may move and speed up (manual section 1.0.7.5)."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFrame, QGridLayout, QLabel, QWidget

from armui.arm.parameters import Batch, Group
from armui.arm.refusal import Refusal
from armui.ui.panels.parameter_panel import ParameterPanel
from armui.ui.widgets.setting_cell import FigureCell
from armui.ui.words.parameters import parameter_name

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController

_FIELD_PX: Final = 132
_TALLEST_CARD_PX: Final = 260


class EndLimitsPanel(ParameterPanel):
    """Four limits of the end, and 【初始化】."""

    def __init__(
        self,
        controller: ArmController,
        open_backup: Callable[[], object],
        parent: QWidget | None = None,
    ) -> None:
        cells = [
            FigureCell(parameter, parameter.kind.unit)
            for parameter in Batch(Group.END_LIMITS).parameters()
        ]
        super().__init__(
            controller, "end_limits", cells, open_backup, can_reset=True, parent=parent
        )
        self._labels = {cell.parameter.name: QLabel() for cell in cells}
        card = QFrame()
        grid = QGridLayout(card)
        grid.setContentsMargins(16, 14, 16, 10)
        grid.setHorizontalSpacing(12)
        grid.setVerticalSpacing(6)
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

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        for name, label in self._labels.items():
            label.setText(parameter_name(name))
        super().retranslate_ui()
