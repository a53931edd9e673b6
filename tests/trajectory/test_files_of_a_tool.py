"""Files of points with the poses of a tool: written so, said so, read back as the flange's."""

import json
import math

import pytest

from armui.cell.cell import Cell, with_part
from armui.cell.tools import Tool
from armui.cell.user_frames import UserFrame
from armui.protocol.codes import MoveMode
from armui.trajectory import files
from armui.trajectory.files import TrajectoryFileError
from armui.trajectory.library.importing import import_files
from armui.trajectory.library.store import Library
from armui.trajectory.points.clipboard import pasted
from armui.trajectory.points.program import PosesOf, Trajectory, Waypoint
from tests.trajectory.frame_oracle import apart, carried

PEN = Tool("pen", (10.0, -5.0, 100.0, 15.0, -25.0, 40.0))
TABLE = UserFrame("Table", (250.0, -80.0, 40.0, 10.0, -20.0, 35.0))
OTHER = UserFrame("Shelf", (0.0, 0.0, 500.0, 0.0, 0.0, 0.0))
POSE = (300.0, 0.0, 250.0, 0.0, 85.0, 0.0)
OF = PosesOf(PEN, (TABLE, OTHER))
CONTENT = Trajectory(
    "t",
    points=(
        Waypoint(MoveMode.MOVE_J, (10.0, 70.0, -60.0, 10.0, 25.0, -20.0)),
        Waypoint(MoveMode.MOVE_P, POSE),
        Waypoint(MoveMode.MOVE_C, POSE, (300.0, 20.0, 250.0, 5.0, 80.0, 7.0), frame="Table"),
    ),
)
SUFFIXES = (".log", ".csv", ".json")


def text_of(suffix, content=CONTENT, of=OF):
    return files.to_bytes(content, suffix, of).decode("utf-8-sig")


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_what_is_written_is_read_back_within_rounding(suffix, tmp_path):
    path = tmp_path / f"x{suffix}"
    path.write_bytes(files.to_bytes(CONTENT, suffix, OF))
    read, of = files.load_with_origin(path)
    assert of == PosesOf(PEN, (TABLE,))  # no point names the other one
    assert files.load(path) == read
    assert read.poses_of == PosesOf()
    for point, was in zip(read.points, CONTENT.points, strict=True):
        assert (point.move, point.frame) == (was.move, was.frame)
        assert (point.target, point.middle) == (was.target, was.middle)
    # written once more it says the same: nothing creeps
    assert text_of(suffix, read) == text_of(suffix, files.read_text(text_of(suffix, read), "x"))


def test_the_table_says_what_its_poses_are_of():
    lines = text_of(".csv").splitlines()
    assert lines[0] == "armui trajectory 3"
    titles = lines[1].split(",")
    assert titles[7:13] == [
        f"tcp_{each}" for each in ("x_mm", "y_mm", "z_mm", "rx_deg", "ry_deg", "rz_deg")
    ]
    assert titles[13] == "middle_tcp_x_mm"
    told = [float(cell) for cell in lines[3].split(",")[7:13]]
    assert told == pytest.approx(carried(POSE, PEN.pose), abs=2e-6)
    assert "#tool,pen,10,-5,100,15,-25,40" in lines
    assert "#frame,Table,250,-80,40,10,-20,35" in lines
    assert not any(line.startswith("#frame,Shelf") for line in lines)


def test_the_text_and_json_say_it_too():
    lines = text_of(".log").splitlines()
    assert lines[0] == "armui trajectory 3"
    assert 'tool: "pen" 10 -5 100 15 -25 40' in lines
    assert 'frame: "Table" 250 -80 40 10 -20 35' in lines
    whole = json.loads(text_of(".json"))
    assert (whole["version"], whole["tool"]["name"], whole["tool"]["z_mm"]) == (3, "pen", 100.0)
    assert whole["points"][1]["pose"] == pytest.approx(carried(POSE, PEN.pose), abs=2e-6)


def test_a_rod_of_100_mm_by_hand():
    """The tip of a flange that points straight up is 100 mm above it."""
    up = Trajectory("t", points=(Waypoint(MoveMode.MOVE_P, (200.0, 50.0, 300.0, 0.0, 0.0, 0.0)),))
    rod = PosesOf(Tool("rod", (0.0, 0.0, 100.0, 0.0, 0.0, 0.0)))
    assert "P 200 50 400 0 0 0 speed=100" in text_of(".log", up, rod).splitlines()
    assert files.read_text(text_of(".log", up, rod), "x").points == up.points


def test_without_a_tool_or_poses_files_are_as_ever():
    joints = Trajectory("t", points=CONTENT.points[:1])
    plain = Trajectory("t", points=CONTENT.points[:2])
    for suffix in SUFFIXES:
        assert text_of(suffix, joints) == text_of(suffix, joints, PosesOf())
        assert text_of(suffix, plain, PosesOf(Tool("", (0.0,) * 6), (TABLE,))) == text_of(
            suffix, plain, PosesOf()
        )
    assert text_of(".armui") == text_of(".armui", of=PosesOf())
    assert "tool" not in text_of(".armui")


