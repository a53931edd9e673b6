"""When a motion of ours is measured to be faster than the speed shown."""

from __future__ import annotations

import pytest

from armui.arm.limits import JointLimits
from armui.arm.refusal import Refusal
from armui.arm.state import ArmState, Reading
from armui.control.safety.overspeed import TOO_FAST, OverspeedWatch
from tests.family import FACTORY_LIMITS
from tests.ui.arm_states import heard_six

BEGIN_S = 0.25
STEP_S = 0.015625
"""Times are sums of powers of two, so that the arithmetic of the limits is exact."""

LIMITS = JointLimits(-180.0, 180.0, 100.0)
PERCENT = 20
"""20 % of 100 °/s is 20 °/s; half again and 2 °/s of slack make 32 °/s."""

BRAKES = (32.0,) * 6
"""°/s²: a joint at 100 °/s takes 3.1 s to rest, and is half a degree a second slower a reading."""


class Motion:
    """Joints that turn at a speed, and the watch."""

    def __init__(self, limits: JointLimits | None = LIMITS) -> None:
        self.watch = OverspeedWatch()
        self.now_s = BEGIN_S
        self.angles_deg = [0.0] * 6
        self.limits = (None if limits is None else Reading(limits, BEGIN_S),) * 6
        self.factory = FACTORY_LIMITS
        self.brakes = BRAKES
        self.in_time_since_s = BEGIN_S
        self.refusal: Refusal | None = None

    def state(self) -> ArmState:
        """The arm as heard now."""
        heard = heard_six(self.angles_deg, self.now_s)
        return ArmState(joints_deg=heard, limits=self.limits, in_time_since_s=self.in_time_since_s)

    def turn(self, speed_deg_s: float, steps: int, joint: int = 1, percent: int | None = PERCENT):
        """Measure so many times, each 1/64 s after the last; what is said at the end."""
        for _ in range(steps):
            self.refusal = self.watch.observe(self.state(), percent, self.factory, self.brakes)
            self.now_s += STEP_S
            self.angles_deg[joint - 1] += speed_deg_s * STEP_S
        return self.refusal


@pytest.fixture
def motion():
    return Motion()


@pytest.mark.parametrize("joint", range(1, 7))
@pytest.mark.parametrize("direction", [1, -1])
def test_the_joint_its_speed_and_the_speed_shown_are_named(motion, joint, direction):
    refusal = motion.turn(direction * 40.25, 9, joint)
    assert refusal.reason == TOO_FAST
    figures = {"value": 40.2, "percent": 20, "maximum": 20.0, "limit": 32.0}
    assert refusal.params == {"joint": joint, **figures}


@pytest.mark.parametrize(("speed_deg_s", "too_fast"), [(32.0, False), (32.5, True)])
def test_half_again_and_two_degrees_a_second_of_slack_are_allowed(motion, speed_deg_s, too_fast):
    assert (motion.turn(speed_deg_s, 20) is not None) is too_fast


@pytest.mark.parametrize(("speed_deg_s", "too_fast"), [(1.5, False), (2.5, True)])
def test_of_a_motion_at_zero_percent_only_the_slack_is_allowed(motion, speed_deg_s, too_fast):
    assert (motion.turn(speed_deg_s, 20, percent=0) is not None) is too_fast


def test_it_takes_a_tenth_of_a_second(motion):
    assert motion.turn(50.0, 7) is None  # 6/64 s
    assert motion.turn(50.0, 1) is not None  # 7/64 s


def test_a_jolt_within_the_tenth_of_a_second_is_none(motion):
    motion.turn(0.0, 10)
    assert motion.turn(40.0, 3) is None
    assert motion.turn(0.0, 20) is None


def test_only_the_last_tenth_of_a_second_counts(motion):
    motion.turn(0.0, 60)
    assert motion.turn(50.0, 9) is not None


def test_a_motion_that_was_too_fast_and_is_not_any_more(motion):
    assert motion.turn(50.0, 9) is not None
    assert motion.turn(10.0, 20) is None


