"""One parameter of the arm in a panel: its value, and a line that says how it stands."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QWidget

from armui.arm.parameters import Parameter
from armui.control.parameters.setting_draft import CellStatus, shown_as
from armui.ui.panels.parameters.cell_note import CellNote
from armui.ui.widgets.buttons import describe, named
from armui.ui.widgets.figure_field import FigureField
from armui.ui.widgets.layouts import in_column

_GAP_PX: Final = 1
_NARROWEST_PX: Final = 62


def cell_name(parameter: Parameter) -> str:
    """What the cell of a parameter is called in the window: ``max_angle_deg_2``."""
    return f"{parameter.name}_{parameter.joint}" if parameter.joint else parameter.name


class SettingCell(QWidget):
    """What every kind of cell can do; the panel knows no more of them.

    Args:
        parameter: What it shows.

    Signals:
        edited: The operator entered something.
    """

    edited = Signal()

    def __init__(self, parameter: Parameter) -> None:
        super().__init__()
        self.parameter = parameter
        self.note = named(f"{cell_name(parameter)}_note", CellNote())

    @property
    def text(self) -> str:
        """What is entered."""
        raise NotImplementedError

    @property
    def value(self) -> float | None:
        """The figure that is entered, or ``None`` if it is none."""
        raise NotImplementedError

    @property
    def focus_widget(self) -> QWidget:
        """What the Tab key leads to."""
        raise NotImplementedError

    def show_value(self, value: float | None) -> None:
        """Show what the arm holds; ``None``: it is not known."""
        raise NotImplementedError

    def set_locked(self, *, locked: bool) -> None:
        """Let nothing be entered, or again."""
        raise NotImplementedError

    def describe(self, name: str, tip: str) -> None:
        """Name it, and say in full how it stands."""
        raise NotImplementedError

    def show_status(
        self,
        status: CellStatus,
        text: str,
        *,
        beyond: bool = False,  # noqa: ARG002 - what has a field marks it
    ) -> None:
        """Say how it stands.

        Args:
            status: How.
            text: The same in a word.
            beyond: It goes beyond the factory's value: it may be saved, and is looked at twice.
        """
        self.note.show_status(status, text)


class FigureCell(SettingCell):
    """A parameter as a field for its figure; named as the parameter, ``max_angle_deg_2``."""

    def __init__(self, parameter: Parameter, unit: str = "") -> None:
        super().__init__(parameter)
        self.field = named(cell_name(parameter), FigureField(parameter.kind.decimals, unit))
        self.field.setMinimumWidth(_NARROWEST_PX)
        in_column(self.field, self.note, on=self, spacing=_GAP_PX, margins=0)
        self.field.value_edited.connect(self.edited)

    @property
    def text(self) -> str:
        """What stands in the field."""
        return self.field.text()

    @property
    def value(self) -> float | None:
        """The figure in it."""
        return self.field.value

    @property
    def focus_widget(self) -> QWidget:
        """The field."""
        return self.field

    def show_value(self, value: float | None) -> None:
        """Show what the arm holds; the same figure typed otherwise is left as it is."""
        shown = None if value is None else shown_as(self.parameter, value)
        if shown is None or self.field.value != shown:
            self.field.show_value(shown)

    def set_locked(self, *, locked: bool) -> None:
        """A locked field can still be read and copied from."""
        self.field.setReadOnly(locked)

    def describe(self, name: str, tip: str) -> None:
        """Name it, and say in full how it stands."""
        describe(self.field, name, tip)
        self.note.setToolTip(tip)

    def show_status(self, status: CellStatus, text: str, *, beyond: bool = False) -> None:
        """Say how it stands; what cannot be saved, or not unasked, is marked in the field too."""
        super().show_status(status, text, beyond=beyond)
        self.field.show_attention(wanted=status is CellStatus.WRONG or beyond)
