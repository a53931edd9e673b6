"""Edits of points, the cells they are typed into, and the clipboard."""

import contextlib
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from armui.arm.refusal import Refusal
from armui.kinematics.arm_kinematics import Kinematics
from armui.protocol.codes import MoveMode
from armui.trajectory.files import TrajectoryFileError
from armui.trajectory.planning.convert import to_move
from armui.trajectory.points import edits
from armui.trajectory.points.cells import PointColumn, edited
from armui.trajectory.points.clipboard import from_text, to_text
from armui.trajectory.points.program import GripperOpening, LightAction, Waypoint
from tests.family import PIPER
from tests.trajectory.strategies import POINTS


def point(first=0.0, **more):
    return Waypoint(MoveMode.MOVE_J, (first, 10.0, -10.0, 0.0, 5.0, 0.0), **more)


ABCDE = tuple(point(float(place), note=note) for place, note in enumerate("ABCDE"))


def notes(points):
    return "".join(each.note for each in points)


@pytest.mark.parametrize(
    ("rows", "before", "expected", "first"),
    [
        ([0], 3, "BCADE", 2),
        ([3], 0, "DABCE", 0),
        ([1, 3], 5, "ACEBD", 3),
        ([1, 3], 0, "BDACE", 0),
        ([1, 3], 2, "ABDCE", 1),
        ([2], 2, "ABCDE", 2),
    ],
)
def test_rows_are_moved_together_before_another(rows, before, expected, first):
    moved, row = edits.move(ABCDE, rows, before)
    assert (notes(moved), row) == (expected, first)


@pytest.mark.parametrize(
    ("rows", "by", "expected"),
    [([1], -1, "BACDE"), ([1], 1, "ACBDE"), ([0], -1, "ABCDE"), ([4], 1, "ABCDE")],
)
def test_rows_go_one_place_up_or_down_and_not_beyond_the_ends(rows, by, expected):
    assert notes(edits.shift(ABCDE, rows, by)[0]) == expected


def test_insert_remove_change():
    assert notes(edits.insert(ABCDE, 2, [point(note="x")])) == "ABxCDE"
    assert notes(edits.remove(ABCDE, [4, 0])) == "BCD"
    assert notes(edits.change(ABCDE, {1: point(note="y")})) == "AyCDE"


@given(st.lists(st.integers(0, 4)), st.lists(st.integers(0, 4)))
def test_a_difference_leads_forth_and_back(before, after):
    old = tuple(ABCDE[place] for place in before)
    new = tuple(ABCDE[place] for place in after)
    change = edits.difference(old, new)
    if change is None:
        assert old == new
        return
    assert change.apply(old) == new
    assert change.reversed().apply(new) == old


def test_a_difference_is_no_larger_than_it_must_be():
    changed = edits.change(ABCDE, {2: point(note="x")})
    change = edits.difference(ABCDE, changed)
    assert (change.first, notes(change.removed), notes(change.added)) == (2, "C", "x")


# Cells --------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("column", "text", "changed"),
    [
        (PointColumn.VALUE_1, "12.5°", {"target": (12.5, 10.0, -10.0, 0.0, 5.0, 0.0)}),
        (PointColumn.VALUE_6, "−3,25", {"target": (0.0, 10.0, -10.0, 0.0, 5.0, -3.25)}),
        (PointColumn.SPEED, "55 %", {"speed_percent": 55}),
        (PointColumn.DWELL, "1.5 s", {"dwell_s": 1.5}),
        (PointColumn.DWELL, "", {"dwell_s": 0.0}),
        (PointColumn.GRIPPER, "35mm@1Nm", {"gripper": GripperOpening(35.0, 1.0)}),
        (PointColumn.GRIPPER, "", {"gripper": None}),
        (PointColumn.LIGHT, "2/all:255,128,0", {"light": LightAction(2, 255, 128, 0)}),
        (PointColumn.NOTE, "over the tray", {"note": "over the tray"}),
    ],
)
def test_what_is_typed_into_a_cell(column, text, changed):
    assert edited(point(), column, text) == replace(point(), **changed)


