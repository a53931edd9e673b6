"""What is held back, what a cancel leaves, and what else ends our target."""

from __future__ import annotations

import pytest

from armui.arm.limits import JointLimits
from armui.arm.other_hosts import OtherHosts
from armui.control.authority import Authority
from armui.control.motion.motion_command import End, Hold, Mover
from armui.control.safety.other_command import OTHER_HOST, OTHER_MODE
from armui.protocol.codes import ArmStatusCode, ControlMode, MoveMode
from tests.control.heard_arm import HERE, THERE, Arm, status
from tests.moments import now

MOVING = {"reached": False}
REPLAYS = ArmStatusCode.TEACHING_RUNNING


@pytest.fixture
def arm():
    return Arm()


# Speed --------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("told", "given", "asked", "lowers"),
    [
        (5, 30, 29, True),
        (30, 5, 29, True),
        (30, 5, 30, False),
        (30, None, 29, True),
        (30, None, 30, False),
        (0, 0, 0, False),
        # generation 2 tells none
        (None, None, 30, True),
        (None, 30, 29, True),
        (None, 30, 30, False),
        (None, 5, 30, False),
    ],
)
def test_a_percentage_below_the_highest_the_arm_may_have(arm, told, given, asked, lowers):
    arm.status = status(speed_percent=told)
    arm.look()
    arm.authority.arm_percent = given
    assert arm.authority.lowers_speed(asked) is lowers


def test_another_percentage_is_that_of_the_command_under_way(arm):
    arm.send()
    arm.authority.told_percent(1)
    assert arm.authority.arm_percent == arm.authority.command.speed_percent == 1


def test_zero_percent_is_none_to_compare_a_motion_with(arm):
    arm.send()
    arm.wait(0.02)
    arm.authority.told_percent(0)
    assert arm.authority.arm_percent == 0
    assert arm.authority.command.speed_percent == 30


def test_a_motion_of_nobody_known_is_held_back_at_zero_percent_too(arm):
    arm.status = status(**MOVING)
    arm.turn(5)
    arm.authority.told_percent(0)
    assert arm.authority.holds == {Hold.SPEED_ZERO}


@pytest.mark.parametrize(
    ("reached", "turns", "percent"), [(True, 5, 0), (False, 0, 0), (False, 5, 1)]
)
def test_nothing_is_held_back_that_does_not_move_or_not_at_zero(arm, reached, turns, percent):
    arm.status = status(reached=reached)
    arm.wait(0.1)
    arm.turn(turns)
    arm.authority.told_percent(percent)
    assert arm.authority.holds == frozenset()


# What is held back --------------------------------------------------------------------------------


def held_at_zero(arm):
    arm.send()
    arm.status = status(**MOVING)
    arm.turn(20)
    arm.authority.told_percent(0)
    arm.wait(1.0)


def test_a_motion_stays_held_back_as_long_as_it_takes(arm):
    held_at_zero(arm)
    arm.wait(5.0)
    assert arm.authority.holds == {Hold.SPEED_ZERO}
    assert arm.authority.held_target_deg == THERE


def test_one_that_had_arrived_is_held_back_no_more_but_a_pause_stays(arm):
    held_at_zero(arm)
    arm.authority.paused()
    arm.status = status()
    arm.wait(0.1)
    assert arm.authority.holds == {Hold.PAUSE}


@pytest.mark.parametrize(("after_s", "held"), [(0.28, True), (0.34, False)])
def test_that_it_has_arrived_must_be_said_after_the_zero(arm, after_s, held):
    arm.send()
    arm.wait(0.1)
    arm.authority.told_percent(0)
    arm.wait(after_s)
    assert bool(arm.authority.holds) is held


@pytest.mark.parametrize("late", ["status", "joints"])
def test_what_is_heard_late_does_not_say_that_it_has_arrived(arm, late):
    arm.send()
    arm.wait(0.1)
    arm.authority.told_percent(0)
    arm.wait(0.02)
    arm.silent = {late}
    arm.wait(0.36)
    assert now(arm.authority.holds)
    arm.silent = set()
    arm.wait(0.4)
    assert not arm.authority.holds


