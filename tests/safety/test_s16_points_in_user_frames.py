"""S16: a point in a user frame is driven to where it was checked, or not at all."""

import json
import random
from dataclasses import replace

import pytest

from armui.cell.cell import Cell, with_part, without_part
from armui.cell.tools import Tool
from armui.cell.user_frames import UserFrame
from armui.control.cell.cell_reasons import CELL_NOT_CONFIRMED
from armui.control.motion.point_frames import POINT_NOT_IN_BASE
from armui.control.operating_state import RUN_UNDER_WAY
from armui.control.parameters.arm_model import arm_model, start_deg
from armui.control.run.preflight import CHANGED_SINCE_CHECK, CheckBasis, Preflight
from armui.control.run.progress import Run, RunPhase
from armui.control.run.runner import Runner
from armui.control.safety.other_command import OTHER_HOST
from armui.kinematics.arm_kinematics import Kinematics
from armui.protocol.codes import MoveMode
from armui.trajectory import files
from armui.trajectory.files import TrajectoryFileError
from armui.trajectory.library.run_options import RunOptions
from armui.trajectory.planning.check import CheckRequest, check
from armui.trajectory.points.clipboard import from_text, to_text
from armui.trajectory.points.program import Trajectory, Waypoint
from tests.accepted import accepted
from tests.control.jogger import bend
from tests.family import PIPER
from tests.safety.test_s15_the_cell_is_confirmed import MOTION, again
from tests.trajectory.frame_oracle import apart, carried, within

POSE = (300.0, 0.0, 250.0, 0.0, 85.0, 0.0)
TABLE = UserFrame("Table", (250.0, -80.0, 40.0, 10.0, -20.0, 35.0))
MOVED = UserFrame("Table", (270.0, -70.0, 55.0, 6.0, -16.0, 39.0))
BENCH = with_part(Cell("bench"), TABLE)
TAUGHT = Waypoint(MoveMode.MOVE_P, within(TABLE.pose, POSE), None, 100, frame="Table")
OPTIONS = RunOptions()


def checked(rig, *points):
    """What 检查 hands to a run."""
    arm = arm_model(rig.controller)
    order = CheckRequest(Trajectory("t", points=points), arm, start_deg(rig.controller))
    return Preflight(order, check(order), CheckBasis.of(rig.controller, OPTIONS, order.content))


def end_of(rig):
    """The pose at which the simulated arm stands."""
    return Kinematics(PIPER).forward(rig.firmware.joints_deg)


def run(rig, *points):
    """Check and run points, and wait for the end."""
    found = checked(rig, *points)
    assert found.errors == 0
    assert Runner(rig.controller).start(found, 30) is None
    rig.run_until(lambda: not rig.controller.player.running, 30.0)
    assert rig.controller.player.progress.phase is RunPhase.DONE


def test_the_frame_moved_and_turned_moves_the_end_of_the_run(rig):
    bend(rig)
    accepted(rig.controller.cell.take(BENCH))
    run(rig, TAUGHT)
    assert apart(end_of(rig), POSE)[0] < 0.01
    accepted(rig.controller.cell.change(with_part(BENCH, MOVED, instead_of="Table")))
    run(rig, TAUGHT)
    off_mm, off_deg = apart(end_of(rig), carried(MOVED.pose, TAUGHT.target))
    assert off_mm < 0.01
    assert off_deg < 0.01
    assert apart(end_of(rig), POSE)[0] > 10.0


def test_random_frames_and_points_end_where_the_oracle_says(rig):
    """Measured: 0.0008 mm at most; the arm is told 0.001 mm and 0.001°."""
    bend(rig)
    accepted(rig.controller.cell.take(BENCH))
    told = random.Random(5)
    for _ in range(8):
        frame = tuple(told.uniform(-200.0, 200.0) for _ in range(3))
        frame += tuple(told.uniform(-180.0, 180.0) for _ in range(3))
        goal = tuple(value + told.uniform(-12.0, 12.0) for value in POSE)
        there = replace(TAUGHT, target=within(frame, goal))
        cell = with_part(BENCH, UserFrame("Table", frame), instead_of="Table")
        accepted(rig.controller.cell.change(cell))
        run(rig, there)
        off_mm, off_deg = apart(end_of(rig), carried(frame, there.target))
        assert off_mm < 0.01
        assert off_deg < 0.01


