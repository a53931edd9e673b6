"""S15: what is known of an arm was heard from that arm, since it came."""

import errno
from dataclasses import replace
from typing import Any

import can
import pytest

from armui.arm.parameters import Batch, Group, Parameter, reading_of
from armui.control.link.link_state import LinkState
from armui.control.parameters.setting_cell import CellState
from armui.control.parameters.setting_checks import SETTING_UNKNOWN
from armui.control.safety.recovery_steps import StepKind
from armui.protocol.codes import LinkageRole
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from armui.sim.node import Node
from tests.accepted import accepted
from tests.arm_rig import ArmRig
from tests.faulty_arm import FaultyDrivers, HardOfHearing
from tests.moments import now

END = Batch(Group.END_LIMITS)
LINEAR_SPEED = Parameter("max_linear_speed_m_s")
ANGULAR_SPEED = Parameter("max_angular_speed_rad_s")
STALL_BIT = 0x80
VERSION = 0x4AF


def swap(rig, firmware):
    """Plug another arm into the same adapter."""
    rig.firmware = firmware
    rig.node = Node(firmware, rig._arm_bus)


def settled(rig):
    rig.run_until(lambda: not rig.controller.settings.busy)


@pytest.mark.parametrize("first", Generation, ids=["gen1", "gen2"])
def test_another_arm_on_the_same_adapter_is_asked_anew(qapp, request, first):
    rig = ArmRig(request.node.nodeid, first)
    second = Generation.ONE if first is Generation.TWO else Generation.TWO
    rig.connect()
    assert rig.controller.settings.read([END]) is None
    settled(rig)
    rig.powered = False
    rig.run(0.7)
    swap(rig, Firmware(second))
    rig.powered = True
    rig.run_until(lambda: rig.controller.operating_state.link is LinkState.ONLINE)
    assert now(rig.controller.operating_state.generation) is None
    rig.run_until(lambda: None not in rig.controller.state.limits, 3.0)
    assert now(rig.controller.operating_state.generation) is second
    # what the first arm held is not shown, and stands in no frame to the second
    assert reading_of(rig.controller.state, LINEAR_SPEED) is None
    assert rig.controller.settings.cell(LINEAR_SPEED).state is CellState.UNREAD
    ear = HardOfHearing(rig.firmware)
    assert rig.controller.settings.save({LINEAR_SPEED: 0.25}).reason == SETTING_UNKNOWN
    rig.run(0.1)
    assert all(frame.arbitration_id != 0x479 for frame in ear.heard)
    rig.controller.settings.read([END])
    settled(rig)
    before = reading_of(rig.controller.state, ANGULAR_SPEED).value
    accepted(rig.controller.settings.save({LINEAR_SPEED: 0.25}))
    settled(rig)
    assert reading_of(rig.controller.state, LINEAR_SPEED).value == 0.25
    assert reading_of(rig.controller.state, ANGULAR_SPEED).value == before == 1.0
    rig.close()


def test_an_arm_swapped_while_the_window_was_held_up_is_asked_anew(rig):
    rig.connect()
    rig._settle()
    swap(rig, Firmware(Generation.ONE))
    rig.time_s += 2.0  # no look at the arm meanwhile
    rig.node.poll(0.02)
    rig._settle()
    rig.run(2.0)
    rig.run_until(lambda: rig.controller.operating_state.generation is not None, 3.0)
    assert rig.controller.operating_state.generation is Generation.ONE


def test_a_power_cycle_starts_from_nothing(any_rig):
    rig = any_rig
    rig.connect()
    rig.controller.settings.read([END])
    settled(rig)
    rig.powered = False
    rig.run(0.7)
    assert now(rig.controller.operating_state.link) is LinkState.OFFLINE
    rig.powered = True
    rig.run_until(lambda: rig.controller.operating_state.link is LinkState.ONLINE)
    assert rig.controller.operating_state.generation is None
    assert rig.controller.state.joints_without_limits() == [1, 2, 3, 4, 5, 6]
    rig.run_until(lambda: rig.codes().count("limits_read") == 2)
    assert rig.controller.settings.cell(LINEAR_SPEED).state is CellState.UNREAD


