"""The arm's supply taken away and given back, in both generations."""

from __future__ import annotations

import pytest

from armui.protocol.codes import ControlMode, MotionState
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from tests.sim.talk import ENABLE, STOP, mode, ready, status_bytes, target, tell

LEANING = (0.0, 60.0, -60.0, 0.0, 20.0, 0.0)


def moving(generation: Generation) -> Firmware:
    arm = ready(generation, joints_deg=LEANING)
    tell(arm, mode(30), *target(90, 60, -60, 0, 20, 0))
    arm.step(0.5)
    assert arm.condition.motion_state is MotionState.NOT_REACHED
    return arm


def test_the_arm_drops_and_starts_in_standby(generation: Generation) -> None:
    arm = moving(generation)
    before = arm.joints_deg
    arm.power_cycle()
    assert arm.enabled == (False,) * 6
    assert arm.joints_deg == before
    # 0x2A1: standby, normal, MOVE P, no teaching, reached
    assert status_bytes(arm)[:10] == "0000000000"
    arm.step(0.3)
    assert abs(arm.joints_deg[1] - LEANING[1]) > 5.0
    assert arm.joints_deg[0] == pytest.approx(before[0], abs=0.5)  # no target is left to go to


def test_no_target_outlives_it(generation: Generation) -> None:
    arm = moving(generation)
    tell(arm, *target(0, 0, 0, 0, 0, 0)[:2])  # two of three frames
    arm.power_cycle()
    arm.step(30.0)
    tell(arm, ENABLE, mode(30))
    lies = arm.joints_deg
    tell(arm, target(0, 0, 0, 0, 0, 0)[2])
    arm.step(2.0)
    assert arm.joints_deg == lies
    assert arm.condition.control_mode is ControlMode.CAN_CONTROL


def test_what_the_flash_holds_is_kept_and_the_rest_is_gone(generation: Generation) -> None:
    arm = moving(generation)
    tell(arm, "121#0102FF0000010000", "47A#0303030303030000")
    lights = dict(arm.settings.lights)
    arm.power_cycle()
    assert arm.settings.collision_levels == (3,) * 6
    assert lights
    assert not arm.settings.lights


def test_while_it_is_off_it_hears_and_says_nothing_and_falls(generation: Generation) -> None:
    arm = moving(generation)
    arm.switch_off()
    assert tell(arm, ENABLE, STOP, "4AF#0100000000000000") == []
    assert arm.step(1.0) == []
    assert abs(arm.joints_deg[1] - LEANING[1]) > 5.0
    arm.switch_on()
    assert arm.step(0.02)
    assert not arm.condition.stopped
    assert arm.enabled == (False,) * 6


def test_mit_ends_with_the_power() -> None:
    arm = ready(joints_deg=LEANING)
    tell(arm, "151#010600AD00000000")
    arm.power_cycle()
    arm.step(30.0)
    tell(arm, ENABLE, mode(30))
    lies = arm.joints_deg
    arm.step(1.0)
    assert arm.joints_deg == lies


def test_an_aborted_target_does_not_come_back_with_a_mode_word(generation: Generation) -> None:
    arm = moving(generation)
    first, second, third = target(90, 60, -60, 0, 20, 0)
    tell(arm, first, second, "150#0006000000000000")
    arm.step(1.0)
    halted = arm.joints_deg
    tell(arm, mode(100))
    arm.step(1.0)
    tell(arm, third)
    arm.step(1.0)
    assert arm.joints_deg == halted


def test_at_speed_0_a_motion_waits_and_counts_as_not_reached(generation: Generation) -> None:
    arm = moving(generation)
    tell(arm, mode(0))
    arm.step(1.0)
    waits = arm.joints_deg
    arm.step(60.0)
    assert arm.joints_deg == waits
    assert arm.condition.motion_state is MotionState.NOT_REACHED
    tell(arm, mode(30))
    arm.step(10.0)
    assert arm.joints_deg[0] == 90.0
