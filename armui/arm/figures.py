"""The figures that commands take: ranges and units declared in annotations, and their one check.

A method says `red: Grey`, with `Grey = Annotated[int, Range(0, 255)]`. What checks the value, shows
its limits beside a field or describes the method to others reads them from there.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Annotated, Final, NamedTuple, get_args, get_origin, get_type_hints

from armui.arm.limits import JOINTS
from armui.arm.refusal import Reason, Refusal
from armui.protocol.codes import ALL_JOINTS

FIGURE_NOT_A_NUMBER = Reason(
    "figure_not_a_number",
    "{figure}: “{value}” is not a number. Enter a value from {minimum} to {maximum} {unit}.",
)
FIGURE_OUT_OF_RANGE = Reason(
    "figure_out_of_range",
    "{figure}: {value} {unit} is out of range. Enter a value from {minimum} to {maximum} {unit}.",
)
FIGURE_NOT_WHOLE = Reason(
    "figure_not_whole",
    "{figure}: “{value}” is not a whole number. Enter one from {minimum} to {maximum}.",
)
WHOLE_OUT_OF_RANGE = Reason(
    "whole_out_of_range",
    "{figure}: {value} is out of range. Enter a whole number from {minimum} to {maximum}.",
)


class Range(NamedTuple):
    """The range of a figure, with its unit.

    Attributes:
        minimum, maximum: The limits, both of them allowed.
        unit: The unit that the operator sees; "" for a plain number.
    """

    minimum: float
    maximum: float
    unit: str = ""


@dataclass(frozen=True, slots=True)
class Also:
    """A value outside a figure's range that is allowed too, as the number that means «all»."""

    value: float


@dataclass(frozen=True, slots=True)
class OneOf:
    """The only values of a figure.

    Attributes:
        values: All that are allowed.
        otherwise: The reason against another, which may name the ``value``.
    """

    values: tuple[float, ...]
    otherwise: Reason


@dataclass(frozen=True, slots=True)
class Count:
    """Marks arguments of which a method takes so many, and no others."""

    number: int


@dataclass(frozen=True, slots=True)
class RangeOfArm:
    """Marks a figure whose range follows from the arm at hand; the method itself checks it.

    Attributes:
        unit: Its unit; both, where that depends on the arm or the axis.
    """

    unit: str = ""


@dataclass(frozen=True, slots=True)
class CommandFigure:
    """A figure of a command.

    Attributes:
        name: The name of the argument; its word for the operator is kept under this name.
        type: ``int`` if only whole numbers are allowed.
        range: Its range, with its unit.
        of_arm: True if its range follows from the arm: the one here has no limits then.
        also: Values outside its range that are allowed as well.
        choices: The only values allowed, where they are few.
    """

    name: str
    type: type[int] | type[float]
    range: Range
    of_arm: bool = False
    also: tuple[float, ...] = ()
    choices: OneOf | None = None

    def check(self, value: float) -> Refusal | None:
        """Return why it may not have a value, or ``None``."""
        if self.choices is not None and value not in self.choices.values:
            return self.choices.otherwise(figure=self.name, value=value)
        if self.of_arm or value in self.also:
            return None
        return check_figure(self.name, value, self.range, whole=self.type is int)


JointNumber = Annotated[int, Range(JOINTS[0], JOINTS[-1])]
"""One joint."""
JointOrAll = Annotated[int, Range(JOINTS[0], JOINTS[-1]), Also(ALL_JOINTS)]
"""One joint, or :data:`ALL_JOINTS`."""
PERCENT: Final = Range(0, 100, "%")
Percent = Annotated[int, PERCENT]
"""A speed, or a share of one: the arm takes whole percent (0x151 byte 2)."""


def check_figure(name: str, value: float, within: Range, *, whole: bool = False) -> Refusal | None:
    """Return why a figure may not have a value, or ``None`` if it may.

    Args:
        name: The figure's name.
        value: The value.
        within: The range in which it must lie.
        whole: True if it must be a whole number.
    """
    figures: dict[str, float | int | str] = {"figure": name, "value": value, **within._asdict()}
    if not math.isfinite(value) or (whole and value != int(value)):
        return FIGURE_NOT_WHOLE(**figures) if whole else FIGURE_NOT_A_NUMBER(**figures)
    if within.minimum <= value <= within.maximum:
        return None
    return WHOLE_OUT_OF_RANGE(**figures) if whole else FIGURE_OUT_OF_RANGE(**figures)


@cache
def figures_of(method: Callable[..., object]) -> Mapping[str, CommandFigure]:
    """Return the figures among a method's arguments by their names, in its order.

    Raises:
        NameError: An annotation of it names something that its module does not have at run time.
    """
    hints = get_type_hints(method, include_extras=True)
    found = {name: _figure(name, hint) for name, hint in hints.items()}
    return {name: figure for name, figure in found.items() if figure is not None}


def check_arguments(
    method: Callable[..., object], arguments: Mapping[str, object]
) -> Refusal | None:
    """Return the first reason against the figures that a method is called with, or ``None``."""
    for name, figure in figures_of(method).items():
        value = arguments[name]
        if isinstance(value, int | float) and (refusal := figure.check(value)) is not None:
            return refusal
    return None


def _figure(name: str, hint: object) -> CommandFigure | None:
    """Return the figure that an annotation declares, or ``None`` if it declares none."""
    if get_origin(hint) is not Annotated:
        return None
    kind, *marks = get_args(hint)
    also = tuple(mark.value for mark in marks if isinstance(mark, Also))
    for mark in marks:
        match mark:
            case Range():
                return CommandFigure(name, kind, mark, also=also)
            case RangeOfArm(unit):
                return CommandFigure(name, kind, Range(-math.inf, math.inf, unit), of_arm=True)
            case OneOf(values):
                return CommandFigure(name, kind, Range(min(values), max(values)), choices=mark)
    return None
