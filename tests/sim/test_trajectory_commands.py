"""0x150 byte 1: pause, continue, clear, abort, in every kind of motion."""

from __future__ import annotations

import numpy as np
import pytest

from armui.kinematics.arm_kinematics import Kinematics
from armui.protocol.codes import MotionState
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from tests.family import PIPER
from tests.sim.talk import (
    BOTH,
    RESUME,
    STOP,
    arc_point,
    frame,
    mode,
    pose_target,
    ready,
    status_bytes,
    target,
    tell,
)

ONE, TWO = Generation.ONE, Generation.TWO
KINEMATICS = Kinematics(PIPER)
HERE = (10.0, 70.0, -60.0, 10.0, 25.0, -20.0)
P, J, L, C = 0, 1, 2, 3

PAUSE = "150#0001000000000000"
CONTINUE = "150#0002000000000000"
CLEAR_CURRENT = "150#0003000000000000"
CLEAR_ALL = "150#0004000000000000"
GET_CURRENT = "150#0005000000000000"
ABORT = "150#0006000000000000"

X, Y, Z, RX, RY, RZ = KINEMATICS.forward(HERE)
THERE = (X + 60.0, Y - 120.0, Z + 30.0, RX, RY, RZ)
BETWEEN = (X + 60.0, Y - 40.0, Z + 50.0, RX, RY, RZ)


def script(move: int, speed_percent: int = 100) -> list[str]:
    """The frames that start a motion from `HERE`."""
    if move == J:
        return [mode(speed_percent), *target(60.0, 100.0, -90.0, 0, 0, 0)]
    if move != C:
        return [mode(speed_percent, move=move), *pose_target(*THERE)]
    lines = []
    for number, pose in enumerate(((X, Y, Z, RX, RY, RZ), BETWEEN, THERE), start=1):
        lines += [*pose_target(*pose), arc_point(number)]
    return [*lines, mode(speed_percent, move=C)]


def run(arm: Firmware, most_s: float = 20.0) -> list[tuple[float, ...]]:
    """Steps until the target is reached."""
    track = [arm.joints_deg]
    while arm.condition.motion_state is MotionState.NOT_REACHED:
        track.append(stepped(arm))
        assert len(track) * 0.005 < most_s
    return track


def stepped(arm: Firmware) -> tuple[float, ...]:
    arm.step(0.005)
    return arm.joints_deg


def to_the_track(joints: list[tuple[float, ...]], track: list[tuple[float, ...]]) -> float:
    """How far the flange strays from the places another arm passed, in mm."""
    ours = np.array([KINEMATICS.matrix(each)[:3, 3] for each in joints])
    theirs = np.array([KINEMATICS.matrix(each)[:3, 3] for each in track])
    starts, ways = theirs[:-1], np.diff(theirs, axis=0)
    lengths = np.maximum((ways**2).sum(axis=1), 1e-12)
    shares = ((ours[:, None] - starts) * ways).sum(axis=2) / lengths
    nearest = starts + np.clip(shares, 0.0, 1.0)[:, :, None] * ways
    return float(np.linalg.norm(ours[:, None] - nearest, axis=2).min(axis=1).max())


@pytest.mark.each_value(full="each move in both generations")
@pytest.mark.parametrize("generation", BOTH)
@pytest.mark.parametrize("move", [P, J, L, C])
def test_a_pause_brakes_and_continuing_goes_on_to_the_target(
    generation: Generation, move: int
) -> None:
    free, paused = ready(generation, HERE), ready(generation, HERE)
    tell(free, *script(move))
    tell(paused, *script(move))
    track = [stepped(paused) for _ in range(100)]
    assert tell(paused, PAUSE) == []
    track += [stepped(paused) for _ in range(200)]
    standing = paused.joints_deg
    track += [stepped(paused) for _ in range(100)]
    assert paused.joints_deg == standing
    assert paused.condition.motion_state is MotionState.NOT_REACHED
    assert tell(paused, CONTINUE) == []
    track += run(paused)
    undisturbed = run(free)
    assert paused.joints_deg == free.joints_deg
    assert standing != free.joints_deg
    if move in (L, C):
        assert to_the_track(track, undisturbed) < 0.1
    speeds = np.diff(np.array(track), axis=0) / 0.005
    assert np.abs(speeds).max() <= np.degrees(3.0) * (1 + 1e-6)
    assert np.abs(np.diff(speeds, axis=0) / 0.005).max() <= np.degrees(5.0) * (1 + 1e-4)


