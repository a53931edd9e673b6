"""What the authority answers to those who ask before they move the arm, and tell what they sent."""

from __future__ import annotations

import pytest

from armui.arm.limits import JointLimits
from armui.control.authority import MET_MOVING, Authority
from armui.control.link.link_state import NOT_CONNECTED
from armui.control.motion.motion_command import HELD_AT_ZERO, PLAN_PAUSED, CommandKind, End, Mover
from armui.control.safety.feedback_freshness import FEEDBACK_SILENT
from armui.control.safety.interlocks import JOINTS_UNKNOWN
from armui.control.safety.other_command import NOBODY_ELSE, OTHER_HOST
from armui.protocol.codes import ControlMode, MoveMode
from tests.control.heard_arm import HERE, NOWHERE, THERE, Arm, status
from tests.moments import now

LEADER = (0x151, 0x155, 0x156, 0x157, 0x159)
TOOL = (object(),)
MOVING = {"reached": False}


@pytest.fixture
def arm():
    return Arm()


def lead(arm):
    """A leader arm moves it for a tenth of a second."""
    for k in range(20):
        for each in LEADER:
            arm.hosts.note(each, bytes(8), arm.now_s + 0.005 * k)
    arm.now_s += 0.1


# Who moves the arm --------------------------------------------------------------------------------


def offline(arm):
    arm.online = False


def silent(arm):
    arm.silent.add("joints")
    arm.wait(0.6)


def limp(arm):
    arm.enabled = False


def led_by_hand(arm):
    arm.status = status(control_mode=ControlMode.TEACHING)


def motors_unknown(arm):
    arm.silent.add("drivers")


def pushed(arm):
    arm.turn(3)


def held_back(arm):
    arm.send()
    arm.arrive()
    arm.authority.paused()


MOVERS = {
    "nobody": ((), Mover.NOBODY),
    "offline": ((offline,), Mover.UNKNOWN),
    "silent": ((silent,), Mover.UNKNOWN),
    "limp": ((limp,), Mover.GRAVITY),
    "motors not heard": ((motors_unknown,), Mover.UNKNOWN),
    "hand": ((led_by_hand,), Mover.HAND),
    "limp in drag teaching": ((led_by_hand, limp), Mover.GRAVITY),
    "other host": ((Arm.other,), Mover.OTHER_HOST),
    "leader": ((lead,), Mover.LEADER),
    "other host while a hand leads": ((Arm.other, led_by_hand), Mover.HAND),
    "ours": ((Arm.send,), Mover.OURS),
    "other host after ours": ((Arm.send, Arm.other), Mover.OTHER_HOST),
    "ours held back": ((held_back,), Mover.OURS),
    "it moves and nobody knows why": ((pushed,), Mover.UNKNOWN),
}


@pytest.mark.parametrize("what", MOVERS)
def test_who_moves_the_arm(arm, what):
    happens, mover = MOVERS[what]
    for each in happens:
        each(arm)
    arm.wait(0.02)
    assert arm.authority.mover is mover


def test_before_anything_is_heard_nothing_is_known():
    authority = Authority()
    assert authority.mover is Mover.UNKNOWN
    assert authority.why_silent().reason == authority.why_not().reason == NOT_CONNECTED
    assert authority.joint_base_deg() is None
    assert authority.tool_base() is None
    assert authority.mode_in_force() is None
    assert authority.lowers_speed(0)
    assert not authority.under_way
    assert not authority.at_rest
    assert not authority.cancel_unheeded
    assert authority.holds == frozenset()
    authority.told_percent(0)
    assert authority.holds == frozenset()
    authority.paused()
    assert now(authority.why_held()) == PLAN_PAUSED()


def test_before_anything_is_heard_a_command_is_not_seen_to_be_under_way():
    authority = Authority()
    authority.begin(CommandKind.JOINTS, now_s=1.0, move_mode=MoveMode.MOVE_J, speed_percent=1)
    assert not authority.under_way
    assert authority.mover is Mover.UNKNOWN


def test_the_first_reason_against_a_motion(arm):
    arm.authority.told_percent(30)
    arm.send()
    arm.wait(0.1)
    arm.authority.told_percent(0)
    assert arm.authority.why_not().reason == HELD_AT_ZERO
    arm.authority.paused()
    assert arm.authority.why_not().reason == PLAN_PAUSED
    arm.other()
    arm.look()
    assert arm.authority.why_not().reason == OTHER_HOST
    silent(arm)
    assert arm.authority.why_not().reason == FEEDBACK_SILENT


# What somebody else may have left in the arm ------------------------------------------------------


