"""S15: what is known of an arm was heard from that arm, since it came."""

import errno
from dataclasses import replace

import can
import pytest

from armui.arm.parameters import Batch, Group, Parameter, heard
from armui.control.recovery_steps import Kind
from armui.control.setting_cell import CellState
from armui.control.situation import LinkState
from armui.protocol.codes import LinkageRole
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from armui.sim.node import Node
from tests.bench import Bench
from tests.faulty_arm import FaultyDrivers, HardOfHearing

END = Batch(Group.END_LIMITS)
LINEAR_SPEED = Parameter("max_linear_speed_m_s")
ANGULAR_SPEED = Parameter("max_angular_speed_rad_s")
STALL_BIT = 0x80
VERSION = 0x4AF


def swap(bench, firmware):
    """Plug another arm into the same adapter."""
    bench.firmware = firmware
    bench.node = Node(firmware, bench._arm_bus)


def settled(bench):
    bench.run_until(lambda: not bench.controller.settings.busy)


@pytest.mark.parametrize("first", Generation, ids=["gen1", "gen2"])
def test_another_arm_on_the_same_adapter_is_asked_anew(qapp, request, first):
    bench = Bench(request.node.nodeid, first)
    second = Generation.ONE if first is Generation.TWO else Generation.TWO
    bench.connect()
    assert bench.controller.settings.read([END]) is None
    settled(bench)
    bench.powered = False
    bench.run(0.7)
    swap(bench, Firmware(second))
    bench.powered = True
    bench.run_until(lambda: bench.controller.situation.link is LinkState.ONLINE)
    assert bench.controller.situation.generation is None
    bench.run_until(lambda: None not in bench.controller.state.limits, 3.0)
    assert bench.controller.situation.generation is second
    # what the first arm held is not shown, and stands in no frame to the second
    assert heard(bench.controller.state, LINEAR_SPEED) is None
    assert bench.controller.settings.cell(LINEAR_SPEED).state is CellState.UNREAD
    bench.ear = HardOfHearing(bench.firmware)
    assert bench.controller.settings.save({LINEAR_SPEED: 0.25}).code == "setting_unknown"
    bench.run(0.1)
    assert all(frame.arbitration_id != 0x479 for frame in bench.ear.heard)
    bench.controller.settings.read([END])
    settled(bench)
    before = heard(bench.controller.state, ANGULAR_SPEED).value
    assert bench.controller.settings.save({LINEAR_SPEED: 0.25}) is None
    settled(bench)
    assert heard(bench.controller.state, LINEAR_SPEED).value == 0.25
    assert heard(bench.controller.state, ANGULAR_SPEED).value == before == 1.0
    bench.close()


def test_an_arm_swapped_while_the_window_was_held_up_is_asked_anew(bench):
    bench.connect()
    bench._settle()
    swap(bench, Firmware(Generation.ONE))
    bench.time_s += 2.0  # no look at the arm meanwhile
    bench.node.poll(0.02)
    bench._settle()
    bench.run(2.0)
    bench.run_until(lambda: bench.controller.situation.generation is not None, 3.0)
    assert bench.controller.situation.generation is Generation.ONE


def test_a_power_cycle_starts_from_nothing(any_bench):
    bench = any_bench
    bench.connect()
    bench.controller.settings.read([END])
    settled(bench)
    bench.powered = False
    bench.run(0.7)
    assert bench.controller.situation.link is LinkState.OFFLINE
    bench.powered = True
    bench.run_until(lambda: bench.controller.situation.link is LinkState.ONLINE)
    assert bench.controller.situation.generation is None
    assert bench.controller.state.joints_without_limits() == [1, 2, 3, 4, 5, 6]
    bench.run_until(lambda: bench.codes().count("limits_read") == 2)
    assert bench.controller.settings.cell(LINEAR_SPEED).state is CellState.UNREAD


