"""0x150 byte 2: a hand leads the arm, the arm remembers and does it again; left with a reset."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from armui.protocol.codes import ArmStatusCode, ControlMode, MotionState
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from tests.moments import now
from tests.sim.talk import (
    BOTH,
    DISABLE,
    ENABLE,
    RESUME,
    STOP,
    mode,
    ready,
    status_bytes,
    target,
    tell,
)

TWO = Generation.TWO
HOME = (0.0,) * 6
THERE = (20.0, 40.0, -30.0, 10.0, -15.0, 5.0)

RECORD = "150#0000010000000000"
END = "150#0000020000000000"
RUN = "150#0000030000000000"
PAUSE = "150#0000040000000000"
CONTINUE = "150#0000050000000000"
ABORT = "150#0000060000000000"
TO_START = "150#0000070000000000"


def taught(generation: Generation = TWO, **arm_type: Any) -> Firmware:
    """An arm that was led from home to `THERE` and back half the way."""
    arm = ready(generation, **arm_type)
    tell(arm, RECORD)
    arm.hand_guiding.lead_to(THERE, speed_deg_s=40.0)
    arm.step(1.5)
    arm.hand_guiding.lead_to(HOME, speed_deg_s=20.0)
    arm.step(1.0)
    arm.hand_guiding.release()
    tell(arm, END)
    return arm


def steps(arm: Firmware, count: int) -> list[tuple[float, ...]]:
    track = []
    for _ in range(count):
        arm.step(0.005)
        track.append(arm.joints_deg)
    return track


def until_reached(arm: Firmware) -> list[tuple[float, ...]]:
    track = [arm.joints_deg]
    while arm.condition.motion_state is MotionState.NOT_REACHED:
        track += steps(arm, 1)
        assert len(track) < 10_000
    return track


def check_limits(track: list[tuple[float, ...]]) -> None:
    speeds = np.diff(np.array(track), axis=0) / 0.005
    assert np.abs(speeds).max() <= np.degrees(3.0) * (1 + 1e-6)
    assert np.abs(np.diff(speeds, axis=0) / 0.005).max() <= np.degrees(5.0) * (1 + 1e-3)


@pytest.mark.parametrize("generation", BOTH)
def test_recording_and_replaying_as_the_frames_tell_it(generation: Generation) -> None:
    arm = ready(generation)
    assert tell(arm, RECORD) == []
    # teaching mode, status 0x0B, MOVE P, teaching state 1, reached
    assert status_bytes(arm) == "020B000100000000"
    arm.hand_guiding.lead_to(THERE, speed_deg_s=40.0)
    arm.step(1.5)
    assert arm.joints_deg == THERE
    assert tell(arm, END) == []
    assert status_bytes(arm) == "0200000200000000"
    assert tell(arm, RUN) == []
    assert status_bytes(arm) == "020C000301000000"
    track = until_reached(arm)
    assert status_bytes(arm) == "0200000000000000"
    check_limits(track)
    assert arm.joints_deg == pytest.approx(THERE)
    assert min(max(map(abs, joints)) for joints in track) < 0.01  # it was at the start


def test_a_replay_passes_where_the_hand_was() -> None:
    arm = taught()
    recorded = np.array(arm.teaching.recording)
    tell(arm, RUN)
    track = np.array(until_reached(arm))
    for place in recorded:
        assert np.abs(track - place).max(axis=1).min() < 0.3


def test_a_replay_pauses_on_its_way_and_goes_on() -> None:
    arm = taught()
    tell(arm, TO_START)
    until_reached(arm)
    assert arm.joints_deg == HOME
    tell(arm, RUN)
    track = steps(arm, 160)
    tell(arm, PAUSE)
    # 0x0D, teaching state 4
    assert status_bytes(arm) == "020D000401000000"
    track += steps(arm, 200)
    standing = arm.joints_deg
    arm.step(1.0)
    assert arm.joints_deg == standing != HOME
    tell(arm, CONTINUE)
    assert status_bytes(arm) == "020C000501000000"
    until_reached(arm)
    assert arm.joints_deg == pytest.approx(arm.teaching.recording[-1])


def test_an_aborted_replay_stays_where_it_brakes() -> None:
    arm = taught()
    tell(arm, RUN)
    arm.step(0.5)
    tell(arm, ABORT)
    arm.step(1.0)
    standing = arm.joints_deg
    tell(arm, CONTINUE)
    arm.step(1.0)
    assert arm.joints_deg == standing
    assert arm.condition.status is ArmStatusCode.NORMAL
    assert arm.condition.motion_state is MotionState.NOT_REACHED


def test_dragging_too_fast_ends_the_recording() -> None:
    arm = ready()
    tell(arm, RECORD)
    arm.hand_guiding.push((0, 200.0, 0, 0, 0, 0))  # more than 3 rad/s
    arm.step(0.1)
    assert status_bytes(arm)[:4] == "0208"
    stopped_at = arm.joints_deg
    arm.step(0.5)
    assert arm.joints_deg == stopped_at
    assert stopped_at[1] < 20.0


@pytest.mark.parametrize(
    "line", [END, RUN, PAUSE, CONTINUE, ABORT, TO_START, "150#0000000000000000"]
)
def test_what_makes_no_sense_without_a_recording_is_ignored(line: str) -> None:
    arm, other = ready(), ready()
    assert tell(arm, line) == []
    assert arm.step(0.3) == other.step(0.3)


def test_an_arm_without_power_cannot_be_taught() -> None:
    arm = Firmware(TWO)
    tell(arm, RECORD)
    assert arm.condition.status is ArmStatusCode.NORMAL
    assert arm.condition.control_mode is ControlMode.STANDBY


def test_drag_teaching_is_left_by_a_reset_near_the_rest_pose_only() -> None:
    arm = taught(version="S-V1.8-4")
    tell(arm, TO_START)
    until_reached(arm)
    tell(arm, mode(50))
    assert now(arm.condition.control_mode) is ControlMode.TEACHING
    tell(arm, STOP)
    arm.step(1.0)
    tell(arm, RESUME)
    assert now(arm.condition.control_mode) is ControlMode.STANDBY
    tell(arm, ENABLE, mode(50))
    assert arm.condition.control_mode is ControlMode.CAN_CONTROL


def test_a_reset_far_from_the_rest_pose_does_not_leave_drag_teaching() -> None:
    arm = taught(version="S-V1.8-4")
    tell(arm, STOP, RESUME, ENABLE, mode(50))
    assert now(arm.condition.control_mode) is ControlMode.TEACHING
    tell(arm, TO_START)
    until_reached(arm)
    tell(arm, STOP, RESUME)
    assert now(arm.condition.control_mode) is ControlMode.STANDBY


@pytest.mark.parametrize("far", [True, False], ids=["far from rest", "near rest"])
def test_newer_firmware_leaves_drag_teaching_by_a_mode_word_and_holds(far: bool) -> None:
    """A clean change out of teaching from S-V1.8-5 on: no reset, and the arm doesn't drop."""
    arm = taught(version="S-V1.8-5")
    if not far:
        tell(arm, TO_START)
        until_reached(arm)
    here = arm.joints_deg

    tell(arm, mode(50))
    track = steps(arm, 400)

    assert now(arm.condition.control_mode) is ControlMode.CAN_CONTROL
    assert not arm.teaching.entered
    assert all(arm.mechanics.powered)
    assert np.abs(np.array(track) - here).max() < 1e-6
    tell(arm, *target(*HOME), mode(50))
    until_reached(arm)
    assert arm.joints_deg == pytest.approx(HOME, abs=0.01)


