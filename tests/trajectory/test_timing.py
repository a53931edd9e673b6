"""Plans against the simulated arm: where it is, when, and how long it takes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest

from armui.control.run import replayer
from armui.kinematics.arm_kinematics import Kinematics
from armui.kinematics.tool_path import Line
from armui.protocol.codes import MotionState, MoveMode
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from armui.trajectory.planning.timing import APPROACH_PERCENT, plan_path
from armui.trajectory.points.program import Trajectory, Waypoint
from armui.trajectory.samples.recording import Recording
from tests.family import PIPER_BEFORE_V1_6_3
from tests.sim.talk import arc_point, mode, pose_target, ready, target, tell
from tests.trajectory.arms import ARM, HERE, KINEMATICS, arc, joint, line, pose, pose_near, run

STEP_S = 0.005


def send(arm: Firmware, point: Waypoint) -> None:
    """A point to the simulated arm, as a run sends it."""
    speed = mode(point.speed_percent, move=point.move.value)
    if point.is_joint:
        tell(arm, speed, *target(*point.target))
    elif point.middle is None:
        tell(arm, speed, *pose_target(*point.target))
    else:
        here = KINEMATICS.forward(arm.joints_deg)
        poses = (here, point.middle, point.target)
        for number, each in enumerate(poses, start=1):
            tell(arm, *pose_target(*each), arc_point(number))
        tell(arm, speed)


def driven(start_deg: Sequence[float], points: Sequence[Waypoint]) -> list[list[tuple[float, ...]]]:
    """The joints at every step of the simulated arm, point by point."""
    arm = ready(Generation.TWO, start_deg)
    tracks = []
    for point in points:
        send(arm, point)
        track = [arm.joints_deg]
        while arm.condition.motion_state is MotionState.NOT_REACHED:
            arm.step(STEP_S)
            track.append(arm.joints_deg)
            assert len(track) * STEP_S < 120.0
        tracks.append(track)
    return tracks


FAR = (-40.0, 100.0, -90.0, -30.0, 40.0, 30.0)
ACROSS = pose_near(HERE, (60, -150, 40), 8.0)
PROGRAM = run(
    joint(*FAR, speed=80),
    joint(*HERE),
    line(ACROSS),
    line(pose_near(HERE), speed=20),
    arc(pose_near(HERE, (50, -40, 60), 4.0), ACROSS, speed=60),
    pose(pose_near(HERE, (0, 60, -30), -10.0), speed=50),
    line(pose_near(HERE, (0, 61, -30), -10.0)),
    line(pose_near(HERE, (0, 61, -30), 12.0)),
    joint(10.0, 70.0, -60.0, 0.0, 20.0, 0.0),
    pose(pose_near((10.0, 70.0, -60.0, 0.0, -20.0, 0.0))),
)


def test_the_arm_takes_as_long_as_planned_and_is_where_planned() -> None:
    path = plan_path(PROGRAM, ARM, (0.0,) * 6)

    tracks = driven((0.0,) * 6, PROGRAM.points)

    assert path.problems == ()
    begin_s = 0.0
    for track, expected_s in zip(tracks, path.expected_s, strict=True):
        took_s = (len(track) - 1) * STEP_S
        assert expected_s == pytest.approx(took_s, rel=0.05, abs=2 * STEP_S)
        for share in np.linspace(0.0, 1.0, 9):
            there = track[round(share * (len(track) - 1))]
            assert path.at(begin_s + share * expected_s) == pytest.approx(there, abs=0.8)
        begin_s += expected_s
    assert path.duration_s == pytest.approx(begin_s)


def test_many_lines_take_as_long_as_planned() -> None:
    draw = np.random.default_rng(4)
    points = []
    for _ in range(25):
        here = draw.uniform((-60, 40, -100, -30, 15, -30), (60, 90, -50, 30, 45, 30)).tolist()
        points += [joint(*here), line(pose_near(here, draw.uniform(-40, 40, 3).tolist()), speed=40)]

    path = plan_path(run(*points), ARM, HERE)
    tracks = driven(HERE, points)

    left_out = {finding.row for finding in path.problems}
    assert len(left_out) < 5
    ratios = []
    for row, (track, expected_s) in enumerate(zip(tracks, path.expected_s, strict=True)):
        if row not in left_out and not {row - 1} & left_out and len(track) > 1:
            assert path.joints_deg[path.rows == row][-1] == pytest.approx(track[-1], abs=0.01)
            ratios.append(expected_s / ((len(track) - 1) * STEP_S))
    assert len(ratios) > 40
    assert min(ratios) > 0.95
    assert max(ratios) < 1.05


def test_a_line_is_straight_between_its_ends() -> None:
    path = plan_path(run(line(ACROSS)), replace(ARM, tool_mm=0.0), HERE)

    start = np.array(KINEMATICS.forward(HERE)[:3])
    way = (np.array(ACROSS[:3]) - start) / math.dist(ACROSS[:3], start)
    gone = path.places_mm - start
    assert np.abs(gone - np.outer(gone @ way, way)).max() < 1e-3
    assert path.places_mm[-1] == pytest.approx(ACROSS[:3], abs=1e-6)


def test_a_wrist_that_passes_through_0_bends_on() -> None:
    begin = (0.0, 80.0, -80.0, 0.0, 30.0, 0.0)
    end = KINEMATICS.forward((0.0, 80.0, -80.0, 0.0, -30.0, 0.0))

    path = plan_path(run(joint(*begin), line(end)), ARM, begin)

    assert path.problems == ()
    assert path.joints_deg[-1] == pytest.approx((0, 80, -80, 0, -30, 0), abs=1e-3)


def test_the_tip_is_as_far_beyond_the_flange_as_the_gripper_reaches() -> None:
    path = plan_path(run(joint(*HERE)), ARM, HERE)

    matrix = KINEMATICS.matrix(HERE)
    assert path.places_mm[-1] == pytest.approx(matrix[:3, 3] + 140.0 * matrix[:3, 2])


def test_time_never_goes_back_and_rows_come_in_order() -> None:
    path = plan_path(PROGRAM, ARM, HERE)

    assert (np.diff(path.times_s) >= 0.0).all()
    assert (np.diff(path.rows) >= 0).all()
    assert set(path.rows.tolist()) == set(range(len(PROGRAM.points)))
    assert path.joints_deg[0] == pytest.approx(HERE)


def test_the_arm_stays_for_the_dwell() -> None:
    path = plan_path(run(joint(*FAR, dwell_s=2.5), joint(*HERE)), ARM, HERE)

    moved_s = path.expected_s[0] - 2.5
    assert path.at(moved_s + 0.001) == pytest.approx(FAR)
    assert path.at(moved_s + 2.49) == pytest.approx(FAR)
    assert path.expected_s[1] == pytest.approx(moved_s)
    assert path.duration_s == pytest.approx(2 * moved_s + 2.5)


def test_speed_colours_a_line_by_what_it_was_given() -> None:
    path = plan_path(run(joint(*HERE), line(ACROSS, speed=20)), ARM, HERE)

    on_line = path.speeds_mm_s[path.rows == 1]
    length_mm = math.dist(ACROSS[:3], KINEMATICS.forward(HERE)[:3])
    assert on_line.max() <= 0.2 * 1000.0 * 1.2  # the tip swings further out than the flange
    assert on_line.max() > length_mm / path.expected_s[1] * 0.8


def test_a_speed_factor_counts_as_a_run_sends_it() -> None:
    slow = plan_path(run(joint(*FAR, speed=40)), ARM, HERE, speed_factor=0.5)

    assert slow.duration_s == plan_path(run(joint(*FAR, speed=20)), ARM, HERE).duration_s


def test_a_point_out_of_reach_is_left_out_and_named() -> None:
    far_away = (900.0, 0.0, 300.0, 0.0, 90.0, 0.0)
    points = (joint(*HERE), pose(far_away), line(ACROSS), line(far_away))

    path = plan_path(run(*points), ARM, HERE)

    assert [(finding.code, finding.row) for finding in path.problems] == [
        ("out_of_reach", 1),
        ("out_of_reach", 3),
    ]
    assert path.problems[0].params["missing"] > 100.0  # type: ignore[operator]
    assert path.expected_s[1] == path.expected_s[3] == 0.0
    assert set(path.rows.tolist()) == {0, 2}
    alone = plan_path(run(line(ACROSS)), ARM, HERE)
    assert path.joints_deg[-1] == pytest.approx(alone.joints_deg[-1], abs=1e-6)


def test_a_line_through_the_shoulder_is_left_out() -> None:
    # the wrist's centre, 91 mm below a hand that points up, would pass through joint 2; the
    # elbow folds ever faster towards 33 mm from it, the difference of the arm's two bars
    ahead, behind = ((x_mm, 0.0, 214.0, 0.0, 0.0, 0.0) for x_mm in (150.0, -150.0))

    path = plan_path(run(pose(ahead), line(behind)), ARM, HERE)

    (finding,) = path.problems
    assert (finding.code, finding.row) == ("path_singular", 1)
    assert finding.params["gone"] == pytest.approx(100 * (150 - 33.3) / 300, abs=4)


def test_three_points_on_a_line_are_no_arc() -> None:
    middle, end = pose_near(HERE, (10, 0, 0)), pose_near(HERE, (20, 0, 0))

    path = plan_path(run(joint(*HERE), arc(middle, end)), ARM, HERE)

    assert [(finding.code, finding.row) for finding in path.problems] == [("arc_no_circle", 1)]


def test_a_line_through_a_singular_pose_is_left_out() -> None:
    # past the axis of joint 1 with the hand hanging: joint 1 would have to leap
    down = (150.0, 2.0, 250.0, 180.0, 0.0, 0.0)
    over = (-150.0, 2.0, 250.0, 180.0, 0.0, 0.0)

    path = plan_path(run(pose(down), line(over)), ARM, HERE)

    assert [(finding.code, finding.row) for finding in path.problems] == [("path_singular", 1)]


def test_many_lines_after_one_another_that_cannot_be_reached_come_to_an_end() -> None:
    draw = np.random.default_rng(9)
    places = draw.uniform(-700, 700, (60, 3))
    points = [line((*place, 10.0, 80.0, 0.0)) for place in places]

    path = plan_path(run(joint(*HERE), *points), ARM, HERE)

    assert path.expected_s[0] == 0.0
    planned = set(path.rows.tolist())
    assert planned | {finding.row for finding in path.problems} == set(range(61))
    assert np.abs(np.diff(path.joints_deg, axis=0)).max() < 10.0


def test_the_nearest_way_within_the_limits_is_taken() -> None:
    narrow = list(ARM.limits)
    narrow[3] = narrow[3]._replace(min_deg=-5.0)
    near, flipped = (10.0, 70.0, -60.0, -90.0, 25.0, 100.0), (10.0, 70.0, -60.0, 90.0, -25.0, -80.0)
    points = run(pose(KINEMATICS.forward(near)))

    free = plan_path(points, ARM, near)
    limited = plan_path(points, replace(ARM, limits=tuple(narrow)), near)

    assert free.joints_deg[-1] == pytest.approx(near, abs=1e-3)
    assert limited.joints_deg[-1] == pytest.approx(flipped, abs=1e-3)


def test_nothing_to_run_is_a_path_of_no_time() -> None:
    path = plan_path(Trajectory("empty"), ARM, HERE)

    assert (path.duration_s, path.expected_s, len(path.times_s)) == (0.0, (), 0)


def samples(*rows: Sequence[float]) -> Recording:
    return Recording("r", samples=np.array([[*row, math.nan] for row in rows], dtype=float))


def test_a_recording_is_approached_slowly_and_then_kept_to_its_time() -> None:
    near = tuple(angle + 5.0 for angle in HERE)
    recording = samples((3.0, *HERE), (4.0, *near), (5.0, *HERE))

    path = plan_path(recording, ARM, FAR, speed_factor=0.5)

    approach_s = plan_path(run(joint(*HERE, speed=APPROACH_PERCENT)), ARM, FAR).duration_s
    assert path.duration_s == pytest.approx(approach_s + 4.0)
    assert path.at(0.0) == pytest.approx(FAR)
    assert path.at(approach_s + 1.0) == pytest.approx([angle + 2.5 for angle in HERE])
    assert path.expected_s == ()


def test_a_replay_approaches_as_slowly_as_planned() -> None:
    assert replayer._APPROACH_PERCENT == APPROACH_PERCENT


def test_before_and_after_a_path_the_arm_is_at_its_ends() -> None:
    path = plan_path(run(joint(*FAR)), ARM, HERE)

    assert path.at(-1.0) == pytest.approx(HERE)
    assert path.at(path.duration_s + 1.0) == pytest.approx(FAR)


def test_no_samples_are_a_path_of_no_time() -> None:
    assert plan_path(Recording("r"), ARM, HERE).duration_s == 0.0


@pytest.mark.parametrize("move", [MoveMode.MOVE_J, MoveMode.MOVE_L])
def test_an_older_arm_is_planned_with_its_own_geometry(move: MoveMode) -> None:
    older = replace(ARM, kinematics=Kinematics(PIPER_BEFORE_V1_6_3), tool_mm=0.0)
    aim = HERE if move is MoveMode.MOVE_J else ACROSS
    path = plan_path(run(Waypoint(move, tuple(aim))), older, HERE)

    expected = older.kinematics.forward(path.joints_deg[-1])[:3]
    assert path.places_mm[-1] == pytest.approx(expected, abs=1e-6)
    assert Line(KINEMATICS.matrix(HERE), older.kinematics.matrix(HERE)).length_mm > 5.0
