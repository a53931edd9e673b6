"""Poses that cannot be: the arm stays, and says exactly what the inverse kinematics says."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence

import numpy as np
import pytest

from armui.arm.limits import check_joints
from armui.kinematics.arm_kinematics import Kinematics
from armui.kinematics.poses import Pose, matrix_to_pose, pose_to_matrix
from armui.kinematics.tool_path import Line
from armui.protocol.codes import ArmStatusCode, MotionState
from armui.protocol.generation import Generation
from tests.family import FACTORY_LIMITS, PIPER
from tests.moments import now
from tests.sim.talk import BOTH, arc_point, mode, pose_target, ready, status_bytes, target, tell

ONE, TWO = Generation.ONE, Generation.TWO
KINEMATICS = Kinematics(PIPER)
HERE = (10.0, 70.0, -60.0, 10.0, 25.0, -20.0)
P, L, C = 0, 2, 3


def expected_for_move_p(pose: Pose, near_deg: Sequence[float]) -> ArmStatusCode:
    solutions = KINEMATICS.inverse(pose, near_deg)
    if not solutions:
        return ArmStatusCode.NO_SOLUTION
    if all(check_joints(solution, FACTORY_LIMITS) for solution in solutions):
        return ArmStatusCode.TARGET_BEYOND_LIMIT
    return ArmStatusCode.NORMAL


def test_move_p_says_what_the_inverse_kinematics_says() -> None:
    rng = np.random.default_rng(21)
    seen = set()
    arm = ready(TWO, HERE)
    tell(arm, mode(0, move=P))
    for _ in range(250):
        pose = Pose(*rng.uniform((-500, -500, 0, -180, -80, -180), (500, 500, 600, 180, 80, 180)))
        pose = Pose(*(round(value, 3) for value in pose))
        tell(arm, *pose_target(*pose))
        assert arm.condition.status is expected_for_move_p(pose, arm.joints_deg)
        assert arm.joints_deg == HERE
        seen.add(arm.condition.status)
    assert len(seen) == 3


def expected_for_move_l(pose: Pose, start_deg: Sequence[float]) -> ArmStatusCode:
    """Follows the nearest solution from pose to pose, every millimetre or quarter degree.

    Where a joint would turn more than 5° in such a step, the arm is at a singular pose.
    """
    status = expected_for_move_p(pose, start_deg)
    if status is not ArmStatusCode.NORMAL:
        return status
    line = Line(KINEMATICS.matrix(start_deg), pose_to_matrix(pose))
    count = math.ceil(max(line.length_mm / 1.0, line.angle_deg / 0.25))
    last: Sequence[float] = start_deg
    for matrix in line.poses(np.linspace(0.0, 1.0, count + 1))[1:]:
        solutions = KINEMATICS.inverse(matrix_to_pose(matrix), last)
        if not solutions:
            return ArmStatusCode.NO_SOLUTION
        if max(abs(a - b) for a, b in zip(solutions[0], last, strict=True)) > 5.0:
            return ArmStatusCode.SINGULARITY
        last = solutions[0]
        if check_joints(last, FACTORY_LIMITS):
            return ArmStatusCode.TARGET_BEYOND_LIMIT
    return ArmStatusCode.NORMAL


def test_move_l_says_what_the_inverse_kinematics_says_along_the_line() -> None:
    rng = np.random.default_rng(23)
    seen: Counter[ArmStatusCode] = Counter()
    for _ in range(30):
        start = rng.uniform((-60, 30, -120, -40, -40, -40), (60, 120, -30, 40, 40, 40))
        goal = start + rng.uniform(-50, 50, 6)
        pose = Pose(*(round(value, 3) for value in KINEMATICS.forward(goal.tolist())))
        arm = ready(TWO, start.tolist())
        tell(arm, mode(100, move=L), *pose_target(*pose))
        expected = expected_for_move_l(pose, arm.joints_deg)
        assert arm.condition.status is expected
        assert arm.condition.motion_state is (
            MotionState.NOT_REACHED if expected is ArmStatusCode.NORMAL else MotionState.REACHED
        )
        seen[expected] += 1
    assert min(seen[ArmStatusCode(each)] for each in (0, 3, 4)) > 2, seen


OUT_OF_REACH = (700.0, 0, 300.0, 0, 90.0, 0)
BEHIND = (-200.0, 0.0, 300.0, 0, 90.0, 0)  # joint 1 at 180° would do


@pytest.mark.parametrize(
    ("generation", "move", "pose", "payload"),
    [
        # CAN control, status, mode, teaching off, reached, then 50 % or no point, the joints
        (ONE, P, OUT_OF_REACH, "0102000000320000"),
        (TWO, P, OUT_OF_REACH, "0102000000000000"),
        (TWO, L, OUT_OF_REACH, "0102020000000000"),
        (ONE, P, BEHIND, "0104000000320000"),
    ],
)
def test_what_the_frames_say(
    generation: Generation, move: int, pose: tuple[float, ...], payload: str
) -> None:
    arm = ready(generation)
    tell(arm, mode(50, move=move), *pose_target(*pose))
    assert status_bytes(arm) == payload
    arm.step(0.5)
    assert arm.joints_deg == (0.0,) * 6
    tell(arm, mode(50, move=P), *pose_target(*KINEMATICS.forward(HERE)))
    assert status_bytes(arm)[:4] == "0100"


def test_generation_2_names_the_joints_beyond_their_limits() -> None:
    """Joint 1 of the nearest way would be at 160°, joint 5 at 75°: bits 0 and 4."""
    arm = ready(TWO, (140.0, 70.0, -60.0, 10.0, 60.0, -20.0))
    pose = KINEMATICS.forward((160.0, 70.0, -60.0, 10.0, 75.0, -20.0))
    tell(arm, mode(50, move=P), *pose_target(*pose))
    assert status_bytes(arm) == "0104000000001100"


@pytest.mark.parametrize("generation", BOTH)
def test_a_line_through_a_singular_pose_is_refused(generation: Generation) -> None:
    """Sideways with a stretched wrist joint 4 would have to jump by 90°."""
    arm = ready(generation, (0.0, 90.0, -90.0, 0.0, 0.0, 0.0))
    x, y, z, rx, ry, rz = KINEMATICS.forward(arm.joints_deg)
    tell(arm, mode(50, move=L), *pose_target(x, y + 50.0, z, rx, ry, rz))
    # 50 % = 0x32 in generation 1
    assert status_bytes(arm) == ("0103020000320000" if generation is ONE else "0103020000000000")
    arm.step(0.5)
    assert arm.joints_deg == (0.0, 90.0, -90.0, 0.0, 0.0, 0.0)
    # in the arm's own plane joint 5 may pass 0
    tell(arm, *pose_target(x + 50.0, y, z, rx, ry, rz))
    assert status_bytes(arm)[:4] == "0100"


def test_a_line_to_a_pose_within_reach_that_leaves_it_on_the_way_is_refused() -> None:
    """From far left to far right, past the arm's own foot."""
    arm = ready(TWO, (89.0, 90.0, -60.0, 0.0, 30.0, 0.0))
    pose = KINEMATICS.forward((-89.0, 90.0, -60.0, 0.0, 30.0, 0.0))
    tell(arm, mode(50, move=L), *pose_target(*pose))
    assert arm.condition.status is expected_for_move_l(
        Pose(*(round(value, 3) for value in pose)), arm.joints_deg
    )
    assert arm.condition.status is not ArmStatusCode.NORMAL
    assert arm.condition.motion_state is MotionState.REACHED


