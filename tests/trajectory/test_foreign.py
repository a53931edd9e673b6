"""Files of other programs that are no tables: read where plain, else refused with a way out."""

from __future__ import annotations

import json
import math
import subprocess
import sys

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st

from armui.protocol.codes import MoveMode
from armui.trajectory import columns
from armui.trajectory.columns import plain_yaml
from armui.trajectory.columns.foreign import FILE_COMMANDS, FILE_FOREIGN, as_table
from armui.trajectory.files import TrajectoryFileError
from armui.trajectory.library.importing import find_or_import, import_files
from armui.trajectory.library.store import Library
from armui.trajectory.points.program import GripperOpening, Trajectory
from armui.trajectory.samples.recording import Recording
from tests.examples import examples
from tests.trajectory.strategies import outcome

A, B = (0.1, 0.6, -0.7, 0.2, 0.3, -0.1), (0.2, 0.7, -0.8, 0.2, 0.3, -0.1)
A_DEG, B_DEG = (pytest.approx([math.degrees(each) for each in one], abs=1e-3) for one in (A, B))
NAMES = [f"joint{number}" for number in range(1, 7)]


def block(values, indent=""):
    return "".join(f"{indent}- {value}\n" for value in values)


def joint_state(place, nanoseconds, *, flow=False):
    """As ``ros2 topic echo`` prints it, or ``rostopic echo``."""
    names, position = [*NAMES, "gripper"], [*place, 0.05]
    if flow:
        return (
            f"header: \n  seq: 7\n  stamp: \n    secs: 1650000000\n    nsecs: {nanoseconds}\n"
            f"  frame_id: ''\nname: [{', '.join(names)}]\nposition: {position}\nvelocity: []\n---\n"
        )
    return (
        f"---\nheader:\n  stamp:\n    sec: 1650000000\n    nanosec: {nanoseconds}\n"
        f"  frame_id: ''\nname:\n{block(names)}position:\n{block(position)}velocity:\n- 0.0\n"
        f"effort:\n- 0.0\n"
    )


def echoed(place, nanoseconds):
    """A row of ``ros2 topic echo --csv``."""
    return ",".join(
        map(str, (1650000000, nanoseconds, "base", *NAMES, "gripper", *place, 0.05, *[0.0] * 14))
    )


RECORDINGS = {
    "ros2 topic echo": joint_state(A, 5_000_000) + joint_state(B, 25_000_000),
    "its last message cut off": joint_state(A, 5_000_000)
    + joint_state(B, 25_000_000)
    + "---\nheader:\n  stamp:\n    sec: 1650000000\n    nanosec: 45000000\n",
    "rostopic echo": joint_state(A, 5_000_000, flow=True) + joint_state(B, 25_000_000, flow=True),
    "ros2 topic echo --csv": f"{echoed(A, 5_000_000)}\n{echoed(B, 25_000_000)}\n",
    "a line each": "\n".join(
        json.dumps({"timestamp": at, "q": place, "gripper": 0.05})
        for at, place in ((3, A), (3.02, B))
    ),
    "a list for each name": json.dumps(
        {"time": [3, 3.02], **{n: [a, b] for n, a, b in zip(NAMES, A, B, strict=True)},
         "gripper": [0.05, 0.05]}
    ),
    "in brackets": "; 50 Hz; mm, degrees\n"
    + "".join(
        f"t{1701453045123 + 20 * k}\tx1.5 J6[{','.join(str(math.degrees(a)) for a in place)}] "
        f"Grp[50.0,1.5,1]\n"
        for k, place in enumerate((A, B))
    ),
}  # fmt: skip


def written(folder, text, name="file.txt"):
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return path


@pytest.mark.parametrize("name", RECORDINGS)
def test_recordings_of_other_programs_are_read_without_a_question(tmp_path, name):
    read = columns.told_by_names(written(tmp_path, RECORDINGS[name]), "mine")
    assert isinstance(read, Recording)
    assert read.name == "mine"
    assert read.times_s == pytest.approx([0.0, 0.02])
    assert [list(each) for each in read.joints_deg] == [A_DEG, B_DEG]
    assert read.gripper_mm == pytest.approx([50.0, 50.0])


