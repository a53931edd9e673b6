"""One number that grows along a path: trapezoids, halts, exact ends."""

from __future__ import annotations

import itertools

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from armui.sim.motion.tool_plan import PathProfile
from tests.examples import examples
from tests.moments import now

STEP_S = 0.001


def duration_s(profile: PathProfile) -> float:
    steps = 0
    while not profile.at_end:
        profile.step(STEP_S)
        steps += 1
        assert steps < 100_000
    return steps * STEP_S


@pytest.mark.parametrize(
    ("end", "top_speed", "expected_s"),
    [
        (100.0, 50.0, 100 / 50 + 50 / 25),  # trapezoid
        (25.0, 50.0, 2 * (25 / 25) ** 0.5),  # triangle
    ],
)
def test_the_time_it_takes(end: float, top_speed: float, expected_s: float) -> None:
    profile = PathProfile(end, 25.0)
    profile.run(top_speed)
    assert duration_s(profile) == pytest.approx(expected_s, abs=2 * STEP_S)
    assert profile.position == end
    assert profile.speed == profile.acceleration == 0.0


def test_it_does_not_run_unasked_and_a_halted_one_stays() -> None:
    profile = PathProfile(10.0, 25.0)
    profile.step(1.0)
    assert profile.position == 0.0
    assert not now(profile.moving)
    profile.run(5.0)
    assert now(profile.moving)
    profile.step(0.5)
    halted_at = profile.position + profile.speed**2 / 50.0
    profile.run(0.0)
    profile.step(5.0)
    assert profile.position == pytest.approx(halted_at)
    assert not profile.moving
    profile.run(5.0)
    profile.step(5.0)
    assert profile.at_end


@settings(max_examples=examples(100), deadline=None)
@given(
    st.floats(0.001, 2000.0),
    st.floats(0.1, 5000.0),
    st.lists(
        st.tuples(st.sampled_from([0.0, 0.01, 1.0, 30.0, 500.0]), st.integers(1, 300)), max_size=6
    ),
)
def test_limits_hold_and_the_end_is_exact_whatever_is_asked_on_the_way(
    end: float, acceleration: float, orders: list[tuple[float, int]]
) -> None:
    profile = PathProfile(end, acceleration)
    track = [profile.position]
    for top_speed, steps in orders:
        profile.run(top_speed)
        for _ in range(steps):
            profile.step(STEP_S)
            track.append(profile.position)
    speeds = [(b - a) / STEP_S for a, b in itertools.pairwise(track)]
    slack = 1e-9 * end / STEP_S**2
    assert all(speed >= 0.0 for speed in speeds)
    for a, b in itertools.pairwise([0.0, *speeds]):
        assert abs(b - a) / STEP_S <= acceleration * (1 + 1e-6) + slack
    assert max(track) <= end
    profile.run(1000.0)
    profile.step(1e5)
    assert profile.position == end