OTHERS = {
    "moved": with_part(BENCH, MOVED, instead_of="Table"),
    "renamed": with_part(BENCH, UserFrame("Desk", TABLE.pose), instead_of="Table"),
    "deleted": without_part(BENCH, UserFrame, "Table"),
}


@pytest.mark.parametrize("other", OTHERS)
def test_a_check_made_with_another_frame_is_outdated(rig, other):
    bend(rig)
    accepted(rig.controller.cell.take(BENCH))
    found = checked(rig, TAUGHT)
    assert found.why_outdated(rig.controller, OPTIONS) is None
    accepted(rig.controller.cell.change(OTHERS[other]))
    assert found.why_outdated(rig.controller, OPTIONS).reason == CHANGED_SINCE_CHECK
    errors = [each.code for each in checked(rig, TAUGHT).outcome.errors]
    assert errors == ([] if other == "moved" else ["frame_unknown"])


def test_another_cell_between_check_and_run_outdates_the_check(rig):
    bend(rig)
    control = rig.controller.cell
    accepted(control.take(with_part(Cell("other"), MOVED)))
    accepted(control.take(BENCH))
    found = checked(rig, TAUGHT)
    accepted(control.choose("other"))
    assert found.why_outdated(rig.controller, OPTIONS).reason == CHANGED_SINCE_CHECK
    accepted(control.choose(""))
    assert found.why_outdated(rig.controller, OPTIONS).reason == CHANGED_SINCE_CHECK


def test_no_frame_is_changed_while_a_run_goes_on(rig):
    bend(rig)
    accepted(rig.controller.cell.take(BENCH))
    assert Runner(rig.controller).start(checked(rig, replace(TAUGHT, speed_percent=5)), 30) is None
    rig.run(0.4)
    answer = rig.controller.cell.change(OTHERS["moved"])
    assert answer.reason == RUN_UNDER_WAY
    assert rig.controller.cell.cell == BENCH


def test_nothing_runs_while_the_cell_is_not_confirmed(rig):
    bend(rig)
    rig.controller.cell.take_loaded({"bench": BENCH})
    again(rig, "bench")
    rig.heard()
    found = checked(rig, TAUGHT)
    assert found.errors == 0
    answer = Runner(rig.controller).start(found, 30)
    assert (answer.reason, answer.params) == (CELL_NOT_CONFIRMED, {"name": "bench"})
    rig.run(0.3)
    assert [each for each in rig.heard() if each.arbitration_id in MOTION] == []


def test_another_host_refuses_and_ends_a_run_as_ever(rig, other_host):
    bend(rig)
    accepted(rig.controller.cell.take(BENCH))
    slowly = replace(TAUGHT, speed_percent=5)
    assert Runner(rig.controller).start(checked(rig, slowly), 30) is None
    rig.run(0.4)
    other_host.move_to(rig.firmware.joints_deg, 5)
    rig.run_until(lambda: not rig.controller.player.running)
    assert rig.controller.player.progress.phase is RunPhase.FAILED
    found = checked(rig, slowly)
    assert found.errors == 0
    rig.heard()
    assert Runner(rig.controller).start(found, 30).reason == OTHER_HOST
    ours = [each for each in rig.heard() if each.arbitration_id in MOTION]
    assert ours == []


def test_a_point_whose_place_was_not_worked_out_is_never_sent(rig):
    bend(rig)
    accepted(rig.controller.cell.take(BENCH))
    rig.heard()
    answer = rig.controller.player.start(Run("t", (TAUGHT,), [1.0]))
    assert answer == POINT_NOT_IN_BASE(row=1, name="Table")
    rig.run(0.3)
    assert [each for each in rig.heard() if each.arbitration_id in MOTION] == []


# What an older program does with them: version 1 is the highest it reads, «move» and the six
# values the first cells it knows. -------------------------------------------------------------

HELD = Waypoint(MoveMode.MOVE_J, (0.0,) * 6, holds="")
OF_CELL = {"frame": TAUGHT, "held": HELD}


