"""Motors on and off, emergency stop and resume: an arm without brakes."""

from __future__ import annotations

import itertools

import pytest

from armui.protocol.codes import ArmStatusCode, ControlMode, MotionState
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from tests.sim.talk import (
    BOTH,
    DISABLE,
    ENABLE,
    RESUME,
    STOP,
    heard,
    mode,
    ready,
    status_bytes,
    target,
    tell,
)

TWO = Generation.TWO
LEANING = (10.0, 110.0, -60.0, 5.0, 10.0, 15.0)
"""Shoulder in front of the base, forearm stretched out: gravity pulls joints 2 and 3."""


def enabled_bits(arm: Firmware) -> str:
    """Bit 6 of byte 5 of 0x261–0x266, joint 1 first."""
    frames = arm.step(0.1)
    last = [heard(frames, 0x260 + joint)[-1] for joint in range(1, 7)]
    return "".join(str(int(payload[10:12], 16) >> 6 & 1) for payload in last)


@pytest.mark.parametrize("generation", BOTH)
def test_enabling_shows_in_every_driver(generation: Generation) -> None:
    arm = Firmware(generation)
    assert enabled_bits(arm) == "000000"
    tell(arm, "471#0302000000000000")
    assert enabled_bits(arm) == "001000"
    tell(arm, ENABLE)
    assert enabled_bits(arm) == "111111"
    tell(arm, "471#0601000000000000")
    assert enabled_bits(arm) == "111110"
    tell(arm, DISABLE)
    assert enabled_bits(arm) == "000000"
    assert arm.enabled == (False,) * 6


def test_an_arm_that_never_had_power_stays_where_it_lies() -> None:
    arm = Firmware(TWO, joints_deg=LEANING)
    arm.step(5.0)
    assert arm.joints_deg == LEANING
    tell(arm, STOP)
    arm.step(5.0)
    assert arm.joints_deg == LEANING


def test_powered_motors_hold_against_gravity() -> None:
    arm = ready(joints_deg=LEANING)
    arm.step(5.0)
    assert arm.joints_deg == LEANING


@pytest.mark.parametrize("generation", BOTH)
def test_emergency_stop_halts_at_once_and_cuts_the_power(generation: Generation) -> None:
    arm = ready(generation)
    tell(arm, mode(100), *target(90.0, 90.0, -90.0, 0, 0, 0))
    arm.step(0.4)
    fast, before = arm.mechanics.speeds_deg_s, arm.joints_deg
    assert max(map(abs, fast)) > 50.0
    assert tell(arm, STOP) == []
    assert arm.mechanics.speeds_deg_s == (0.0,) * 6
    assert enabled_bits(arm) == "000000"
    # joint 1 carries no weight: it stands where it was
    assert arm.joints_deg[0] == before[0]
    payload = status_bytes(arm)
    # CAN control, emergency stop, MOVE J, -, not reached
    assert payload[:10] == "0101010001"
    assert arm.condition.stopped


def test_a_stopped_arm_sinks_slowly_and_within_its_limits() -> None:
    arm = ready(joints_deg=LEANING)
    tell(arm, STOP)
    track = [arm.joints_deg]
    for _ in range(1000):
        arm.step(0.005)
        track.append(arm.joints_deg)
        assert all(
            limits.min_deg <= angle <= limits.max_deg
            for angle, limits in zip(arm.joints_deg, arm.settings.limits, strict=True)
        )
    speeds = [
        abs(b - a) / 0.005
        for before, after in itertools.pairwise(track)
        for a, b in zip(before, after, strict=True)
    ]
    assert 0.5 < max(speeds) <= 5.0 + 1e-6
    # leaning forward, the shoulder goes on forward; joints 1, 4, 6 stay
    assert arm.joints_deg[1] > LEANING[1] + 5.0
    assert [arm.joints_deg[i] for i in (0, 3, 5)] == [LEANING[i] for i in (0, 3, 5)]


def test_the_speeds_of_a_sinking_arm_are_those_of_its_positions() -> None:
    arm = ready(joints_deg=LEANING)
    tell(arm, STOP)
    for _ in range(100):
        before = arm.joints_deg
        arm.step(0.005)
        for a, b, speed in zip(before, arm.joints_deg, arm.mechanics.speeds_deg_s, strict=True):
            assert (b - a) / 0.005 == pytest.approx(speed, abs=1e-6)


