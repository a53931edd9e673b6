"""Figures are declared in annotations: their ranges, and the sentence against another value."""

from typing import Annotated

import pytest

from armui.arm.figures import (
    FIGURE_NOT_A_NUMBER,
    FIGURE_NOT_WHOLE,
    FIGURE_OUT_OF_RANGE,
    WHOLE_OUT_OF_RANGE,
    Also,
    CommandFigure,
    JointNumber,
    JointOrAll,
    OneOf,
    Range,
    RangeOfArm,
    check_arguments,
    figures_of,
)
from armui.arm.refusal import Reason

NO_SUCH_OFFSET = Reason("no_such_offset", "{value} is no offset.")
Angle = Annotated[float, RangeOfArm("°")]
Share = Annotated[float, Range(0, 100, "%")]
Offset = Annotated[int, OneOf((0, 16), NO_SUCH_OFFSET)]


def command(name: str, joint: JointOrAll, percent: Share, to_deg: Angle, offset: Offset) -> None:
    """Take a figure of each kind."""


ARGUMENTS = {"name": "x", "joint": 1, "percent": 50.0, "to_deg": 12.5, "offset": 16}


def test_the_figures_of_a_method_are_told_with_range_and_unit():
    figures = figures_of(command)
    assert list(figures) == ["joint", "percent", "to_deg", "offset"]
    assert figures["joint"] == CommandFigure("joint", int, Range(1, 6), also=(7,))
    assert figures["percent"] == CommandFigure("percent", float, Range(0, 100, "%"))
    assert figures["to_deg"].of_arm
    assert figures["to_deg"].range.unit == "°"
    assert figures["offset"].range == Range(0, 16)


@pytest.mark.parametrize(
    ("name", "value", "reason"),
    [
        ("joint", 0, WHOLE_OUT_OF_RANGE),
        ("joint", 8, WHOLE_OUT_OF_RANGE),
        ("joint", 1.5, FIGURE_NOT_WHOLE),
        ("joint", float("nan"), FIGURE_NOT_WHOLE),
        ("percent", -0.001, FIGURE_OUT_OF_RANGE),
        ("percent", 100.001, FIGURE_OUT_OF_RANGE),
        ("percent", float("nan"), FIGURE_NOT_A_NUMBER),
        ("percent", float("inf"), FIGURE_NOT_A_NUMBER),
        ("offset", 32, NO_SUCH_OFFSET),
    ],
)
def test_a_value_that_is_not_allowed_is_named_with_its_figure(name, value, reason):
    refusal = check_arguments(command, ARGUMENTS | {name: value})
    assert refusal.reason == reason
    assert refusal.params["figure"] == name


@pytest.mark.parametrize(
    ("name", "value"),
    [("joint", 1), ("joint", 6), ("joint", 7), ("percent", 0), ("percent", 100), ("offset", 0)],
)
def test_the_ends_of_a_range_are_allowed_and_what_is_also_allowed(name, value):
    assert check_arguments(command, ARGUMENTS | {name: value}) is None


def test_what_the_arm_decides_is_left_to_the_method():
    assert check_arguments(command, ARGUMENTS | {"to_deg": 1e9}) is None


def test_a_mark_alone_is_no_figure():
    def odd(value: Annotated[int, Also(7)], joint: JointNumber) -> None: ...

    assert list(figures_of(odd)) == ["joint"]
