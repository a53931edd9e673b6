"""How long it takes to plan and to check 10,000 points, against ruckig and the check of one pose.

Run with `python -m pytest tests/benchmarks/test_plan_speed.py`; nothing fails for being slow.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from ruckig import InputParameter, Ruckig
from ruckig import Trajectory as JointPlan

from armui.arm.reach import check_pose, led_joints
from armui.kinematics.poses import Pose, pose_to_matrix
from armui.kinematics.tool_path import Line
from armui.trajectory.planning.check import CheckRequest, check
from armui.trajectory.planning.timing import plan_path
from armui.trajectory.points.program import Trajectory, Waypoint
from armui.trajectory.samples.recording import Recording
from tests.trajectory.arms import ARM, KINEMATICS, joint, line, pose_near, run

POINTS = 10_000
AIM_S = 1.0
ROUNDS = 3
START = (0.0,) * 6
SAMPLES = 180_000


@pytest.fixture(scope="module")
def joints_only() -> Trajectory:
    draw = np.random.default_rng(3)
    rows = draw.uniform((-60, 40, -100, -30, 15, -30), (60, 90, -50, 30, 50, 30), (POINTS, 6))
    return run(*(joint(*row, speed=50) for row in rows.tolist()))


def mixed_program() -> Trajectory:
    """MOVE J and MOVE L by turns, the lines some 40 mm long."""
    draw = np.random.default_rng(4)
    points: list[Waypoint] = []
    for _ in range(POINTS // 2):
        here = draw.uniform((-60, 40, -100, -30, 15, -30), (60, 90, -50, 30, 50, 30)).tolist()
        points.append(joint(*here, speed=50))
        points.append(line(pose_near(here, draw.uniform(-30, 30, 3).tolist()), speed=50))
    return replace(run(*points), name="mixed")


@pytest.fixture(scope="module")
def mixed() -> Trajectory:
    return mixed_program()


def best_s(work: Callable[[], object]) -> float:
    times = []
    for _ in range(ROUNDS):
        begin = time.perf_counter()
        work()
        times.append(time.perf_counter() - begin)
    return min(times)


def by_ruckig(points: tuple[Waypoint, ...]) -> float:
    """The running time of the same motions, planned one by one."""
    planner, plan = Ruckig(6), JointPlan(6)
    total_s = 0.0
    before: tuple[float, ...] = START
    for point in points:
        request = InputParameter(6)
        request.current_position, request.target_position = list(before), list(point.target)
        request.max_velocity = [each.max_speed_deg_s / 2 for each in ARM.limits]
        request.max_acceleration = list(ARM.accelerations_deg_s2)
        planner.calculate(request, plan)
        total_s, before = total_s + plan.duration, point.target
    return total_s


def one_by_one(points: tuple[Waypoint, ...]) -> None:
    """Each point and each line by the checks a single motion gets."""
    here: tuple[float, ...] = START
    for point in points:
        if point.is_joint:
            here = point.target
            continue
        way = Line(KINEMATICS.matrix(here), pose_to_matrix(Pose(*point.target)))
        led_joints(KINEMATICS, way, here)
        check_pose(KINEMATICS, Pose(*point.target), here, ARM.limits)


def test_planning_move_j_against_ruckig(joints_only, capsys):
    ours_s = best_s(lambda: plan_path(joints_only, ARM, START))
    theirs_s = best_s(lambda: by_ruckig(joints_only.points))
    path = plan_path(joints_only, ARM, START)

    assert path.duration_s == pytest.approx(by_ruckig(joints_only.points), rel=1e-6)
    with capsys.disabled():
        print(
            f"\nplanning {POINTS} MOVE J: {ours_s:.2f} s with {len(path.times_s)} samples; "
            f"ruckig, without samples: {theirs_s:.2f} s"
        )


def test_checking_a_mixed_trajectory(mixed, capsys):
    plan_s = best_s(lambda: plan_path(mixed, ARM, START))
    check_s = best_s(lambda: check(CheckRequest(mixed, ARM, START)))
    share = POINTS // 50
    single_s = best_s(lambda: one_by_one(mixed.points[:share])) * POINTS / share

    report = check(CheckRequest(mixed, ARM, START))
    assert len(report.path.expected_s) == POINTS
    with capsys.disabled():
        print(
            f"\nchecking {POINTS} points, half of them lines, {len(report.path.times_s)} samples: "
            f"{check_s:.2f} s (aim: {AIM_S:.0f} s), of it planning {plan_s:.2f} s; "
            f"one by one, reach and limits only: {single_s:.0f} s"
        )


def test_checking_a_recording_of_half_an_hour(capsys):
    times_s = np.arange(SAMPLES) / 100.0
    angles = np.array((0.0, 70.0, -60.0, 0.0, 25.0, 0.0)) + 20.0 * np.sin(times_s / 3)[:, None]
    samples = np.hstack((times_s[:, None], angles, np.full((SAMPLES, 1), math.nan)))
    recording = Recording("half an hour", samples=samples)

    check_s = best_s(lambda: check(CheckRequest(recording, ARM, START)))

    assert check(CheckRequest(recording, ARM, START)).path.duration_s > 1799.0
    with capsys.disabled():
        print(f"\nchecking {SAMPLES} samples: {check_s:.2f} s")