BROKEN = {
    "no row of the tool": lambda text: text.replace("#tool,pen", "#,"),
    "titles of the flange": lambda text: text.replace("tcp_", ""),
    "five figures": lambda text: text.replace("#tool,pen,10,", "#tool,pen,"),
    "no figure": lambda text: text.replace("#tool,pen,10,", "#tool,pen,x,"),
    "too long": lambda text: text.replace("#tool,pen,10,", "#tool,pen,1000,"),
}


@pytest.mark.parametrize("how", BROKEN)
def test_a_table_that_does_not_say_clearly_is_refused(how):
    text = text_of(".csv")
    broken = BROKEN[how](text)
    assert broken != text
    with pytest.raises(TrajectoryFileError):
        files.read_text(broken, "x")


@pytest.mark.parametrize(
    "line",
    [
        "tool: pen 1 2 3 4 5 6",
        'tool: "pen" 1 2 3',
        'tool: "pen" 1 2 3 4 5 x',
        'tool: "a" 1 2 3 4 5 6',
    ],
)
def test_a_header_that_is_broken_or_twice_is_refused(line):
    text = text_of(".log").replace("modified:", f"{line}\nmodified:")
    with pytest.raises(TrajectoryFileError):
        files.read_text(text, "x")
    alone = 'armui recording 1\nname: r\ntool: "pen" 1 2 3 4 5 6\n\n0 0 0 0 0 0 0\n'
    with pytest.raises(TrajectoryFileError):
        files.read_text(alone, "x")


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_pasted_as_a_whole_it_is_the_flanges(suffix):
    new = pasted(text_of(suffix))
    assert new.is_file
    assert apart(new.points[1].target, POSE) == pytest.approx((0.0, 0.0), abs=1e-5)


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_put_into_the_librarys_folder_it_is_the_flanges(suffix, tmp_path):
    (tmp_path / "t.log").write_text(text_of(suffix))
    library = Library(tmp_path)
    read = library.load("t")
    assert apart(read.points[1].target, POSE) == pytest.approx((0.0, 0.0), abs=1e-5)
    library.save(read, replacing="t")
    assert (tmp_path / "t.log").read_text().startswith("armui trajectory 2\n")


BENCH = with_part(with_part(Cell("bench"), PEN), TABLE)
LONG = Tool("pen", (10.0, -5.0, 130.0, 15.0, -25.0, 40.0))
MOVED = UserFrame("Table", (250.0, -80.0, 52.0, 10.0, -20.0, 35.0))
HERE = {
    "the same": (BENCH, []),
    "another in force": (with_part(BENCH, Tool("rod", (0, 0, 50.0, 0, 0, 0))), []),
    "no cell": (None, ["tool_not_here", "frame_not_here"]),
    "re-measured": (with_part(BENCH, LONG, instead_of="pen"), ["tool_otherwise"]),
    "frame moved": (with_part(BENCH, MOVED, instead_of="Table"), ["frame_elsewhere"]),
    "neither": (Cell("bench"), ["tool_not_here", "frame_not_here"]),
}


@pytest.mark.parametrize("here", HERE)
def test_what_is_otherwise_here_is_told(here, tmp_path):
    cell, expected = HERE[here]
    (tmp_path / "x.csv").write_bytes(files.to_bytes(CONTENT, ".csv", OF))
    (imported,) = import_files(tmp_path / "library", [tmp_path / "x.csv"])
    told = imported.differences((0.0,) * 6, cell)
    assert [each.code for each in told] == expected
    if here == "frame moved":
        assert (told[0].params["distance"], told[0].params["turned"]) == (12.0, 0.0)


def test_a_tool_of_the_settings_has_no_name(tmp_path):
    own = (0.0, 0.0, 80.0, 0.0, 0.0, 0.0)
    content = Trajectory("t", points=(Waypoint(MoveMode.MOVE_L, POSE),))
    (tmp_path / "x.json").write_bytes(files.to_bytes(content, ".json", PosesOf(Tool("", own))))
    (imported,) = import_files(tmp_path / "library", [tmp_path / "x.json"])
    assert [each.code for each in imported.differences(own, None)] == []
    assert [each.code for each in imported.differences((0.0,) * 6, None)] == ["tool_otherwise"]


def test_many_points_are_read_back_as_they_were():
    points = tuple(
        Waypoint(MoveMode.MOVE_L, (300.0 + 0.01 * place, math.sin(place), 250.0, 0.0, 85.0, 0.0))
        for place in range(2000)
    )
    content = Trajectory("t", points=points)
    read = files.read_text(text_of(".csv", content), "x")
    assert (
        max(
            abs(a - b)
            for one, other in zip(read.points, points, strict=True)
            for a, b in zip(one.target, other.target, strict=True)
        )
        < 1e-6
    )