def test_an_old_status_ends_no_hold(arm):
    held_at_zero(arm)
    arm.silent.add("status")
    arm._status = type(arm._status)(status(control_mode=ControlMode.STANDBY), arm.now_s)
    arm.now_s += 0.6
    arm.look()
    assert arm.authority.holds == {Hold.SPEED_ZERO}


def test_before_the_status_is_heard_no_hold_ends(arm):
    arm.authority.paused()
    arm.silent.add("status")
    arm._status = None
    arm.look()
    assert arm.authority.holds == {Hold.PAUSE}


def test_what_goes_on_is_under_way_again(arm):
    held_at_zero(arm)
    arm.status = status()
    arm.authority.went_on(arm.now_s)
    assert arm.authority.holds == frozenset()
    assert arm.authority.command.sent_s == arm.now_s
    arm.wait(0.1)
    assert arm.authority.under_way


def test_what_goes_on_may_be_of_nobody_known(arm):
    arm.authority.paused()
    arm.authority.went_on(arm.now_s)
    assert arm.authority.holds == frozenset()
    assert arm.authority.command is None


CLEARS = {End.STOPPED, End.DISABLED, End.FORGOTTEN}


@pytest.mark.parametrize("reason", End)
def test_which_ends_leave_nothing_held_back(arm, reason):
    arm.send()
    arm.authority.paused()
    arm.authority.end_command(reason)
    assert bool(arm.authority.holds) is (reason not in CLEARS)
    assert arm.authority.ended is reason
    assert (arm.authority.mover is Mover.UNKNOWN) is (reason is End.FORGOTTEN)


def test_over_a_new_connection_everything_is_heard_anew(arm):
    arm.other(0x151, bytes.fromhex("01 04 00 AD 00 00 00 00"))
    arm.status = status(move_mode=MoveMode.MOVE_M)
    arm.wait(0.1)
    assert arm.authority.why_not().reason == OTHER_MODE
    assert arm.authority.at_rest
    arm.authority.end_command(End.FORGOTTEN)
    assert not arm.authority.at_rest
    assert arm.authority.measured_deg() is None
    assert arm.authority.mode_in_force() is None
    assert arm.authority.other.why_not().reason == OTHER_HOST


# Cancel -------------------------------------------------------------------------------------------


def cancel_a_motion(arm):
    arm.send()
    arm.status = status(**MOVING)
    arm.turn(10)
    arm.authority.paused()
    arm.authority.cancelled(arm.now_s)


def test_a_cancel_is_unheeded_after_a_second_in_which_the_arm_did_not_rest(arm):
    cancel_a_motion(arm)
    assert arm.authority.holds == frozenset()
    arm.turn(49)
    assert not arm.authority.cancel_unheeded
    arm.turn(2)
    assert arm.authority.cancel_unheeded


def test_rest_of_before_the_cancel_is_none(arm):
    arm.send()
    arm.status = status(**MOVING)
    arm.authority.cancelled(arm.now_s)
    arm.wait(0.36)
    arm.turn(60)
    assert arm.authority.cancel_unheeded


def test_rest_four_tenths_of_a_second_after_the_cancel_is_its_doing(arm):
    arm.authority.cancelled(arm.now_s)
    arm.wait(0.42)
    arm.turn(60)
    assert not arm.authority.cancel_unheeded


ENDS_A_CANCEL = {
    "another host": Arm.other,
    "stop": lambda arm: arm.authority.end_command(End.STOPPED),
    "disable": lambda arm: arm.authority.end_command(End.DISABLED),
    "new connection": lambda arm: arm.authority.end_command(End.FORGOTTEN),
    "a motion": Arm.send,
    "another cancel": lambda arm: arm.authority.cancelled(arm.now_s),
}


@pytest.mark.parametrize("when", ["before", "after"])
@pytest.mark.parametrize("what", ENDS_A_CANCEL)
def test_what_ends_the_following_of_a_cancel(arm, what, when):
    cancel_a_motion(arm)
    arm.turn(60 if when == "after" else 30)
    assert arm.authority.cancel_unheeded is (when == "after")
    ENDS_A_CANCEL[what](arm)
    arm.turn(1)
    assert not arm.authority.cancel_unheeded
    arm.turn(40)
    assert not arm.authority.cancel_unheeded


