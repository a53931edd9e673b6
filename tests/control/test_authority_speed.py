"""Which speed percentage goes first, and when a motion of ours is measured too fast."""

from __future__ import annotations

import pytest

from tests.control.test_authority import HERE, Arm, status


@pytest.fixture
def arm():
    return Arm()


@pytest.mark.parametrize(
    ("given", "asked", "lowers"),
    [(None, 30, True), (30, 29, True), (30, 30, False), (5, 30, False)],
)
def test_which_percentage_goes_first(arm, given, asked, lowers):
    arm.authority.arm_percent = given
    assert arm.authority.lowers_speed(asked) is lowers


def test_generation_1_tells_its_percentage(arm):
    arm.authority.arm_percent = 5
    arm.status = status(speed_percent=100)
    arm.look()
    assert arm.authority.lowers_speed(30)


@pytest.mark.parametrize(("speed_deg_s", "too_fast"), [(70.0, False), (90.0, True)])
def test_one_and_a_half_times_the_speed_shown_for_a_tenth_of_a_second(arm, speed_deg_s, too_fast):
    """30 % of the factory's 171.9 °/s is 51.6 °/s; half again and the slack make 79.3 °/s."""
    arm.send(percent=30)
    arm.status = status(reached=False)
    for k in range(12):
        arm.joints_deg = (speed_deg_s * 0.02 * k, *HERE[1:])
        arm.wait(0.02)
    assert (arm.authority.overspeed is not None) is too_fast


def test_a_joint_that_brakes_to_a_lower_speed_is_not_too_fast(arm):
    arm.send(percent=5)
    arm.status = status(reached=False)
    place = 0.0
    for k in range(14):
        place += max(0.0, 100.0 - 100.0 * k / 12) * 0.02
        arm.joints_deg = (place, *HERE[1:])
        arm.wait(0.02)
        assert arm.authority.overspeed is None
