"""A parameter that has few levels, as a row of buttons: one click, no typing."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QSignalBlocker, Signal
from PySide6.QtWidgets import QButtonGroup, QSizePolicy, QWidget

from armui.arm.parameters import Parameter
from armui.ui.panels.parameters.setting_cell import SettingCell, cell_name
from armui.ui.widgets.buttons import choice_button, named
from armui.ui.widgets.layouts import in_column, in_row

_GAP_PX: Final = 3
_HEIGHT_PX: Final = 30


class LevelRow(QWidget):
    """Whole levels side by side; the chosen one stands out, or none.

    Args:
        levels: From left to right.
        name: For the names of the buttons: ``<name>_level_<level>``.

    Signals:
        chosen: The operator chose a level.
    """

    chosen = Signal(int)

    def __init__(self, levels: range, name: str) -> None:
        super().__init__()
        self._group = QButtonGroup(self)
        layout = in_row(on=self, spacing=_GAP_PX, margins=0)
        for level in levels:
            button = choice_button(f"{name}_level_{level}", str(level))
            button.setProperty("narrow", True)
            button.setFixedHeight(_HEIGHT_PX)
            button.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
            self._group.addButton(button, level)
            layout.addWidget(button, 1)
        self._group.idClicked.connect(self.chosen)

    @property
    def level(self) -> int | None:
        """The chosen level."""
        level = self._group.checkedId()
        return None if level < 0 else level

    def show_level(self, level: int | None) -> None:
        """Choose a level, or none, without telling anyone."""
        with QSignalBlocker(self._group):
            self._group.setExclusive(False)
            for button in self._group.buttons():
                button.setChecked(self._group.id(button) == level)
            self._group.setExclusive(True)

    def set_locked(self, *, locked: bool) -> None:
        """Show the level and let no other be chosen, or let it again."""
        for button in self._group.buttons():
            button.setEnabled(not locked)

    def first(self) -> QWidget:
        """Where the Tab key enters."""
        return self._group.checkedButton() or self._group.buttons()[0]

    def describe(self, name: str) -> None:
        """Name the buttons: whose levels they are."""
        for button in self._group.buttons():
            button.setAccessibleName(f"{name} {self._group.id(button)}")


class LevelCell(SettingCell):
    """A parameter of whole levels; the row is named as the parameter, ``collision_level_3``.

    Attributes:
        levels: From left to right.
    """

    def __init__(self, parameter: Parameter) -> None:
        super().__init__(parameter)
        kind = parameter.kind
        self.levels = range(round(kind.minimum), round(kind.maximum) + 1)
        self._row = named(cell_name(parameter), LevelRow(self.levels, cell_name(parameter)))
        in_column(self._row, self.note, on=self, spacing=1, margins=0)
        self._row.chosen.connect(self.edited)

    @property
    def text(self) -> str:
        """The chosen level."""
        return "" if self._row.level is None else str(self._row.level)

    @property
    def value(self) -> float | None:
        """The chosen level as a figure."""
        return None if self._row.level is None else float(self._row.level)

    @property
    def focus_widget(self) -> QWidget:
        """The chosen button."""
        return self._row.first()

    def show_value(self, value: float | None) -> None:
        """Choose what the arm holds; a level there is no button for chooses none."""
        self._row.show_level(None if value is None else round(value))

    def choose(self, level: int) -> None:
        """Enter a level as if its button had been pressed."""
        self._row.show_level(level)
        self.edited.emit()

    def set_locked(self, *, locked: bool) -> None:
        """Let no other level be chosen, or let it again."""
        self._row.set_locked(locked=locked)

    def describe(self, name: str, tip: str) -> None:
        """Name the levels, and say in full how it stands."""
        self._row.describe(name)
        self.setToolTip(tip)