@pytest.mark.parametrize("reason", [End.ZERO_CHANGED, End.NOT_SENT])
def test_other_ends_leave_a_cancel_to_be_followed(arm, reason):
    cancel_a_motion(arm)
    arm.authority.end_command(reason)
    arm.turn(55)
    assert arm.authority.cancel_unheeded


@pytest.mark.parametrize(
    ("says", "unheeded"),
    [
        ({}, True),
        ({"arm_status": ArmStatusCode.COLLISION}, True),
        ({"arm_status": ArmStatusCode.EMERGENCY_STOP}, False),
        ({"control_mode": ControlMode.TEACHING}, False),  # a hand leads it
        ({"control_mode": ControlMode.TEACHING, "arm_status": REPLAYS}, True),
    ],
)
def test_a_cancel_has_nothing_left_to_end_where_a_stop_or_a_hand_rules(arm, says, unheeded):
    cancel_a_motion(arm)
    arm.status = status(**MOVING, **says)
    arm.turn(60)
    assert arm.authority.cancel_unheeded is unheeded


@pytest.mark.parametrize(("driver_deg_s", "due"), [(5.0, True), (0.5, False)])
def test_a_cancel_is_told_once_more_if_the_joints_turn_when_they_could_have_braked(
    arm, driver_deg_s, due
):
    authority = Authority()
    assert not authority.cancel_is_due(1.0)
    authority.cancelled(0.0)
    assert not authority.cancel_is_due(1.0)  # nothing is heard

    assert not arm.authority.cancel_is_due(arm.now_s)
    for _ in range(2):
        cancel_a_motion(arm)
        arm.driver_deg_s = driver_deg_s
        asked = []
        for _ in range(20):
            arm.turn(1)
            asked.append(arm.authority.cancel_is_due(arm.now_s))
        assert asked == [False] * 14 + [due] + [False] * 5
    arm.send()
    arm.turn(20)
    assert not arm.authority.cancel_is_due(arm.now_s)


# A replay of the arm's own ------------------------------------------------------------------------


def teaches(arm, arm_status=ArmStatusCode.NORMAL):
    arm.status = status(control_mode=ControlMode.TEACHING, arm_status=arm_status)


def replay_told(arm):
    teaches(arm)
    arm.look()
    arm.authority.replay_told(arm.now_s)


@pytest.mark.parametrize(("after_s", "ours"), [(1.48, True), (1.54, False)])
def test_a_replay_that_was_told_shows_within_a_second_and_a_half(arm, after_s, ours):
    replay_told(arm)
    arm.wait(after_s)
    assert arm.authority.may_be_ours is ours


def test_a_replay_that_shows_is_ours_until_it_shows_no_more(arm):
    replay_told(arm)
    for code in (REPLAYS, ArmStatusCode.TEACHING_PAUSED, REPLAYS):
        teaches(arm, code)
        arm.wait(1.0)
        assert now(arm.authority.may_be_ours)
    teaches(arm)
    arm.look()
    assert not arm.authority.may_be_ours


ENDS_A_REPLAY = [does for what, does in ENDS_A_CANCEL.items() if what != "a motion"]


@pytest.mark.parametrize("does", ENDS_A_REPLAY)
def test_what_ends_the_waiting_for_a_replay(arm, does):
    replay_told(arm)
    does(arm)
    arm.look()
    assert not arm.authority.may_be_ours


# What ends our target -----------------------------------------------------------------------------


def test_frames_of_another_host_of_before_our_command_do_not_end_it(arm):
    arm.other()
    arm.wait(0.6)
    assert arm.authority.other.take_over() is None
    arm.send()
    arm.wait(0.1)
    assert arm.authority.command is not None


def test_a_frame_of_another_host_at_the_same_moment_ends_it(arm):
    arm.send()
    arm.other()
    arm.look()
    assert arm.authority.ended is End.OTHER_HOST


def test_a_step_back_in_the_list_of_hosts_is_no_new_frame(arm):
    arm.other()
    arm.wait(2.5)
    arm.send()
    arm.hosts = OtherHosts()
    arm.wait(0.1)
    assert arm.authority.command is not None


