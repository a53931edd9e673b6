"""Points and trajectories: what is refused and in which words; conversion; find and replace."""

from __future__ import annotations

import pickle
import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given

from armui.kinematics.arm_kinematics import Kinematics
from armui.protocol.codes import MoveMode
from armui.trajectory.planning.convert import (
    CONVERT_NEEDS_MIDDLE,
    CONVERT_OUT_OF_REACH,
    to_joints,
    to_pose,
)
from armui.trajectory.points import edits
from armui.trajectory.points.program import (
    POINT_OUT_OF_RANGE,
    TEXT_TOO_LONG,
    GripperOpening,
    LightAction,
    Trajectory,
    Waypoint,
    check_point,
    check_trajectory,
)
from armui.trajectory.samples.recording import Recording, check_recording
from tests.family import FACTORY_LIMITS, PIPER
from tests.trajectory.strategies import RECORDINGS, TRAJECTORIES

HERE = (10.0, 70.0, -60.0, 10.0, 25.0, -20.0)
POINT = Waypoint(MoveMode.MOVE_J, HERE, note="over the tray")
POSE = (300.0, 0.0, 250.0, 0.0, 85.0, 0.0)
KINEMATICS = Kinematics(PIPER)


@given(TRAJECTORIES)
def test_another_process_gets_it_whole(trajectory):
    assert pickle.loads(pickle.dumps(trajectory)) == trajectory


@given(TRAJECTORIES)
def test_every_trajectory_of_the_strategy_is_possible(trajectory):
    assert check_trajectory(trajectory) is None


@given(RECORDINGS)
def test_every_recording_of_the_strategy_is_possible(recording):
    assert check_recording(recording) is None


@pytest.mark.parametrize(
    ("changes", "code", "field"),
    [
        ({"target": (0, 361, 0, 0, 0, 0)}, "point_out_of_range", "J2"),
        ({"target": (0, 0, float("nan"), 0, 0, 0)}, "point_not_a_number", "J3"),
        ({"target": (0, 0, 0)}, "point_incomplete", "target"),
        ({"move": MoveMode.MOVE_L, "target": (0, 0, 2001, 0, 0, 0)}, "point_out_of_range", "Z"),
        ({"move": MoveMode.MOVE_C}, "point_incomplete", "middle"),
        ({"middle": POSE}, "point_incomplete", "middle"),
        ({"move": MoveMode.MOVE_M}, "point_move_unknown", None),
        ({"speed_percent": 0}, "point_out_of_range", "speed"),
        ({"speed_percent": 30.5}, "point_not_whole", "speed"),
        ({"dwell_s": -1}, "point_out_of_range", "dwell"),
        ({"gripper": GripperOpening(-1)}, "point_out_of_range", "opening"),
        ({"gripper": GripperOpening(1, 6)}, "point_out_of_range", "torque"),
        ({"light": LightAction(7, 0, 0, 0)}, "point_out_of_range", "light joint"),
        ({"light": LightAction(1, 256, 0, 0)}, "point_out_of_range", "red"),
        ({"note": "x" * 4001}, "text_too_long", "note"),
        ({"note": "\ud800"}, "text_bad", "note"),
        ({"comments": ("a\nb",)}, "text_bad", "comment"),
    ],
)
def test_what_no_arm_can_do_is_refused_by_field(changes, code, field):
    point = replace(POINT, **changes)
    refusal = check_point(point)
    assert refusal is not None
    assert refusal.code == code
    assert refusal.params.get("field") == field
    assert check_trajectory(Trajectory("t", points=(POINT, point))) == (2, refusal)


def test_a_refusal_names_value_limits_and_unit():
    assert check_point(replace(POINT, dwell_s=5000.0)) == POINT_OUT_OF_RANGE(
        field="dwell", value=5000.0, minimum=0.0, maximum=3600.0, unit="s"
    )


@pytest.mark.parametrize(
    ("name", "code"), [("", "name_empty"), (" \t", "name_empty"), ("x" * 201, "name_too_long"),
                       ("a\nb", "text_bad"), ("\udfff", "text_bad")]
)  # fmt: skip
def test_a_name_must_be_one(name, code):
    found = check_trajectory(Trajectory(name))
    assert found is not None
    assert found[1].code == code


