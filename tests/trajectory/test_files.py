"""Every format: what is written is read back the same, and nothing broken does harm."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from armui.protocol.codes import MoveMode
from armui.trajectory import files
from armui.trajectory.files import TrajectoryFileError
from armui.trajectory.points.program import GripperOpening, LightAction, Trajectory, Waypoint
from armui.trajectory.samples.recording import Recording
from tests.examples import examples
from tests.trajectory.library.contents import recording, trajectory
from tests.trajectory.strategies import RECORDINGS, TRAJECTORIES

TEXT_FORMATS = (".log", ".csv", ".json")
POSE = (300.0, 0.0, 250.0, 0.0, 85.0, 0.0)
EXAMPLE = """\
armui trajectory 1
name: Pick and place
note: "two\\nlines"
modified: 2026-01-02T03:04:05+00:00

# from above, slowly
J 10 70 -60 10 25 -20 speed=30 dwell=1.5 gripper=35mm@1Nm light=1/all:255,128,0 note="tray"
L 300 0 250.5 0 85 0 speed=10  # touch
C 300 50 250 0 85 0 / 300 0 200 0 85 0 speed=20 gripper=-20°@0.5rad/s
# the end
"""


@pytest.mark.parametrize("suffix", TEXT_FORMATS)
@given(content=TRAJECTORIES | RECORDINGS)
def test_what_is_written_is_read_back_the_same(suffix, content):
    assert files.read_bytes(files.to_bytes(content, suffix), "x") == content


@given(content=RECORDINGS)
def test_a_recording_survives_its_archive(content):
    assert files.read_bytes(files.to_bytes(content, ".npz"), "x") == content


def test_the_example_means_what_it_says():
    read = files.read_text(EXAMPLE, "x")
    assert (read.name, read.note, read.closing) == ("Pick and place", "two\nlines", (" the end",))
    first, second, third = read.points
    assert first == Waypoint(
        MoveMode.MOVE_J,
        (10, 70, -60, 10, 25, -20),
        speed_percent=30,
        dwell_s=1.5,
        gripper=GripperOpening(35, 1),
        light=LightAction(1, 255, 128, 0),
        note="tray",
        comments=(" from above, slowly",),
    )
    assert second.comments == (" touch",)
    assert third.middle == (300, 50, 250, 0, 85, 0)
    assert third.target == (300, 0, 200, 0, 85, 0)
    again = files.to_bytes(read, ".log").decode()
    assert "# from above, slowly\nJ 10 70" in again
    assert "# touch\nL 300" in again
    assert again.endswith("# the end\n")


def test_the_example_in_the_description_of_the_format_is_read():
    text = (Path(__file__).parents[2] / "resources/docs/trajectory-files.md").read_text(
        encoding="utf-8"
    )
    read = files.read_text(text.partition("```text\n")[2].partition("```")[0], "x")
    assert read.note == "two lines\nof a note"
    assert [point.move.name[-1] for point in read.points] == ["J", "L", "C"]


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "gbk", "utf-16"])
def test_text_of_a_chinese_windows_is_read(encoding):
    text = EXAMPLE.replace("tray", "取料盘").replace("\n", "\r\n").replace("°", "deg")
    read = files.read_bytes(text.encode(encoding), "x")
    assert read.points[0].note == "取料盘"
    assert read.closing == (" the end",)


# Errors: line, column, reason ---------------------------------------------------------------------

JSON = """{
  "format": "armui trajectory",
  "version": 1,
  "points": [
    {"move": "MOVE J", "joints_deg": [0, 0, 0, 0, 0, 0]},
    {"move": "MOVE J", %s}
  ]
}"""
CSV = "move,j1_deg,j2_deg,j3_deg,j4_deg,j5_deg,j6_deg,speed_percent\nMOVE J,0,0,0,0,0,0,30\n"
HEADER = "armui trajectory 1\n\nJ 0 0 0 0 0 0\n"


@pytest.mark.parametrize(
    ("text", "line", "column", "code"),
    [
        ("", 0, 0, "file_empty"),
        ("hello", 1, 0, "file_kind_unknown"),
        ("armui trajectory 4\n", 1, 18, "file_version"),
        ("armui trajectory 1\nauthor: me\n", 2, 1, "header_unknown"),
        ("armui trajectory 1\nname: a\nname: b\n", 3, 1, "option_twice"),
        ("armui trajectory 1\nmodified: now\n", 2, 11, "time_bad"),
        (HEADER + "X 1 2 3", 4, 1, "line_unknown"),
        (HEADER + "J 0 0 0 0 0", 4, 1, "values_count"),
        (HEADER + "J 0 0 o 0 0 0", 4, 7, "number_bad"),
        (HEADER + "J 0 0 inf 0 0 0", 4, 7, "number_bad"),
        (HEADER + "J 0 0 0 0 0 0 sped=3", 4, 15, "option_unknown"),
        (HEADER + "J 0 0 0 0 0 0 speed=3 speed=4", 4, 23, "option_twice"),
        (HEADER + "J 0 0 0 0 0 0 speed=fast", 4, 21, "option_bad"),
        (HEADER + "J 0 0 0 0 0 0 gripper=3mm", 4, 23, "option_bad"),
        (HEADER + "J 0 0 0 0 0 0 light=red", 4, 21, "option_bad"),
        (HEADER + 'J 0 0 0 0 0 0 note="a', 4, 20, "text_unclosed"),
        (HEADER + "J 0 0 0 0 400 0", 4, 1, "point_out_of_range"),
        (HEADER + "C 0 0 0 0 0 0", 4, 1, "values_count"),
        ("armui recording 1\n\n0 1 2 3 4 5\n", 3, 1, "values_count"),
        ("armui recording 1\n\n1 0 0 0 0 0 0\n0 0 0 0 0 0 0\n", 4, 0, "sample_back_in_time"),
        ("{", 1, 2, "json_bad"),
        ("[" * 100_000, 0, 0, "json_bad"),
        ('{"format": "armui trajectory"}', 1, 1, "json_field_missing"),
        (JSON % '"joints_deg": [0, 0, 0]', 6, 38, "json_field_bad"),
        (JSON % '"joints_deg": [0, 0, 0, 0, 0, 400]', 6, 5, "point_out_of_range"),
        (JSON % '"joint": 1', 6, 5, "json_field_missing"),
        (JSON % '"joints_deg": [0, 0, 0, 0, 0, 0], "sped": 1', 6, 66, "json_field_unknown"),
        (CSV + "MOVE J,0,0,x,0,0,0,30\n", 3, 4, "number_bad"),
        (CSV + "MOVE J,0,0,0,0,0,0\n", 3, 0, "cells_count"),
        (CSV + "MOVE X,0,0,0,0,0,0,30\n", 3, 1, "point_move_unknown"),
        (CSV + "MOVE P,0,0,0,0,0,0,30\n", 3, 0, "column_missing"),
        (CSV + "MOVE J,0,0,0,0,0,0,0\n", 3, 0, "point_out_of_range"),
        ("move,colour\n", 1, 2, "column_unknown"),
        ("move,note,note\n", 1, 3, "column_twice"),
        ("0.1,0,0,0,0,0,0\n0.1,0,0,0,0,0,x\n", 2, 7, "number_bad"),
        ("0.1,0,0,0,0,0,0\n0.1,0,0,0,0,0,9\n", 2, 0, "point_out_of_range"),
    ],
)
def test_a_broken_file_says_where_and_why(tmp_path, text, line, column, code):
    path = tmp_path / "broken.log"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(TrajectoryFileError) as caught:
        files.load(path)
    error = caught.value
    assert (error.line, error.column, error.refusal.code) == (line, column, code)
    assert error.file == "broken.log"
    assert str(error).startswith("broken.log")
    assert "?" not in str(error)


def test_what_cannot_be_read_at_all_says_why(tmp_path):
    with pytest.raises(TrajectoryFileError, match=r"nowhere\.log: The file cannot be read: No "):
        files.load(tmp_path / "nowhere.log")


def test_what_cannot_be_kept_is_not_written():
    point = Waypoint(MoveMode.MOVE_J, (0, 0, math.nan, 0, 0, 0))
    for suffix in TEXT_FORMATS:
        with pytest.raises(ValueError, match=r"row 1, point_not_a_number\(.*J3"):
            files.to_bytes(Trajectory("t", points=(point,)), suffix)
    with pytest.raises(ValueError, match=r"no format '\.xyz'"):
        files.to_bytes(Trajectory("t"), ".xyz")


# Foreign and damaged ------------------------------------------------------------------------------


def test_the_makers_recording_is_read_in_our_units():
    text = "0.5,0,1.5708,-0.7854,0,0,0.1,0.035\n0.02,0.01,1.58,-0.79,0,0,0.1,0.04\n"
    read = files.read_text(text, "maker")
    assert isinstance(read, Recording)
    assert read.name == "maker"
    assert read.times_s == pytest.approx([0.0, 0.02])
    assert read.joints_deg[0] == pytest.approx((0.0, 90.0002, -45.0001, 0.0, 0.0, 5.7296), abs=1e-3)
    assert read.gripper_mm == pytest.approx([35.0, 40.0])
    bare = files.read_text("0.02,0,0,0,0,0,0\n", "maker")
    assert np.isnan(bare.gripper_mm).all()


def survives(data: bytes) -> None:
    """Anything but a `TrajectoryFileError` fails the test."""
    error = None
    try:
        files.read_bytes(data, "x")
    except TrajectoryFileError as caught:
        error = caught
    if error is not None:
        assert error.refusal.reason.source
        assert error.refusal.code not in str(error)


@settings(max_examples=examples(100))
@given(st.binary(max_size=200))
def test_random_bytes_raise_nothing_else(data):
    survives(data)


BEGINNINGS = (b"armui trajectory 1\n\nJ ", b"armui recording 1\n\n", b'{"format":', b"move,",
              b"PK\x03\x04", b"0.1,0,0,0,0,0,0\n", b"\xff\xfe")  # fmt: skip


@settings(max_examples=examples(100))
@given(st.sampled_from(BEGINNINGS), st.binary(max_size=100))
def test_random_ends_raise_nothing_else(beginning, data):
    survives(beginning + data)


@pytest.mark.parametrize("suffix", [*TEXT_FORMATS, ".npz"])
@settings(suppress_health_check=[HealthCheck.too_slow])
@given(data=st.data())
def test_truncated_and_half_edited_files_raise_nothing_else(suffix, data):
    content = data.draw(RECORDINGS if suffix == ".npz" else TRAJECTORIES | RECORDINGS)
    whole = files.to_bytes(content, suffix)
    begin = data.draw(st.integers(0, len(whole)))
    end = data.draw(st.integers(begin, len(whole)))
    survives(whole[:begin])
    survives(whole[:begin] + whole[end:])
    survives(whole[:begin] + data.draw(st.binary(max_size=8)) + whole[end:])


def test_a_name_missing_in_the_file_is_the_files_own():
    assert files.read_text("armui trajectory 1\n", "my run").name == "my run"


def test_a_spreadsheet_that_parts_by_semicolons_is_read():
    text = files.to_bytes(
        Trajectory("t", points=(replace(Waypoint(MoveMode.MOVE_P, POSE), note="a"),)), ".csv"
    ).decode("utf-8-sig")
    read = files.read_text(text.replace(",", ";"), "x")
    assert read.points[0].target == POSE


def test_good_files_are_read_and_bad_ones_named(tmp_path: Path) -> None:
    (tmp_path / "1.csv").write_bytes(files.to_bytes(trajectory(), ".csv"))
    (tmp_path / "2.log").write_text("armui trajectory 1\n\nJ 0 0 o 0 0 0\n")
    (tmp_path / "3.json").write_bytes(files.to_bytes(recording(), ".json"))

    assert files.load(tmp_path / "1.csv") == trajectory()
    assert files.load(tmp_path / "3.json") == recording()
    with pytest.raises(TrajectoryFileError) as bad:
        files.load(tmp_path / "2.log")
    with pytest.raises(TrajectoryFileError, match=r"4\.log: The file cannot be read"):
        files.load(tmp_path / "4.log")

    assert bad.value.file == "2.log"
    assert (bad.value.line, bad.value.column) == (3, 7)