def test_a_mode_word_ends_a_recording_or_a_replay_of_newer_firmware() -> None:
    arm = ready()
    tell(arm, RECORD)
    arm.hand_guiding.lead_to(THERE, speed_deg_s=20.0)
    arm.step(1.0)
    tell(arm, mode(50))
    here = now(arm.joints_deg)
    arm.step(1.0)
    assert arm.joints_deg == here
    assert arm.condition.status is ArmStatusCode.NORMAL

    arm = taught()
    tell(arm, RUN)
    track = steps(arm, 60)
    tell(arm, mode(50))
    track += steps(arm, 400)
    check_limits(track)  # it brakes
    assert track[-1] == track[-2]
    assert now(arm.condition.control_mode) is ControlMode.CAN_CONTROL


@pytest.mark.parametrize("line", [STOP, DISABLE])
def test_a_stop_or_a_cut_of_the_power_ends_a_replay(line: str) -> None:
    arm = taught()
    tell(arm, RUN)
    arm.step(1.0)
    tell(arm, line)
    assert status_bytes(arm)[6:8] == "00"
    tell(arm, CONTINUE)
    arm.step(0.5)
    assert arm.condition.status in (ArmStatusCode.EMERGENCY_STOP, ArmStatusCode.NORMAL)
    assert not any(arm.enabled)


def test_a_power_cycle_forgets_the_recording_and_drag_teaching() -> None:
    arm = taught()
    arm.power_cycle()
    assert now(arm.condition.control_mode) is ControlMode.STANDBY
    tell(arm, ENABLE, mode(50))
    assert now(arm.condition.control_mode) is ControlMode.CAN_CONTROL
    assert arm.teaching.recording == []