@pytest.mark.parametrize(
    ("row", "column", "value", "code"),
    [(2, 0, 0.5, "sample_back_in_time"), (1, 3, 400.0, "point_out_of_range"),
     (1, 6, float("nan"), "point_not_a_number"), (2, 7, 999.0, "point_out_of_range")],
)  # fmt: skip
def test_a_sample_that_cannot_be_is_refused_by_row(row, column, value, code):
    samples = np.zeros((3, 8))
    samples[:, 0] = (0.0, 1.0, 2.0)
    samples[:, 7] = np.nan
    assert check_recording(Recording("r", samples=samples)) is None
    samples[row, column] = value
    found = check_recording(Recording("r", samples=samples))
    assert found is not None
    assert (found[0], found[1].code) == (row + 1, code)


# Conversion ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("move", [MoveMode.MOVE_P, MoveMode.MOVE_L])
def test_joints_become_a_pose_and_the_same_joints_again(move):
    as_pose = to_pose(POINT, KINEMATICS, move)
    assert isinstance(as_pose, Waypoint)
    assert as_pose.move is move
    assert as_pose.note == POINT.note
    back = to_joints(as_pose, KINEMATICS, HERE)
    assert back.target == pytest.approx(HERE, abs=1e-6)
    assert back.move is MoveMode.MOVE_J


def test_a_pose_as_it_is_written_becomes_the_round_angles_that_were_set():
    """A pose is kept to 0.001 mm and 0.001°, which alone makes 54.999° of 55."""
    set_deg = (12.0, 55.0, -60.0, 7.5, 30.25, -41.0)
    as_pose = to_pose(replace(POINT, target=set_deg), KINEMATICS)
    assert isinstance(as_pose, Waypoint)
    written = replace(as_pose, target=tuple(round(figure, 3) for figure in as_pose.target))
    assert to_joints(written, KINEMATICS, set_deg).target == set_deg


def test_a_way_within_the_limits_goes_before_a_nearer_one():
    as_pose = to_pose(POINT, KINEMATICS)
    assert isinstance(as_pose, Waypoint)
    ways = KINEMATICS.inverse(KINEMATICS.forward(HERE), HERE)
    beyond = next(way for way in ways if abs(way[3]) > 100.0)
    assert to_joints(as_pose, KINEMATICS, beyond).target == pytest.approx(beyond)
    within = to_joints(as_pose, KINEMATICS, beyond, FACTORY_LIMITS)
    assert abs(within.target[3]) <= 100.0


def test_a_pose_out_of_reach_stays_a_pose():
    far = Waypoint(MoveMode.MOVE_P, (900.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    assert to_joints(far, KINEMATICS, HERE) == CONVERT_OUT_OF_REACH(x=900.0, y=0.0, z=0.0)


def test_no_conversion_invents_the_middle_of_an_arc():
    assert to_pose(POINT, KINEMATICS, MoveMode.MOVE_C).reason == CONVERT_NEEDS_MIDDLE


# Find and replace ---------------------------------------------------------------------------------


def test_find_and_replace_in_notes():
    points = [POINT, replace(POINT, note="away"), replace(POINT, note="Over again")]
    assert list(edits.find_text(points, "over")) == [0]
    assert edits.replace_text(points[0], "tray", "box").note == "over the box"
    assert edits.replace_text(points[0], "tray", "x" * 5000).reason == TEXT_TOO_LONG


def test_find_and_replace_figures():
    points = [POINT, replace(POINT, speed_percent=50), Waypoint(MoveMode.MOVE_P, POSE)]
    assert list(edits.find_figure(points, edits.FigureQuery("J2", 70.0))) == [0, 1]
    assert list(edits.find_figure(points, edits.FigureQuery("speed", 50))) == [1]
    assert list(edits.find_figure(points, edits.FigureQuery("X", 301, 2.0))) == [2]


def test_the_points_alone_need_no_numpy():
    code = "import sys, armui.trajectory.points.program; sys.exit('numpy' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
