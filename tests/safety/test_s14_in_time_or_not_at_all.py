"""S14: an action leaves within a second of its press or not at all, and is checked again."""

import pytest

from armui.arm.parameters import Batch, Group, Parameter
from armui.control.link.link_state import OFFLINE
from armui.control.operations.started import ARM_CHANGED, NOTHING_LEFT, Ending
from armui.control.parameters.parameter_reader import ParameterReader
from armui.control.safety.interlocks import JOINTS_UNKNOWN
from armui.protocol.codes import TeachingState
from tests.accepted import accepted
from tests.faulty_arm import HardOfHearing, laid_down

END = Batch(Group.END_LIMITS)
LINEAR_SPEED = Parameter("max_linear_speed_m_s")
QUESTIONS = {0x472, 0x477}
ANSWER = 0x476


@pytest.fixture
def arm(any_rig):
    return laid_down(any_rig)


def zeros(arm):
    return [each for each in arm.ear.heard if each.arbitration_id == 0x475 and each.data[1] == 0xAE]


def failed(arm):
    return [each.params["reason"].code for each in arm.events if each.code == "zero_failed"]


def test_a_zero_does_not_wait_behind_questions_nobody_answers(arm):
    arm.ear.deaf_to = QUESTIONS
    reader = ParameterReader(arm.controller.settings)
    assert reader.start() is None
    arm.run(0.3)
    accepted(arm.controller.zeroing.set_zero(1))
    arm.run(0.1)
    assert len(zeros(arm)) == 1
    arm.run_until(lambda: "zero_set_joint" in arm.codes())
    arm.run_until(lambda: not reader.running, 30.0)
    assert len(zeros(arm)) == 1


def test_a_zero_that_cannot_begin_within_a_second_is_dropped_with_words(arm):
    arm.ear.mute_on = {ANSWER}
    accepted(arm.controller.joint_errors.clear(1))
    accepted(arm.controller.zeroing.set_zero(2))
    arm.run(0.96)
    assert zeros(arm) == []
    arm.run(20.0)
    assert zeros(arm) == []
    assert failed(arm) == ["order_too_late"]
    assert not arm.controller.zeroing.busy


def test_a_zero_is_not_sent_to_a_joint_that_stands_elsewhere_by_then(arm):
    arm.ear.mute_on = {ANSWER}
    arm.controller.joint_errors.clear(1)
    arm.run(0.5)
    accepted(arm.controller.zeroing.set_zero(2))
    arm.firmware.mechanics.count_anew((5.0, 12.0, -20.0, 0.0, 30.0, -40.0))
    arm.run(3.0)
    assert zeros(arm) == []
    assert failed(arm) == ["zero_moved"]
    reason = next(each.params["reason"] for each in arm.events if each.code == "zero_failed")
    assert reason.params == {"joints": "2"}


def test_a_zero_waits_for_a_short_while_where_nothing_has_changed(arm):
    arm.ear.mute_on = {ANSWER}
    arm.controller.joint_errors.clear(1)
    arm.run(0.5)
    arm.controller.zeroing.set_zero(2)
    arm.run(0.4)
    arm.ear.mute_on = set()
    arm.run_until(lambda: "zero_set_joint" in arm.codes())
    assert len(zeros(arm)) == 1


def test_a_zero_is_never_repeated(arm):
    arm.ear.mute_on = {ANSWER}  # heard and done, and the answer got lost
    arm.controller.zeroing.set_zero(3)
    arm.run(5.0)
    assert len(zeros(arm)) == 1
    assert not arm.controller.zeroing.busy
    assert "zero_set_joint" in arm.codes()  # by the angle that is read now


def test_a_zero_unanswered_where_the_joint_lay_at_zero_is_not_told_as_set(arm):
    arm.ear.deaf_to = {0x475}
    arm.controller.zeroing.set_zero(4)  # it lies at 0°
    arm.run_until(lambda: not arm.controller.zeroing.busy)
    assert failed(arm) == ["setting_unanswered"]


def test_no_zero_while_the_angles_are_silent(any_rig):
    any_rig.connect()
    silence = {0x2A5, 0x2A6, 0x2A7}
    step = any_rig.firmware.step
    any_rig.firmware.step = lambda dt_s: [
        frame for frame in step(dt_s) if frame.arbitration_id not in silence
    ]
    any_rig.run(0.7)
    assert any_rig.controller.zeroing.set_zero(1).reason == JOINTS_UNKNOWN
    del any_rig.firmware.step


def test_a_parameter_is_not_set_again_on_an_arm_that_moves_by_then(rig, other_host):
    rig.ready()
    rig.controller.settings.read([END])
    rig.run_until(lambda: not rig.controller.settings.busy)
    rig.ear = HardOfHearing(rig.firmware)
    rig.ear.mute_on = {ANSWER}
    accepted(rig.controller.settings.save({LINEAR_SPEED: 0.5}))
    other_host.move_to((40.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    rig.run(3.0)
    assert len([each for each in rig.ear.heard if each.arbitration_id == 0x479]) == 1


def test_a_command_meant_for_one_arm_is_not_given_to_the_next(arm):
    arm.controller.settings.read([END])
    arm.run_until(lambda: not arm.controller.settings.busy)
    arm.ear.mute_on = {ANSWER}
    arm.ear.heard.clear()
    accepted(arm.controller.settings.save({LINEAR_SPEED: 0.5}))
    arm.step()
    connection = arm.controller._connection
    connection._start_anew(connection._worker, arm.time_s)  # it was silent, and an arm came
    arm.run(3.0)
    assert len([each for each in arm.ear.heard if each.arbitration_id == 0x479]) == 1
    assert arm.controller.settings.cell(LINEAR_SPEED).refusal.reason in {
        ARM_CHANGED,
        OFFLINE,
    }


# What is sent again until the feedback shows it ---------------------------------------------------


def disable(controller):
    return controller.motors.disable()


def gripper_enable(controller):
    return controller.gripper.enable(1.0)


def record_a_hand(controller):
    return controller.teaching.command(TeachingState.START_RECORDING)


@pytest.mark.each_value(full="each press in both generations")
@pytest.mark.parametrize("press", [disable, gripper_enable, record_a_hand])
def test_what_no_driver_took_within_a_second_is_dropped_and_said(arm, press):
    arm.controller.motors.enable()
    arm.run(0.3)
    arm.hold_driver()
    accepted(arm.controller.lights.set_light(1, 1, 0, 0, 0))  # the driver keeps this one
    arm.run(0.1)
    arm.events.clear()
    started = accepted(press(arm.controller))
    arm.run(1.2)
    told = [each.params["reason"].reason for each in arm.events if each.code == "refused"]
    assert told == [NOTHING_LEFT]
    assert started.ending is Ending.FAILED
    assert arm.controller.operating_state.busy is None
    arm.heard()
    arm.free_driver()
    arm.run(1.0)
    assert {each.arbitration_id for each in arm.heard()} & {0x150, 0x159, 0x471} == set()
    assert all(arm.firmware.enabled)
    accepted(press(arm.controller))
    arm.run(0.5)
    assert {each.arbitration_id for each in arm.heard()} & {0x150, 0x159, 0x471}


def test_what_has_left_is_sent_again_after_more_than_a_second(arm):
    """Some arms need it three times."""
    arm.controller.motors.disable()
    arm.run(0.3)
    arm.node.link.lose_to_arm(0x471, 2)
    started = accepted(arm.controller.motors.enable())
    arm.run(0.96)
    assert not any(arm.firmware.enabled)
    arm.run(0.4)
    assert all(arm.firmware.enabled)
    assert started.ending is Ending.DONE