def test_after_a_power_cycle_the_offset_of_the_commands_is_proven_by_nothing(any_bench):
    bench = any_bench
    bench.connect()
    assert bench.controller.linkage.set(LinkageRole.MOTION_OUTPUT, control_offset=0x10) is None
    bench.run_until(lambda: bench.controller.situation.addressing.control_offset == 0x10)
    assert bench.controller.situation.control_certain
    bench.powered = False
    bench.run(0.7)
    bench.powered = True
    bench.run_until(lambda: bench.controller.situation.link is LinkState.ONLINE)
    assert not bench.controller.situation.control_certain


def test_after_a_lost_cable_nothing_of_before_counts(any_bench, qtbot):
    bench = any_bench
    bench.connect()
    bench.unplug(can.CanOperationError("gone", error_code=errno.ENODEV))
    qtbot.waitUntil(lambda: bench.controller.situation.link is LinkState.LOST)
    bench.controller.tick()
    assert bench.controller.situation.generation is None
    assert bench.controller.state.limits == (None,) * 6
    assert bench.controller.state.last_feedback_s is None


def test_no_false_stall_before_the_generation_is_known(qapp, request):
    bench = Bench(request.node.nodeid, Generation.ONE)
    drivers = FaultyDrivers(bench.firmware)
    drivers.bits = dict.fromkeys(range(1, 7), STALL_BIT)  # «homed» in generation 1
    shown = []
    bench.controller.state_changed.connect(
        lambda state: shown.extend(each.value for each in state.drivers_slow if each is not None)
    )
    steps = []
    bench.controller.step_changed.connect(lambda step: steps.append(step.kind))
    bench.controller.connect_device(bench.device)
    bench.run_until(lambda: "limits_read" in bench.codes())
    bench.run(0.3)
    assert any(each.homed for each in shown)
    assert not any(each.stall_protection for each in shown)
    assert Kind.STALL not in steps
    drivers.mend()
    bench.close()


def test_a_version_that_comes_late_is_asked_for_again(bench):
    ear = HardOfHearing(bench.firmware)
    ear.mute_on = {VERSION}
    bench.controller.connect_device(bench.device)
    bench.run_until(lambda: bench.controller.situation.link is LinkState.ONLINE)
    bench.run(0.4)
    questions = [frame for frame in ear.heard if frame.arbitration_id == VERSION]
    assert questions == [Frame(VERSION, bytes.fromhex("01 00 00 00 00 00 00 00"))]
    ear.mute_on = set()
    bench.run_until(lambda: bench.controller.situation.generation is not None, 1.0)
    assert bench.controller.situation.generation is Generation.TWO


def test_an_answer_without_a_readable_version_is_no_generation_1(bench):
    ear = HardOfHearing(bench.firmware)
    ear.mute_on = {VERSION}
    bench.controller.connect_device(bench.device)
    bench.run_until(lambda: bench.controller.situation.link is LinkState.ONLINE)
    cut = can.Message(arbitration_id=VERSION, data=b"\0\0\0\0S-V1", is_extended_id=False)
    bench._arm_bus.send(cut)
    bench.run_until(lambda: bench.controller.situation.generation is not None, 2.0)
    assert bench.controller.situation.generation is Generation.TWO


def test_a_late_failure_of_one_device_does_not_close_the_next(bench):
    bench.broken = OSError(errno.ENODEV, "gone")
    bench.controller.connect_device(bench.device)
    assert bench.controller._connection._worker.wait(5000)  # its failure waits to be told
    bench.broken = None
    bench.connect()
    assert bench.controller.situation.link is LinkState.ONLINE
    assert "connect_failed" not in bench.codes()


def test_an_arm_that_is_only_listened_to_is_told_by_its_pace(any_bench, generation):
    bench = any_bench
    bench.controller.connect_device(replace(bench.device, listen_only=True))
    bench.run_until(lambda: bench.controller.situation.generation is not None, 3.0)
    assert bench.controller.situation.generation is generation
