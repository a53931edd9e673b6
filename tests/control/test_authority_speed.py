"""When a motion of ours is measured too fast, and when another speed may be given."""

from __future__ import annotations

import pytest

from armui.control.authority import MET_MOVING, PART_FAILED
from armui.control.cell.cell_reasons import CELL_NOT_CONFIRMED
from armui.control.motion.motion_command import HELD_AT_ZERO, CommandKind, End
from armui.control.safety.other_command import OTHER_HOST
from armui.control.safety.overspeed import ToolPace
from tests.control.heard_arm import HERE, Arm, status
from tests.control.test_overspeed_tool import MM_PER_DEG, SLIDE


@pytest.fixture
def arm():
    return Arm()


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


def test_a_command_in_the_place_of_a_faster_one_is_given_the_time_to_slow_down(arm):
    arm.send(HERE, percent=90)
    assert not too_fast(arm)
    arm.send(HERE, percent=10)
    arm.turn(15, 2.0)
    assert [arm.authority.overspeed] == [None]
    arm.turn(25, 2.0)
    assert arm.authority.overspeed is not None


# A line or an arc that brakes ---------------------------------------------------------------------

PACE = ToolPace(SLIDE, linear_mm_s=100.0, angular_deg_s=100.0, ramp_s=4.0)
"""From 100 mm/s to rest in 4 s, 0.2 s after it was told."""


def line(arm, percent):
    """A line of ours."""
    arm.send(HERE, CommandKind.POSE, percent, pace=PACE)


def told(percent):
    """Another percentage for the line under way."""
    return lambda arm: arm.authority.told_percent(percent)


def slower_line(arm):
    """Another line at 10 %, before the arm has come to the end of the last."""
    line(arm, 10)


def arrives(arm):
    """It is at its end, and rests."""
    arm.status = status()
    arm.wait(0.6)


def along(arm, mm_s, seconds):
    """The tool moves so fast; after how many seconds that is told as too fast, or ``None``."""
    for k in range(round(seconds / 0.02)):
        arm.turn(1, mm_s / MM_PER_DEG * 0.02)
        if arm.authority.overspeed is not None:
            return 0.02 * (k + 1)
    return None


@pytest.mark.parametrize(
    ("told_before", "then", "after_s"),
    [
        ((), told(10), 1.4),
        ((), told(20), 1.0),
        ((), hold_by_pause, 1.8),
        ((), slower_line, 1.8),
        # the speed of before counts on while it brakes
        ((told(20),), told(10), 1.4),
        # another one begins at rest: nothing is left to brake
        ((told(20), arrives), slower_line, 0.12),
    ],
)
def test_a_line_may_be_as_fast_as_it_was_until_it_could_have_braked(
    arm, told_before, then, after_s
):
    line(arm, 40)
    arm.status = status(reached=False)
    assert along(arm, 40.0, 0.4) is None
    for each in told_before:
        each(arm)
        assert each is arrives or along(arm, 40.0, 0.1) is None
    then(arm)
    assert along(arm, 40.0, 2.0) == pytest.approx(after_s, abs=0.021)


def test_once_it_has_braked_it_slows_down_from_its_new_speed(arm):
    line(arm, 40)
    arm.status = status(reached=False)
    along(arm, 40.0, 0.4)
    arm.authority.told_percent(10)
    along(arm, 10.0, 1.5)
    arm.authority.told_percent(5)
    assert along(arm, 40.0, 1.0) == pytest.approx(0.12, abs=0.021)


# Whether it may be set ----------------------------------------------------------------------------


def not_confirmed(arm):
    arm.authority.unconfirmed_cell = CELL_NOT_CONFIRMED(name="CELL")


def held_back(arm):
    arm.send()
    arm.wait(0.1)
    arm.authority.told_percent(0)


def failed(arm):
    arm.authority.failed = True


def under_way(arm):
    arm.send(percent=30)
    arm.status = status(reached=False)
    arm.turn(20)


def arrived(arm):
    arm.send(percent=30)
    arm.arrive()


def moves_after_a_silence(arm):
    arm.silent = {"status", "joints"}
    arm.wait(0.6)
    arm.authority.end_command(End.SILENT)
    arm.silent = set()
    arm.move()


@pytest.mark.parametrize(
    ("happens", "percent", "reason"),
    [
        ((), 30, None),
        ((failed,), 0, PART_FAILED),
        ((Arm.other,), 0, OTHER_HOST),
        # what moves may be held back, where none may be set going
        ((not_confirmed,), 0, None),
        ((not_confirmed,), 30, CELL_NOT_CONFIRMED),
        ((held_back,), 0, None),
        ((held_back,), 30, HELD_AT_ZERO),
        ((Arm.meet,), 0, None),
        ((Arm.meet,), 30, MET_MOVING),
        # a motion of ours that went on while nothing was heard may be slowed
        ((under_way, moves_after_a_silence), 29, None),
        ((under_way, moves_after_a_silence), 30, MET_MOVING),
        ((arrived, moves_after_a_silence), 29, MET_MOVING),
        ((under_way, Arm.cancel, moves_after_a_silence), 29, MET_MOVING),
        ((under_way, moves_after_a_silence, Arm.take_over), 29, MET_MOVING),
    ],
)
def test_whether_another_speed_may_be_given(arm, happens, percent, reason):
    for each in happens:
        each(arm)
    arm.look()
    refusal = arm.authority.why_no_speed(percent)
    assert (None if refusal is None else refusal.reason) == reason