def test_resume_drops_the_arm_and_needs_enabling_again() -> None:
    stopped, resumed = ready(joints_deg=LEANING), ready(joints_deg=LEANING)
    tell(stopped, mode(50), STOP)
    tell(resumed, mode(50), STOP)
    stopped.step(0.2)
    resumed.step(0.2)
    assert tell(resumed, RESUME) == []
    stopped.step(0.5)
    resumed.step(0.5)
    sunk = stopped.joints_deg[1] - LEANING[1]
    dropped = resumed.joints_deg[1] - LEANING[1]
    assert dropped > 5.0 * sunk > 0.0
    assert resumed.condition.status is ArmStatusCode.NORMAL
    assert resumed.condition.control_mode is ControlMode.STANDBY
    assert resumed.condition.motion_state is MotionState.REACHED
    assert enabled_bits(resumed) == "000000"
    tell(resumed, mode(50), *target(*LEANING))
    fallen = resumed.joints_deg
    resumed.step(5.0)
    assert resumed.joints_deg != LEANING
    tell(resumed, ENABLE)
    caught = resumed.joints_deg
    assert caught != fallen
    resumed.step(1.0)
    assert resumed.joints_deg == caught
    tell(resumed, mode(50), *target(*LEANING))
    resumed.step(10.0)
    assert resumed.joints_deg == LEANING


def test_disabling_drops_the_arm_to_rest_and_it_lies_still() -> None:
    arm = ready(joints_deg=LEANING)
    tell(arm, DISABLE)
    arm.step(30.0)
    at_rest = arm.joints_deg
    assert at_rest != LEANING
    arm.step(10.0)
    assert arm.joints_deg == at_rest
    assert arm.mechanics.speeds_deg_s == (0.0,) * 6


def test_an_arm_folded_on_its_base_has_nowhere_to_fall() -> None:
    arm = ready()
    tell(arm, DISABLE)
    arm.step(5.0)
    assert arm.joints_deg == (0.0,) * 6


def test_one_disabled_joint_drops_and_the_others_hold() -> None:
    arm = ready(joints_deg=LEANING)
    tell(arm, "471#0301000000000000")
    arm.step(2.0)
    assert arm.joints_deg[2] != LEANING[2]
    assert [a for i, a in enumerate(arm.joints_deg) if i != 2] == [
        a for i, a in enumerate(LEANING) if i != 2
    ]
    tell(arm, "471#0302000000000000")
    caught = arm.joints_deg
    arm.step(1.0)
    assert arm.joints_deg == caught


def test_disabling_one_joint_ends_a_motion() -> None:
    arm = ready()
    tell(arm, mode(100), *target(90.0, 45.0, -45.0, 0, 0, 0))
    arm.step(0.3)
    tell(arm, "471#0601000000000000")
    arm.step(1.0)
    halted = arm.joints_deg
    assert 0.0 < halted[0] < 90.0
    arm.step(1.0)
    assert arm.joints_deg == halted


@pytest.mark.parametrize(
    "lines", [[ENABLE], [mode(50)], target(1, 1, -1, 0, 0, 0), ["159#00009C4003E80100"], [STOP]]
)
def test_what_a_stopped_arm_ignores(lines: list[str]) -> None:
    arm = ready()
    tell(arm, STOP, *lines)
    arm.step(0.5)
    assert arm.condition.stopped
    assert arm.enabled == (False,) * 6
    assert arm.condition.control_mode is ControlMode.STANDBY
    tell(arm, RESUME, ENABLE, mode(50))
    arm.step(0.5)
    assert arm.joints_deg == (0.0,) * 6
    assert arm.gripper.travel == 0.0


def test_resume_clears_a_refused_target() -> None:
    arm = ready()
    tell(arm, mode(50), *target(151.0, 0, 0, 0, 0, 0))
    assert arm.condition.status is ArmStatusCode.TARGET_BEYOND_LIMIT
    tell(arm, RESUME)
    assert status_bytes(arm)[2:4] == "00"
    assert arm.enabled == (False,) * 6


def test_a_stop_in_the_middle_of_a_drop_catches_it_with_damping() -> None:
    arm = ready(joints_deg=LEANING)
    tell(arm, DISABLE)
    arm.step(0.3)
    fast = arm.mechanics.speeds_deg_s[1]
    tell(arm, STOP)
    arm.step(1.0)
    assert fast > 20.0
    assert 0.0 < arm.mechanics.speeds_deg_s[1] <= 5.0 + 0.1


def test_disabling_a_stopped_arm_does_not_undo_the_damping() -> None:
    arm = ready(joints_deg=LEANING)
    tell(arm, STOP)
    assert tell(arm, DISABLE) == ["476#7100000000000000"]
    arm.step(1.0)
    assert 0.0 < arm.mechanics.speeds_deg_s[1] <= 5.0 + 0.1
