"""When the joints stand still, by the angles the arm reports or the speeds of its drivers."""

from __future__ import annotations

import pytest

from armui.arm.state import ArmState, DriverFast, Reading
from armui.control.safety.standstill import (
    JOINTS_MOVING,
    QUIET_DEG,
    QUIET_S,
    SPEED_UNKNOWN,
    RestWatch,
    why_moving,
    why_not_still,
)
from tests.ui.arm_states import heard_six

BEGIN_S = 0.25
STEP_S = 0.0625
"""Times are sums of powers of two, so that the limits are met exactly."""


class Joints:
    """Six measured angles over time, and the watch."""

    def __init__(self, **how) -> None:
        self.watch = RestWatch(**how)
        self.now_s = BEGIN_S
        self.angles_deg = [0.0] * 6

    def look(self, seconds: float = 0.0) -> bool:
        """Measure every 1/16 s for so long, then once; whether the arm is at rest."""
        end_s = self.now_s + seconds
        while self.now_s < end_s:
            self._observe()
            self.now_s += STEP_S
        self._observe()
        return self.watch.at_rest

    def _observe(self) -> None:
        heard = heard_six(self.angles_deg, self.now_s)
        self.watch.observe(ArmState(joints_deg=heard), self.now_s)


@pytest.fixture
def joints():
    return Joints()


def test_nothing_is_at_rest_before_it_was_measured(joints):
    assert not joints.watch.at_rest
    assert not joints.look()


def test_three_tenths_of_a_second_without_motion_are_rest(joints):
    assert not joints.look(0.25)
    assert joints.look(0.0625)


def test_exactly_the_time_asked_for_is_rest():
    joints = Joints(for_s=0.25)
    assert not joints.look(0.1875)
    assert joints.look(0.0625)


@pytest.mark.parametrize("index", [0, 5])
@pytest.mark.parametrize("direction", [1, -1])
@pytest.mark.parametrize(("moved_deg", "rests"), [(0.02, True), (0.021, False)])
def test_a_joint_that_moves_by_more_than_its_last_digits_is_not_at_rest(
    joints, index, direction, moved_deg, rests
):
    assert joints.look(0.5)
    joints.angles_deg[index] += direction * moved_deg
    assert joints.look() is rests
    assert joints.look(0.375)


def test_a_slow_creep_is_no_rest(joints):
    for _ in range(60):
        joints.angles_deg[2] += 0.01
        joints.look(STEP_S)
    assert not joints.watch.at_rest


def test_a_watch_may_be_told_how_near_and_how_long():
    joints = Joints(within_deg=1.0, for_s=1.0)
    assert not joints.look(0.9375)
    joints.angles_deg[0] = 1.0
    assert joints.look(0.0625)
    joints.angles_deg[0] = 1.5
    assert not joints.look(0.0625)


def test_time_without_measuring_is_no_rest(joints):
    joints.look()
    heard = (Reading(0.0, joints.now_s),) * 6
    joints.watch.observe(ArmState(joints_deg=heard), joints.now_s + 0.4)
    assert not joints.watch.at_rest


def test_the_angle_heard_longest_ago_counts(joints):
    joints.look()
    later_s = BEGIN_S + 0.4
    fresh, old = Reading(0.0, later_s), Reading(0.0, BEGIN_S)
    for heard in ((old, *(fresh,) * 5), (*(fresh,) * 5, old)):
        joints.watch.observe(ArmState(joints_deg=heard), later_s)
        assert not joints.watch.at_rest


def stale(joints):
    return tuple(Reading(each, joints.now_s - 0.51) for each in joints.angles_deg)


def one_missing(joints):
    return (*(Reading(each, joints.now_s) for each in joints.angles_deg[:5]), None)


@pytest.mark.parametrize("heard", [stale, one_missing])
def test_rest_is_forgotten_when_the_angles_are_not_heard(joints, heard):
    assert joints.look(0.5)
    joints.watch.observe(ArmState(joints_deg=heard(joints)), joints.now_s)
    assert not joints.watch.at_rest
    assert not joints.look()
    assert joints.look(0.375)


def test_forget(joints):
    assert joints.look(0.5)
    joints.watch.reset()
    assert not joints.watch.at_rest


@pytest.mark.parametrize(("speed_deg_s", "quiet"), [(0.4, True), (1.1, False)])
def test_to_be_quiet_is_to_move_slower_than_a_degree_a_second(speed_deg_s, quiet):
    joints = Joints(within_deg=QUIET_DEG, for_s=QUIET_S)
    assert not joints.look()
    joints.now_s += 0.03125
    joints.angles_deg[0] += speed_deg_s * 0.03125
    assert joints.look() is quiet


# By the speeds of the drivers --------------------------------------------------------------------


def speeds(values, age_s=0.0, heard_s: float | None = 2.0) -> ArmState:
    """Drivers that tell speeds, heard so long before the newest feedback."""
    fast = [
        None if each is None else Reading(DriverFast(each, 0.0, None), 2.0 - age_s)
        for each in values
    ]
    one, two, three, four, five, six = fast
    return ArmState(last_feedback_s=heard_s, drivers_fast=(one, two, three, four, five, six))


STILL = (0.0,) * 6


@pytest.mark.parametrize(
    ("values", "joints"),
    [
        (STILL, None),
        ((0.99, -0.99, *STILL[2:]), None),
        ((1.0, *STILL[1:]), "1"),
        ((*STILL[:5], -1.0), "6"),
        ((0.0, 20.0, 0.5, -30.0, None, None), "2, 4"),
    ],
)
def test_joints_that_are_measured_to_move_are_named(values, joints):
    refusal = why_moving(speeds(values))
    expected = JOINTS_MOVING(joints=joints)
    assert refusal == (None if joints is None else expected)


def test_a_joint_that_tells_nothing_is_no_reason_unless_it_must_be_known():
    state = speeds((20.0, None, 0.0, 0.0, 0.0, None))
    assert why_moving(state).params == {"joints": "1"}
    assert why_not_still(state) == SPEED_UNKNOWN(joints="2, 6")


def test_all_speeds_known_the_joints_that_move_are_the_reason():
    assert why_not_still(speeds(STILL)) is None
    assert why_not_still(speeds((20.0, *STILL[1:]))).reason == JOINTS_MOVING


@pytest.mark.parametrize(
    ("age_s", "heard_s", "known"), [(0.5, 2.0, True), (0.51, 2.0, False), (0.0, None, False)]
)
def test_speeds_must_be_heard_beside_the_newest_feedback(age_s, heard_s, known):
    refusal = why_not_still(speeds(STILL, age_s, heard_s))
    assert (refusal is None) is known