@pytest.mark.parametrize(("after_s", "ends"), [(0.28, False), (0.34, True)])
def test_the_arm_has_three_tenths_of_a_second_to_leave_standby(arm, after_s, ends):
    arm.send()
    arm.status = status(control_mode=ControlMode.STANDBY)
    arm.wait(after_s)
    assert (arm.authority.command is None) is ends


@pytest.mark.parametrize("late", ["status", "joints"])
def test_what_is_heard_late_does_not_say_that_it_has_not_left_standby(arm, late):
    arm.send(HERE)
    arm.status = status(control_mode=ControlMode.STANDBY)
    arm.wait(0.02)
    arm.silent = {late}
    arm.wait(0.36)
    assert now(arm.authority.command) is not None
    arm.silent = set()
    arm.wait(0.4)
    assert arm.authority.ended is End.OTHER_MODE


def test_angles_that_came_late_do_not_show_that_it_rests_elsewhere(arm):
    arm.send()
    arm.status = status(**MOVING)
    arm.turn(20)
    arm.silent = {"joints"}
    arm.status = status()
    arm.now_s += 0.1
    arm.look()
    assert now(arm.authority.command) is not None
    arm.silent = set()
    arm.joints_deg = THERE
    arm.wait(0.7)
    assert arm.authority.joint_base_deg() == THERE
    assert arm.authority.command is not None


@pytest.mark.parametrize("mode", set(ControlMode) - {ControlMode.CAN_CONTROL})
def test_outside_can_control_there_is_no_command_of_ours(arm, mode):
    arm.send(HERE)
    arm.authority.paused()
    arm.status = status(control_mode=mode)
    arm.wait(0.4)
    led = mode in {ControlMode.TEACHING, ControlMode.LINKED_TEACHING_INPUT}
    assert arm.authority.ended is (End.TAUGHT if led else End.OTHER_MODE)
    assert arm.authority.holds == frozenset()


@pytest.mark.parametrize("code", [ArmStatusCode.NO_SOLUTION, ArmStatusCode.COLLISION])
def test_other_faults_than_a_stop_leave_our_target(arm, code):
    arm.send(HERE)
    arm.authority.paused()
    arm.status = status(arm_status=code)
    arm.wait(0.5)
    assert arm.authority.command is not None
    assert arm.authority.holds


def test_while_it_is_held_back_the_arm_may_stand_elsewhere(arm):
    held_at_zero(arm)
    assert arm.joints_deg != THERE
    assert arm.authority.command is not None


@pytest.mark.parametrize("index", range(6))
@pytest.mark.parametrize("direction", [1, -1])
def test_each_joint_must_be_where_it_was_sent(arm, index, direction):
    arm.send(HERE)
    place = list(HERE)
    place[index] += direction * 0.51
    arm.joints_deg = tuple(place)
    arm.wait(0.4)
    assert arm.authority.ended is End.MOVED_AWAY


def test_exactly_half_a_degree_away_it_has_arrived(arm):
    arm.send(HERE)
    arm.joints_deg = (0.5, *HERE[1:])
    arm.wait(0.7)
    assert arm.authority.joint_base_deg() == HERE


@pytest.mark.parametrize("before", [None, JointLimits(-90.0, 90.0, 100.0)])
def test_limits_that_are_read_again_as_they_were_end_nothing(arm, before):
    limits = JointLimits(-90.0, 90.0, 100.0)
    arm.send(HERE)
    arm.limits = before
    arm.wait(0.1)
    arm.limits = limits
    arm.wait(0.1)
    arm.limits = None
    arm.wait(0.1)
    assert arm.authority.command is not None


def test_limits_that_changed_before_our_command_do_not_end_it(arm):
    arm.send(HERE)
    arm.limits = JointLimits(-90.0, 90.0, 100.0)
    arm.wait(0.1)
    arm.authority.cancelled(arm.now_s)
    arm.send(HERE)
    arm.limits = JointLimits(-80.0, 90.0, 100.0)
    arm.wait(0.1)
    assert arm.authority.command is not None
