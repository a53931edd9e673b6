"""零点设置: the literal bytes, what the arm answers, what its angles then read, what is told."""

import errno

import can
import pytest

from armui.control.devices.zeroing import ZERO_NOT_SET, ZERO_NOT_TAKEN
from armui.control.link.link_state import LINK_LOST, NOT_CONNECTED
from armui.control.operating_state import BUSY
from armui.control.operations.started import ENDED_BY_STOP, SETTING_UNANSWERED
from armui.control.safety.interlocks import STOPPED
from armui.control.safety.standstill import JOINTS_MOVING, SPEED_UNKNOWN
from armui.protocol.frame import Frame
from tests.accepted import accepted
from tests.faulty_arm import FaultyDrivers, laid_down

ANSWER = 0x476


def setting(payload):
    return Frame(0x475, bytes.fromhex(payload))


# joint, AE: zero; acceleration left alone: 7FFF in generation 2, 0 and «not valid» in generation 1
ZERO_2 = {1: setting("02 AE 00 00 00 00 00 00"), 2: setting("02 AE 00 7F FF 00 00 00")}
ZERO_ALL = {1: setting("07 AE 00 00 00 00 00 00"), 2: setting("07 AE 00 7F FF 00 00 00")}


@pytest.fixture
def arm(any_rig):
    return laid_down(any_rig)


def sent(arm):
    return [frame for frame in arm.ear.heard if frame.arbitration_id == 0x475]


def done(arm):
    arm.run_until(lambda: not arm.controller.zeroing.busy)


def last(arm):
    return arm.events[-1]


def test_one_joint(arm, generation):
    accepted(arm.controller.zeroing.set_zero(2))
    assert arm.controller.operating_state.cannot_move.reason == BUSY
    done(arm)
    assert sent(arm) == [ZERO_2[generation]]
    assert arm.firmware.settings.zeros_deg == [0.0, 10.0, 0.0, 0.0, 0.0, 0.0]
    assert arm.controller.state.angles_deg() == (5.0, 0.0, -20.0, 0.0, 30.0, -40.0)
    assert arm.codes()[-2:] == ["zero_sent_joint", "zero_set_joint"]
    assert last(arm).params["joint"] == 2
    assert arm.controller.operating_state.busy is None


def test_all_joints(arm, generation):
    accepted(arm.controller.zeroing.set_zero())
    done(arm)
    assert sent(arm) == [ZERO_ALL[generation]]
    assert arm.controller.state.angles_deg() == (0.0,) * 6
    assert last(arm).code == "zero_set"


def test_an_arm_that_says_no(arm):
    arm.firmware.condition.communication_fault[1] = True
    arm.controller.zeroing.set_zero(2)
    done(arm)
    assert last(arm).code == "zero_failed"
    assert last(arm).params["reason"].reason == ZERO_NOT_SET
    assert last(arm).params["reason"].params == {"joints": "2"}
    assert arm.controller.state.angles_deg()[1] == 10.0


def test_an_arm_that_says_yes_and_does_nothing(arm):
    arm.firmware.settings_applier.set_zero = lambda _indices: True
    arm.controller.zeroing.set_zero()
    done(arm)
    assert last(arm).params["reason"].reason == ZERO_NOT_TAKEN
    assert last(arm).params["reason"].params == {"joints": "1, 2, 3, 5, 6"}  # 4 lies at 0


def test_an_arm_that_does_not_hear(arm, generation):
    arm.ear.deaf_to = {0x475}
    arm.controller.zeroing.set_zero(3)
    done(arm)
    assert last(arm).params["reason"].reason in {
        ZERO_NOT_TAKEN,
        SETTING_UNANSWERED,
    }
    assert arm.firmware.settings.zeros_deg == [0.0] * 6


def test_after_a_lost_answer_the_angles_decide_and_it_is_not_sent_again(arm, generation):
    arm.ear.mute_on = {ANSWER}
    arm.controller.zeroing.set_zero(2)
    arm.run(0.1)
    arm.ear.mute_on = set()
    done(arm)
    assert sent(arm) == [ZERO_2[generation]]
    assert last(arm).code == "zero_set_joint"


def test_a_stop_ends_it_and_nothing_is_sent_again(arm):
    arm.ear.mute_on = {ANSWER}
    arm.controller.zeroing.set_zero(2)
    arm.step()
    arm.controller.emergency_stop()
    assert not arm.controller.zeroing.busy
    arm.run(2.0)
    assert len(sent(arm)) == 1
    reasons = [each.params["reason"].reason for each in arm.events if each.code == "zero_failed"]
    assert reasons == [ENDED_BY_STOP]


def test_a_stop_drops_those_that_wait(arm):
    arm.ear.mute_on = {ANSWER}
    accepted(arm.controller.joint_errors.clear(1))
    arm.controller.zeroing.set_zero(2)
    arm.controller.emergency_stop()
    arm.run(3.0)
    assert not arm.controller.zeroing.busy
    assert all(frame.data[1] != 0xAE for frame in sent(arm))


def test_a_link_lost_half_way_ends_it(arm):
    arm.ear.mute_on = {ANSWER}
    arm.controller.zeroing.set_zero(2)
    arm.unplug(can.CanOperationError("gone", error_code=errno.ENODEV))
    arm.run_until(lambda: "zero_failed" in arm.codes())
    failed = next(each for each in arm.events if each.code == "zero_failed")
    assert failed.params["reason"].reason == LINK_LOST
    assert not arm.controller.zeroing.busy


def test_not_while_it_moves(any_rig):
    any_rig.ready()
    any_rig.controller.motion.send_joints((30.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    any_rig.run_until(lambda: any_rig.controller.operating_state.moving)
    any_rig.run(0.3)
    any_rig.heard()
    refusal = any_rig.controller.zeroing.set_zero(2)
    assert refusal.reason == JOINTS_MOVING
    assert refusal.params == {"joints": "1"}
    any_rig.step()
    assert 0x475 not in [frame.arbitration_id for frame in any_rig.heard()]


def test_not_without_an_arm_nor_in_a_stop(any_rig):
    zeroing = any_rig.controller.zeroing
    assert zeroing.set_zero(1).reason == NOT_CONNECTED
    any_rig.connect()
    any_rig.controller.emergency_stop()
    any_rig.run_until(lambda: "stop_confirmed" in any_rig.codes())
    assert zeroing.set_zero(1).reason == STOPPED


def test_not_while_the_speeds_are_unknown(any_rig):
    any_rig.connect()
    drivers = FaultyDrivers(any_rig.firmware)
    drivers.missing = {0x254}
    any_rig.run(0.7)
    refusal = any_rig.controller.zeroing.set_zero()
    assert refusal.reason == SPEED_UNKNOWN
    assert refusal.params == {"joints": "4"}
    drivers.mend()