def rests(arm):
    arm.wait(0.5)


def arrives(arm):
    arm.status = status()
    arm.look()


def paused(arm):
    arm.authority.paused()


def goes_on(arm):
    arm.authority.went_on(arm.now_s)


def nothing_to_take_over(arm):
    assert arm.authority.take_over().reason == NOBODY_ELSE


def ends(reason):
    return lambda arm: arm.authority.end_command(reason)


def other_host_heard_late(arm):
    """What it sent before our command is read after it: it does not end that."""
    arm.other()
    arm.now_s += 0.01
    arm.send()
    arm.status = status(**MOVING)
    arm.turn(30)
    assert arm.authority.take_over() is None


another_arm, another_connection = ends(End.SILENT), ends(End.FORGOTTEN)


@pytest.mark.parametrize(
    ("happens", "refused", "may_hold", "seems"),
    [
        ((), False, True, True),
        # it moved when it was met, until it is seen to have ended, or is ruled from here
        ((Arm.meet,), True, True, True),
        ((Arm.meet, nothing_to_take_over), True, True, True),
        ((Arm.meet, rests), False, True, True),
        ((Arm.meet, arrives), False, True, True),
        ((Arm.meet, Arm.take_over), False, True, True),
        ((Arm.meet, paused), False, True, True),
        ((Arm.meet, goes_on), False, False, False),
        ((Arm.meet, Arm.cancel), False, False, False),
        ((Arm.meet, Arm.send), False, False, False),
        ((Arm.meet, Arm.send, ends(End.STOPPED)), False, False, False),
        ((Arm.meet, Arm.send, ends(End.NOT_SENT)), False, False, False),
        ((other_host_heard_late,), False, False, False),
        # in a silence another host may have been there
        ((Arm.send, another_arm), True, True, True),
        ((Arm.cancel, another_arm), True, True, False),
        ((Arm.cancel, another_arm, Arm.take_over), False, True, True),
        ((Arm.cancel, Arm.send, another_arm), True, True, True),
        ((Arm.cancel, another_connection), True, True, True),
    ],
)
def test_whether_an_arm_short_of_its_target_may_go_on_to_one_of_somebody_else(
    arm, happens, refused, may_hold, seems
):
    for each in happens:
        each(arm)
    arm.move()
    authority = arm.authority
    assert authority.moves
    assert authority.why_not_ours() == (MET_MOVING() if refused else None)
    assert (authority.may_hold_another, authority.seems_to_hold_another) == (may_hold, seems)


def test_at_its_target_it_holds_nothing_and_unheard_it_may(arm):
    assert arm.authority.may_hold_another is arm.authority.seems_to_hold_another is False
    assert Authority().may_hold_another is Authority().seems_to_hold_another is True
    arm.silent.add("status")
    arm._status = None
    arm.look()
    assert arm.authority.may_hold_another is True


def replay_told(arm):
    arm.authority.replay_told(arm.now_s)


def limits_change(arm):
    for least_deg in (-90.0, -80.0):
        arm.limits = JointLimits(least_deg, 90.0, 100.0)
        arm.look()


@pytest.mark.parametrize(
    ("happens", "ours", "ending"),
    [
        ((), False, False),
        ((Arm.send,), True, False),
        ((held_back,), True, False),
        ((replay_told,), True, False),
        ((Arm.move,), True, False),
        ((Arm.send, Arm.move, limits_change), True, False),
        ((Arm.other, Arm.move), False, False),
        ((led_by_hand, pushed), False, False),
        ((Arm.send, Arm.move, Arm.cancel), False, True),
        ((Arm.send, Arm.move, Arm.cancel, rests), False, False),
    ],
)
def test_whether_what_moves_may_be_ours_to_end(arm, happens, ours, ending):
    for each in happens:
        each(arm)
    arm.look()
    assert arm.authority.may_be_ours is ours
    assert arm.authority.is_ending is ending


# Where the next motion starts ---------------------------------------------------------------------


def test_a_pose_under_way_names_no_angles_to_start_from(arm):
    arm.send(None, CommandKind.POSE, tool=TOOL)
    arm.status = status(**MOVING)
    arm.turn(5)
    assert arm.authority.command.joints_deg is None
    assert arm.authority.joint_base_deg() == arm.joints_deg
    assert arm.authority.tool_base() is TOOL


def test_a_motion_held_back_is_told_with_its_target(arm):
    assert arm.authority.held_target_deg is None
    arm.send()
    arm.wait(0.1)
    assert arm.authority.held_target_deg is None
    arm.authority.paused()
    assert arm.authority.held_target_deg == THERE


