"""拖动助力: how much each joint helps the hand in drag teaching (0x487, from S-V1.8-1)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFrame, QLabel

from armui.arm.parameters import Batch, Group
from armui.control.arm_controller import ArmController
from armui.ui.panels.parameters.level_cell import LevelCell, LevelRow
from armui.ui.panels.parameters.parameter_panel import ParameterPanel
from armui.ui.widgets.layouts import empty_grid
from armui.ui.widgets.text_label import text_label

_LEVELS: Final = range(11)
_TALLEST_CARD_PX: Final = 470


class DragAssistancePanel(ParameterPanel):
    """A level for each joint, and one click for all of them."""

    def __init__(self, controller: ArmController, open_backup: Callable[[], object]) -> None:
        batch = Batch(Group.DRAG_ASSISTANCE)
        self._levels = [LevelCell(each) for each in batch.parameters()]
        super().__init__(controller, "drag_assistance", self._levels, open_backup, can_reset=False)
        self._all_label = QLabel()
        self._all = LevelRow(_LEVELS, "drag_assistance_all")
        self._all.chosen.connect(self._on_all_chosen)
        self._note = text_label("drag_assistance_note", rank="muted", wraps=True)
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
        """拖动助力."""
        return self.tr("Drag assistance")

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
            self.tr(
                "From 0, the joint does not help the hand, to 10, it helps most. Read and set with "
                "the arm at rest; keep a hand on it when it is led for the first time afterwards."
            )
        )
        super().retranslate_ui()
