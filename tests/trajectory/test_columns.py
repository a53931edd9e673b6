"""Tables of an unknown dialect: what is seen in them, and what they become by a mapping."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from armui.protocol.codes import MoveMode
from armui.trajectory import columns
from armui.trajectory.columns import ColumnMapping, ColumnQuantity, TableColumn
from armui.trajectory.columns.sniff import FILE_NO_TABLE
from armui.trajectory.files import TrajectoryFileError
from armui.trajectory.points.program import GripperOpening, Trajectory
from armui.trajectory.samples.recording import Recording
from tests.examples import examples
from tests.trajectory.strategies import outcome

JOINTS = [f"J{joint}" for joint in range(1, 7)]


def guessed(text):
    """The guesses of a table in short: `J1 rad`, `-` for none."""
    return [
        "-" if guess.column is None else " ".join(filter(None, guess.column))
        for guess in columns.sniff(text).guesses
    ]


def joints(unit):
    return [f"{joint} {unit}" for joint in JOINTS]


def mapping(*names, **options):
    """A mapping from `J1 rad` and the like; `-` for a column left out."""
    chosen = []
    for name in names:
        quantity, _, unit = name.partition(" ")
        chosen.append(None if name == "-" else TableColumn(ColumnQuantity(quantity), unit))
    return ColumnMapping(tuple(chosen), **options)


def applied(text, chosen):
    return columns.apply(text, columns.sniff(text), chosen, "x")


# What is seen -------------------------------------------------------------------------------------

ROW = "0.01 0.1 1.2 -0.7 0 0.2 1"


@pytest.mark.parametrize("delimiter", [",", ";", "\t", "|", " ", "   ", ", "])
@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_the_delimiter_is_found(delimiter, end):
    text = end.join(line.replace(" ", delimiter) for line in (ROW, ROW, ROW))
    sheet = columns.sniff(text)
    assert sheet.delimiter == (delimiter.strip(" ") or " ")
    assert (sheet.width, sheet.header, sheet.first_line) == (7, (), 1)
    assert [cell.strip() for cell in sheet.preview[2]] == ROW.split()


@pytest.mark.parametrize("delimiter", [";", "\t", " "])
def test_a_decimal_comma_is_found(delimiter):
    text = "\n".join([ROW.replace(" ", delimiter).replace(".", ",")] * 3)
    sheet = columns.sniff(text)
    assert (sheet.delimiter, sheet.decimal, sheet.width) == (delimiter, ",", 7)
    read = applied(text, mapping("wait s", *joints("rad")))
    assert read.joints_deg[0, 1] == pytest.approx(math.degrees(1.2))


def test_what_stands_before_the_table_is_passed_over():
    text = 'Robot "7\n# by hand\n\n# t, q1, q2, q3, q4, q5, q6\n' + ROW.replace(" ", ",") + "\n"
    sheet = columns.sniff(text)
    assert sheet.first_line == 5
    assert sheet.header == ("t", "q1", "q2", "q3", "q4", "q5", "q6")
    assert len(sheet.preview) == 1


@pytest.mark.parametrize(
    "text", ["", "\n\n", "hello", "a,b\nc,d\n", "1\n2\n3\n", "#1,2\n", "\0", '"']
)
def test_what_holds_no_table_says_so(text):
    with pytest.raises(TrajectoryFileError) as caught:
        columns.sniff(text)
    assert caught.value.refusal.reason == FILE_NO_TABLE


@pytest.mark.parametrize(
    ("header", "row", "expected"),
    [
        (
            "time_ms,joint1_deg,joint2_deg,joint3_deg,joint4_deg,joint5_deg,joint6_deg,gripper_mm",
            "5,1,2,3,4,5,6,7",
            ["time ms", *joints("°"), "gripper mm"],
        ),
        (
            "t [s],J1 (rad),J2 (rad),J3 (rad),J4 (rad),J5 (rad),J6 (rad)",
            "5,1,2,3,4,5,6",
            ["time s", *joints("rad")],
        ),
        ("joint0,joint1,joint2,joint3,joint4,joint5", "10,20,30,40,50,60", joints("°")),
        ("name,A1,A2,A3,A4,A5,A6,v", "p,0,50,-40,0,10,0,40", ["-", *joints("°"), "-"]),
        ("J1,J2,J3,J4,J5,J6,A1", "10,20,30,40,50,60,7", [*joints("°"), "-"]),
        (
            "label,x_m,y_m,z_m,roll,pitch,yaw,speed,dwell_s",
            "a,0.3,0,0.2,0,1.5,0,30,2",
            ["note", "X m", "Y m", "Z m", "RX rad", "RY rad", "RZ rad", "speed %", "dwell s"],
        ),
        (
            "时间(毫秒),关节1(度),关节2(度),关节3(度),关节4(度),关节5(度),关节6(度),温度",
            "5,1,2,3,4,5,6,40",
            ["time ms", *joints("°"), "-"],
        ),
        ("x,x,y,z,rx,ry,rz", "300,1,0,200,0,85,0", ["X mm", "-", *[f"{n} mm" for n in "YZ"],
         *[f"{n} °" for n in ("RX", "RY", "RZ")]]),
    ],
)  # fmt: skip
def test_titles_are_understood(header, row, expected):
    text = f"{header}\n{row}\n{row}\n"
    assert guessed(text) == expected
    sheet = columns.sniff(text)
    assert sheet.first_line == 2
    assert sheet.header == tuple(header.split(","))


def test_how_sure_a_guess_is():
    sure, unit_guessed, none = columns.sniff("t_s,j1,colour\n1,2,3\n2,3,4\n").guesses
    assert (sure.confidence, unit_guessed.confidence, none.confidence) == (1.0, 0.8, 0.0)
    assert {guess.confidence for guess in columns.sniff("1 2 3 4 5 6\n").guesses} == {0.5}


@pytest.mark.parametrize(
    ("rows", "expected"),
    [
        (["0.02,0,1.5,-0.7,0,0,0", "0.01,0,1.5,-0.7,0,0,0"], ["wait s", *joints("rad")]),
        (["0,0,90,-45,0,0,0,50", "10,0,90,-45,0,0,0,50"], ["time s", *joints("°"), "gripper mm"]),
        (["0,0,90,-45,0,0,0", "500,0,90,-45,0,0,0"], ["time ms", *joints("°")]),
        (["1700000000.5,0,1,0,0,0,0", "1700000001.5,0,1,0,0,0,0"], ["time s", *joints("rad")]),
        (["1700000000123,0,1,0,0,0,0", "1700000000223,0,1,0,0,0,0"], ["time ms", *joints("rad")]),
        (["0,1,0,0,0,0,0.05", "0,1,0,0,0,0,0.05"], ["wait s", *joints("rad")]),
        (["400,0,250,0,85,0"] * 2, ["X mm", "Y mm", "Z mm", "RX °", "RY °", "RZ °"]),
        (["1,2,3"] * 2, ["-", "-", "-"]),
    ],
)
def test_without_titles_place_and_figures_speak(rows, expected):
    assert guessed("\n".join(rows)) == expected


# What it becomes ----------------------------------------------------------------------------------


def test_a_recording_by_absolute_time():
    text = "stamp q1 q2 q3 q4 q5 q6 grip\n" + "".join(
        f"{1000 + 20 * k} 0 {math.pi / 2} -1 0 0 {k / 10} 0.05\n" for k in range(4)
    )
    read = applied(text, mapping("time ms", *joints("rad"), "gripper m"))
    assert isinstance(read, Recording)
    assert read.name == "x"
    assert read.times_s == pytest.approx([0.0, 0.02, 0.04, 0.06])
    assert read.joints_deg[0, :3] == pytest.approx([0.0, 90.0, math.degrees(-1)])
    assert read.gripper_mm == pytest.approx([50.0] * 4)


def test_a_recording_by_waits_in_any_order_of_columns():
    text = "6,5,4,3,2,1,9,500\n6,5,4,3,2,1,9,250\n"
    read = applied(text, mapping(*[f"J{j} °" for j in (6, 5, 4, 3, 2, 1)], "-", "wait ms"))
    assert read.times_s == pytest.approx([0.0, 0.25])
    assert read.joints_deg[1] == pytest.approx([1, 2, 3, 4, 5, 6])
    assert np.isnan(read.gripper_mm).all()


def test_points_by_joints():
    text = "j1;j2;j3;j4;j5;j6;speed;pause;grip;note\n1;2;-3;4;5;6;40;1,5;;\n1;2;-3;4;5;6;;;35;go\n"
    options = ("speed %", "dwell s", "gripper mm", "note")
    read = applied(text, mapping(*joints("°"), *options, move=MoveMode.MOVE_J))
    assert isinstance(read, Trajectory)
    first, second = read.points
    assert (first.move, first.target) == (MoveMode.MOVE_J, (1, 2, -3, 4, 5, 6))
    assert (first.speed_percent, first.dwell_s, first.gripper, first.note) == (40, 1.5, None, "")
    assert (second.speed_percent, second.dwell_s) == (100, 0.0)
    assert (second.gripper, second.note) == (GripperOpening(35), "go")


def test_points_by_poses():
    text = "0.3,0,0.25,0,1.5707963267948966,0\n"
    chosen = mapping("X m", "Y m", "Z m", "RX rad", "RY rad", "RZ rad", move=MoveMode.MOVE_L)
    (point,) = applied(text, chosen).points
    assert point.move is MoveMode.MOVE_L
    assert point.target == pytest.approx((300, 0, 250, 0, 90, 0))


@pytest.mark.parametrize(
    ("chosen", "code", "params"),
    [
        (mapping(*joints("°")), "columns_missing", {"missing": "time"}),
        (mapping("time s", "J1 °"), "columns_missing", {"missing": "J2, J3, J4, J5, J6"}),
        (mapping("X mm", move=MoveMode.MOVE_P), "columns_missing", {"missing": "Y, Z, RX, RY, RZ"}),
        (mapping("J1 °", "J1 °"), "columns_twice", {"first": 1, "second": 2, "field": "J1"}),
        (
            mapping("J1 mm"),
            "columns_unit",
            {"column": 1, "field": "J1", "value": "mm", "choices": "°, rad, 0.1°, mrad, 0.001°"},
        ),
    ],
)
def test_a_mapping_that_says_too_little_or_too_much(chosen, code, params):
    refusal = columns.check_mapping(chosen)
    assert (refusal.code, refusal.params) == (code, params)
    with pytest.raises(ValueError, match=code):
        applied("1,2\n", chosen)


GOOD = "0,1,2,-3,4,5,6\n"


@pytest.mark.parametrize(
    ("bad", "line", "column", "code"),
    [
        ("1,1,x,-3,4,5,6", 4, 3, "number_bad"),
        ("1,1,1_0,-3,4,5,6", 4, 3, "number_bad"),
        ("1,1,,-3,4,5,6", 4, 3, "number_bad"),
        ("1,1,2,-3,4,5", 4, 0, "cells_count"),
        ("1,1,2,-3,4,5,6,7", 4, 0, "cells_count"),
        ("1,1,2,-3,400,5,6", 4, 0, "point_out_of_range"),
        ("1,1,nan,-3,4,5,6", 4, 0, "point_not_a_number"),
        ("-1,1,2,-3,4,5,6", 4, 0, "point_out_of_range"),
    ],
)
def test_a_row_that_does_not_fit_is_named(bad, line, column, code):
    text = f"t,j1,j2,j3,j4,j5,j6\n{GOOD}\n{bad}\n{GOOD}"
    with pytest.raises(TrajectoryFileError) as caught:
        applied(text, mapping("time s", *joints("°")))
    error = caught.value
    assert (error.line, error.column, error.refusal.code) == (line, column, code)


def test_trailing_delimiters_and_comments_are_no_cells():
    text = f"# first\n{GOOD}{GOOD}# in between\n1,1,2,-3,4,5,6,,\n"
    assert len(applied(text, mapping("time s", *joints("°"))).samples) == 3


def test_a_row_with_cells_too_few_is_told_even_where_it_is_the_first():
    text = "1,2,3,4,5,6\n" + GOOD * 3
    with pytest.raises(TrajectoryFileError, match="line 1: 6 cells where there are 7"):
        applied(text, mapping("time s", *joints("°")))


def test_a_mapping_of_another_sheet_is_a_mistake_of_the_caller():
    with pytest.raises(ValueError, match="7 columns mapped of 2"):
        applied("1,2\n", mapping("time s", *joints("°")))


WIDE = st.lists(
    st.lists(st.text('0123456789.,-#_ "ae', max_size=4), min_size=6, max_size=9).map(";".join),
    max_size=6,
).map("\n".join)
"""Rows of half-sensible cells, wide enough for a recording."""


@settings(max_examples=examples(100))
@given(st.text(max_size=80) | WIDE)
def test_any_text_is_read_or_refused(text):
    result = outcome(columns.sniff, text)
    if isinstance(result, columns.Sheet):
        assert len(result.guesses) == result.width
        if result.width < 7:  # too narrow for a recording
            return
        names = ["time s", *joints("°"), *"-" * result.width][: result.width]
        result = outcome(columns.apply, text, result, mapping(*names), "x")
    if isinstance(result, TrajectoryFileError):
        assert result.refusal.reason.source
    else:
        assert isinstance(result, Recording)