def test_what_is_held_back_by_nobody_knows_which_command_has_no_target(arm):
    arm.authority.paused()
    assert arm.authority.held_target_deg is None
    assert arm.authority.why_held().reason == PLAN_PAUSED


@pytest.mark.parametrize(("age_s", "known"), [(0.04, True), (0.06, False)])
def test_the_angles_of_a_moving_arm_are_known_for_a_twentieth_of_a_second(arm, age_s, known):
    arm.turn(5)
    arm.silent.add("joints")
    arm.now_s = round(arm.now_s, 2)
    arm._joints = tuple(type(each)(each.value, arm.now_s) for each in arm._joints)
    arm.now_s += age_s
    arm.look()
    assert (arm.authority.measured_deg() is not None) is known
    if not known:
        late = FEEDBACK_SILENT(frames="0x2A5, 0x2A6, 0x2A7", seconds=0.05)
        assert arm.authority.why_unmeasured() == late


def test_the_angles_of_a_resting_arm_may_be_older(arm):
    arm.silent.add("joints")
    arm.wait(0.4)
    assert arm.authority.measured_deg() == HERE


def further(arm):
    """The next setpoint of the stream under way."""
    assert arm.authority.extend(arm.authority.command, HERE, arm.now_s) is not None


@pytest.mark.parametrize("gives", [lambda arm: arm.send(HERE), further, goes_on])
def test_but_not_older_than_what_may_have_set_the_arm_going(arm, gives):
    arm.send(HERE)
    arm.wait(0.6)
    arm.silent.add("joints")
    arm.wait(0.2)
    assert arm.authority.measured_deg() == HERE
    gives(arm)
    arm.look()
    assert arm.authority.measured_deg() is None
    arm.silent.clear()
    arm.look()
    arm.silent.add("joints")
    arm.wait(0.2)
    assert arm.authority.measured_deg() == HERE


def test_angles_that_were_never_heard_are_none(arm):
    arm.turn(3)
    arm.silent.add("joints")
    arm._joints = (*arm._joints[:5], None)
    arm.look()
    assert arm.authority.measured_deg() is None
    assert arm.authority.why_unmeasured() == JOINTS_UNKNOWN()


# Modes --------------------------------------------------------------------------------------------


@pytest.mark.parametrize("mode", [MoveMode.MOVE_L, MoveMode.MOVE_P])
def test_a_mode_word_is_in_force_before_the_arm_has_shown_it(arm, mode):
    assert arm.authority.mode_in_force() == (ControlMode.CAN_CONTROL, MoveMode.MOVE_J)
    arm.status = status(control_mode=ControlMode.STANDBY)
    arm.look()
    assert arm.authority.mode_in_force() == (ControlMode.STANDBY, MoveMode.MOVE_J)
    assert now(arm.authority.mode_unproven) is False
    arm.send(mode=mode)
    arm.wait(0.04)
    assert arm.authority.mode_in_force() == (ControlMode.CAN_CONTROL, mode)
    assert now(arm.authority.mode_unproven) is True
    arm.wait(0.02)
    assert now(arm.authority.mode_unproven) is False
    assert arm.authority.mode_in_force() == (ControlMode.STANDBY, MoveMode.MOVE_J)


def test_a_status_of_exactly_a_twentieth_of_a_second_later_shows_it(arm):
    arm.now_s = 2.0
    arm.look()
    arm.send(mode=MoveMode.MOVE_L)
    arm.now_s = 2.0 + 0.05
    arm.look()
    assert arm.authority.mode_in_force() == (ControlMode.CAN_CONTROL, MoveMode.MOVE_J)


@pytest.mark.parametrize("mode", MoveMode)
def test_only_planned_modes_may_be_asked_for_again(arm, mode):
    arm.status = status(move_mode=mode)
    arm.look()
    planned = {MoveMode.MOVE_P, MoveMode.MOVE_J, MoveMode.MOVE_L, MoveMode.MOVE_C}
    expected = (ControlMode.CAN_CONTROL, mode) if mode in planned else None
    assert arm.authority.mode_in_force() == expected


@pytest.mark.parametrize("mode", ControlMode)
def test_no_mode_word_while_somebody_else_has_the_command(arm, mode):
    arm.status = status(control_mode=mode)
    arm.look()
    ours = mode in {ControlMode.STANDBY, ControlMode.CAN_CONTROL}
    assert arm.authority.mode_in_force() == ((mode, MoveMode.MOVE_J) if ours else None)