@pytest.mark.each_value(full="each word in each kind of motion")
@pytest.mark.parametrize("move", [P, J, L, C])
@pytest.mark.parametrize("word", [CLEAR_CURRENT, CLEAR_ALL, ABORT])
def test_a_motion_cleared_or_aborted_brakes_and_is_not_continued(move: int, word: str) -> None:
    arm = ready(TWO, HERE)
    tell(arm, *script(move))
    arm.step(0.5)
    moving = arm.joints_deg
    assert tell(arm, word) == []
    arm.step(1.5)
    standing = arm.joints_deg
    assert standing != moving
    tell(arm, CONTINUE)
    arm.step(1.0)
    assert arm.joints_deg == standing
    # cut short is not reached; byte 4
    assert status_bytes(arm)[8:10] == "01"
    tell(arm, *script(J))
    run(arm)
    assert arm.joints_deg == (60.0, 100.0, -90.0, 0, 0, 0)


@pytest.mark.parametrize("move", [P, J, L])
def test_a_paused_arm_stays_though_the_host_repeats_itself(move: int) -> None:
    arm = ready(TWO, HERE)
    tell(arm, *script(move))
    arm.step(0.3)
    tell(arm, PAUSE)
    arm.step(1.0)
    standing = arm.joints_deg
    for _ in range(100):
        tell(arm, *script(move))
        arm.step(0.005)
    assert arm.joints_deg == standing


def test_a_new_target_waits_for_the_end_of_the_pause() -> None:
    arm = ready(TWO, HERE)
    tell(arm, *script(J))
    arm.step(0.3)
    tell(arm, PAUSE)
    arm.step(1.0)
    standing = arm.joints_deg
    tell(arm, *target(0, 80, -70, 0, 0, 0))
    arm.step(1.0)
    assert arm.joints_deg == standing
    tell(arm, CONTINUE)
    run(arm)
    assert arm.joints_deg == (0, 80, -70, 0, 0, 0)


def test_aborting_a_paused_motion_ends_the_pause() -> None:
    arm = ready(TWO, HERE)
    tell(arm, *script(L))
    arm.step(0.3)
    tell(arm, PAUSE, ABORT, *script(J))
    run(arm)
    assert arm.joints_deg == (60.0, 100.0, -90.0, 0, 0, 0)


def test_a_pause_at_rest_is_nothing() -> None:
    arm = ready(TWO, HERE)
    tell(arm, PAUSE, *script(L))
    run(arm)
    assert KINEMATICS.forward(arm.joints_deg) == pytest.approx(THERE, abs=0.001)


def test_clear_all_drops_what_waits_and_half_an_arc() -> None:
    arm = ready(TWO, HERE)
    lines = script(C)
    tell(arm, *target(0, 80, -70, 0, 0, 0), *lines[:-2], CLEAR_ALL, lines[-2], lines[-1], mode(100))
    arm.step(0.5)
    assert arm.joints_deg == HERE


@pytest.mark.parametrize("line", [STOP, RESUME])
def test_a_stop_forgets_the_pause_and_what_was_paused(line: str) -> None:
    arm = ready(TWO, HERE)
    tell(arm, *script(L))
    arm.step(0.3)
    tell(arm, PAUSE, line)
    before = arm.joints_deg
    tell(arm, CONTINUE)
    arm.step(0.005)
    assert arm.joints_deg == pytest.approx(before, abs=1.0)
    tell(arm, RESUME, "471#0702000000000000", *script(J))
    run(arm)
    assert arm.joints_deg == (60.0, 100.0, -90.0, 0, 0, 0)


def test_the_current_trajectory_is_asked_for_in_vain() -> None:
    """Generation 2 answers 0x476 with the low byte of 0x150 and trajectory point 0."""
    assert tell(Firmware(ONE), GET_CURRENT) == []
    assert tell(Firmware(TWO), GET_CURRENT) == ["476#5000000000000000"]


@pytest.mark.parametrize(
    ("line", "counted"),
    [
        ("150#0007000100020000", {"TRANSFER": 1}),
        ("150#0008000100020000", {"TRANSFER_ENDS": 1}),
    ],
)
def test_what_the_arm_understands_and_does_not_do_is_counted(
    line: str, counted: dict[str, int]
) -> None:
    arm, other = Firmware(TWO), Firmware(TWO)
    assert arm.on_frame(frame(line)) == []
    assert arm.unsupported == counted
    assert not arm.ignored
    assert arm.step(0.05) == other.step(0.05)
