"""MOVE J through the firmware: when the arm moves, when it doesn't, what it says of it."""

from __future__ import annotations

import itertools
import math

import pytest

from armui.protocol.codes import ArmStatusCode, ControlMode, MotionState, MoveMode
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from tests.sim.talk import (
    BOTH,
    DISABLE,
    ENABLE,
    STANDBY,
    heard,
    mode,
    ready,
    status_bytes,
    target,
    tell,
)

TWO = Generation.TWO
GOAL = (30.0, 60.0, -45.0, 10.0, -20.0, 5.0)
HOME = (0.0,) * 6


def run_until_reached(arm: Firmware, *, most_s: float = 60.0) -> float:
    """Steps until the motion state is 0 again; returns the time it took."""
    start_s = arm.time_s
    while arm.condition.motion_state is MotionState.NOT_REACHED:
        arm.step(0.005)
        assert arm.time_s - start_s < most_s
    return arm.time_s - start_s


@pytest.mark.parametrize("generation", BOTH)
@pytest.mark.parametrize(
    "script",
    [
        [*target(*GOAL), mode(100)],
        [mode(100), *target(*GOAL)],
        [mode(100), *reversed(target(*GOAL))],
        [STANDBY, *target(*GOAL), mode(100)],
        [mode(0), *target(*GOAL), mode(100)],
        [mode(100, move=0), *target(*GOAL), mode(100)],
    ],
    ids=["target-mode", "mode-target", "backwards", "standby", "speed-last", "move-p-first"],
)
def test_targets_and_mode_in_any_order_move_the_arm(
    generation: Generation, script: list[str]
) -> None:
    arm = ready(generation)
    assert tell(arm, *script) == []
    assert arm.condition.motion_state is MotionState.NOT_REACHED
    run_until_reached(arm)
    assert arm.joints_deg == pytest.approx(GOAL, abs=0.001)
    assert arm.targets_deg == GOAL


@pytest.mark.parametrize(
    "script",
    [
        target(*GOAL),
        [STANDBY, *target(*GOAL)],
        [mode(100, control=3), *target(*GOAL)],
        [mode(100, move=0), *target(*GOAL)],
        [mode(0), *target(*GOAL)],
        [mode(100), *target(*GOAL)[:2]],
        [mode(100), target(*GOAL)[0], target(*GOAL)[0], target(*GOAL)[2]],
    ],
    ids=["no mode", "standby", "ethernet", "move P", "0 %", "no 0x157", "no 0x156"],
)
def test_what_does_not_move_the_arm(script: list[str]) -> None:
    arm = ready()
    tell(arm, *script)
    arm.step(0.5)
    assert arm.joints_deg == HOME
    assert arm.condition.motion_state is MotionState.REACHED


@pytest.mark.parametrize("joint", range(1, 7))
def test_an_arm_with_one_motor_off_does_not_move_nor_later(joint: int) -> None:
    arm = ready()
    tell(arm, f"471#0{joint}01000000000000", mode(100), *target(*GOAL))
    arm.step(0.5)
    assert arm.joints_deg == HOME
    tell(arm, f"471#0{joint}02000000000000", mode(100))
    arm.step(0.5)
    assert arm.joints_deg == HOME


def test_a_new_set_of_targets_is_enough_once_in_can_control() -> None:
    arm = ready()
    tell(arm, mode(100), *target(*GOAL))
    run_until_reached(arm)
    tell(arm, *target(*HOME))
    assert arm.condition.motion_state is MotionState.NOT_REACHED
    run_until_reached(arm)
    assert arm.joints_deg == HOME


@pytest.mark.parametrize("generation", BOTH)
def test_the_motion_state_in_the_frames_goes_0_1_0_once(generation: Generation) -> None:
    arm = ready(generation)
    payloads = heard(arm.step(0.1), 0x2A1)
    tell(arm, mode(50), *target(*GOAL))
    payloads += heard(arm.step(3.0), 0x2A1)
    states = [payload[8:10] for payload in payloads]
    assert [key for key, _ in itertools.groupby(states)] == ["00", "01", "00"]


@pytest.mark.parametrize("percent", [100, 50, 20, 5, 1])
def test_the_speed_percentage_scales_the_joint_speed(percent: int) -> None:
    """The trapezoid's time: distance / speed + speed / acceleration."""
    arm = ready()
    tell(arm, mode(percent), *target(30.0, 0, 0, 0, 0, 0))
    speed = math.degrees(3.0) * percent / 100
    acceleration = math.degrees(5.0)
    if percent == 100:  # too short a way for full speed: a triangle
        expected_s = 2.0 * math.sqrt(30.0 / acceleration)
    else:
        expected_s = 30.0 / speed + speed / acceleration
    assert run_until_reached(arm) == pytest.approx(expected_s, abs=0.006)