@pytest.mark.parametrize(
    ("column", "text", "code", "field"),
    [
        (PointColumn.VALUE_2, "abc", "point_not_a_number", "J2"),
        (PointColumn.VALUE_2, "", "point_not_a_number", "J2"),
        (PointColumn.VALUE_3, "361", "point_out_of_range", "J3"),
        (PointColumn.SPEED, "0", "point_out_of_range", "speed"),
        (PointColumn.SPEED, "12.5", "point_not_whole", "speed"),
        (PointColumn.DWELL, "-1", "point_out_of_range", "dwell"),
        (PointColumn.GRIPPER, "open", "option_bad", "gripper"),
        (PointColumn.GRIPPER, "900mm@1Nm", "point_out_of_range", "opening"),
        (PointColumn.LIGHT, "9/all:0,0,0", "option_bad", "light"),
        (PointColumn.MIDDLE, "1 2 3", "point_incomplete", "middle"),
    ],
)
def test_what_cannot_be_names_the_field(column, text, code, field):
    refusal = edited(point(), column, text)
    assert isinstance(refusal, Refusal)
    assert (refusal.code, refusal.params["field"]) == (code, field)


def test_a_middle_pose_is_six_figures_with_anything_between():
    arc = Waypoint(MoveMode.MOVE_C, (300.0, 0, 200, 0, 85, 0), (0.0,) * 6)
    assert edited(arc, PointColumn.MIDDLE, "250, 40; 210 0 85,0").middle == (250, 40, 210, 0, 85, 0)


# The kind of motion -------------------------------------------------------------------------------


def test_another_kind_of_motion_keeps_the_place():
    model = Kinematics(PIPER)
    joint = Waypoint(MoveMode.MOVE_J, (10.0, 60.0, -60.0, 5.0, 30.0, -10.0))
    before = tuple(model.forward((0.0, 60.0, -60.0, 0.0, 30.0, 0.0)))

    line = to_move(joint, MoveMode.MOVE_L, model, joint.target, before)
    assert isinstance(line, Waypoint)
    arc = to_move(line, MoveMode.MOVE_C, model, joint.target, before)
    assert isinstance(arc, Waypoint)
    assert arc.middle is not None
    back = to_move(arc, MoveMode.MOVE_J, model, joint.target, before)

    assert line.target == pytest.approx(tuple(model.forward(joint.target)))
    assert arc.middle[:3] == pytest.approx(
        [(a + b) / 2 for a, b in zip(before[:3], line.target[:3], strict=True)]
    )
    assert back.middle is None
    assert back.target == pytest.approx(joint.target, abs=1e-6)


# The clipboard ------------------------------------------------------------------------------------


@given(st.lists(POINTS, min_size=1, max_size=5))
def test_points_copied_and_pasted_are_the_same(points):
    plain = [replace(each, comments=(), note=" ".join(each.note.split()) or "") for each in points]
    assert from_text(to_text(plain)) == tuple(plain)


def test_rows_of_a_spreadsheet():
    pasted = from_text("J1\tJ2\tJ3\tJ4\tJ5\tJ6\n1\t2\t-3\t4\t5\t6\t50\t0.5\n7\t8\t-9\t0\t1\t2\n")
    assert [each.target for each in pasted] == [(1, 2, -3, 4, 5, 6), (7, 8, -9, 0, 1, 2)]
    assert [(each.speed_percent, each.dwell_s) for each in pasted] == [(50, 0.5), (100, 0.0)]


def test_rows_are_poses_where_the_row_in_the_table_is_one():
    (pasted,) = from_text("300;0;250;0;85;0", MoveMode.MOVE_L)
    assert (pasted.move, pasted.target) == (MoveMode.MOVE_L, (300, 0, 250, 0, 85, 0))


def test_lines_of_our_own_format():
    (pasted,) = from_text('L 300 0 250 0 85 0 speed=10 note="x y"')
    assert (pasted.move, pasted.speed_percent, pasted.note) == (MoveMode.MOVE_L, 10, "x y")


@pytest.mark.parametrize(
    ("text", "line", "column", "code"),
    [
        ("", 0, 0, "file_empty"),
        ("hello", 1, 1, "values_count"),
        ("1,2,3,4,5,6\n1,2,x,4,5,6", 2, 3, "point_not_a_number"),
        ("1\t2\t3\t4\t5\t6\t999", 1, 9, "point_out_of_range"),
    ],
)
def test_what_is_no_point_is_told_by_line_and_cell(text, line, column, code):
    with pytest.raises(TrajectoryFileError) as caught:
        from_text(text)
    error = caught.value
    assert (error.line, error.column, error.refusal.code) == (line, column, code)


@given(st.text(max_size=80))
def test_any_text_gives_points_or_a_place(text):
    with contextlib.suppress(TrajectoryFileError):
        assert from_text(text)
