"""Figures: a field for an argument of an operation is declared once, on the class of its panel."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, overload

from PySide6.QtWidgets import QLabel

from armui.arm.figures import FIGURE_NOT_A_NUMBER, FIGURE_NOT_WHOLE, CommandFigure, figures_of
from armui.arm.refusal import Refusal
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.widgets.buttons import describe, named
from armui.ui.widgets.figure_field import FigureField
from armui.ui.widgets.translated import Translated

if TYPE_CHECKING:
    from PySide6.QtWidgets import QWidget


class CommandField(Translated, FigureField):
    """A field for a figure of a command, with the name, range and unit of its declaration.

    Args:
        figure: The declared figure.
        decimals: The decimals, for one that need not be whole.

    Attributes:
        figure: The declared figure.
        label: A label with its name.
    """

    def __init__(self, figure: CommandFigure, decimals: int = fmt.DECIMALS) -> None:
        super().__init__(0 if figure.type is int else decimals, figure.range.unit)
        self.figure = figure
        self.label = QLabel()
        self.label.setBuddy(self)
        self.retranslate_ui()

    @property
    def name(self) -> str:
        """The name of the figure in the operator's language."""
        return words.figure(self.figure.name)

    @property
    def span(self) -> str:
        """The name of the figure with its range."""
        allowed = self.figure.range
        if not math.isfinite(allowed.minimum):
            return self.name
        return f"{self.name}: {allowed.minimum:g}–{allowed.maximum:g} {allowed.unit}".rstrip()

    def why_wrong(self) -> Refusal | None:
        """Return why the content of the field may not be sent, or ``None``."""
        value = self.value
        if value is not None:
            return self.figure.check(self.figure.type(value))
        no_number = FIGURE_NOT_WHOLE if self.figure.type is int else FIGURE_NOT_A_NUMBER
        text = self.text().strip() or fmt.NOTHING
        return no_number(figure=self.figure.name, value=text, **self.figure.range._asdict())

    def retranslate_ui(self) -> None:
        """Set name and range in the operator's language."""
        self.label.setText(self.name)
        describe(self, self.name, self.span)


class Figure:
    """A field of a widget for an argument of an operation, declared on the widget's class.

    It is the :class:`CommandField` when it is read from an instance, where it is made at the first
    use.

    Args:
        does: The operation's method.
        name: The argument; it needs a declared range.
        named: The object name of the field.

    Raises:
        KeyError: The method has no such figure.
    """

    def __init__(self, does: Callable[..., object], name: str, *, named: str) -> None:
        self._figure = figures_of(does)[name]
        self._named = named

    def __set_name__(self, _owner: type, name: str) -> None:
        self._kept_as = f"_figure_{name}"

    @overload
    def __get__(self, owner: None, kind: type) -> Figure: ...
    @overload
    def __get__(self, owner: QWidget, kind: type) -> CommandField: ...
    def __get__(self, owner: QWidget | None, kind: type) -> Figure | CommandField:
        """Return the field of a widget; the declaration itself if it is read from the class."""
        if owner is None:
            return self
        field = owner.__dict__.get(self._kept_as)
        if not isinstance(field, CommandField):
            field = named(self._named, CommandField(self._figure))
            owner.__dict__[self._kept_as] = field
        return field