def test_after_a_power_cycle_the_offset_of_the_commands_is_proven_by_nothing(any_rig):
    rig = any_rig
    rig.connect()
    accepted(rig.controller.linkage.set(LinkageRole.MOTION_OUTPUT, control_offset=0x10))
    rig.run_until(lambda: rig.controller.operating_state.addressing.control_offset == 0x10)
    assert rig.controller.operating_state.control_certain
    rig.powered = False
    rig.run(0.7)
    rig.powered = True
    rig.run_until(lambda: rig.controller.operating_state.link is LinkState.ONLINE)
    assert not rig.controller.operating_state.control_certain


def test_after_a_lost_cable_nothing_of_before_counts(any_rig, qtbot):
    rig = any_rig
    rig.connect()
    rig.unplug(can.CanOperationError("gone", error_code=errno.ENODEV))
    qtbot.waitUntil(lambda: rig.controller.operating_state.link is LinkState.LOST)
    rig.controller.tick()
    assert rig.controller.operating_state.generation is None
    assert rig.controller.state.limits == (None,) * 6
    assert rig.controller.state.last_feedback_s is None


def test_no_false_stall_before_the_generation_is_known(qapp, request):
    rig = ArmRig(request.node.nodeid, Generation.ONE)
    drivers = FaultyDrivers(rig.firmware)
    drivers.bits = dict.fromkeys(range(1, 7), STALL_BIT)  # «homed» in generation 1
    shown: list[Any] = []
    rig.controller.state_changed.connect(
        lambda state: shown.extend(each.value for each in state.drivers_slow if each is not None)
    )
    steps = []
    rig.controller.step_changed.connect(lambda step: steps.append(step.kind))
    rig.controller.connect_device(rig.device)
    rig.run_until(lambda: "limits_read" in rig.codes())
    rig.run(0.3)
    assert any(each.homed for each in shown)
    assert not any(each.stall_protection for each in shown)
    assert StepKind.STALL not in steps
    drivers.mend()
    rig.close()


def test_a_version_that_comes_late_is_asked_for_again(rig):
    ear = HardOfHearing(rig.firmware)
    ear.mute_on = {VERSION}
    rig.controller.connect_device(rig.device)
    rig.run_until(lambda: rig.controller.operating_state.link is LinkState.ONLINE)
    rig.run(0.4)
    questions = [frame for frame in ear.heard if frame.arbitration_id == VERSION]
    assert questions == [Frame(VERSION, bytes.fromhex("01 00 00 00 00 00 00 00"))]
    ear.mute_on = set()
    rig.run_until(lambda: rig.controller.operating_state.generation is not None, 1.0)
    assert rig.controller.operating_state.generation is Generation.TWO


def test_an_answer_without_a_readable_version_is_no_generation_1(rig):
    ear = HardOfHearing(rig.firmware)
    ear.mute_on = {VERSION}
    rig.controller.connect_device(rig.device)
    rig.run_until(lambda: rig.controller.operating_state.link is LinkState.ONLINE)
    cut = can.Message(arbitration_id=VERSION, data=b"\0\0\0\0S-V1", is_extended_id=False)
    rig._arm_bus.send(cut)
    rig.run_until(lambda: rig.controller.operating_state.generation is not None, 5.0)
    assert rig.controller.operating_state.generation is Generation.TWO


def test_a_late_failure_of_one_device_does_not_close_the_next(rig):
    rig.broken = OSError(errno.ENODEV, "gone")
    rig.controller.connect_device(rig.device)
    assert rig.controller._connection._worker.wait(5000)  # its failure waits to be told
    rig.broken = None
    rig.connect()
    assert rig.controller.operating_state.link is LinkState.ONLINE
    assert "connect_failed" not in rig.codes()


def test_an_arm_that_is_only_listened_to_is_told_by_its_pace(any_rig, generation):
    rig = any_rig
    rig.controller.connect_device(replace(rig.device, listen_only=True))
    rig.run_until(lambda: rig.controller.operating_state.generation is not None, 3.0)
    assert rig.controller.operating_state.generation is generation