def test_the_points_of_a_planned_trajectory_come_at_their_times(tmp_path):
    points = "".join(
        f"    - positions: {list(place)}\n      velocities: []\n"
        f"      time_from_start:\n        sec: {k}\n        nanosec: 500000000\n"
        for k, place in enumerate((A, B))
    )
    text = f"joint_trajectory:\n  joint_names: [{', '.join(NAMES)}]\n  points:\n{points}"
    read = columns.told_by_names(written(tmp_path, text), "plan")
    assert isinstance(read, Recording)
    assert read.times_s == pytest.approx([0.0, 1.0])
    assert list(read.joints_deg[1]) == B_DEG


WAY_POINTS = (
    "# taught by hand\nversion: 1\njoint_names:\n"
    + block([*NAMES, "finger_joint1"]) + "waypoints:\n"
    + "".join(
        f"- name: 'wp {k}'\n  positions:\n{block([*place, 0.02], '  ')}"
        f"  gripper_width: 0.04\n  hold_time: 1.5\n" for k, place in enumerate((A, B))
    )
)  # fmt: skip
UNITS = "angle_unit: deg\nposes:\n" + "".join(
    f"  - {{label: wp {k}, joints: {[round(math.degrees(a), 4) for a in place]}, gripper_mm: 40,"
    f"\n     hold_time: 1.5}}\n"
    for k, place in enumerate((A, B))
)
COMMANDS = json.dumps(
    {
        "steps": [
            step
            for k, place in enumerate((A, B))
            for step in (
                {"name": f"wp {k}", **dict(zip(NAMES, place, strict=True)), "gripper_m": 0.04},
                {"type": "Wait", "duration_ms": 1500},
            )
        ]
    }
)


@pytest.mark.parametrize("text", [WAY_POINTS, UNITS, COMMANDS])
def test_way_points_become_points(tmp_path, text):
    read = columns.told_by_names(written(tmp_path, text), "mine")
    assert isinstance(read, Trajectory)
    assert [list(point.target) for point in read.points] == [A_DEG, B_DEG]
    assert {point.move for point in read.points} == {MoveMode.MOVE_J}
    assert [point.note for point in read.points] == ["wp 0", "wp 1"]
    assert {(point.dwell_s, point.speed_percent) for point in read.points} == {(1.5, 100)}
    opening = read.points[0].gripper
    assert isinstance(opening, GripperOpening)
    assert opening.opening_mm == pytest.approx(40.0)


@pytest.mark.parametrize(
    ("text", "reason", "words"),
    [
        ("a: 1\nb: 2\nc:\n  - 3\n  - 4\n", FILE_FOREIGN, "CSV"),
        ("- 0.1\n- 0.2\n- -0.3\n- 0.4\n", FILE_FOREIGN, "joint1_rad"),
        ("base: &b {x: 1}\nother: *b\nx: 1\n", FILE_FOREIGN, "joint1_deg"),
        ('{"arm": "piper", "speed": 3}', FILE_FOREIGN, "CSV"),
        (
            json.dumps([{"type": "Home"}, {"type": "Move", "joints": A}, {"cmd": "open"}]),
            FILE_COMMANDS,
            "Home, open",
        ),
    ],
)
def test_what_is_not_plain_is_refused_with_a_way_and_not_offered_as_a_table(
    tmp_path, text, reason, words
):
    (done,) = import_files(tmp_path / "library", [written(tmp_path, text)])
    assert isinstance(done.error, TrajectoryFileError)
    assert done.error.refusal.reason == reason
    assert words in str(done.error)
    assert not done.is_table


def test_records_whose_unit_nobody_tells_are_offered_as_a_table(tmp_path):
    text = json.dumps([{"joints": A}, {"joints": B}])
    (done,) = import_files(tmp_path / "library", [written(tmp_path, text)])
    assert done.is_table
    sheet = columns.open_table(tmp_path / "file.txt").sheet
    assert [str(guess.column.quantity) for guess in sheet.guesses if guess.column] == [
        f"J{number}" for number in range(1, 7)
    ]


def test_what_tells_all_is_in_the_library_under_the_name_of_its_file(tmp_path):
    path = written(tmp_path, WAY_POINTS, "there and back.yaml")
    (done,) = import_files(tmp_path / "library", [path])
    assert (done.name, done.error, done.is_table) == ("there and back", None, False)
    assert len(Library(tmp_path / "library").load("there and back").points) == 2
    again = find_or_import(tmp_path / "library", path)
    assert (again.name, again.was_there) == ("there and back", True)


