"""A teaching input on the bus: commands are heard and no feedback (0x470)."""

import can

from armui.control.situation import LinkState
from armui.protocol.frame import Frame

SET_AS_TEACHING_INPUT = Frame(0x470, bytes.fromhex("FA 00 00 00"))


def test_an_arm_that_leads_is_told_apart_from_an_arm_that_is_silent(any_bench):
    bench = any_bench
    bench.firmware.on_frame(SET_AS_TEACHING_INPUT)
    bench.controller.connect_device(bench.device)
    bench.run_until(lambda: bench.controller.situation.teaching_input)
    assert bench.controller.situation.link is LinkState.OFFLINE
    bench.powered = False
    bench.run(0.6)
    assert not bench.controller.situation.teaching_input


def test_the_programs_own_targets_make_no_teaching_input(any_bench):
    bench = any_bench
    bench.ready()
    assert bench.controller.motion.send_joints([5.0] * 2 + [-5.0] * 4) is None
    bench.step()
    bench.powered = False
    bench.run_until(lambda: bench.controller.situation.link is LinkState.OFFLINE)
    assert not bench.controller.situation.teaching_input


def test_a_second_host_beside_an_arm_that_answers_makes_no_teaching_input(any_bench):
    bench = any_bench
    bench.connect()
    for target_id in (0x155, 0x156, 0x157):
        bench._arm_bus.send(
            can.Message(arbitration_id=target_id, data=bytes(8), is_extended_id=False)
        )
    bench.step()
    assert bench.controller.state.foreign_targets_s is not None
    assert not bench.controller.situation.teaching_input
