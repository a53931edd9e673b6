import math

import pytest

from armui.ui import format as fmt


def test_figures_keep_their_decimals():
    assert fmt.angle(12) == "12.000°"
    assert fmt.number(213.2664) == "213.266"
    assert fmt.percent(30.0) == "30 %"


@pytest.mark.parametrize("value", [None, float("nan"), float("inf")])
def test_what_is_no_figure_is_a_dash(value):
    assert fmt.number(value) == "—"


def test_zero_has_no_sign():
    assert fmt.angle(-0.0004) == "0.000°"
    assert fmt.angle(-0.0006) == "-0.001°"


def test_limits_are_short():
    assert [fmt.short_angle(v) for v in (-150.0, 0.0, 100.0, 179.5)] == [
        "-150°",
        "0°",
        "100°",
        "179.5°",
    ]


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("12.5", 12.5),
        (" -3 ", -3.0),
        ("−3,25°", -3.25),
        ("1e2", 100.0),
        ("", None),
        ("abc", None),
        ("nan", None),
        ("inf", None),
        ("1.2.3", None),
    ],
)
def test_typed_figures(text, value):
    assert fmt.parse_number(text) == value


@pytest.mark.parametrize(
    ("seconds", "length", "place"),
    [
        (0.0, "0.000 s", "0:00.000"),
        (7.25, "7.250 s", "0:07.250"),
        (59.9996, "1:00", "1:00.000"),
        (3723.0, "1:02:03", "1:02:03.000"),
    ],
)
def test_a_time_is_written_alike_everywhere(seconds, length, place):
    assert (fmt.duration(seconds, 3), fmt.clock(seconds, 3)) == (length, place)
    assert fmt.duration(None) == "—"


def test_joints_in_a_row_are_one_span():
    assert fmt.joint_spans([1, 3, 4, 5, 6]) == "J1, J3–J6"
    assert fmt.joint_spans([1, 2, 5, 6]) == "J1, J2, J5, J6"
    assert fmt.joint_spans([]) == ""


@pytest.mark.parametrize(
    ("values", "texts"),
    [
        ([337.0], ["337"]),
        ([337.04, -12.26], ["337", "-12.3"]),
        ([0.125, 30.0], ["0.125", "30"]),
        ([180.04, 180.0], ["180.04", "180"]),
        ([0.0], ["0"]),
        ([100.0, math.nan], ["100", "—"]),
    ],
)
def test_figures_of_a_sentence_have_the_decimals_that_tell_them_apart(values, texts):
    """What exceeds a limit by little must not read as the limit."""
    assert fmt.spoken(values) == texts


def test_no_line_ends_between_the_name_of_a_figure_of_a_pose_and_the_figure():
    pairs = fmt.pose((1.0, 2.0, 3.0, 4.0, 5.0, 6.0), 1).split("  ")
    assert [each.split() for each in pairs][2:4] == [["Z", "3.0", "mm"], ["RX", "4.0°"]]
    assert not any(" " in each for each in pairs)
