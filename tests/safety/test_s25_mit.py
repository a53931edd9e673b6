"""S25: in a mode another host has chosen, no mode word of ours lets the arm fall."""

import pytest

from armui.control.motion.motion_command import Mover
from armui.control.safety.interlocks import SPEED_ZERO
from armui.control.safety.other_command import OTHER_HOST_STREAMS, OTHER_MODE
from armui.control.safety.recovery_steps import Action, StepKind
from armui.protocol.codes import MoveMode, TrajectoryCommand
from tests.accepted import accepted
from tests.named_version import name_version
from tests.sim.talk import frame, target
from tests.sim.test_direct_control import STIFF, hold

A = (10.0, 45.0, -45.0, 0.0, 20.0, 0.0)
MIT_UNTIL_1_8_7 = "151#010400AD00000000"
MIT = "151#010600AD00000000"
HIGH_FOLLOW = "151#010100AD00000000"
CPV = "151#0105320000000000"


@pytest.fixture
def raised(rig):
    """An arm that would fall if it went limp."""
    rig.ready()
    rig.controller.motion.set_speed_percent(60)
    accepted(rig.controller.motion.send_joints(A))
    rig.run(0.2)
    rig.run_until(lambda: not rig.controller.operating_state.moving)
    assert rig.firmware.joints_deg == pytest.approx(A, abs=0.01)
    return rig


@pytest.mark.parametrize(
    ("word", "mode"),
    [
        (MIT_UNTIL_1_8_7, "mit"),
        (MIT, "mit"),
        (HIGH_FOLLOW, "high_follow"),
        (CPV, "cpv"),
    ],
)
def test_no_mode_word_of_ours_goes_out(raised, other_host, word, mode):
    rig, controller = raised, raised.controller
    other_host.say(word)
    rig.run(5.0)
    rig.heard()

    controller.motion.set_speed_percent(10)
    refusals = [
        controller.motion.jog(6, 1.0),
        controller.motion.send_joints(A),
        controller.planned_motion.command(TrajectoryCommand.CONTINUE),
    ]
    rig.run(3.0)

    assert rig.heard() == []
    assert {refusal.code for refusal in refusals[:2]} == {"other_mode"}
    assert refusals[0].params["other_mode"] == mode
    assert controller.recovery.step.kind is StepKind.OTHER_MODE


@pytest.mark.parametrize("shown", [0x04, 0x05, 0x06])
def test_what_0x2a1_shows_is_enough(raised, shown):
    """Nobody was heard to say it: the arm was in the mode when this program came."""
    rig, controller = raised, raised.controller
    rig.firmware.condition.move_mode = MoveMode(shown)
    rig.run(0.5)
    rig.heard()
    controller.motion.set_speed_percent(10)
    assert controller.motion.jog(6, 1.0).reason == OTHER_MODE
    rig.run(2.0)
    assert rig.heard() == []


@pytest.mark.parametrize("word", [MIT_UNTIL_1_8_7, MIT, HIGH_FOLLOW, CPV])
def test_who_moves_the_arm_is_the_other_host_as_long_as_its_mode_lasts(raised, other_host, word):
    other_host.say(word)
    raised.run(6.0)  # it has said nothing for long
    assert raised.controller.operating_state.mover is Mover.OTHER_HOST


def test_the_speed_slider_lets_no_arm_fall(raised, other_host):
    rig = raised
    other_host.say(MIT, *hold(A, **STIFF))
    rig.run(0.5)
    for percent in (10, 0, 100):
        rig.controller.motion.set_speed_percent(percent)
        rig.run(0.5)

    assert rig.firmware.joints_deg == pytest.approx(A, abs=1.0)


def resume_and_enable(rig):
    rig.run(0.5)
    accepted(rig.controller.motors.resume())
    rig.run(3.0)
    accepted(rig.controller.motors.enable())
    rig.run(1.0)


RESET_FIRST = [None, "S-V1.5-2", "S-V1.8-4", "S-V1.8-5"]
BY_A_WORD = ["S-V1.8-6", "S-V1.8-8", "S-V1.9-0"]


