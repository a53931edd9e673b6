"""S4: a stop reaches the arm on whichever identifiers it listens to; a second arm is named."""

import can
import pytest

from armui.control.safety.interlocks import CONTROL_OFFSET_UNKNOWN
from armui.protocol.addressing import Addressing
from armui.protocol.codes import LinkageRole
from armui.protocol.frame import Frame
from armui.sim.parameters.settings import LinkageSettings
from tests.accepted import accepted
from tests.faulty_arm import HardOfHearing

OUTPUT = LinkageRole.MOTION_OUTPUT
STOP = bytes.fromhex("01 00 00 00 00 00 00 00")


def keep_control_offset(rig, offset):
    """Give the arm a control offset from before, of which its feedback tells nothing."""
    rig.firmware.settings.linkage = LinkageSettings(OUTPUT, 0x00, offset)
    rig.firmware._linkage.take_effect()


@pytest.mark.parametrize("offset", [0x00, 0x10, 0x20])
def test_the_first_stop_reaches_an_arm_that_kept_a_control_offset(any_rig, offset):
    rig = any_rig
    keep_control_offset(rig, offset)
    rig.connect()
    rig.controller.emergency_stop()
    rig._settle()
    rig.node.poll(0.0)
    assert rig.firmware.condition.stopped


def test_it_goes_out_on_all_three_its_own_first(any_rig):
    rig = any_rig
    rig.connect()
    ear = HardOfHearing(rig.firmware)
    rig.controller.emergency_stop()
    rig._settle()
    rig.node.poll(0.0)
    assert [frame for frame in ear.heard if frame.data == STOP] == [
        Frame(each, STOP) for each in (0x150, 0x160, 0x170)
    ]


def test_a_second_arm_that_is_heard_is_named(rig):
    rig.connect()
    with can.Bus(interface="virtual", channel=rig.channel) as other:
        other.send(can.Message(arbitration_id=0x2B1, data=bytes(8), is_extended_id=False))
        rig.step()
        rig.controller.emergency_stop()
    (named,) = [each for each in rig.events if each.code == "stop_reaches_other"]
    assert named.params == {"feedback": "0x2B1"}


def test_one_arm_alone_names_no_other(rig):
    rig.connect()
    rig.controller.emergency_stop()
    assert "stop_reaches_other" not in rig.codes()


def test_a_linkage_change_the_arm_never_heard_is_not_told_as_in_use(any_rig):
    rig = any_rig
    rig.connect()
    ear = HardOfHearing(rig.firmware)
    ear.deaf_to = {0x470}
    accepted(rig.controller.linkage.set(OUTPUT, control_offset=0x10))
    rig.run_until(lambda: "linkage_failed" in rig.codes())
    rig.run(1.0)
    operating_state = rig.controller.operating_state
    assert "linkage_in_use" not in rig.codes()
    assert operating_state.addressing == Addressing()
    accepted(rig.controller.motors.enable())
    rig.run_until(lambda: all(rig.controller.operating_state.enabled))
    assert rig.controller.operating_state.cannot_move.reason == CONTROL_OFFSET_UNKNOWN
    rig.controller.emergency_stop()
    rig.step()
    assert rig.firmware.condition.stopped


def test_an_answer_proves_it(any_rig):
    rig = any_rig
    rig.connect()
    accepted(rig.controller.linkage.set(OUTPUT, control_offset=0x10))
    rig.run_until(lambda: "linkage_in_use" in rig.codes())
    assert rig.codes().index("linkage_answered") < rig.codes().index("linkage_in_use")
    assert rig.controller.operating_state.control_certain
