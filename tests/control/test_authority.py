"""Who moves the arm: the table of what begins and ends our command, and what holds it back."""

from __future__ import annotations

import pytest

from armui.arm.limits import JointLimits
from armui.arm.other_hosts import OtherHosts
from armui.control.motion.motion_command import HELD_AT_ZERO, CommandKind, End, Hold, Mover
from armui.control.safety.other_command import OTHER_HOST
from armui.protocol.codes import ArmStatusCode, ControlMode, MoveMode
from tests.control.heard_arm import HERE, NOWHERE, THERE, Arm, status
from tests.moments import now


@pytest.fixture
def arm():
    return Arm()


def test_at_rest_with_nobody_a_step_starts_where_the_arm_is(arm):
    assert arm.authority.mover is Mover.NOBODY
    assert arm.authority.joint_base_deg() == HERE
    assert arm.authority.why_not() is None


def test_a_command_is_ours_under_way_and_when_it_has_arrived(arm):
    arm.send()
    arm.wait(0.1)
    assert now(arm.authority.mover) is Mover.OURS
    assert arm.authority.joint_base_deg() == THERE
    arm.arrive()
    assert now(arm.authority.mover) is Mover.NOBODY
    assert arm.authority.joint_base_deg() == THERE


@pytest.mark.parametrize(("away_deg", "base"), [(0.49, "target"), (0.51, "measured")])
def test_arrived_is_within_half_a_degree(arm, away_deg, base):
    arm.send()
    place = (THERE[0], THERE[1] - away_deg, *THERE[2:])
    arm.arrive(place)

    assert arm.authority.joint_base_deg() == (THERE if base == "target" else place)


def _stop(arm):
    arm.status = status(arm_status=ArmStatusCode.EMERGENCY_STOP)


def _standby(arm):
    arm.status = status(control_mode=ControlMode.STANDBY)


def _teach(arm):
    arm.status = status(control_mode=ControlMode.TEACHING)


def _disable(arm):
    arm.enabled = False


def _mute_status(arm):
    arm.silent.add("status")


def _mute_joints(arm):
    arm.silent.add("joints")


def _push(arm):
    arm.joints_deg = NOWHERE


def _narrow_limits(arm):
    arm.limits = JointLimits(-90.0, 90.0, 100.0)
    arm.wait(0.1)
    arm.limits = JointLimits(-80.0, 90.0, 100.0)


def _widen_limits(arm):
    arm.limits = JointLimits(-80.0, 90.0, 100.0)
    arm.wait(0.1)
    arm.limits = JointLimits(-90.0, 90.0, 100.0)


ENDS = {
    "another host": (Arm.other, End.OTHER_HOST),
    "stop": (_stop, End.STOPPED),
    "disable": (_disable, End.DISABLED),
    "drag teaching": (_teach, End.TAUGHT),
    "standby, as after a power cycle": (_standby, End.OTHER_MODE),
    "status silent": (_mute_status, End.SILENT),
    "angles silent": (_mute_joints, End.SILENT),
    "pushed away": (_push, End.MOVED_AWAY),
    "narrower limits": (_narrow_limits, End.LIMITS_CHANGED),
    "wider limits": (_widen_limits, End.LIMITS_CHANGED),
    "cancel": (lambda arm: arm.authority.cancelled(arm.now_s), End.CANCELLED),
    "zero": (lambda arm: arm.authority.end_command(End.ZERO_CHANGED), End.ZERO_CHANGED),
    "new connection": (lambda arm: arm.authority.end_command(End.FORGOTTEN), End.FORGOTTEN),
}
"""The table: what ends a command of ours that has arrived, and what it is called."""


@pytest.mark.parametrize("code", [ArmStatusCode.JOINT_STATUS_ABNORMAL, ArmStatusCode.COLLISION])
def test_after_a_fault_however_short_a_step_starts_from_the_measured_angles(arm, code):
    """A driver's fault stands in 0x2A1 before the slow feedback of the driver tells of it."""
    arm.send()
    arm.status = status(reached=False, arm_status=code)
    arm.look()
    arm.status = status(reached=False)
    arm.wait(0.1)
    assert arm.authority.under_way  # for all that is known: the program's end still ends it
    assert arm.authority.joint_base_deg() == HERE
    arm.status = status()
    arm.wait(0.7)
    assert arm.authority.joint_base_deg() == HERE


@pytest.mark.parametrize("what", ENDS)
def test_the_table_of_what_ends_our_target(arm, what):
    does, end = ENDS[what]
    command = arm.send()
    arm.arrive()
    assert arm.authority.command is not None

    does(arm)
    arm.wait(0.7)

    assert arm.authority.command is None
    assert arm.authority.ended is end
    assert arm.authority.number > command.number


@pytest.mark.parametrize("what", [each for each in ENDS if each != "pushed away"])
def test_the_same_while_it_is_under_way(arm, what):
    does, end = ENDS[what]
    arm.send()
    arm.status = status(reached=False)
    for k in range(25):
        arm.joints_deg = (0.5 * k, *HERE[1:])
        arm.wait(0.02)
    assert arm.authority.under_way

    does(arm)
    for k in range(35):
        arm.joints_deg = (12.5 + 0.5 * k, *HERE[1:])
        arm.wait(0.02)

    assert arm.authority.ended is end


def test_an_arm_that_sets_out_at_a_cancel_has_not_heeded_it(arm):
    arm.send()
    arm.status = status(reached=False)
    arm.authority.cancelled(arm.now_s)
    for k in range(60):
        arm.joints_deg = (0.5 * k, *HERE[1:])
        arm.wait(0.02)
    assert arm.authority.cancel_unheeded


