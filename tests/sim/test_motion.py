"""The planner under the firmware: limits at every step, exact arrival, smooth replacement."""

from __future__ import annotations

import itertools
import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from armui.sim.mechanics.powered_joints import SLOWEST_DEG_S, JointMotion, MotionError
from tests.examples import examples
from tests.family import FACTORY_LIMITS
from tests.moments import now

STEP_S = 0.001
SPEED = math.degrees(3.0)
ACCELERATION = math.degrees(5.0)
SPEEDS = (SPEED,) * 6
ACCELERATIONS = (ACCELERATION,) * 6

angles = st.tuples(
    *(st.integers(round(1e3 * j.min_deg), round(1e3 * j.max_deg)) for j in FACTORY_LIMITS)
).map(lambda raw: tuple(value / 1e3 for value in raw))


def duration_s(motion: JointMotion) -> float:
    steps = 0
    while motion.moving:
        motion.step(STEP_S)
        steps += 1
    return steps * STEP_S


def test_a_long_motion_takes_the_time_of_a_trapezoid() -> None:
    """distance / speed + speed / acceleration."""
    motion = JointMotion((0.0,) * 6)
    motion.move_to((150.0, 0, 0, 0, 0, 0), SPEEDS, ACCELERATIONS)
    assert duration_s(motion) == pytest.approx(150.0 / SPEED + SPEED / ACCELERATION, abs=STEP_S)
    assert now(motion.positions_deg) == (150.0, 0, 0, 0, 0, 0)
    assert motion.speeds_deg_s == (0.0,) * 6


def test_a_short_motion_takes_the_time_of_a_triangle() -> None:
    motion = JointMotion((0.0,) * 6)
    motion.move_to((0, 0, 0, 0, 0, 10.0), SPEEDS, ACCELERATIONS)
    assert duration_s(motion) == pytest.approx(2.0 * math.sqrt(10.0 / ACCELERATION), abs=STEP_S)


def test_joints_start_and_arrive_together() -> None:
    motion = JointMotion((0.0,) * 6)
    motion.move_to((100.0, 10.0, -1.0, 0, 0, 0), SPEEDS, ACCELERATIONS)
    while motion.moving:
        assert motion.positions_deg[1] == pytest.approx(motion.positions_deg[0] / 10, abs=6.0)
        before = motion.positions_deg
        motion.step(STEP_S)
    assert all(a != b for a, b in zip(before[:3], motion.positions_deg[:3], strict=True))


@settings(max_examples=examples(60), deadline=None)
@given(
    st.lists(st.tuples(angles, st.integers(1, 100), st.integers(1, 900)), min_size=1, max_size=5)
)
def test_speed_and_acceleration_stay_within_limits_and_joints_within_range(
    legs: list[tuple[tuple[float, ...], int, int]],
) -> None:
    """Whatever replaces whatever in the middle, at whatever speed percentage."""
    motion = JointMotion((0.0,) * 6)
    track = [motion.positions_deg]
    for target, percent, steps in legs:
        motion.move_to(target, [SPEED * percent / 100] * 6, ACCELERATIONS)
        for _ in range(steps):
            motion.step(STEP_S)
            track.append(motion.positions_deg)
    for joint, limits in enumerate(FACTORY_LIMITS):
        path = [positions[joint] for positions in track]
        speeds = [(b - a) / STEP_S for a, b in itertools.pairwise(path)]
        assert max(map(abs, speeds)) <= SPEED + 1e-6
        for a, b in itertools.pairwise(speeds):
            assert abs(b - a) / STEP_S <= ACCELERATION * (1 + 1e-5)
        assert min(path) >= limits.min_deg - 1e-6
        assert max(path) <= limits.max_deg + 1e-6


@settings(max_examples=examples(60), deadline=None)
@given(angles, angles, st.integers(1, 1500))
def test_the_last_target_is_reached_exactly(
    first: tuple[float, ...], last: tuple[float, ...], steps: int
) -> None:
    motion = JointMotion((0.0,) * 6)
    motion.move_to(first, SPEEDS, ACCELERATIONS)
    motion.step(steps * STEP_S)
    motion.move_to(last, SPEEDS, ACCELERATIONS)
    motion.step(60.0)
    assert not motion.moving
    assert motion.positions_deg == last


@settings(max_examples=examples(40), deadline=None)
@given(
    st.lists(
        st.tuples(
            angles,
            st.lists(st.floats(0.0, SPEED), min_size=6, max_size=6),
            st.lists(st.floats(0.5, ACCELERATION), min_size=6, max_size=6),
            st.floats(0.0, 3.0),
        ),
        min_size=1,
        max_size=6,
    )
)
def test_no_limits_a_host_can_set_defeat_the_planner(
    legs: list[tuple[tuple[float, ...], list[float], list[float], float]],
) -> None:
    motion = JointMotion((0.0,) * 6)
    for target, speeds, accelerations, dt_s in legs:
        motion.move_to(target, speeds, accelerations)
        motion.step(dt_s)
        for position, limits in zip(motion.positions_deg, FACTORY_LIMITS, strict=True):
            assert limits.min_deg - 1e-6 <= position <= limits.max_deg + 1e-6


