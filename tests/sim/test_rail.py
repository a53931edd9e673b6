"""One number that grows along a path: trapezoids, halts, exact ends."""

from __future__ import annotations

import itertools

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from armui.sim.motion.path_profile import PathProfile
from tests.examples import examples
from tests.moments import now

STEP_S = 0.001


def duration_s(rail: PathProfile) -> float:
    steps = 0
    while not rail.at_end:
        rail.advance(STEP_S)
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
    rail = PathProfile(end, 25.0)
    rail.run(top_speed)
    assert duration_s(rail) == pytest.approx(expected_s, abs=2 * STEP_S)
    assert rail.position == end
    assert rail.speed == rail.acceleration == 0.0


def test_it_does_not_run_unasked_and_a_halted_one_stays() -> None:
    rail = PathProfile(10.0, 25.0)
    rail.advance(1.0)
    assert rail.position == 0.0
    assert not now(rail.moving)
    rail.run(5.0)
    assert now(rail.moving)
    rail.advance(0.5)
    halted_at = rail.position + rail.speed**2 / 50.0
    rail.run(0.0)
    rail.advance(5.0)
    assert rail.position == pytest.approx(halted_at)
    assert not rail.moving
    rail.run(5.0)
    rail.advance(5.0)
    assert rail.at_end


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
    rail = PathProfile(end, acceleration)
    track = [rail.position]
    for top_speed, steps in orders:
        rail.run(top_speed)
        for _ in range(steps):
            rail.advance(STEP_S)
            track.append(rail.position)
    speeds = [(b - a) / STEP_S for a, b in itertools.pairwise(track)]
    slack = 1e-9 * end / STEP_S**2
    assert all(speed >= 0.0 for speed in speeds)
    for a, b in itertools.pairwise([0.0, *speeds]):
        assert abs(b - a) / STEP_S <= acceleration * (1 + 1e-6) + slack
    assert max(track) <= end
    rail.run(1000.0)
    rail.advance(1e5)
    assert rail.position == end