def test_modes_are_unknown_before_the_status_is_heard(arm):
    arm.silent.add("status")
    arm._status = None
    arm.look()
    assert arm.authority.mode_in_force() is None
    assert arm.authority.lowers_speed(100)
    arm.authority.arm_percent = 30
    assert not arm.authority.lowers_speed(30)
    arm.send()
    assert arm.authority.mode_unproven


@pytest.mark.parametrize("how", ["another host", "another connection"])
def test_what_we_sent_last_is_not_in_force_any_more(arm, how):
    arm.send(mode=MoveMode.MOVE_L)
    assert arm.authority.arm_percent == 30
    if how == "another host":
        arm.other()
    else:
        arm.authority.end_command(End.FORGOTTEN)
    arm.look()
    assert arm.authority.arm_percent is None
    assert arm.authority.mode_in_force() == (ControlMode.CAN_CONTROL, MoveMode.MOVE_J)


# What is sent -------------------------------------------------------------------------------------


def test_a_command_is_kept_as_it_was_sent(arm):
    command = arm.send(list(THERE), CommandKind.RUN, 42, tool=TOOL)
    assert command is arm.authority.command
    assert (command.kind, command.sent_s, command.speed_percent) == (
        CommandKind.RUN,
        arm.now_s,
        42,
    )
    assert (command.joints_deg, command.tool) == (THERE, TOOL)
    assert arm.authority.number == command.number > 0  # 0 is none
    assert arm.authority.is_current(command)
    assert arm.authority.arm_percent == 42
    assert arm.authority.ended is None
    assert not command.leads_away


def test_the_next_takes_its_place(arm):
    first = arm.send()
    second = arm.send()
    assert arm.authority.ended is End.REPLACED
    assert not arm.authority.is_current(first)
    arm.authority.cancelled(arm.now_s)
    assert arm.authority.over == [(first, End.REPLACED), (second, End.CANCELLED)]


@pytest.mark.parametrize("does", [Arm.send, Arm.cancel, ends(End.TOOL_CHANGED), another_connection])
def test_a_check_begun_before_any_command_or_end_is_void(arm, does):
    for _ in range(2):
        revision = arm.authority.revision
        arm.wait(0.1)
        assert arm.authority.revision == revision
        does(arm)
        assert arm.authority.revision > revision


def test_a_command_that_has_ended_is_none_to_go_on_with(arm):
    command = arm.send()
    arm.authority.end_command(End.NOT_SENT)
    assert not arm.authority.is_current(command)
    assert arm.authority.extend(command, NOWHERE, arm.now_s) is None
    assert arm.authority.number > command.number
    assert arm.authority.tool_base() is None


def test_what_ended_first_is_what_ended_it(arm):
    arm.send()
    arm.authority.end_command(End.STOPPED)
    number = arm.authority.number
    arm.authority.end_command(End.ZERO_CHANGED)
    assert arm.authority.ended is End.STOPPED
    assert arm.authority.number == number


def test_the_next_setpoint_of_a_stream_is_of_the_same_command(arm):
    command = arm.send()
    arm.wait(0.2)
    further = arm.authority.extend(command, list(NOWHERE), arm.now_s)
    assert further is arm.authority.command
    assert (further.number, further.joints_deg, further.sent_s) == (
        command.number,
        NOWHERE,
        arm.now_s,
    )


@pytest.mark.parametrize(("after_s", "under_way"), [(0.28, True), (0.32, False)])
def test_a_command_may_be_about_to_move_the_arm_for_three_tenths_of_a_second(
    arm, after_s, under_way
):
    arm.send(HERE)
    arm.wait(after_s)
    assert arm.authority.under_way is under_way
    arm.wait(3.0)
    assert not arm.authority.under_way


def test_what_still_waits_to_be_sent_is_about_to_move_the_arm(arm):
    arm.send(HERE)
    arm.waiting = True
    arm.wait(1.0)
    assert arm.authority.under_way
    assert arm.authority.command.sent_s == arm.now_s
    arm.waiting = False
    arm.wait(0.4)
    assert not arm.authority.under_way


@pytest.mark.parametrize(
    ("reached", "turns", "under_way"),
    [(False, True, True), (True, True, False), (False, False, False)],
)
def test_later_it_is_under_way_while_the_arm_moves_and_says_so(arm, reached, turns, under_way):
    arm.send()
    arm.status = status(**MOVING)
    arm.turn(20)
    assert arm.authority.under_way
    arm.status = status(reached=reached)
    arm.turn(20, 1.0 if turns else 0.0)
    assert arm.authority.under_way is under_way