def test_a_joint_that_has_just_the_way_to_brake_is_planned_again() -> None:
    """v²/2a equals the way left but for rounding: found while streaming targets at 200 Hz."""
    motion = JointMotion((8.115892216924259, 90.0, -90.0, 0.0, 0.0, 0.0))
    motion.speeds_deg_s = (15.40345033872572, 0, 0, 0, 0, 0)
    motion.moving = True
    motion.move_to((8.53, 90.0, -90.0, 0, 0, 0), SPEEDS, ACCELERATIONS)
    assert duration_s(motion) == pytest.approx(15.40345 / ACCELERATION, abs=0.002)
    assert motion.positions_deg[0] == 8.53


@settings(max_examples=examples(30), deadline=None)
@given(angles, st.lists(st.integers(-1, 1), min_size=200, max_size=200))
def test_planning_anew_every_5_ms_reaches_the_target_too(
    goal: tuple[float, ...], jitters: list[int]
) -> None:
    motion = JointMotion((0.0,) * 6)
    for jitter in jitters:
        nudged = (min(max(goal[0] + jitter * 0.001, -150.0), 150.0), *goal[1:])
        motion.move_to(nudged, SPEEDS, ACCELERATIONS)
        motion.step(0.005)
    motion.move_to(goal, SPEEDS, ACCELERATIONS)
    motion.step(5.0)
    assert motion.positions_deg == goal


def test_less_acceleration_in_the_middle_does_not_run_past_the_target() -> None:
    motion = JointMotion((0.0,) * 6)
    motion.move_to((150.0, 0, 0, 0, 0, 0), SPEEDS, ACCELERATIONS)
    motion.step(0.9)
    motion.move_to((150.0, 0, 0, 0, 0, 0), SPEEDS, (1.0,) * 6)
    furthest = 0.0
    while motion.moving:
        motion.step(STEP_S)
        furthest = max(furthest, motion.positions_deg[0])
    assert furthest <= 150.0


def test_braking_takes_speed_over_acceleration_and_stays_there() -> None:
    motion = JointMotion((0.0,) * 6)
    motion.move_to((150.0, 0, 0, 0, 0, 0), SPEEDS, ACCELERATIONS)
    motion.step(0.7)
    speed = motion.speeds_deg_s[0]
    assert speed == pytest.approx(SPEED)
    start = motion.positions_deg[0]
    motion.brake(ACCELERATIONS)
    assert duration_s(motion) == pytest.approx(speed / ACCELERATION, abs=STEP_S)
    assert motion.positions_deg[0] - start == pytest.approx(speed**2 / (2 * ACCELERATION))
    assert motion.speeds_deg_s == (0.0,) * 6


def test_speeds_and_accelerations_are_the_derivatives_of_the_positions() -> None:
    motion = JointMotion((0.0,) * 6)
    motion.move_to((90.0, 45.0, -20.0, 5.0, -5.0, 1.0), SPEEDS, ACCELERATIONS)
    while motion.moving:
        before, speeds_before = motion.positions_deg, motion.speeds_deg_s
        motion.step(STEP_S)
        if motion.moving:
            for a, b, va, vb in zip(
                before, motion.positions_deg, speeds_before, motion.speeds_deg_s, strict=True
            ):
                assert (b - a) / STEP_S == pytest.approx((va + vb) / 2, abs=0.1)


def test_a_target_where_the_joints_stand_is_no_motion() -> None:
    motion = JointMotion((1.0,) * 6)
    motion.move_to((1.0,) * 6, SPEEDS, ACCELERATIONS)
    assert not motion.moving


def test_braking_at_a_standstill_is_no_motion() -> None:
    motion = JointMotion((1.0,) * 6)
    motion.brake(ACCELERATIONS)
    assert not motion.moving


def test_no_plan_is_slower_than_the_slowest() -> None:
    motion = JointMotion((0.0,) * 6)
    motion.move_to((1.0, 0, 0, 0, 0, 0), (0.0,) * 6, ACCELERATIONS)
    motion.step(1.0 / SLOWEST_DEG_S + 1.0)
    assert motion.positions_deg[0] == 1.0


def test_no_acceleration_is_refused() -> None:
    with pytest.raises(MotionError, match="ruckig cannot plan"):
        JointMotion((0.0,) * 6).move_to((1.0,) * 6, SPEEDS, (0.0,) * 6)
