"""联动控制: the literal bytes, and under which identifiers the arm is heard, moved and stopped."""

import can
import pytest

from armui.control.devices.linkage import LINKAGE_WHILE_MOVING, OFFSET_NOT_POSSIBLE
from armui.control.link.link_state import NOT_CONNECTED, LinkState
from armui.control.link.offsets import OffsetFollower
from armui.control.operations.started import SETTING_UNANSWERED
from armui.control.safety.interlocks import CONTROL_OFFSET_UNKNOWN
from armui.control.safety.recovery_steps import StepKind
from armui.protocol.addressing import Addressing
from armui.protocol.codes import LinkageRole
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.sim.parameters.settings import LinkageSettings
from tests.accepted import accepted
from tests.faulty_arm import HardOfHearing

OUTPUT, INPUT = LinkageRole.MOTION_OUTPUT, LinkageRole.TEACHING_INPUT
STOP = bytes.fromhex("01 00 00 00 00 00 00 00")


@pytest.fixture
def arm(any_rig):
    any_rig.connect()
    any_rig.ear = HardOfHearing(any_rig.firmware)
    any_rig.linkage = any_rig.controller.linkage
    return any_rig


def used(arm):
    return arm.controller.operating_state.addressing


def wait_for(arm, addressing):
    arm.run_until(
        lambda: used(arm) == addressing and arm.controller.operating_state.control_certain
    )
    arm.run_until(lambda: arm.controller.state.angles_deg() is not None)
    arm.run_until(lambda: None not in arm.controller.operating_state.enabled)


def with_id(arm, arbitration_id):
    return [frame for frame in arm.ear.heard if frame.arbitration_id == arbitration_id]


def test_both_offsets(arm, generation):
    accepted(arm.linkage.set(OUTPUT, feedback_offset=0x10, control_offset=0x20))
    wait_for(arm, Addressing(0x10, 0x20))
    padding = "" if generation is Generation.ONE else "00 00 00 00"
    assert with_id(arm, 0x470) == [Frame(0x470, bytes.fromhex("FC 10 20 00" + padding))]
    assert arm.firmware.addressing == Addressing(0x10, 0x20)
    assert {"linkage_sent", "linkage_answered", "linkage_in_use"} <= set(arm.codes())
    arm.run_until(lambda: arm.controller.operating_state.generation is generation)


def test_it_moves_under_the_new_identifiers(arm):
    arm.linkage.set(OUTPUT, feedback_offset=0x20, control_offset=0x10)
    wait_for(arm, Addressing(0x20, 0x10))
    accepted(arm.controller.motors.enable())
    arm.run_until(lambda: arm.controller.operating_state.cannot_move is None)
    arm.ear.heard.clear()
    accepted(arm.controller.motion.send_joints((5.0, 0.0, 0.0, 0.0, 0.0, 0.0)))
    arm.run_until(lambda: arm.controller.operating_state.moving)
    ids = {frame.arbitration_id for frame in arm.ear.heard}
    assert {0x161, 0x165, 0x166, 0x167} <= ids
    assert not ids & {0x151, 0x155, 0x156, 0x157}
    arm.ear.heard.clear()
    arm.controller.emergency_stop()
    arm.run_until(lambda: "stop_confirmed" in arm.codes())
    assert arm.ear.heard[:3] == [Frame(each, STOP) for each in (0x160, 0x150, 0x170)]


def test_only_the_commands_move(arm):
    arm.linkage.set(OUTPUT, control_offset=0x10)
    assert not arm.controller._connection.offsets.certain
    wait_for(arm, Addressing(0x00, 0x10))
    assert arm.firmware.addressing == Addressing(0x00, 0x10)


def test_until_standby_it_is_not_sure(any_rig):
    arm = any_rig
    arm.ready()
    arm.controller.motion.jog(1, 0.1)  # CAN control
    arm.run(1.0)
    arm.ear = HardOfHearing(arm.firmware)
    arm.controller.linkage.set(OUTPUT, control_offset=0x20)
    arm.run(0.5)
    assert arm.controller.operating_state.cannot_move.reason == CONTROL_OFFSET_UNKNOWN
    assert used(arm) == Addressing()


def test_a_stop_that_is_not_confirmed_goes_everywhere(arm):
    arm.ear.deaf_to = {0x150}
    arm.controller.emergency_stop()
    arm.run(0.3)
    assert {frame.arbitration_id for frame in arm.ear.heard} == {0x160, 0x170}


def test_an_arm_left_with_offsets_is_found(any_rig):
    arm = any_rig
    arm.firmware.settings.linkage = LinkageSettings(OUTPUT, 0x10, 0x20)
    arm.firmware._linkage.take_effect()
    arm.controller.connect_device(arm.device)
    arm.run_until(lambda: "linkage_found" in arm.codes())
    arm.run_until(lambda: arm.controller.state.angles_deg() is not None)
    assert used(arm).feedback_offset == 0x10
    assert not arm.controller.operating_state.control_certain
    arm.run_until(lambda: "limits_read" in arm.codes())
    accepted(arm.controller.motors.enable())
    arm.run_until(lambda: all(arm.controller.operating_state.enabled))
    assert arm.controller.operating_state.cannot_move.reason == CONTROL_OFFSET_UNKNOWN
    arm.controller.emergency_stop()
    arm.run_until(lambda: "stop_confirmed" in arm.codes(), seconds=0.5)


