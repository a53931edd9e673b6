"""A panel of a level for each joint, and one click for all of them."""

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

_LABEL_PX: Final = 30


class LevelsPanel(ParameterPanel):
    """The levels of a group of parameters, joint 1 at the top.

    Args:
        controller: Reads and saves them.
        group: Whose levels; ``<group>_all`` and ``<group>_note`` are the names of what is below.
        open_backup: Opens the window in which parameters are backed up.
        tallest_px: The card grows no taller.
    """

    def __init__(
        self,
        controller: ArmController,
        group: Group,
        open_backup: Callable[[], object],
        *,
        tallest_px: int,
    ) -> None:
        self._levels = [LevelCell(each) for each in Batch(group).parameters()]
        super().__init__(controller, group.value, self._levels, open_backup, can_reset=False)
        self._all_label = QLabel()
        self._all = LevelRow(self._levels[0].levels, f"{group.value}_all")
        self._all.chosen.connect(self._on_all_chosen)
        self._note = text_label(f"{group.value}_note", rank="muted", wraps=True)
        card = QFrame()
        grid = empty_grid(card, gaps=(10, 4), margins=(12, 12, 12, 10))
        for row, cell in enumerate(self._levels):
            label = QLabel(f"J{cell.parameter.joint}")
            label.setMinimumHeight(_LABEL_PX)
            grid.addWidget(label, row, 0, Qt.AlignmentFlag.AlignTop)
            grid.addWidget(cell, row, 1)
        last = len(self._levels)
        grid.addWidget(self._all_label, last, 0)
        grid.addWidget(self._all, last, 1)
        grid.addWidget(self._note, last + 1, 0, 1, 2)
        grid.setColumnStretch(1, 1)
        grid.setRowStretch(last + 2, 1)
        self.finish(card, tallest_px=tallest_px)

    def note(self) -> str:
        """What the levels mean, in the operator's language."""
        raise NotImplementedError

    def _on_all_chosen(self, level: int) -> None:
        self._all.show_level(None)
        for cell in self._levels:
            cell.choose(level)

    def _show_possible(self) -> None:
        super()._show_possible()
        self._all.set_locked(locked=not self._draft.editing or self._saving.running)

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self._all_label.setText(self.tr("All"))
        self._all.describe(self.tr("All joints: level"))
        self._note.setText(self.note())
        super().retranslate_ui()
