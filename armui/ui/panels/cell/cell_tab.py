"""The base of a tab of the panel 单元: a part of the chosen cell."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, ClassVar, Final, cast

from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QGridLayout, QLabel, QStackedWidget, QWidget

from armui.arm.refusal import Refusal
from armui.arm.state import ArmState
from armui.cell.cell import Cell
from armui.control.arm_controller import ArmController
from armui.control.cell.cell_control import CellControl
from armui.control.cell.cell_reasons import CELL_NONE
from armui.control.operations.operation import operation_of
from armui.control.operations.started import Started
from armui.kinematics.axes import AXES, LINEAR_AXES
from armui.ui import words
from armui.ui.actions.act import HasActs
from armui.ui.actions.command import Command, Target
from armui.ui.widgets.figure_field import FigureField
from armui.ui.widgets.layouts import empty_grid
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated
from armui.ui.words.text import Text

if TYPE_CHECKING:
    from armui.settings import SettingsStore

Answered = Callable[[Started | Refusal | None], bool]
"""Shows an answer in the panel, and returns whether it was a yes."""


NARROW_PX: Final = 56
"""The least width of fields and buttons that share a row."""
UNITS: Final = dict(zip(AXES, ("mm",) * LINEAR_AXES + ("°",) * LINEAR_AXES, strict=True))
"""The unit of each figure of a pose."""


def change_command(name: str, title: Text, *, risky: bool = False) -> Command:
    """Return a command of the palette that changes the cell."""
    return Command(name, title, operation_of(CellControl.change), leads=True, risky=risky)


def hint_label(name: str, lines: int = 2) -> QLabel:
    """Return a label for the next step; it keeps room for its lines, so that nothing moves."""
    label = text_label(name, wraps=True)
    label.setMinimumHeight(lines * label.fontMetrics().lineSpacing())
    label.setAlignment(Qt.AlignmentFlag.AlignTop)
    return label


class CurrentStack(QStackedWidget):
    """Shows one of several parts, and is as high as that one alone."""

    def __init__(self) -> None:
        super().__init__()
        self.currentChanged.connect(lambda _place: self.updateGeometry())

    def sizeHint(self) -> QSize:
        """Return the preferred size of the part that is shown."""
        part = self.currentWidget()
        return super().sizeHint() if part is None else part.sizeHint()

    def minimumSizeHint(self) -> QSize:
        """Return the smallest size of the part that is shown."""
        part = self.currentWidget()
        return super().minimumSizeHint() if part is None else part.minimumSizeHint()

    def hasHeightForWidth(self) -> bool:  # noqa: N802 - the name Qt calls
        """Return whether the height depends on the width: of texts that wrap it does."""
        part = self.currentWidget()
        return part is not None and part.hasHeightForWidth()

    def heightForWidth(self, width: int) -> int:  # noqa: N802 - the name Qt calls
        """Return the height that the part that is shown needs."""
        part = self.currentWidget()
        return super().heightForWidth(width) if part is None else part.heightForWidth(width)


def pose_grid(fields: Sequence[FigureField]) -> QGridLayout:
    """Return the six fields of a pose with their names, in two rows."""
    grid = empty_grid(gaps=(6, 4), margins=0)
    for place, (axis, field) in enumerate(zip(AXES, fields, strict=True)):
        row, column = place // LINEAR_AXES, 2 * (place % LINEAR_AXES)
        field.setMinimumWidth(NARROW_PX)
        grid.addWidget(QLabel(axis), row, column)
        grid.addWidget(field, row, column + 1)
        grid.setColumnStretch(column + 1, 1)
    return grid


def figures(fields: Sequence[FigureField]) -> tuple[float, ...]:
    """Return the figures as typed: 0 for an empty field, the text itself if it is no figure."""
    return tuple(
        field.text() if field.is_nonsense() else field.value or 0.0  # type: ignore[misc]  # refused
        for field in fields
    )


class CellTab(HasActs, Translated, QWidget):
    """A part of the chosen cell.

    Args:
        controller: The controller of the arm; changes go through its `cell`.
        answered: Shows an answer in the panel.

    Attributes:
        key: Its stable name.
        title: The title of its button.
        preferences: The settings; ``None`` until the panel has given them.
    """

    key: ClassVar[str] = ""
    title: ClassVar[Text]

    def __init__(self, controller: ArmController, answered: Answered) -> None:
        super().__init__()
        self._controller = controller
        self._answered = answered
        self.preferences: SettingsStore | None = None

    def show_cell(self, why_not: str) -> None:
        """Show the chosen cell.

        Args:
            why_not: Why it cannot be changed now; empty if it can.
        """
        raise NotImplementedError

    def show_state(self, state: ArmState) -> None:
        """Show what the arm says."""

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each of its commands: the widget that has the command's name."""
        widgets = ((each.name, each.name.replace(".", "_")) for each in self.commands)
        return {name: cast("QWidget", self.findChild(QWidget, each)) for name, each in widgets}

    def _no_step(self) -> str:
        """Return why nothing in the cell takes effect: there is no cell, or it is not confirmed."""
        cells = self._controller.cell
        if cells.cell is None:
            return words.refusal(CELL_NONE())
        if cells.unconfirmed is None:
            return ""
        return self.tr("Not in force until the cell is confirmed; the picture shows it pale.")

    @property
    def _cell(self) -> Cell:
        return self._controller.cell.cell or Cell("")
