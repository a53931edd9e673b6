"""An arm whose powered joints stand a little off their setpoints, as under a load."""

from __future__ import annotations

import pytest

from armui.protocol.codes import MotionState
from armui.sim.firmware import Firmware
from tests.sim.talk import (
    DISABLE,
    ENABLE,
    STOP,
    frame,
    heard,
    mode,
    pose_target,
    ready,
    target,
    tell,
)

SAG = (0.0, 0.1, -0.1, 0.0, 0.05, 0.0)
HERE = (0.0, 40.0, -40.0, 0.0, 0.0, 0.0)


def sagging(joints_deg: tuple[float, ...] = HERE) -> Firmware:
    """Brought by a motion to where it stands."""
    arm = ready()
    arm.mechanics.sag_deg = SAG
    tell(arm, mode(100), *target(*joints_deg))
    arm.step(3.0)
    assert arm.condition.motion_state is MotionState.REACHED
    return arm


def off_by(arm: Firmware, joints_deg: tuple[float, ...]) -> list[float]:
    return [a - b for a, b in zip(arm.joints_deg, joints_deg, strict=True)]


def test_an_arm_at_its_target_measures_itself_beside_it() -> None:
    arm = sagging()
    assert off_by(arm, HERE) == pytest.approx(SAG)
    # 0x2A5: J1 0, J2 40.100° = 40100 = 0x9CA4
    assert heard(arm.step(0.02), 0x2A5)[-1] == "0000000000009CA4"


def test_steps_from_the_measured_place_creep_and_steps_from_the_target_do_not() -> None:
    creeping, standing = sagging(), sagging()
    for number in range(1, 11):
        measured = creeping.joints_deg
        tell(creeping, *target(*measured[:5], float(number)))
        creeping.step(1.0)
        tell(standing, *target(*HERE[:5], float(number)))
        standing.step(1.0)
    assert off_by(creeping, HERE)[1:3] == pytest.approx([1.1, -1.1])
    assert off_by(standing, HERE)[1:3] == pytest.approx([0.1, -0.1])


def test_the_same_target_again_moves_nothing() -> None:
    arm = sagging()
    before = arm.joints_deg
    tell(arm, mode(100), *target(*HERE))
    arm.step(0.5)
    assert arm.joints_deg == before
    assert arm.condition.motion_state is MotionState.REACHED


def test_nothing_jumps_when_joints_are_caught_halted_or_let_go() -> None:
    arm = sagging()

    def shift() -> float:
        before = arm.joints_deg
        arm.step(0.005)
        return max(abs(a - b) for a, b in zip(arm.joints_deg, before, strict=True))

    for lines in ([STOP], ["150#0200000000000000"], [ENABLE], [DISABLE], [ENABLE]):
        before = arm.joints_deg
        tell(arm, *lines)
        assert arm.joints_deg == pytest.approx(before, abs=1e-9)
        assert shift() < 0.7  # 120°/s at most
    held = arm.joints_deg
    arm.step(1.0)
    assert arm.joints_deg == held


@pytest.mark.parametrize("move", [0, 2])
def test_a_motion_of_the_tool_starts_without_a_jump_and_ends_beside_its_target(move: int) -> None:
    arm = sagging()
    pose = arm.kinematics.forward(HERE)
    tell(arm, mode(50, move=move), *pose_target(*pose[:2], pose[2] + 10.0, *pose[3:]))
    fastest = 0.0
    for _ in range(400):
        before = arm.joints_deg
        arm.step(0.005)
        fastest = max(fastest, *(abs(a - b) for a, b in zip(arm.joints_deg, before, strict=True)))
    assert arm.condition.motion_state is MotionState.REACHED
    assert 0.0 < fastest < 172.0 * 0.005
    reached = arm.kinematics.forward(arm.mechanics.setpoints_deg)
    assert reached[2] == pytest.approx(pose[2] + 10.0, abs=0.01)
    assert off_by(arm, arm.mechanics.setpoints_deg) == pytest.approx(SAG)


def test_an_arm_that_does_not_sag_is_at_its_setpoints() -> None:
    arm = ready()
    assert arm.on_frame(frame(mode(100))) == []
    tell(arm, *target(*HERE))
    arm.step(3.0)
    assert arm.joints_deg == arm.mechanics.setpoints_deg == HERE
