"""MOVE P, L and C through the firmware: where the tool goes, how the joints fare, what is said."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np
import pytest

from armui.kinematics.arm_kinematics import Kinematics
from armui.kinematics.poses import Matrix, Pose, pose_to_matrix
from armui.kinematics.tool_path import Arc, Line
from armui.protocol.codes import ArmStatusCode, MotionState
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from tests.family import PIPER
from tests.sim.talk import BOTH, STANDBY, arc_point, heard, mode, pose_target, ready, target, tell

TWO = Generation.TWO
KINEMATICS = Kinematics(PIPER)
HERE = (10.0, 70.0, -60.0, 10.0, 25.0, -20.0)
P, L, C = 0, 2, 3

SPEED = math.degrees(3.0)
ACCELERATION = math.degrees(5.0)


def moved(
    joints_deg: Sequence[float], by_mm: Sequence[float] = (0, 0, 0), by_deg: float = 0.0
) -> Pose:
    """The pose some way off the one at these joints, rounded as a frame rounds it."""
    x, y, z, rx, ry, rz = KINEMATICS.forward(joints_deg)
    dx, dy, dz = by_mm
    pose = (x + dx, y + dy, z + dz, rx, ry, rz + by_deg)
    return Pose(*(round(value, 3) for value in pose))


THERE = moved(HERE, (60, -150, 40), 8.0)
HERE_POSE = moved(HERE)
BETWEEN = moved(HERE, (50, -40, 60), 4.0)


def arc_script(*poses: Pose) -> list[str]:
    return [
        line
        for number, pose in enumerate(poses, start=1)
        for line in (*pose_target(*pose), arc_point(number))
    ]


def track_until_reached(arm: Firmware, dt_s: float = 0.005) -> list[tuple[float, ...]]:
    """Steps until the motion state is 0; where the joints were at each step."""
    track = [arm.joints_deg]
    while arm.condition.motion_state is MotionState.NOT_REACHED:
        arm.step(dt_s)
        track.append(arm.joints_deg)
        assert len(track) * dt_s < 60.0
    return track


def flange(track: Sequence[Sequence[float]]) -> Matrix:
    return np.array([KINEMATICS.matrix(joints)[:3, 3] for joints in track])


def off_the_line(points: Matrix, start: Matrix, end: Matrix) -> float:
    way = (end - start) / np.linalg.norm(end - start)
    gone = points - start
    return float(np.linalg.norm(gone - np.outer(gone @ way, way), axis=1).max())


def off_the_arc(points: Matrix, arc: Arc) -> float:
    """To the nearest of many points of the arc."""
    places = arc.poses(np.linspace(0.0, 1.0, 5001))[:, :3, 3]
    gaps = np.linalg.norm(points[:, None, :] - places[None, ::1], axis=2)
    return float(gaps.min(axis=1).max())


def check_joint_limits(track: Sequence[Sequence[float]], dt_s: float) -> None:
    """Finite differences of what the joints did."""
    speeds = np.diff(np.array(track), axis=0) / dt_s
    assert np.abs(speeds).max() <= SPEED * (1 + 1e-6)
    assert np.abs(np.diff(speeds, axis=0) / dt_s).max() <= ACCELERATION * (1 + 1e-4)


@pytest.mark.each_pair(full="all three together")
@pytest.mark.parametrize("dt_s", [0.001, 0.005])
@pytest.mark.parametrize("generation", BOTH)
@pytest.mark.parametrize("percent", [100, 30])
def test_move_l_keeps_to_the_line_and_the_joints_to_their_limits(
    generation: Generation, percent: int, dt_s: float
) -> None:
    arm = ready(generation, HERE)
    tell(arm, mode(percent, move=L), *pose_target(*THERE))
    track = track_until_reached(arm, dt_s)
    points = flange(track)
    assert off_the_line(points, points[0], np.array(THERE[:3])) < 0.1
    check_joint_limits(track, dt_s)
    strides = np.linalg.norm(np.diff(points, axis=0), axis=1)
    assert strides.max() / dt_s <= 1000.0 * percent / 100 + 1e-6
    assert np.abs(np.diff(strides)).max() / dt_s**2 <= 1000.0 * 1.01
    assert KINEMATICS.forward(arm.joints_deg) == pytest.approx(THERE, abs=1e-5)


def test_move_l_turns_the_hand_evenly_with_the_way() -> None:
    arm = ready(TWO, HERE)
    start, end = KINEMATICS.matrix(HERE), pose_to_matrix(THERE)
    line = Line(start, end)
    tell(arm, mode(100, move=L), *pose_target(*THERE))
    for joints in track_until_reached(arm):
        pose = KINEMATICS.matrix(joints)
        share = float(np.linalg.norm(pose[:3, 3] - start[:3, 3])) / line.length_mm
        expected = line.poses(np.array([min(share, 1.0)]))[0]
        assert pose[:3, :3] == pytest.approx(expected[:3, :3], abs=1e-6)


@pytest.mark.parametrize("dt_s", [0.001, 0.005])
@pytest.mark.parametrize("marked_first", [True, False])
def test_move_c_keeps_to_the_arc_and_the_joints_to_their_limits(
    marked_first: bool, dt_s: float
) -> None:
    """0x151 after the points or before them."""
    arm = ready(TWO, HERE)
    start = moved(HERE, (0, 20, 0))
    points = arc_script(start, BETWEEN, THERE)
    tell(arm, *([*points, mode(100, move=C)] if marked_first else [mode(100, move=C), *points]))
    track = track_until_reached(arm, dt_s)
    check_joint_limits(track, dt_s)
    places = flange(track)
    begins = int(np.linalg.norm(places - np.array(start[:3]), axis=1).argmin())
    assert begins > 0  # it goes to the arc's start first
    assert places[begins] == pytest.approx(start[:3], abs=1.0)
    arc = Arc(*map(pose_to_matrix, (start, BETWEEN, THERE)))
    assert off_the_arc(places[begins + 1 :], arc) < 0.1
    passes = np.linalg.norm(places - np.array(BETWEEN[:3]), axis=1).min()
    assert passes < 1000.0 * dt_s
    assert KINEMATICS.forward(arm.joints_deg) == pytest.approx(THERE, abs=1e-5)


def test_the_points_of_an_arc_are_no_targets_of_their_own() -> None:
    arm = ready(TWO, HERE)
    tell(arm, mode(100, move=P), *arc_script(HERE_POSE, BETWEEN, THERE))
    arm.step(0.5)
    assert arm.joints_deg == pytest.approx(HERE, abs=1e-3)
    tell(arm, mode(50, move=C))
    track_until_reached(arm)
    assert KINEMATICS.forward(arm.joints_deg) == pytest.approx(THERE, abs=1e-5)


@pytest.mark.each_pair(full="all three together")
@pytest.mark.parametrize("generation", BOTH)
@pytest.mark.parametrize("move", [P, L])
@pytest.mark.parametrize(
    "arrange",
    [
        lambda move: [*pose_target(*THERE), mode(80, move=move)],
        lambda move: [mode(80, move=move), *pose_target(*THERE)],
        lambda move: [mode(80, move=move), *reversed(pose_target(*THERE))],
        lambda move: [STANDBY, *pose_target(*THERE), mode(80, move=move)],
        lambda move: [mode(0, move=move), *pose_target(*THERE), mode(80, move=move)],
        lambda move: [mode(80, move=1), *pose_target(*THERE), mode(80, move=move)],
    ],
    ids=["target-mode", "mode-target", "backwards", "standby", "speed-last", "move-j-first"],
)
def test_poses_and_mode_in_any_order_move_the_tool(
    generation: Generation, move: int, arrange: Callable[[int], list[str]]
) -> None:
    arm = ready(generation, HERE)
    assert tell(arm, *arrange(move)) == []
    assert arm.condition.motion_state is MotionState.NOT_REACHED
    track_until_reached(arm, 0.05)
    assert KINEMATICS.forward(arm.joints_deg) == pytest.approx(THERE, abs=1e-5)
    # the frames say so too, to a thousandth
    reported = b"".join(bytes.fromhex(heard(arm.step(0.02), each)[-1]) for each in (0x2A2, 0x2A3))
    x, y, z = (int.from_bytes(reported[k : k + 4], "big", signed=True) for k in (0, 4, 8))
    assert (x, y, z) == tuple(round(1000 * value) for value in THERE[:3])


@pytest.mark.parametrize(
    "script",
    [
        pose_target(*THERE),
        [mode(100, move=P), *pose_target(*THERE)[:2]],
        [mode(100, move=1), *pose_target(*THERE)],
        [mode(100, move=C), *pose_target(*THERE)],
        [mode(100, control=2, move=P), *pose_target(*THERE)],
        [mode(100, move=L), *target(*HERE)],
        [mode(100, move=C), *arc_script(HERE_POSE, BETWEEN)],
        [mode(100, move=C), *pose_target(*THERE), *map(arc_point, (0, 2, 3))],
        [mode(100, move=C), *map(arc_point, (1, 2, 3))],
    ],
    ids=[
        *("no mode", "no 0x154", "move J", "move C", "teaching", "joint target", "two points"),
        *("one pose", "no pose"),
    ],
)
def test_what_does_not_move_the_tool(script: list[str]) -> None:
    arm = ready(TWO, HERE)
    tell(arm, *script)
    arm.step(0.5)
    assert arm.joints_deg == HERE
    assert arm.condition.motion_state is MotionState.REACHED
    assert arm.condition.status is ArmStatusCode.NORMAL


@pytest.mark.parametrize("move", [P, L])
def test_a_host_that_repeats_a_pose_at_200_hz_gets_the_same_motion(move: int) -> None:
    once, often = ready(TWO, HERE), ready(TWO, HERE)
    tell(once, mode(60, move=move), *pose_target(*THERE))
    for _ in range(600):
        tell(often, *pose_target(*THERE), mode(60, move=move))
        once.step(0.005)
        often.step(0.005)
        assert often.joints_deg == pytest.approx(once.joints_deg, abs=1e-3)
        assert often.condition.motion_state is once.condition.motion_state
    assert once.condition.motion_state is MotionState.REACHED


def test_a_host_that_repeats_an_arc_at_200_hz_gets_it_once() -> None:
    once, often = ready(TWO, HERE), ready(TWO, HERE)
    script = [*arc_script(HERE_POSE, BETWEEN, THERE), mode(60, move=C)]
    tell(once, *script)
    for _ in range(1000):
        tell(often, *script)
        once.step(0.005)
        often.step(0.005)
        assert often.joints_deg == pytest.approx(once.joints_deg, abs=1e-3)
    assert once.condition.motion_state is often.condition.motion_state is MotionState.REACHED


def test_the_end_limits_of_0x479_bound_the_tool() -> None:
    arm = ready(TWO, HERE)
    # 0.050 m/s = 50 = 0x0032, 0.200 m/s² = 200 = 0x00C8, the angular ones unchanged
    tell(arm, "479#00327FFF00C87FFF", mode(100, move=L), *pose_target(*moved(HERE, (0, 100, 0))))
    strides = np.linalg.norm(np.diff(flange(track_until_reached(arm)), axis=0), axis=1)
    assert strides.max() / 0.005 == pytest.approx(50.0, rel=1e-4)
    assert np.diff(strides).max() / 0.005**2 == pytest.approx(200.0, rel=0.01)


def test_a_turn_on_the_spot_keeps_the_place_and_the_angular_limit() -> None:
    arm = ready(TWO, HERE)
    # 0.100 rad/s = 100 = 0x0064
    tell(arm, "479#7FFF00647FFF7FFF", mode(100, move=L), *pose_target(*moved(HERE, by_deg=10.0)))
    track = track_until_reached(arm)
    places = flange(track)
    assert np.linalg.norm(places - places[0], axis=1).max() < 0.001
    expected_s = math.radians(10.0 * math.sin(math.radians(90))) / 0.1
    assert len(track) * 0.005 == pytest.approx(expected_s, rel=0.1)


def test_a_new_line_replaces_the_old_one_after_braking_along_it() -> None:
    arm = ready(TWO, HERE)
    start = KINEMATICS.matrix(HERE)[:3, 3]
    tell(arm, mode(100, move=L), *pose_target(*THERE))
    track = [arm.joints_deg]
    for _ in range(80):
        arm.step(0.005)
        track.append(arm.joints_deg)
    tell(arm, *pose_target(*BETWEEN))
    track += track_until_reached(arm)[1:]
    check_joint_limits(track, 0.005)
    places = flange(track)
    turning = 80 + int(np.linalg.norm(np.diff(places[80:-10], axis=0), axis=1).argmin())
    assert off_the_line(places[turning : turning + 2], start, np.array(THERE[:3])) < 0.1
    assert off_the_line(places[: turning + 1], start, np.array(THERE[:3])) < 0.1
    assert off_the_line(places[turning:], places[turning], np.array(BETWEEN[:3])) < 0.1
    assert KINEMATICS.forward(arm.joints_deg) == pytest.approx(BETWEEN, abs=1e-5)


@pytest.mark.parametrize("move", [P, 1])
def test_a_line_gives_way_to_a_joint_motion_smoothly(move: int) -> None:
    arm = ready(TWO, HERE)
    tell(arm, mode(100, move=L), *pose_target(*THERE))
    track = [arm.joints_deg]
    for tick in range(200):
        if tick == 60:
            lines = target(0, 60, -50, 0, 20, 0) if move else pose_target(*BETWEEN)
            tell(arm, mode(100, move=move), *lines)
        arm.step(0.005)
        track.append(arm.joints_deg)
    track += track_until_reached(arm)[1:]
    check_joint_limits(track, 0.005)
    assert arm.joints_deg == pytest.approx(arm.targets_deg)


def test_speed_0_halts_on_the_line_and_more_speed_goes_on() -> None:
    arm = ready(TWO, HERE)
    start = KINEMATICS.matrix(HERE)[:3, 3]
    tell(arm, mode(100, move=L), *pose_target(*THERE))
    arm.step(0.4)
    tell(arm, mode(0, move=L))
    arm.step(2.0)
    halted = arm.joints_deg
    arm.step(1.0)
    assert arm.joints_deg == halted
    assert arm.condition.motion_state is MotionState.NOT_REACHED
    tell(arm, mode(20, move=L))
    places = flange(track_until_reached(arm))
    assert off_the_line(places, start, np.array(THERE[:3])) < 0.1


@pytest.mark.parametrize("line", [STANDBY, mode(50, move=1), mode(50, control=2, move=L)])
def test_leaving_the_mode_halts_for_good(line: str) -> None:
    arm = ready(TWO, HERE)
    tell(arm, mode(50, move=L), *pose_target(*THERE))
    arm.step(0.4)
    tell(arm, line)
    arm.step(2.0)
    halted = arm.joints_deg
    tell(arm, mode(50, move=L))
    arm.step(1.0)
    assert arm.joints_deg == halted
    assert arm.condition.motion_state is MotionState.NOT_REACHED


@pytest.mark.parametrize("generation", BOTH)
def test_the_rest_pose_in_bytes(generation: Generation) -> None:
    """All joints at 0, at two of their limits and with a stretched wrist, rounded to a frame."""
    arm = ready(generation, (0.0, 20.0, -20.0, 0.0, 10.0, 0.0))
    answers = tell(
        arm,
        "151#0100640000000000",  # CAN control, MOVE P, 100 %
        "152#0000DB4000000000",  # X 56.128 mm = 56128 = 0xDB40, Y 0
        "153#0003411200000000",  # Z 213.266 mm = 213266 = 0x34112, RX 0
        "154#00014C0800000000",  # RY 85.000° = 85000 = 0x14C08, RZ 0
    )
    assert answers == []
    track_until_reached(arm)
    assert arm.joints_deg == pytest.approx((0.0,) * 6, abs=0.01)
    frames = arm.step(0.02)
    assert heard(frames, 0x2A2)[-1] == "0000DB4000000000"
    assert heard(frames, 0x2A3)[-1] == "0003411200000000"
    assert heard(frames, 0x2A4)[-1] == "00014C0800000000"


def test_an_arc_in_bytes_of_both_lengths() -> None:
    """0x158 with one byte and with eight: three points, then 0x151 with MOVE C."""
    arm = ready(TWO, HERE)
    tell(
        arm,
        *(*pose_target(*HERE_POSE), "158#01"),
        *(*pose_target(*BETWEEN), "158#0200000000000000"),
        *(*pose_target(*THERE), "158#03"),
        "151#0103640000000000",
    )
    assert arm.condition.motion_state is MotionState.NOT_REACHED
    track_until_reached(arm)
    assert KINEMATICS.forward(arm.joints_deg) == pytest.approx(THERE, abs=1e-5)
