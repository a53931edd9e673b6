"""The arm as it lies when it is switched on: two joints outside their limits."""

from __future__ import annotations

import pytest

from armui.arm.rest_pose import REST_DEG, from_rest_deg, rest_pose_deg
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
    pose_target,
    ready,
    status_bytes,
    target,
    tell,
)

TWO = Generation.TWO
RECORD = "150#0000010000000000"
STOP_RECORDING = "150#0000020000000000"
INSIDE_DEG = (0.0, 0.0, 0.0, -1.412, 15.0, -2.608)
MOVE_P, MOVE_L = 0, 2


def run(arm: Firmware, seconds: float) -> None:
    for _ in range(round(seconds / 0.02)):
        arm.step(0.02)


@pytest.mark.parametrize("generation", BOTH)
def test_it_stays_where_it_lies_also_with_power(generation: Generation) -> None:
    arm = Firmware(generation, joints_deg=REST_DEG)
    run(arm, 1.0)
    assert now(arm.joints_deg) == REST_DEG
    tell(arm, ENABLE, mode(100))
    run(arm, 1.0)
    assert now(arm.joints_deg) == REST_DEG
    assert arm.condition.status is ArmStatusCode.NORMAL


# status 0x04 behind the modes; bytes 6 and 7: the joints beyond their limits, the first worth 1
@pytest.mark.parametrize(
    ("to", "said"),
    [
        ((10.0, *REST_DEG[1:]), "0104010000000600"),  # joints 2 and 3 would stay outside
        ((0.0, 0.0, *REST_DEG[2:]), "0104010000000400"),  # joint 3 would
        ((0.0, REST_DEG[1], 0.0, *REST_DEG[3:]), "0104010000000200"),
        ((0.0, -0.5, 0.5, *REST_DEG[3:]), "0104010000000600"),  # nearer is not inside
    ],
)
def test_a_target_that_leaves_a_joint_outside_is_refused(to, said) -> None:
    arm = ready(joints_deg=REST_DEG)
    tell(arm, mode(100), *target(*to))
    run(arm, 1.0)
    assert status_bytes(arm) == said
    assert now(arm.joints_deg) == REST_DEG


@pytest.mark.parametrize("before", [(), (10.0, *REST_DEG[1:])], ids=["at once", "after a refusal"])
def test_one_that_brings_all_of_them_inside_is_driven(before) -> None:
    arm = ready(joints_deg=REST_DEG)
    tell(arm, mode(100))
    if before:
        tell(arm, *target(*before))
    tell(arm, *target(*INSIDE_DEG))
    assert arm.condition.motion_state is MotionState.NOT_REACHED
    run(arm, 2.0)
    assert now(arm.joints_deg) == INSIDE_DEG
    assert arm.condition.status is ArmStatusCode.NORMAL


def test_a_pose_inside_is_driven_and_a_line_from_outside_is_not() -> None:
    goal_deg = (5.0, 30.0, -30.0, 0.0, 10.0, 0.0)
    arm = ready(joints_deg=REST_DEG)
    pose = arm.kinematics.forward(goal_deg)
    tell(arm, mode(100, move=MOVE_L), *pose_target(*pose))
    run(arm, 1.0)
    assert arm.condition.status is ArmStatusCode.TARGET_BEYOND_LIMIT
    assert now(arm.joints_deg) == REST_DEG
    tell(arm, mode(100, move=MOVE_P), *pose_target(*pose))
    run(arm, 3.0)
    assert now(arm.joints_deg) == pytest.approx(goal_deg, abs=0.01)


@pytest.mark.parametrize("lets_go", [[STOP], [DISABLE], [STOP, RESUME]])
def test_it_sinks_back_to_where_it_lay(lets_go) -> None:
    arm = ready(joints_deg=REST_DEG)
    tell(arm, mode(100), *target(*INSIDE_DEG))
    run(arm, 2.0)
    tell(arm, *lets_go)
    run(arm, 30.0)
    assert now(arm.joints_deg) == (0.0, REST_DEG[1], REST_DEG[2], *INSIDE_DEG[3:])


def test_an_arm_found_within_its_limits_sinks_to_them() -> None:
    arm = ready(joints_deg=(0.0, 10.0, -10.0, 0.0, 0.0, 0.0))
    tell(arm, DISABLE)
    run(arm, 30.0)
    assert now(arm.joints_deg)[1:3] == (0.0, 0.0)


def test_a_joint_pushed_outside_by_hand_comes_back_and_goes_no_further() -> None:
    arm = ready(joints_deg=(152.0, 30.0, -30.0, 0.0, 0.0, 0.0))
    tell(arm, mode(100), *target(151.0, 30.0, -30.0, 0.0, 0.0, 0.0))
    assert arm.condition.status is ArmStatusCode.TARGET_BEYOND_LIMIT
    tell(arm, *target(150.0, 30.0, -30.0, 0.0, 0.0, 0.0))
    run(arm, 1.0)
    assert now(arm.joints_deg)[0] == 150.0


def test_a_hand_takes_it_from_where_it_lies() -> None:
    """It does not leap to the limits."""
    arm = ready(joints_deg=REST_DEG)
    tell(arm, RECORD)
    arm.hand_guiding.push((1.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    arm.step(0.02)
    assert now(arm.joints_deg) == pytest.approx((0.02, *REST_DEG[1:]))


def test_a_reset_where_it_lies_ends_drag_teaching() -> None:
    """Joint 5 rests at 22°: nobody has to lift the hand for it."""
    arm = ready(joints_deg=REST_DEG, version="S-V1.7-3")
    tell(arm, RECORD, STOP_RECORDING, STOP, RESUME)
    assert not arm.teaching.entered
    assert arm.condition.control_mode is ControlMode.STANDBY


def test_how_far_from_rest() -> None:
    assert from_rest_deg(REST_DEG) == (0.0,) * 6
    assert from_rest_deg((0.0,) * 6) == (0.0,) * 6
    assert from_rest_deg((3.0, -5.0, 5.0, 1.0, 30.0, 5.0)) == pytest.approx(
        (3.0, 3.001, 3.029, 1.0, 7.89, 5.0)
    )


def test_the_same_place_by_the_older_zeros() -> None:
    """Joints 2 and 3 counted from 2° elsewhere before S-V1.6-3."""
    older = Firmware(TWO, version="S-V1.6-2").kinematics.forward(rest_pose_deg(older_zeros=True))
    today = Firmware(TWO).kinematics.forward(REST_DEG)
    assert older == pytest.approx(today, abs=1e-6)