@pytest.mark.parametrize(
    ("text", "titles"),
    [
        (
            (
                f'i,state,t\n0,"[{" ".join(map(str, A))}\n 0.03]",1\n'
                f'1,"[{" ".join(map(str, B))} 0.03]",2\n'
            ),
            ["i", *(f"state_{k}" for k in range(7)), "t"],
        ),
        (
            "\n".join(
                ["ts;joint_positions", *(f"{k};array({list(A)}, dtype=float32)" for k in "12")]
            ),
            ["ts", *(f"joint_positions_{k}" for k in range(6))],
        ),
        (
            "header.stamp.sec,header.stamp.nanosec,"
            + ",".join(NAMES)
            + "\n"
            + "\n".join(f"5,{k}0000000," + ",".join(map(str, A)) for k in "12"),
            ["header.stamp [s]", *NAMES],
        ),
    ],
)
def test_cells_of_arrays_and_parted_times_become_plain_columns(tmp_path, text, titles):
    table = columns.open_table(written(tmp_path, text))
    assert list(table.sheet.header) == titles
    assert table.sheet.count == 2
    found = [guess.column and guess.column.quantity for guess in table.sheet.guesses]
    assert [str(each) for each in found if each in columns.model.JOINTS] == [
        f"J{number}" for number in range(1, 7)
    ]
    assert not table.is_record
    if "header" in text:
        assert table.sheet.preview[1][0] == "5.020000000"


def test_a_plain_table_stays_as_it_is():
    for text in ("t,j1\n1,2\n", "1 2 3\n", "a;b\n[x];2\n", "Robot: x\n1,2,3,4,5,6\n1,2,3,4,5,6\n"):
        assert as_table(text) is None


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("a: [1e-3, 1.5E3, -.5, +2, 010, 7.]\n", [{"a": [0.001, 1500.0, -0.5, 2, 10, 7.0]}]),
        ("a: [.inf, -.INF, inf]\n", [{"a": [math.inf, -math.inf, math.inf]}]),
        ("a: [true, False, on, off, yes, n]\n", [{"a": [True, False, "on", "off", "yes", "n"]}]),
        ("a: [12:30, 2024-01-02, =, <<, 0x1f]\n",
         [{"a": ["12:30", "2024-01-02", "=", "<<", "0x1f"]}]),
        ("a: ['1', \"2.5\", 'true', '']\nb: |\n  3\n",
         [{"a": ["1", "2.5", "true", ""], "b": "3\n"}]),
        ("---\na: ~\n...\n---\n1: null\non:\n---\n", [{"a": None}, {"1": None, "on": None}]),
        ("a: &x [1]\nb: *x\n", None),
        ("<<: &x {a: 1}\nb:\n  <<: *x\n", None),
        ("a: &a [&b [&c [1]]]\nb: &d [*a, *a, *a]\n", None),
        ("a: !!python/object/apply:os.getcwd []\n", None),
        ("a: !!timestamp 5\n", None),
        ("a: ! 5\n", None),
        ("a: 1\n   b: 2\n", None),
        ("a: [1, 2\n", None),
        ("a: 1\n\tb: 2\n", None),
    ],
)  # fmt: skip
@pytest.mark.parametrize("loader", [plain_yaml._LOADER, yaml.SafeLoader])
def test_figures_of_yaml_are_what_they_look_like_and_aliases_and_tags_are_refused(
    monkeypatch, loader, text, expected
):
    """PyYAML may have been built without its parser in C."""
    monkeypatch.setattr(plain_yaml, "_LOADER", loader)
    assert plain_yaml.read_yaml(text) == expected


@pytest.mark.parametrize("text", ["[" * 700 + "]" * 700, "- " * 700, "a: " + "[" * 99_999])
def test_what_is_nested_without_end_is_refused(tmp_path, text):
    (done,) = import_files(tmp_path / "library", [written(tmp_path, text)])
    assert done.error.refusal.reason == FILE_FOREIGN


def test_nothing_of_yaml_is_loaded_before_a_file_of_it_is_read():
    code = (
        "import sys, armui.trajectory.columns as columns; before = 'yaml' in sys.modules; "
        "columns.foreign.as_table('- 1'); print(before, 'yaml' in sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["False", "True"]


@settings(max_examples=examples(200))
@given(st.text("abt1.-:[]{},'\"# \n&*|", max_size=60))
def test_any_text_is_a_table_or_none_and_breaks_nothing(text):
    result = outcome(as_table, text)
    if isinstance(result, TrajectoryFileError):
        assert result.refusal.reason == FILE_COMMANDS
    else:
        assert result is None or result.text
