"""Tables of other hosts: their titles say what the columns are, their figures in which unit."""

from __future__ import annotations

from typing import Any

import pytest

from armui.trajectory import columns, files
from armui.trajectory.columns.model import JOINTS
from armui.trajectory.files import TrajectoryFileError
from armui.trajectory.files.log_file import FILE_KIND_UNKNOWN
from tests.trajectory.test_columns import guessed, joints

RAD = (0.1, 0.6, -0.7, 0.2, 0.3, -0.1)
DEG = (12, 60, -70, 20, 30, -10)
SIX = range(1, 7)


def table(titles, *figures):
    rows = [",".join(map(str, (*each,))) for each in figures]
    return "\n".join([",".join(titles), *rows]) + "\n"


def in_doubt(text):
    """The units among which the operator is asked for the joints' own."""
    angles = [
        (guess.column.quantity, guess)
        for guess in columns.sniff(text).guesses
        if guess.column is not None
        and guess.column.quantity in JOINTS
        and guess.titled_unit != guess.column.unit
    ]
    return columns.units_in_doubt(angles)


KNOWN: dict[str, tuple[list[str], list[Any], list[str]]] = {
    "the maker's": (
        ["waitTime", *(f"joint_{n}" for n in SIX), "gripper"],
        [(0.01, *RAD, 0.07), (0.02, *RAD, 0.07)],
        ["wait s", *joints("rad"), "gripper m"],
    ),
    "times that are waits": (
        ["time", *(f"joint{n}" for n in SIX)],
        [(0.011, *RAD), (0.01, *RAD), (0.012, *RAD)],
        ["wait s", *joints("rad")],
    ),
    "ROS 1": (
        ["%time", "field.header.frame_id", *(f"field.name{n}" for n in range(7)),
         *(f"field.position{n}" for n in range(7)), *(f"field.velocity{n}" for n in range(7))],
        [(1650000000000000000 + k, "", *"abcdefg", *RAD, 0.03, *(9,) * 7) for k in range(2)],
        ["time ns", *"-" * 8, *joints("rad"), "gripper m", *"-" * 7],
    ),
    "PlotJuggler, all of a joint side by side": (
        ["__time", *(f"/piper/joint_states/joint{n}/{what}"
                     for n in SIX for what in ("effort", "position", "velocity")),
         "/piper/joint_states/gripper/effort", "/piper/joint_states/gripper/position"],
        [(1780914562.5 + k, *(v for a in RAD for v in (9, a, 8)), 5, 0.05) for k in range(2)],
        ["time s", *(each for n in SIX for each in ("-", f"J{n} rad", "-")), "-", "gripper m"],
    ),
    "two arms: the first": (
        ["ts", *(f"left/joint{n}.position" for n in SIX), "left/gripper",
         *(f"right/joint{n}.position" for n in SIX), "right/gripper"],
        [(k, *RAD, 0.03, *RAD, 0.01) for k in range(2)],
        ["time s", *joints("rad"), "gripper m", *"-" * 7],
    ),
    "speeds and torques": (
        ["t_sec", *(f"qd{n}" for n in SIX), *(f"joint{n}_torque" for n in SIX),
         *(f"joint{n}_deg" for n in SIX), *(f"joint{n}_deg_s" for n in SIX)],
        [(k, *(7,) * 12, *DEG, *(3,) * 6) for k in range(2)],
        ["time s", *"-" * 12, *joints("°"), *"-" * 6],
    ),
    "Chinese": (
        ["时间戳(毫秒)", *(f"{n}号关节角度(度)" for n in SIX), "夹爪开口(mm)", "2号关节电流"],
        [(k, *DEG, 30, 2) for k in range(2)],
        ["time ms", *joints("°"), "gripper mm", "-"],
    ),
    "the maker's SDK": (
        ["TimeStamp", *(f"joint_{n}" for n in SIX), "grippers_angle"],
        [(1700000000.5 + k, *(1000 * a for a in DEG), 50000) for k in range(2)],
        ["time s", *joints("0.001°"), "gripper µm"],
    ),
    "its poses": (
        ["X_axis", "Y_axis", "Z_axis", "RX_axis", "RY_axis", "RZ_axis"],
        [(300000, 0, 250000, 0, 85000, k) for k in range(2)],
        ["X µm", "Y µm", "Z µm", "RX 0.001°", "RY 0.001°", "RZ 0.001°"],
    ),
    "units in titles": (
        ["dt_ms", *(f"j{n} [mrad]" for n in SIX), "gripper(um)", "description"],
        [(5, *(1000 * a for a in RAD), 50000, "x") for k in range(2)],
        ["wait ms", *joints("mrad"), "gripper µm", "note"],
    ),
    "way points": (
        [*(f"joint{n}" for n in SIX), "gripper_joint1", "gripper_width", "hold_time"],
        [(*RAD, 0.02, 0.04, 1)] * 2,
        [*joints("rad"), "-", "gripper m", "dwell s"],
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", KNOWN)
def test_titles_of_other_hosts_are_known_and_nothing_is_asked(name):
    titles, figures, expected = KNOWN[name]
    text = table(titles, *figures)
    assert guessed(text) == expected
    assert in_doubt(text) == ()


def test_a_step_a_frame_and_an_index_are_no_waits():
    text = table(["step", "frame", "index", *(f"joint{n}" for n in SIX)], (1, 2, 3, *RAD))
    assert guessed(text) == ["-", "-", "-", *joints("rad")]


def test_of_target_and_actual_angles_one_set_is_taken_with_its_gripper():
    groups = [[f"{who}_joint{n}" for n in SIX] + [f"{who}_gripper"] for who in ("actual", "target")]
    text = table([*groups[0][:5], *groups[1]], (*RAD[:5], *RAD, 0.03), (*RAD[:5], *RAD, 0.03))
    assert guessed(text) == [*"-" * 5, *joints("rad"), "gripper m"]


NORMALISED = (1.2, -88.1, 96.0, 0.2, 10.1, 0.0)


@pytest.mark.parametrize(
    ("titles", "figures", "asked"),
    [
        ([f"j{n}" for n in SIX], RAD, ("rad", "°")),
        ([f"joint{n}" for n in SIX], (0.1, -1.6, 1.2, 0, 0, 0), ("°", "%")),  # in no unit of it
        ([f"joint{n}" for n in SIX], NORMALISED, ("°", "%")),
        ([f"joint{n}.pos" for n in SIX], (1, 20, -30, 4, 5, 6.5), ("°", "%")),  # LeRobot's own
        ([f"joint{n}" for n in SIX], (10, 250, -60, -140, 20, 30), ("°",)),
        ([f"norm_joint{n}" for n in SIX], (0.1, 0.6, -0.7, 0, 0, 0), ("rad", "°")),
        ([f"action_{n}" for n in range(6)], (1, 20, -30, 4, 5, 6.5), ("°", "%")),
        ([f"joint{n}" for n in SIX], [10 * a for a in DEG], ("0.1°", "mrad", "0.001°")),
        ([f"j{n}" for n in SIX], [1000 * a for a in RAD], ("0.1°", "mrad", "0.001°")),
        ([f"j{n}" for n in SIX], [1000 * a for a in DEG], ()),
        ([f"j{n}" for n in SIX], DEG, ()),
        ([f"joint{n}_deg" for n in SIX], NORMALISED, ()),  # who says so knows
        ([f"j{n}" for n in SIX], (0,) * 6, ()),
    ],
)
def test_a_unit_that_does_not_fit_the_arm_is_asked_for(titles, figures, asked):
    assert in_doubt(table(titles, figures, figures)) == asked


@pytest.mark.parametrize("factor", [10, 1000])
def test_without_titles_the_ranges_of_the_joints_tell_angles_from_poses(factor):
    row = " ".join(str(factor * angle) for angle in DEG) + "\n"
    assert guessed(row * 3) == joints({10: "0.1°", 1000: "0.001°"}[factor])
    pose = "300000 0 250000 0 85000 0\n" if factor == 1000 else "400 0 250 0 85 0\n"
    assert guessed(pose * 3)[0] == ("X µm" if factor == 1000 else "X mm")


@pytest.mark.parametrize("angles", ["0.1,-1.6,1.2,0,0,0", "12,60,-70,20,30,-10", "0,6,-6,0,0,0"])
def test_figures_no_arm_comes_to_in_radians_are_not_the_makers_recording(angles):
    with pytest.raises(TrajectoryFileError) as caught:
        files.read_text(f"0.02,0,0,0,0,0,0\n0.02,{angles}\n", "maker")
    outside = caught.value.refusal.reason == FILE_KIND_UNKNOWN
    assert (outside, caught.value.line) == (angles[0] == "0", 2)
