"""0x2AA–0x2AC, the arm's own inverse kinematics, and 0x191, the leader's way to its zero."""

from __future__ import annotations

import pytest

from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from tests.sim.talk import ENABLE, frame, heard, mode, pose_target, ready, target, tell

HERE = (0.0, 60.0, -60.0, 0.0, 0.0, 0.0)
LEADER = "470#FA00000000000000"


def solution_deg(frames) -> list[float]:
    """The last 0x2AA–0x2AC."""
    words = "".join(heard(frames, identifier)[-1] for identifier in (0x2AA, 0x2AB, 0x2AC))
    raw = bytes.fromhex(words)
    return [int.from_bytes(raw[i : i + 4], "big", signed=True) / 1000 for i in range(0, 24, 4)]


def test_the_solution_is_told_after_a_pose_of_move_p_and_from_then_on() -> None:
    arm = ready(joints_deg=HERE)
    goal = (20.0, 70.0, -70.0, 5.0, 20.0, 10.0)
    assert heard(arm.step(0.1), 0x2AA) == []
    tell(arm, mode(50), *target(*HERE))
    assert heard(arm.step(0.1), 0x2AA) == []
    tell(arm, mode(50, move=0), *pose_target(*arm.kinematics.forward(goal)))
    frames = arm.step(0.1)
    assert len(heard(frames, 0x2AA)) == len(heard(frames, 0x2A5)) == 20
    assert solution_deg(frames) == pytest.approx(goal, abs=0.005)
    tell(arm, mode(50), *target(*HERE))
    assert solution_deg(arm.step(2.0)) == pytest.approx(goal, abs=0.005)


def test_a_pose_out_of_reach_brings_no_solution() -> None:
    arm = ready(joints_deg=HERE)
    tell(arm, mode(50, move=0), *pose_target(2000, 0, 300, 0, 85, 0))
    assert heard(arm.step(0.1), 0x2AA) == []


def test_before_1_8_8_there_is_none() -> None:
    arm = Firmware(Generation.TWO, joints_deg=HERE, version="S-V1.8-7")
    tell(arm, ENABLE, mode(50, move=0), *pose_target(*arm.kinematics.forward(HERE)))
    assert heard(arm.step(0.1), 0x2AA) == []


@pytest.mark.parametrize(("command", "follower_is_led"), [("010101", False), ("010001", True)])
def test_a_leader_goes_to_its_zero_with_the_follower_or_without(command, follower_is_led) -> None:
    arm = ready(joints_deg=(30.0, 60.0, -60.0, 0.0, 0.0, 0.0))
    tell(arm, LEADER)
    arm.step(0.1)
    assert arm.leads
    tell(arm, f"191#{command}0000000000")
    assert bool(heard(arm.step(1.0), 0x155)) is follower_is_led
    arm.step(5.0)
    assert arm.joints_deg == pytest.approx((0.0,) * 6)
    assert not arm.mechanics.gives_way
    tell(arm, "191#0100000000000000")
    assert heard(arm.step(0.1), 0x155)
    assert arm.mechanics.gives_way


def test_an_arm_that_leads_nobody_and_one_before_1_7_4_ignore_it() -> None:
    arm = ready(joints_deg=HERE)
    tell(arm, "191#0101010000000000")
    arm.step(1.0)
    assert arm.joints_deg == HERE
    old = Firmware(Generation.TWO, joints_deg=HERE, version="S-V1.7-3")
    tell(old, ENABLE, LEADER, "191#0101010000000000")
    old.step(1.0)
    assert old.on_frame(frame("191#0101010000000000")) == []
    assert old.joints_deg == HERE