@pytest.mark.each_value(full="each word in each version")
@pytest.mark.parametrize("version", RESET_FIRST)
@pytest.mark.parametrize("word", [MIT_UNTIL_1_8_7, MIT])
def test_the_way_back_is_the_reset_before_1_8_6(raised, other_host, version, word):
    name_version(raised.controller, version)
    other_host.say(word)
    raised.run(3.0)
    step = raised.controller.recovery.step
    assert step.kind is StepKind.OTHER_MODE
    assert step.action is Action.RESET
    assert step.dangerous


@pytest.mark.each_value(full="each word in each version")
@pytest.mark.parametrize("version", BY_A_WORD)
@pytest.mark.parametrize("word", [MIT, HIGH_FOLLOW, CPV])
def test_the_way_back_is_a_mode_word_from_1_8_6_on(raised, other_host, version, word):
    """The word and the six angles measured leave together, and the arm stays where it is."""
    rig, controller = raised, raised.controller
    name_version(rig.controller, version, rig.firmware)
    targets = {HIGH_FOLLOW: target(*A), MIT: hold(A, **STIFF)}
    other_host.say(word, *targets.get(word, []))
    rig.run(3.0)
    step = controller.recovery.step
    assert step.action is Action.LEAVE_MODE
    assert step.dangerous
    rig.heard()

    assert controller.recovery.act(step) is None
    rig.run(1.5)
    ours = rig.heard()
    *words, last = ours[: [each.arbitration_id for each in ours].index(0x157) + 1]
    # CAN control, MOVE J, 60 % = 0x3C, position-velocity
    assert {each for each in words if each.arbitration_id == 0x151} == {
        frame("151#01013C0000000000")
    }
    assert [each.arbitration_id for each in (*words[-2:], last)] == [0x155, 0x156, 0x157]
    assert controller.operating_state.other_host is None
    assert rig.firmware.joints_deg == pytest.approx(A, abs=1.0)
    accepted(controller.motion.jog(6, 1.0))


def test_against_a_stream_only_the_stop_wins(raised, other_host):
    rig, controller = raised, raised.controller
    name_version(rig.controller, "S-V1.8-9", rig.firmware)
    other_host.stream(lambda _t_s: [MIT, *hold(A)], rate_hz=100)
    rig.run(1.0)
    step = controller.recovery.step
    assert step.action is Action.LEAVE_MODE
    rig.heard()
    assert controller.recovery.act(step).reason == OTHER_HOST_STREAMS
    ours = [each for each in rig.heard() if each == frame("151#01013C0000000000")]
    assert ours == []


def test_it_is_not_left_at_no_speed(raised, other_host):
    """At 0 % no target would hold the arm."""
    rig, controller = raised, raised.controller
    name_version(rig.controller, "S-V1.8-9", rig.firmware)
    other_host.say(CPV)
    rig.run(3.0)
    controller.motion.set_speed_percent(0)
    rig.run(0.2)
    assert controller.recovery.act(controller.recovery.step).reason == SPEED_ZERO


def test_an_arm_that_does_not_leave_its_mode_is_said_to_be_in_it(raised, other_host):
    rig, controller = raised, raised.controller
    name_version(rig.controller, "S-V1.8-9", rig.firmware)
    other_host.say(CPV)
    rig.run(3.0)
    rig.firmware._handlers["ModeControl"] = lambda _signals: []
    assert controller.recovery.act(controller.recovery.step) is None
    rig.run(1.0)
    assert controller.recovery.step.kind is StepKind.OTHER_MODE
    assert controller.motion.jog(6, 1.0).reason == OTHER_MODE


def test_the_way_back_is_the_reset(raised, other_host):
    rig, controller = raised, raised.controller
    name_version(rig.controller, "S-V1.8-5")
    other_host.say(MIT_UNTIL_1_8_7)
    rig.run(3.0)
    step = controller.recovery.step
    assert step.action is Action.RESET
    assert step.dangerous

    assert controller.recovery.act(step) is None
    resume_and_enable(rig)
    assert controller.operating_state.cannot_move is None


def test_high_follow_is_over_after_the_reset(raised, other_host):
    rig, controller = raised, raised.controller
    other_host.say(HIGH_FOLLOW)
    rig.run(3.0)
    assert controller.operating_state.cannot_move.reason == OTHER_MODE
    controller.emergency_stop()
    resume_and_enable(rig)
    assert controller.operating_state.cannot_move is None