@pytest.mark.parametrize(("later_deg_s", "too_fast"), [(38.75, True), (36.0, False)])
def test_a_joint_that_brakes_is_on_its_way_to_the_speed_it_was_told(motion, later_deg_s, too_fast):
    """Of 40 °/s 95 % are 38 °/s."""
    motion.turn(40.0, 4)
    assert (motion.turn(later_deg_s, 5) is not None) is too_fast


def test_a_joint_that_gets_faster_is_not_braking(motion):
    motion.turn(34.0, 4)
    assert motion.turn(60.0, 5) is not None


@pytest.mark.parametrize(
    ("limits", "shown"),
    [
        (LIMITS, 20.0),
        (None, 34.4),
        (JointLimits(-180.0, 180.0, 6553.5), 34.4),
        (JointLimits(-180.0, 180.0, 0.0), 34.4),
    ],
    ids=["read", "not read", "0xFFFF", "0"],
)
def test_limits_that_cannot_be_true_are_the_factorys(limits, shown):
    """The factory's highest speed is 171.9 °/s."""
    assert Motion(limits).turn(100.0, 9).params["maximum"] == shown


def test_a_model_with_faster_joints_is_measured_by_its_own_table():
    motion = Motion(None)
    motion.factory = tuple(JointLimits(-180.0, 180.0, 300.0) for _ in range(6))
    assert motion.turn(90.0, 9) is None  # 20 % of 300 °/s is 60 °/s; half again and 2 are 92
    assert motion.turn(100.0, 9).params["maximum"] == 60.0


def test_nothing_is_compared_without_a_speed_shown(motion):
    assert motion.turn(100.0, 20, percent=None) is None
    assert motion.turn(100.0, 7) is None  # what was measured before is not of this motion
    assert motion.turn(100.0, 1) is not None


def test_another_speed_shown_begins_anew(motion):
    motion.turn(100.0, 7)
    motion.watch.change_speed()
    assert motion.turn(100.0, 7) is None
    assert motion.turn(100.0, 1) is not None


def slow_down(motion, begin_deg_s, steps, percent=5):
    """Turn at 100 %, then be told another speed and brake at 32 °/s²; what was said meanwhile."""
    motion.turn(begin_deg_s, 9, percent=100)
    motion.watch.change_speed()
    speed_deg_s, said = begin_deg_s, []
    for _ in range(steps):
        said.append(motion.turn(speed_deg_s, 1, percent=percent))
        speed_deg_s = max(speed_deg_s - 32.0 * STEP_S, 5.0)
    return said


def test_a_joint_that_brakes_gently_is_on_its_way_all_the_time(motion):
    """In 0.05 s it gets 1.6 °/s slower, which is no more than 2 % of 100 °/s."""
    assert not any(slow_down(motion, 100.0, 300))


def test_a_joint_that_does_not_slow_down_is_named_within_half_a_second(motion):
    """0.2 s until it is taken up, twice that and 0.05 s until it must be slower than it was."""
    motion.turn(100.0, 9, percent=100)
    motion.watch.change_speed()
    said = [motion.turn(100.0, 1, percent=5) for _ in range(36)]
    assert not any(said[:28])  # 0.44 s
    figures = {"value": 100.0, "percent": 5, "maximum": 5.0, "limit": 98.4}
    assert said[-1].params == {"joint": 1, **figures}  # 0.55 s: so fast it may be on its way down


def test_one_that_goes_on_from_a_speed_on_its_way_down_is_named(motion):
    assert not any(slow_down(motion, 100.0, 100))
    assert motion.turn(52.0, 60, percent=5) is not None


def test_slower_still_is_allowed_from_where_it_is_by_then(motion):
    assert not any(slow_down(motion, 100.0, 60, percent=50))
    motion.watch.change_speed()
    speed_deg_s, said = 70.0, []
    for _ in range(200):
        said.append(motion.turn(speed_deg_s, 1, percent=5))
        speed_deg_s = max(speed_deg_s - 32.0 * STEP_S, 5.0)
    assert not any(said)


