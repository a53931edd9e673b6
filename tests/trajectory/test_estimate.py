"""How long something takes is estimated before it is checked, by the same plan."""

from dataclasses import replace
from typing import Any

import pytest

from armui.protocol.codes import MoveMode
from armui.trajectory.library.run_options import RunOptions
from armui.trajectory.planning.check import CheckRequest, check
from armui.trajectory.planning.estimate import MOST_POINTS, estimate_s, estimates_s
from armui.trajectory.points.program import Trajectory, Waypoint
from tests.sample_trajectories import SAMPLES
from tests.trajectory.arms import ARM

BEGIN = (20.0, 60.0, -50.0, 10.0, 20.0, 15.0)
OTHER = (60.0, 70.0, -60.0, 10.0, 20.0, 15.0)
ONE, TWO = (Waypoint(MoveMode.MOVE_J, angles, dwell_s=1.0) for angles in (BEGIN, OTHER))
BOTH = Trajectory("both", points=(ONE, TWO))


def checked_s(content, start_deg, options):
    order = CheckRequest(content, ARM, start_deg, options.first, options.cycles)
    return check(order).path.duration_s


@pytest.mark.parametrize(
    "options",
    [
        RunOptions(),
        RunOptions(first=1),
        RunOptions(cycles=2),
        RunOptions(cycles=3, first=1),
    ],
)
def test_it_is_what_a_check_finds_for_an_arm_that_stands_at_the_first_point(options):
    start = (BEGIN, OTHER)[options.first]
    cycle_s = checked_s(BOTH, OTHER, RunOptions())
    whole = replace(options, cycles=1)
    expected = checked_s(BOTH, start, whole) + (options.cycles - 1) * cycle_s
    assert estimate_s(BOTH, ARM, options) == pytest.approx(expected, rel=0.01)


def test_without_end_it_is_that_of_a_further_cycle_wherever_the_first_began():
    whole = check(CheckRequest(BOTH, ARM, BEGIN, 1, 0)).path
    for first in (0, 1):
        endless = RunOptions(cycles=0, first=first)
        assert estimate_s(BOTH, ARM, endless) == pytest.approx(whole.lap_s, rel=0.01)
        away = estimate_s(BOTH, ARM, endless, (90.0, *BEGIN[1:]))
        assert away == estimate_s(BOTH, ARM, endless)


def test_lines_and_arcs_count_too():
    known: dict[str, Any] = {content.name: estimate_s(content, ARM) for content in SAMPLES}
    assert known["Pick and place"] > 2.0
    assert known["Out of reach"] is None


def test_one_that_begins_with_a_line_is_known_all_the_same():
    pose = next(point for point in SAMPLES[0].points if point.move is MoveMode.MOVE_L)
    known: Any = estimate_s(Trajectory("line", points=(pose, TWO)), ARM)
    assert known > 0.0


def test_what_is_not_known_is_told_so():
    assert estimate_s(Trajectory("empty"), ARM) is None
    assert estimate_s(BOTH, ARM, RunOptions(first=2)) is None
    many = Trajectory("many", points=(ONE,) * (MOST_POINTS + 1))
    assert estimate_s(many, ARM) is None


def test_a_recording_takes_its_own_time():
    recording = next(each for each in SAMPLES if not isinstance(each, Trajectory))
    assert estimates_s(recording, ARM, RunOptions(cycles=2), (100, 50)) == pytest.approx(
        (2 * recording.duration_s, 4 * recording.duration_s)
    )


def test_points_take_longer_at_a_lower_speed_but_for_their_dwells():
    known: Any = estimates_s(BOTH, ARM, RunOptions(), (100, 20))
    full_s, slow_s = known
    assert full_s + 0.2 < slow_s < 5 * (full_s - 2.0) + 2.0 + 0.01


def test_the_way_from_where_the_arm_stands_counts_where_that_is_known():
    there = BOTH.points[0].target
    from_here: Any = estimate_s(BOTH, ARM, start_deg=there)
    assert from_here == pytest.approx(estimate_s(BOTH, ARM), abs=0.05)
    away = tuple(each + 30.0 if place == 0 else each for place, each in enumerate(there))
    from_away: Any = estimate_s(BOTH, ARM, start_deg=away)
    assert from_away > from_here + 0.3