def test_a_moving_arm_is_measured_by_fresh_angles_or_not_at_all(arm):
    for k in range(10):
        arm.joints_deg = (1.0 * k, *HERE[1:])
        arm.wait(0.02)
    assert arm.authority.joint_base_deg() == arm.joints_deg
    arm.silent.add("joints")
    arm.wait(0.14)
    assert arm.authority.joint_base_deg() is None


def test_another_host_is_remembered_over_a_new_connection(arm):
    arm.other()
    arm.wait(0.2)
    arm.authority.end_command(End.FORGOTTEN)
    arm.hosts = OtherHosts()
    arm.wait(0.5)
    assert arm.authority.why_not().reason == OTHER_HOST
    arm.wait(1.6)
    assert arm.authority.why_not() is None


def test_a_motion_that_came_to_rest_short_of_its_target_is_over(arm):
    arm.send()
    arm.status = status(reached=False)
    arm.joints_deg = NOWHERE
    arm.wait(0.7)

    assert arm.authority.command is None
    assert arm.authority.joint_base_deg() == NOWHERE


def test_a_pose_is_kept_until_the_arm_is_led_from_where_it_came_to_rest(arm):
    arm.authority.begin(
        CommandKind.POSE,
        now_s=arm.now_s,
        move_mode=MoveMode.MOVE_L,
        speed_percent=30,
        tool=(object(),),
    )
    arm.arrive(THERE)
    assert arm.authority.tool_base() is not None
    assert arm.authority.joint_base_deg() == THERE
    arm.joints_deg = NOWHERE
    arm.wait(0.7)
    assert arm.authority.tool_base() is None


def test_frames_of_a_command_that_is_over_are_outdated(arm):
    first = arm.send()
    second = arm.send(NOWHERE)
    assert second.number > first.number
    assert not arm.authority.is_current(first)
    assert arm.authority.extend(first, HERE, arm.now_s) is None
    assert arm.authority.extend(second, HERE, arm.now_s).joints_deg == HERE


# Other hosts --------------------------------------------------------------------------------------


def test_another_host_counts_for_two_seconds_and_until_the_arm_rests(arm):
    arm.other()
    arm.wait(1.9)
    assert arm.authority.why_not().reason == OTHER_HOST
    assert arm.authority.mover is Mover.OTHER_HOST
    for k in range(20):
        arm.joints_deg = (1.0 * k, *HERE[1:])
        arm.wait(0.02)
    assert arm.authority.why_not().reason == OTHER_HOST
    arm.wait(0.4)
    assert arm.authority.why_not() is None


@pytest.mark.parametrize(("after_s", "possible"), [(0.4, False), (0.6, True)])
def test_it_may_be_taken_over_half_a_second_later(arm, after_s, possible):
    arm.other()
    arm.wait(after_s)
    assert (arm.authority.other.take_over() is None) is possible
    arm.look()
    assert (arm.authority.why_not() is None) is possible


def test_after_a_take_over_its_next_frame_counts_again(arm):
    arm.other()
    arm.wait(0.6)
    assert arm.authority.other.take_over() is None
    arm.wait(0.1)
    arm.other()
    arm.wait(0.1)
    assert arm.authority.why_not().reason == OTHER_HOST


@pytest.mark.parametrize(("offsets", "counts"), [((0,), False), ((0, 0x10, 0x20), True)])
def test_frames_for_another_arm_count_only_while_ours_is_not_known(arm, offsets, counts):
    arm.offsets = offsets
    arm.other(0x165)
    arm.wait(0.1)
    assert (arm.authority.why_not() is not None) is counts


# Motions held back --------------------------------------------------------------------------------


def test_zero_percent_holds_back_what_is_under_way_and_nothing_else(arm):
    arm.authority.told_percent(0)
    assert arm.authority.holds == frozenset()
    arm.authority.told_percent(30)
    arm.send()
    arm.wait(0.1)
    arm.authority.told_percent(0)
    assert arm.authority.holds == {Hold.SPEED_ZERO}
    assert arm.authority.why_not().reason == HELD_AT_ZERO
    assert arm.authority.mover is Mover.OURS


def test_a_motion_that_had_arrived_is_not_held_back_at_zero_percent(arm):
    arm.send()
    arm.joints_deg = THERE
    arm.wait(0.1)
    arm.authority.told_percent(0)
    assert arm.authority.holds
    arm.wait(0.6)
    assert not arm.authority.holds


@pytest.mark.parametrize(
    ("does", "held"),
    [
        (_stop, False),
        (_disable, False),
        (_standby, False),
        (Arm.other, False),
        (_mute_status, True),
        (_mute_joints, True),
        (lambda arm: arm.authority.cancelled(arm.now_s), False),
        (lambda arm: arm.authority.went_on(arm.now_s), False),
        (lambda arm: arm.authority.end_command(End.FORGOTTEN), False),
        (lambda arm: arm.authority.told_percent(50), True),
    ],
    ids=[
        *("stop", "disable", "standby", "another host", "status silent", "angles silent"),
        *("cancel", "continue", "new connection", "another speed"),
    ],
)
def test_the_table_of_what_ends_a_hold(arm, does, held):
    arm.send()
    arm.wait(0.1)
    arm.authority.paused()
    does(arm)
    arm.wait(0.7)
    assert (Hold.PAUSE in arm.authority.holds) is held


# Cancel -------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("rests", "unheeded"), [(True, False), (False, True)])
def test_a_cancel_is_followed_until_the_arm_rests(arm, rests, unheeded):
    arm.send()
    arm.status = status(reached=False)
    arm.authority.cancelled(arm.now_s)
    for k in range(60):
        if not rests:
            arm.joints_deg = (0.5 * k, *HERE[1:])
        arm.wait(0.02)
    assert arm.authority.cancel_unheeded is unheeded
    arm.wait(0.5)
    assert not arm.authority.cancel_unheeded