@pytest.mark.parametrize("point", OF_CELL)
def test_an_older_program_refuses_the_files(point):
    content = Trajectory("t", points=(OF_CELL[point],))
    texts = {each: files.to_bytes(content, each).decode("utf-8-sig") for each in files.SUFFIXES}
    for suffix in (".log", ".armui", ".csv"):
        assert texts[suffix].splitlines()[0] == "armui trajectory 2"
    assert json.loads(texts[".json"])["version"] == 2
    for text in texts.values():
        assert files.is_ours(text)  # an import by columns is not offered


def test_an_older_program_refuses_the_rows_of_the_clipboard():
    """It takes a first cell that is no motion for the first figure."""
    first = to_text((TAUGHT,)).split("\t")[0]
    assert first == "MOVE P@Table"
    row = to_text((replace(HELD, holds="Cube"),)).split("\t")
    assert "holds=Cube" in row  # where an older one reads 35mm@1Nm or nothing


PLAIN = Trajectory(
    "t",
    points=(
        Waypoint(MoveMode.MOVE_P, POSE, speed_percent=30),
        Waypoint(MoveMode.MOVE_J, (0.0,) * 6, speed_percent=30, note="n"),
    ),
)


def test_files_without_frames_are_written_as_ever():
    written = {each: files.to_bytes(PLAIN, each).decode() for each in files.SUFFIXES}
    head = "name: t\nmodified: 1970-01-01T00:00:00+00:00\n\n"
    log = (
        f'armui trajectory 1\n{head}P 300 0 250 0 85 0 speed=30\nJ 0 0 0 0 0 0 speed=30 note="n"\n'
    )
    assert (written[".log"], written[".armui"]) == (log, log)
    lines = written[".csv"].split("\r\n")
    assert lines[0].startswith("\ufeffmove,j1_deg,")
    assert lines[0].endswith(",light_lamp,note")
    assert lines[1] == "MOVE P,,,,,,,300,0,250,0,85,0,,,,,,,30,0,,,,,,,,,,"
    assert '  "version": 1,\n' in written[".json"]
    assert (
        '{"move": "MOVE P", "pose": [300.0, 0.0, 250.0, 0.0, 85.0, 0.0], "speed'
        in (written[".json"])
    )
    assert "frame" not in written[".json"]
    assert to_text(PLAIN.points[:1]) == "MOVE P\t300\t0\t250\t0\t85\t0\t\t30\t0\t\t\t"


def test_a_newer_table_is_refused():
    text = files.to_bytes(Trajectory("t", points=(TAUGHT,)), ".csv").decode("utf-8-sig")
    with pytest.raises(TrajectoryFileError) as caught:
        files.read_text(text.replace("armui trajectory 2", "armui trajectory 4"), "t")
    assert (caught.value.line, caught.value.refusal.code) == (1, "file_version")


def test_a_spreadsheet_may_fill_up_the_line_with_the_version():
    content = Trajectory("t", points=(TAUGHT, HELD))
    text = files.to_bytes(content, ".csv").decode("utf-8-sig")
    filled = text.replace("armui trajectory 2", '"armui trajectory 2"' + 32 * ",", 1)
    assert files.read_text(filled, "x") == content
    assert files.read_text(text.replace(",", ";"), "x") == content


def test_a_name_with_commas_does_not_make_a_table_of_a_text():
    content = replace(PLAIN, name="pick,move,place")
    assert files.read_bytes(files.to_bytes(content, ".log"), "x") == content


def test_what_is_copied_in_a_frame_is_pasted_in_it():
    points = (TAUGHT, replace(HELD, holds="Cube"), HELD)
    assert from_text(to_text(points)) == points


def test_a_tool_does_not_change_where_a_frame_carries_a_point(rig):
    """Points are places of the flange, as everywhere in a trajectory."""
    bend(rig)
    pen = Tool("pen", (0.0, 0.0, 100.0, 0.0, 0.0, 0.0), 10.0)
    accepted(rig.controller.cell.take(replace(BENCH, tools=(pen,), tool="pen")))
    run(rig, TAUGHT)
    assert apart(end_of(rig), POSE)[0] < 0.01
