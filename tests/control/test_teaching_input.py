"""A teaching input on the bus: commands are heard and no feedback (0x470)."""

import can

from armui.control.link.link_state import LinkState
from armui.protocol.frame import Frame
from tests.accepted import accepted

SET_AS_TEACHING_INPUT = Frame(0x470, bytes.fromhex("FA 00 00 00"))


def test_an_arm_that_leads_is_told_apart_from_an_arm_that_is_silent(any_rig):
    rig = any_rig
    rig.firmware.on_frame(SET_AS_TEACHING_INPUT)
    rig.controller.connect_device(rig.device)
    rig.run_until(lambda: rig.controller.operating_state.teaching_input)
    assert rig.controller.operating_state.link is LinkState.OFFLINE
    rig.powered = False
    rig.run(0.6)
    assert not rig.controller.operating_state.teaching_input


def test_the_programs_own_targets_make_no_teaching_input(any_rig):
    rig = any_rig
    rig.ready()
    accepted(rig.controller.motion.send_joints([5.0] * 2 + [-5.0] * 4))
    rig.step()
    rig.powered = False
    rig.run_until(lambda: rig.controller.operating_state.link is LinkState.OFFLINE)
    assert not rig.controller.operating_state.teaching_input


def test_a_second_host_beside_an_arm_that_answers_makes_no_teaching_input(any_rig):
    rig = any_rig
    rig.connect()
    for target_id in (0x155, 0x156, 0x157):
        rig._arm_bus.send(
            can.Message(arbitration_id=target_id, data=bytes(8), is_extended_id=False)
        )
    rig.step()
    assert rig.controller.state.foreign_targets_s is not None
    assert not rig.controller.operating_state.teaching_input
