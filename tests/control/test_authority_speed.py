"""Which speed percentage goes first, and when a motion of ours is measured too fast."""

from __future__ import annotations

import pytest

from armui.control.motion.motion_command import CommandKind
from tests.control.heard_arm import HERE, Arm, status


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


def too_fast(arm):
    """Whether joint 1 at 100 °/s is told as too fast for the command under way."""
    arm.status = status(reached=False)
    arm.turn(8, 2.0)
    return arm.authority.overspeed is not None


@pytest.mark.parametrize("kind", CommandKind)
def test_all_but_replays_are_watched(arm, kind):
    """A replay is watched by how far it lags behind what was recorded."""
    arm.send(HERE, kind, 10)
    assert too_fast(arm) is (kind is not CommandKind.REPLAY)


def test_a_motion_that_is_not_ours_is_nothing_to_compare_with(arm):
    assert not too_fast(arm)


def test_nor_is_a_command_that_is_not_under_way(arm):
    arm.send(HERE, percent=10)
    arm.wait(0.4)
    arm.status = status()
    arm.joints_deg = (0.4, *HERE[1:])
    arm.wait(0.02)
    assert not arm.authority.under_way
    assert arm.authority.overspeed is None


@pytest.mark.parametrize(
    "does",
    [lambda arm: arm.send(HERE, percent=10), lambda arm: arm.authority.told_percent(10)],
    ids=["another command", "another percentage"],
)
def test_another_speed_shown_is_compared_with_what_comes_after(arm, does):
    arm.send(HERE, percent=90)
    assert not too_fast(arm)
    arm.authority.told_percent(10)
    arm.turn(4, 2.0)
    assert arm.authority.overspeed is None
    does(arm)
    arm.turn(15, 2.0)  # 0.3 s at 100 °/s: time to take it up, and to slow down by 286 °/s²
    assert arm.authority.overspeed is None
    arm.turn(5, 2.0)
    assert arm.authority.overspeed is not None


def hold_by_zero(arm):
    arm.authority.told_percent(0)


def hold_by_pause(arm):
    arm.authority.paused()


@pytest.mark.parametrize("hold", [hold_by_zero, hold_by_pause])
def test_what_is_held_back_is_given_the_time_to_brake_and_no_more(arm, hold):
    arm.send(HERE, percent=100)
    arm.status = status(reached=False)
    arm.turn(8, 2.0)
    hold(arm)
    arm.turn(15, 2.0)  # 0.3 s at 100 °/s: time to take it up, and to slow down by 286 °/s²
    assert [arm.authority.overspeed] == [None]
    arm.turn(15, 2.0)
    (reason,) = [arm.authority.overspeed]
    assert reason is not None
    assert reason.params["maximum"] == 0.0


@pytest.mark.parametrize("hold", [hold_by_zero, hold_by_pause])
def test_a_hand_may_move_what_stands_held_back(arm, hold):
    arm.send(HERE, percent=100)
    arm.status = status(reached=False)
    hold(arm)
    arm.wait(0.5)
    assert arm.authority.at_rest
    arm.turn(15, 2.0)
    assert arm.authority.overspeed is None
    assert arm.authority.holds