@pytest.mark.parametrize(("measurements", "excused"), [(1, False), (4, False), (5, True)])
def test_only_a_speed_measured_over_half_the_time_counts_as_that_of_before(
    motion, measurements, excused
):
    """Five measurements are 4/64 s apart, more than 0.05 s; four are 3/64 s."""
    motion.turn(100.0, measurements, percent=100)
    motion.watch.change_speed()
    assert (motion.turn(100.0, 8, percent=5) is None) is excused


def test_the_speed_of_before_is_that_of_the_whole_tenth_of_a_second(motion):
    motion.turn(20.0, 1, percent=100)
    motion.turn(100.0, 7, percent=100)
    motion.watch.change_speed()
    assert motion.turn(60.0, 9, percent=5) is None


def test_no_more_is_allowed_than_was_before_the_speed_was_lowered(motion):
    """What was too fast already is so still: at 20 % that is 32 °/s."""
    motion.turn(40.0, 7)
    motion.watch.change_speed()
    assert motion.turn(40.0, 8, percent=5) is not None


def test_what_was_measured_of_an_earlier_motion_allows_the_next_nothing(motion):
    motion.turn(100.0, 9, percent=100)
    motion.watch.change_speed()
    motion.turn(0.0, 1, percent=None)
    assert motion.turn(40.0, 9, percent=5) is not None


@pytest.mark.parametrize("index", [0, 5])
def test_angles_that_are_not_all_known_are_none(motion, index):
    motion.turn(100.0, 7)
    state = motion.state()
    some = (*state.joints_deg[:index], None, *state.joints_deg[index + 1 :])
    assert (
        motion.watch.observe(state._replace(joints_deg=some), PERCENT, FACTORY_LIMITS, BRAKES)
        is None
    )
    assert motion.watch.observe(state, PERCENT, FACTORY_LIMITS, BRAKES) is None
    assert motion.turn(100.0, 7) is None


def test_the_same_angles_seen_again_are_measured_once(motion):
    motion.turn(50.0, 7)
    state = motion.state()
    first = motion.watch.observe(state, PERCENT, FACTORY_LIMITS, BRAKES)
    again = [motion.watch.observe(state, PERCENT, FACTORY_LIMITS, BRAKES) for _ in range(20)]
    assert first is not None
    assert again == [first] * 20


def test_a_measurement_is_complete_with_its_last_frame(motion):
    """0x2A7 comes last: until then the new angles of other joints have no time of their own."""
    motion.turn(30.0, 8)
    newer = motion.now_s
    last = Reading(0.0, float(str(newer - STEP_S)))
    early = (Reading(motion.angles_deg[0] + 2.0, newer), *(Reading(0.0, newer),) * 3, last, last)
    state = motion.state()._replace(joints_deg=early)
    assert [motion.watch.observe(state, PERCENT, FACTORY_LIMITS, BRAKES) for _ in range(3)] == [
        None
    ] * 3


def test_what_the_joints_did_in_a_gap_is_no_speed(motion):
    motion.turn(10.0, 8)
    motion.now_s += 0.25
    motion.angles_deg[0] += 10.0  # as fast as after it, so that it is not braking
    motion.in_time_since_s = motion.now_s
    assert motion.turn(40.0, 7) is None
    assert motion.turn(40.0, 1).params["value"] == 40.0


def test_a_long_gap_between_two_measurements_is_judged_by_what_lies_between(motion):
    motion.turn(0.0, 1)
    motion.now_s += 1.0
    motion.angles_deg[0] = 20.0
    assert motion.turn(0.0, 1) is None  # 20 °/s
    motion.now_s += 1.0
    motion.angles_deg[0] = 90.0
    assert motion.turn(0.0, 1).params["value"] > 60.0
