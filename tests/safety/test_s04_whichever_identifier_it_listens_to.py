"""S4: a stop reaches the arm on whichever identifiers it listens to; a second arm is named."""

import can
import pytest

from armui.protocol.addressing import Addressing
from armui.protocol.codes import LinkageRole
from armui.protocol.frame import Frame
from armui.sim.settings import Linkage
from tests.faulty_arm import HardOfHearing

OUTPUT = LinkageRole.MOTION_OUTPUT
STOP = bytes.fromhex("01 00 00 00 00 00 00 00")


def keep_control_offset(bench, offset):
    """Give the arm a control offset from before, of which its feedback tells nothing."""
    bench.firmware.settings.linkage = Linkage(OUTPUT, 0x00, offset)
    bench.firmware._take_linkage()


@pytest.mark.parametrize("offset", [0x00, 0x10, 0x20])
def test_the_first_stop_reaches_an_arm_that_kept_a_control_offset(any_bench, offset):
    bench = any_bench
    keep_control_offset(bench, offset)
    bench.connect()
    bench.controller.emergency_stop()
    bench._settle()
    bench.node.poll(0.0)
    assert bench.firmware.stopped


def test_it_goes_out_on_all_three_its_own_first(any_bench):
    bench = any_bench
    bench.connect()
    ear = HardOfHearing(bench.firmware)
    bench.controller.emergency_stop()
    bench._settle()
    bench.node.poll(0.0)
    assert [frame for frame in ear.heard if frame.data == STOP] == [
        Frame(each, STOP) for each in (0x150, 0x160, 0x170)
    ]


def test_a_second_arm_that_is_heard_is_named(bench):
    bench.connect()
    with can.Bus(interface="virtual", channel=bench.channel) as other:
        other.send(can.Message(arbitration_id=0x2B1, data=bytes(8), is_extended_id=False))
        bench.step()
        bench.controller.emergency_stop()
    (named,) = [each for each in bench.notices if each.code == "stop_reaches_other"]
    assert named.params == {"feedback": "0x2B1"}


def test_one_arm_alone_names_no_other(bench):
    bench.connect()
    bench.controller.emergency_stop()
    assert "stop_reaches_other" not in bench.codes()


def test_a_linkage_change_the_arm_never_heard_is_not_told_as_in_use(any_bench):
    bench = any_bench
    bench.connect()
    ear = HardOfHearing(bench.firmware)
    ear.deaf_to = {0x470}
    assert bench.controller.linkage.set(OUTPUT, control_offset=0x10) is None
    bench.run_until(lambda: "linkage_failed" in bench.codes())
    bench.run(1.0)
    situation = bench.controller.situation
    assert "linkage_in_use" not in bench.codes()
    assert situation.addressing == Addressing()
    assert bench.controller.motors.enable() is None
    bench.run_until(lambda: all(bench.controller.situation.enabled))
    assert bench.controller.situation.cannot_move.code == "control_offset_unknown"
    bench.controller.emergency_stop()
    bench.step()
    assert bench.firmware.stopped


def test_an_answer_proves_it(any_bench):
    bench = any_bench
    bench.connect()
    assert bench.controller.linkage.set(OUTPUT, control_offset=0x10) is None
    bench.run_until(lambda: "linkage_in_use" in bench.codes())
    assert bench.codes().index("linkage_answered") < bench.codes().index("linkage_in_use")
    assert bench.controller.situation.control_certain
