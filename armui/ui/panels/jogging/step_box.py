"""How far one press of − or + goes; or on and on, while it is held."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Final

from PySide6.QtCore import QEvent, Signal
from PySide6.QtWidgets import QComboBox

STEPS: Final = (0.1, 1.0, 5.0, 10.0)
_CONTINUOUS: Final = 0.0


class StepBox(QComboBox):
    """The usual steps, one more if asked for, and «Continuous».

    Args:
        write: A step as text.
    """

    chosen = Signal()
    """Another entry was chosen."""

    def __init__(self, write: Callable[[float], str]) -> None:
        super().__init__()
        self._write = write
        self._step = 1.0
        self._fill(STEPS)
        self.set_step(self._step)
        self.currentIndexChanged.connect(self._on_index_changed)

    @property
    def step(self) -> float:
        """The step chosen last; it stays that of the arrow keys in the fields."""
        return self._step

    @property
    def continuous(self) -> bool:
        """Whether − and + move for as long as they are held."""
        return bool(self.currentData() == _CONTINUOUS)

    def set_step(self, step: float) -> None:
        """Choose a step; one that is not usual becomes an entry too."""
        blocked = self.blockSignals(True)
        self._step = step
        self._fill(sorted({*STEPS, step}))
        self.setCurrentIndex(self.findData(step))
        self.blockSignals(blocked)

    def _fill(self, steps: Sequence[float]) -> None:
        self.clear()
        for step in steps:
            self.addItem(self._write(step), step)
        self.addItem(self.tr("Continuous"), _CONTINUOUS)

    def _on_index_changed(self) -> None:
        if not self.continuous:
            self._step = float(self.currentData())
        self.chosen.emit()

    def changeEvent(self, event: QEvent) -> None:
        """Follow the language."""
        if event.type() == QEvent.Type.LanguageChange:
            self.setItemText(self.count() - 1, self.tr("Continuous"))
        super().changeEvent(event)