def test_points_on_a_line_are_no_arc() -> None:
    arm = ready(TWO, HERE)
    x, y, z, rx, ry, rz = KINEMATICS.forward(HERE)
    for number in (1, 2, 3):
        tell(arm, *pose_target(x, y + 10.0 * number, z, rx, ry, rz), arc_point(number))
    tell(arm, mode(50, move=C))
    assert status_bytes(arm) == "0102030000000000"
    arm.step(0.5)
    assert arm.joints_deg == HERE


@pytest.mark.parametrize("middle_y", [40.0, 2_000_000.0])
def test_an_arc_of_kilometres_is_refused_without_a_closer_look(middle_y: float) -> None:
    """The long way round a circle of huge radius: all but in line, or its middle far away."""
    arm = ready(TWO, HERE)
    x, y, z, rx, ry, rz = KINEMATICS.forward(HERE)
    for number, (dx, dy) in enumerate(((0.0, 0.0), (0.01, middle_y), (0.0, 20.0)), start=1):
        tell(arm, *pose_target(x + dx, y + dy, z, rx, ry, rz), arc_point(number))
    tell(arm, mode(50, move=C))
    assert status_bytes(arm) == "0102030000000000"
    arm.step(0.5)
    assert arm.joints_deg == HERE


def test_a_refused_pose_ends_the_motion_under_way_on_its_line() -> None:
    arm = ready(TWO, HERE)
    x, y, z, rx, ry, rz = KINEMATICS.forward(HERE)
    tell(arm, mode(50, move=L), *pose_target(x, y + 100.0, z, rx, ry, rz))
    arm.step(0.3)
    tell(arm, *pose_target(*OUT_OF_REACH))
    assert arm.condition.status is ArmStatusCode.NO_SOLUTION
    arm.step(2.0)
    halted = arm.joints_deg
    arm.step(1.0)
    assert arm.joints_deg == halted
    here = KINEMATICS.forward(halted)
    assert here.y_mm < y + 100.0
    assert here[::2] == pytest.approx((x, z, ry), abs=0.1)


def test_an_end_limit_of_0_leaves_no_way() -> None:
    arm = ready(TWO, HERE)
    tell(arm, "479#00007FFF7FFF7FFF", mode(50, move=L))
    x, y, z, rx, ry, rz = KINEMATICS.forward(HERE)
    tell(arm, *pose_target(x, y + 100.0, z, rx, ry, rz))
    assert arm.condition.status is ArmStatusCode.NO_SOLUTION


def test_a_refused_pose_is_tried_again_when_the_limits_have_changed() -> None:
    arm = ready(TWO)
    pose = pose_target(*KINEMATICS.forward((20.0, 70.0, -60.0, 10.0, 25.0, -20.0)))
    # joint 1: ±10.0° (0x0064, 0xFF9C); then ±150.0°
    tell(arm, "474#010064FF9C7FFF00", mode(50, move=P), *pose, *pose)
    assert now(arm.condition.status) is ArmStatusCode.TARGET_BEYOND_LIMIT
    tell(arm, "474#0105DCFA247FFF00", *pose)
    assert now(arm.condition.status) is ArmStatusCode.NORMAL
    assert arm.condition.motion_state is MotionState.NOT_REACHED


def test_a_joint_target_clears_what_was_wrong_with_a_pose() -> None:
    arm = ready(TWO)
    tell(arm, mode(50, move=P), *pose_target(*OUT_OF_REACH), mode(50), *target(*HERE))
    assert arm.condition.status is ArmStatusCode.NORMAL