def test_a_host_that_repeats_everything_at_200_hz_gets_the_same_motion() -> None:
    once, often = ready(), ready()
    tell(once, mode(40), *target(*GOAL))
    for _ in range(800):
        tell(often, mode(40), *target(*GOAL))
        once.step(0.005)
        often.step(0.005)
        assert often.joints_deg == pytest.approx(once.joints_deg, abs=0.001)
        assert often.condition.motion_state is once.condition.motion_state
    assert often.joints_deg == GOAL


def test_a_host_that_streams_a_path_at_200_hz_is_followed() -> None:
    """At most the way it needs to stop, v²/2a, behind."""
    arm = ready(joints_deg=(0, 90, -90, 0, 0, 0))
    tell(arm, mode(100))
    lag_deg = 20.0**2 / (2.0 * math.degrees(5.0))
    for tick in range(600):
        angle = 20.0 * (1.0 - math.cos(tick * 0.005))
        tell(arm, mode(100), *target(angle, 90, -90, 0, 0, 0))
        arm.step(0.005)
        assert arm.joints_deg[0] == pytest.approx(angle, abs=lag_deg + 0.15)


def test_a_new_target_replaces_the_old_one_smoothly_within_the_limits() -> None:
    arm = ready()
    tell(arm, mode(100), *target(*GOAL))
    track = [arm.joints_deg]
    for tick in range(1000):
        if tick == 300:
            tell(arm, *target(-40.0, 20.0, -90.0, -10.0, 20.0, -5.0))
        if tick == 450:
            tell(arm, mode(30))
        arm.step(0.001)
        track.append(arm.joints_deg)
    for path in zip(*track, strict=True):
        speeds = [(b - a) / 0.001 for a, b in itertools.pairwise(path)]
        assert max(map(abs, speeds)) <= math.degrees(3.0) + 1e-6
        for a, b in itertools.pairwise(speeds):
            assert abs(b - a) / 0.001 <= math.degrees(5.0) * (1 + 1e-5)


def test_speed_0_in_the_middle_halts_and_more_speed_goes_on() -> None:
    arm = ready()
    tell(arm, mode(50), *target(*GOAL))
    arm.step(0.4)
    tell(arm, mode(0))
    arm.step(1.0)
    halted = arm.joints_deg
    arm.step(1.0)
    assert arm.joints_deg == halted
    assert HOME != halted != GOAL
    assert arm.condition.motion_state is MotionState.NOT_REACHED
    tell(arm, mode(50))
    run_until_reached(arm)
    assert arm.joints_deg == GOAL


@pytest.mark.parametrize("line", [STANDBY, mode(50, move=0), mode(50, control=2)])
def test_leaving_can_control_or_move_j_halts_for_good(line: str) -> None:
    arm = ready()
    tell(arm, mode(50), *target(*GOAL))
    arm.step(0.4)
    tell(arm, line)
    arm.step(1.0)
    halted = arm.joints_deg
    tell(arm, mode(50))
    arm.step(1.0)
    assert arm.joints_deg == halted
    # cut short is not reached
    assert arm.condition.motion_state is MotionState.NOT_REACHED


@pytest.mark.parametrize(
    ("generation", "angles", "payload"),
    [
        # CAN control, status 4, MOVE J, 0, reached, 50 %, reserved, no communication fault
        (Generation.ONE, (150.001, 0, 0, 0, 0, 0), "0104010000320000"),
        # byte 6: bit 0 is joint 1
        (Generation.TWO, (150.001, 0, 0, 0, 0, 0), "0104010000000100"),
        (Generation.TWO, (0, -0.001, 0, 0, 0, 0), "0104010000000200"),
        (Generation.TWO, (0, 0, 0.001, 0, 70.001, 0), "0104010000001400"),
        (Generation.TWO, (0, 0, 0, -100.001, 0, -2147483.648), "0104010000002800"),
    ],
)
def test_a_target_beyond_the_limits_is_refused_and_the_arm_stays(
    generation: Generation, angles: tuple[float, ...], payload: str
) -> None:
    arm = ready(generation)
    tell(arm, mode(50), *target(*angles))
    assert status_bytes(arm) == payload
    arm.step(0.5)
    assert arm.joints_deg == HOME
    assert arm.targets_deg == HOME
    tell(arm, *target(1.0, 1.0, -1.0, 0, 0, 0))
    assert arm.condition.status is ArmStatusCode.NORMAL
    run_until_reached(arm)
    assert arm.joints_deg == (1.0, 1.0, -1.0, 0, 0, 0)