def test_a_teaching_input_and_the_way_back(arm):
    arm.linkage.set(INPUT, target_offset=0x10)
    arm.run_until(lambda: arm.controller.operating_state.teaching_input)
    assert arm.firmware.leads
    assert "linkage_answered" in arm.codes()
    assert arm.controller.operating_state.link is LinkState.OFFLINE
    accepted(arm.linkage.release())
    wait_for(arm, Addressing())
    assert not arm.firmware.leads
    assert with_id(arm, 0x470)[-1].data[:4] == bytes.fromhex("FC 00 00 00")


def test_no_answer(arm):
    arm.ear.deaf_to = {0x470}
    arm.linkage.set(OUTPUT, feedback_offset=0x10)
    arm.run_until(lambda: "linkage_failed" in arm.codes())
    assert used(arm) == Addressing()
    failed = next(each for each in arm.events if each.code == "linkage_failed")
    assert failed.params["reason"].reason == SETTING_UNANSWERED


def test_an_answer_that_got_lost_does_not_lose_the_arm(arm):
    arm.ear.mute_on = {0x476}
    arm.linkage.set(OUTPUT, feedback_offset=0x20, control_offset=0x20)
    wait_for(arm, Addressing(0x20, 0x20))


def test_another_arm_on_the_bus_is_not_mixed_in(arm, request):
    with can.Bus(interface="virtual", channel=arm.channel) as other:
        for _ in range(60):
            other.send(can.Message(arbitration_id=0x2B1, data=bytes(8), is_extended_id=False))
            other.send(can.Message(arbitration_id=0x2B5, data=b"\x7f" * 8, is_extended_id=False))
            arm.step()
    assert used(arm) == Addressing()
    assert arm.controller.state.angles_deg() == (0.0,) * 6


def test_refused(any_rig):
    linkage = any_rig.controller.linkage
    assert linkage.release().reason == NOT_CONNECTED
    any_rig.ready()
    assert linkage.set(OUTPUT, feedback_offset=0x30).reason == OFFSET_NOT_POSSIBLE
    any_rig.controller.motion.send_joints((20.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    any_rig.run_until(lambda: any_rig.controller.operating_state.moving)
    assert linkage.release().reason == LINKAGE_WHILE_MOVING


def test_what_is_the_same_is_no_wish():
    follower = OffsetFollower()
    follower.request(Addressing(), 1.0)
    assert follower.requested is None
    assert follower.certain
    follower.request(Addressing(0x10, 0x00), 1.0)
    assert follower.certain  # the old feedback vouches for the old commands
    follower.request(Addressing(0x00, 0x10), 1.0)
    assert not follower.certain


def test_a_role_that_waits_is_shown_until_the_release_of_a_stop_brings_it(rig):
    rig.ready()
    accepted(rig.controller.motion.jog(1, 0.1))  # CAN control: the role waits for standby
    rig.run(1.0)
    accepted(rig.controller.linkage.set(INPUT))
    rig.run_until(lambda: "linkage_answered" in rig.codes())
    rig.run(1.0)
    now = rig.controller.operating_state
    assert (now.becomes_input, now.teaching_input, now.cannot_move) == (True, False, None)
    rig.controller.emergency_stop()
    rig.run_until(lambda: rig.controller.recovery.step.kind is StepKind.STOPPED_INPUT)
    assert rig.controller.recovery.act(rig.controller.recovery.step) is None
    rig.run_until(lambda: rig.controller.operating_state.teaching_input)
    assert not rig.controller.operating_state.becomes_input
    rig.run(2.0)  # longer than the release is followed
    assert "resume_unheard" in rig.codes()
    assert "its six motors hold it under power" in rig.controller.recovery.step.kind.value.source
    ear = HardOfHearing(rig.firmware)
    assert rig.controller.recovery.act(rig.controller.recovery.step) is None
    rig.run_until(lambda: rig.controller.operating_state.link is LinkState.ONLINE)
    rig.run(0.5)
    assert all(rig.firmware.enabled), "the arm's own doing: 0x471 was not sent"
    assert 0x471 not in {frame.arbitration_id for frame in ear.heard}
    assert not {"resume_failed", "stop_undone"} & set(rig.codes())
    now = rig.controller.operating_state
    assert (now.becomes_input, now.teaching_input) == (False, False)


def test_a_role_that_waits_is_taken_back(rig):
    rig.ready()
    accepted(rig.controller.motion.jog(1, 0.1))
    rig.run(1.0)
    accepted(rig.controller.linkage.set(INPUT))
    rig.run_until(lambda: rig.controller.operating_state.becomes_input)
    accepted(rig.controller.linkage.release())
    rig.run_until(lambda: not rig.controller.operating_state.becomes_input)
