"""S16: what was checked is what is driven: in every cycle, from every row, with every motion."""

from dataclasses import replace

import numpy as np
import pytest

from armui.protocol.codes import MoveMode
from armui.protocol.generation import Generation, PiperModel
from armui.trajectory.planning.check import CheckRequest, check
from armui.trajectory.planning.findings import Severity
from armui.trajectory.points.program import Trajectory
from tests.safety.test_s16_every_way_checked import BACK, OUT, OVER, recording
from tests.safety.ways import Way, Ways, judge
from tests.trajectory.arms import ARM, HERE, arc, joint, line, pose, pose_near, run

SAMPLE = (1, 2, 9, 11)


def way(*points, cycles=2, first=0, start=HERE):
    return Way(run(*points), start, PiperModel.PIPER, Generation.TWO, cycles=cycles, first=first)


def checked(*points, cycles=2, first=0, start=HERE, arm=ARM):
    return check(CheckRequest(run(*points), arm, start, first=first, cycles=cycles))


def errors(outcome):
    return {
        (each.code, each.cycle, each.row)
        for each in outcome.findings
        if each.severity is Severity.ERROR
    }


@pytest.mark.usefixtures("qapp")
@pytest.mark.parametrize("seed", SAMPLE)
def test_what_is_checked_is_driven(seed):
    """A sample of `python -m tests.safety.ways`: among them arcs that are none."""
    assert judge(Ways(seed).way()).wrong == ""


THERE = pose_near(HERE, (40, -60, 30))
BESIDE = pose_near(HERE, (0, 60, -20))


def visits(outcome):
    """Which rows are come to, in which cycle, in the order of the way."""
    begins = np.flatnonzero(outcome.path.begins)
    path = outcome.path
    return list(zip(path.cycles[begins].tolist(), path.rows[begins].tolist(), strict=True))


def test_a_start_in_the_middle_is_planned_from_where_the_arm_stands():
    outcome = checked(line(THERE), pose(BESIDE), joint(*HERE), cycles=1, first=1)
    assert visits(outcome) == [(1, 1), (1, 2)]
    assert outcome.expected_s[0] == 0.0
    assert outcome.path.at(0.0) == pytest.approx(HERE)


def test_rows_left_out_are_come_to_in_the_next_cycle():
    outcome = checked(line(THERE), pose(BESIDE), joint(*HERE), cycles=0, first=1)
    assert visits(outcome) == [(1, 1), (1, 2), (2, 0), (2, 1)]
    assert min(outcome.expected_s) > 0.0


def test_a_row_come_to_from_elsewhere_is_given_the_time_of_the_longer_way():
    far = (-40.0, 100.0, -90.0, -30.0, 40.0, 30.0)
    once = checked(joint(*HERE, speed=5), joint(*far), cycles=1)
    again = checked(joint(*HERE, speed=5), joint(*far), cycles=3)
    assert once.expected_s[0] == pytest.approx(0.0, abs=0.01)
    assert again.expected_s[0] > 5.0


def test_an_arc_alone_has_no_way_in_the_second_cycle():
    """It would begin where it ends."""
    alone = arc(pose_near(HERE, (30, -30, 0)), THERE)
    assert errors(checked(alone, cycles=1)) == set()
    assert errors(checked(alone, cycles=2)) == {("arc_no_circle", 2, 0)}


@pytest.mark.usefixtures("qapp")
def test_so_the_arm_says_too():
    result = judge(way(arc(pose_near(HERE, (30, -30, 0)), THERE)))
    assert (result.wrong, result.progress.cycle) == ("", 2)


@pytest.mark.usefixtures("qapp")
@pytest.mark.parametrize("off_mm", [0.0, 0.0004, 0.1])
def test_an_arc_that_ends_where_it_begins_is_none(off_mm):
    """The arm rounds where it stands: the two may be one, or the arc a whole circle."""
    end = pose_near(HERE, (off_mm, 0, 0))
    outcome = checked(joint(*HERE), arc(pose_near(HERE, (30, -30, 0)), end), cycles=1)
    assert errors(outcome) == {("arc_no_circle", 1, 1)}


def test_an_arc_that_begins_at_a_limit_is_an_error():
    at_limit = (10.0, 70.0, -60.0, 100.0, 25.0, -20.0)
    middle, end = pose_near(at_limit, (20, -20, 0)), pose_near(at_limit, (40, 0, 10))
    outcome = checked(joint(*at_limit), arc(middle, end), cycles=1)
    assert ("arc_at_limit", 1, 1) in errors(outcome)


def test_a_pose_between_two_ways_is_a_warning():
    straight = (0.0, 70.0, -60.0, 0.0, 0.0, 0.0)
    sideways = (0.0, 70.0, -60.0, 90.0, 20.0, -90.0)
    outcome = checked(pose(pose_near(sideways)), cycles=1, start=straight)
    assert "either_way" in {each.code for each in outcome.findings}
    sure = checked(joint(*sideways), cycles=1, start=straight)
    assert "either_way" not in {each.code for each in sure.findings}


@pytest.mark.parametrize(
    ("most_deg", "found"), [(400.0, "target_beyond_limit"), (1e5, "never_repeats")]
)
def test_cycles_of_which_each_turns_the_hand_once_more(most_deg, found):
    """Until a limit ends it, or for so many cycles that nobody has looked at the next."""
    limits = (*ARM.limits[:5], ARM.limits[5]._replace(min_deg=-most_deg, max_deg=most_deg))
    flat = (10.0, 70.0, -60.0, 0.0, 80.0, 0.0)
    limits = (*limits[:4], limits[4]._replace(max_deg=90.0), limits[5])
    turned = [line(pose_near(flat, turned_deg=deg)) for deg in (120.0, -120.0, 0.0)]
    outcome = checked(*turned, cycles=0, start=flat, arm=replace(ARM, limits=limits))
    assert {code for code, _, _ in errors(outcome)} == {found}


def test_a_recording_is_looked_at_with_its_way_back():
    path = check(CheckRequest(recording(BACK, OVER, OUT), ARM, BACK, cycles=0)).path
    once = check(CheckRequest(recording(BACK, OVER, OUT), ARM, BACK)).path
    assert path.joints_deg[-1] == pytest.approx(BACK)
    assert path.first_cycle_s == once.duration_s < path.duration_s


def test_moves_are_as_they_are_told():
    """The arm is told whole steps of 0.001 mm and degrees; what lies between is rounded."""
    exact = pose_near(HERE, (40, -60, 30))
    between = tuple(value + 0.0004 for value in exact)
    ends = [checked(line(each), cycles=1).path.joints_deg[-1] for each in (exact, between)]
    assert ends[0] == pytest.approx(ends[1], abs=1e-9)


def test_a_move_of_each_kind_is_in_the_sample():
    moves = set()
    for seed in SAMPLE:
        content = Ways(seed).way().content
        if isinstance(content, Trajectory):
            moves |= {each.move for each in content.points}
    assert moves == {MoveMode.MOVE_J, MoveMode.MOVE_P, MoveMode.MOVE_L, MoveMode.MOVE_C}