@pytest.mark.parametrize(
    "angles", [(150.0, 180.0, -170.0, 100.0, 70.0, 120.0), (-150.0, 0, 0, -100.0, -70.0, -120.0)]
)
def test_the_limits_themselves_are_within(angles: tuple[float, ...]) -> None:
    arm = ready()
    tell(arm, mode(100), *target(*angles))
    assert arm.condition.status is ArmStatusCode.NORMAL
    run_until_reached(arm)
    assert arm.joints_deg == angles


def test_a_refused_target_ends_the_motion_under_way() -> None:
    arm = ready()
    tell(arm, mode(50), *target(*GOAL))
    arm.step(0.4)
    tell(arm, *target(200.0, 0, 0, 0, 0, 0))
    arm.step(1.0)
    halted = arm.joints_deg
    arm.step(1.0)
    assert arm.joints_deg == halted != GOAL


def test_limits_set_over_the_bus_count_at_once() -> None:
    arm = ready()
    # joint 1: ±10.0° (0x0064, 0xFF9C), 0.30 rad/s (0x001E)
    tell(arm, "474#010064FF9C001E00", mode(100), *target(11.0, 0, 0, 0, 0, 0))
    assert arm.condition.status is ArmStatusCode.TARGET_BEYOND_LIMIT
    tell(arm, *target(10.0, 0, 0, 0, 0, 0))
    speed, acceleration = math.degrees(0.3), math.degrees(5.0)
    assert run_until_reached(arm) == pytest.approx(10 / speed + speed / acceleration, abs=0.006)


def test_disabling_and_enabling_forgets_a_target_that_waits() -> None:
    arm = ready()
    tell(arm, *target(*GOAL), DISABLE, ENABLE, mode(100))
    arm.step(0.5)
    assert arm.joints_deg == HOME


def test_modes_and_speed_are_reported() -> None:
    arm = ready(Generation.ONE)
    assert status_bytes(arm) == "0000000000000000"
    tell(arm, mode(77, control=1, move=3))
    # CAN control, normal, MOVE C, 77 % = 0x4D
    assert status_bytes(arm) == "01000300004D0000"
    assert arm.condition.control_mode is ControlMode.CAN_CONTROL
    assert arm.condition.move_mode is MoveMode.MOVE_C
    assert arm.condition.speed_percent == 77


def test_generation_2_knows_more_modes() -> None:
    arm = ready(TWO)
    tell(arm, mode(50, control=7, move=5))
    assert status_bytes(arm) == "0700050000000000"


@pytest.mark.parametrize("generation", BOTH)
def test_a_joint_that_cannot_be_reached_halts_the_arm(generation: Generation) -> None:
    arm = ready(generation)
    tell(arm, mode(50), *target(*GOAL))
    arm.step(0.4)
    arm.set_communication_fault(5, present=True)
    # status 5, byte 7 bit 4; not reached
    assert status_bytes(arm)[2:4] == "05"
    assert status_bytes(arm)[14:16] == "10"
    arm.step(1.0)
    halted = arm.joints_deg
    tell(arm, *target(*GOAL))
    arm.step(1.0)
    assert arm.joints_deg == halted
    arm.set_communication_fault(5, present=False)
    tell(arm, *target(*GOAL))
    run_until_reached(arm)
    assert arm.joints_deg == GOAL
    assert status_bytes(arm)[2:4] == "00"


def test_a_target_without_a_way_is_no_solution_until_the_next() -> None:
    arm = ready()
    tell(arm, mode(50), *target(*GOAL))
    arm.step(0.4)
    arm.settings.accelerations_deg_s2[0] = float("nan")
    tell(arm, *target(10.0, 0, 0, 0, 0, 0))
    halted = arm.joints_deg
    # status 2
    assert status_bytes(arm)[:4] == "0102"
    arm.step(0.5)
    assert arm.joints_deg == halted
    arm.settings.accelerations_deg_s2[0] = 100.0
    tell(arm, *target(10.0, 0, 0, 0, 0, 0))
    assert status_bytes(arm)[:4] == "0100"
    run_until_reached(arm)
