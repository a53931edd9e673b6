"""The weight of the arm."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from armui.sim.mechanics.gravity import Weight
from tests.family import FACTORY_LIMITS
from tests.sim.talk import ready, tell

poses = st.tuples(*(st.floats(j.min_deg, j.max_deg) for j in FACTORY_LIMITS))


@given(poses)
def test_a_level_arm_is_not_turned_about_the_upright(pose: tuple[float, ...]) -> None:
    assert Weight().torques_nm(pose)[0] == pytest.approx(0.0, abs=1e-12)


@given(poses)
def test_the_wrist_that_carries_nothing_is_held_by_its_gears(pose: tuple[float, ...]) -> None:
    """Less than the dry friction of 0.25 N·m: hand and flange weigh 0.39 kg."""
    assert max(map(abs, Weight().torques_nm(pose)[3:])) < 0.25


def test_which_way_gravity_pulls_the_shoulder() -> None:
    assert Weight().torques_nm((0,) * 6)[1] < 0.0  # folded back
    assert Weight().torques_nm((0, 170, -90, 0, 0, 0))[1] > 0.0  # stretched forward


def test_the_shoulder_carries_the_stretched_arm() -> None:
    """Upper arm and forearm level, joint 2 at 172.22°, joint 3 at −167.22°.

    1.16 kg at 218.52 mm; 0.5 kg at 285.03 + 148.08 mm; 0.38 kg at 285.03 + 250.75 − 3.94 mm;
    0.383 kg at 285.03 + 250.75 + 61.04 mm; 0.007 kg 2 mm before the flange at 626.78 mm:
    0.25348 + 0.21656 + 0.20210 + 0.22858 + 0.00437 = 0.90509 kg·m, times 9.81 m/s².
    """
    torque = Weight().torques_nm((0, 172.22, 102.78 - 270.0, 0, 0, 0))[1]
    assert torque == pytest.approx(8.879, abs=0.001)


def weights_nm(arm: Firmware) -> tuple[float, ...]:
    return arm.mechanics.weight.torques_nm(arm.joints_deg)


def test_the_mounting_that_the_host_tells_turns_gravity_and_0_changes_nothing() -> None:
    pose = (0.0, 90.0, -60.0, 0.0, 0.0, 0.0)
    arm = ready(joints_deg=pose)
    level = weights_nm(arm)
    tell(arm, "151#0101000000020000")  # on the left side
    left = weights_nm(arm)
    assert left[0] > 1.0  # the arm reaches forward: joint 1 turns it down to its left
    tell(arm, "151#0101000000000000")
    assert weights_nm(arm) == left
    tell(arm, "151#0101000000030000")  # on the right side
    assert weights_nm(arm) == pytest.approx([-each for each in left])
    tell(arm, "151#0101000000040000")  # upside down
    assert weights_nm(arm) == pytest.approx([-each for each in level])
    tell(arm, "151#0101000000010000")  # level
    assert weights_nm(arm) == level


def test_before_1_8_8_there_is_no_upside_down() -> None:
    arm = Firmware(Generation.TWO, version="S-V1.8-7")
    tell(arm, "151#0101000000040000")
    assert weights_nm(arm) == Weight().torques_nm((0.0,) * 6)


def test_an_arm_mounted_on_its_side_turns_about_joint_1_when_let_go() -> None:
    arm = ready(joints_deg=(0.0, 90.0, -60.0, 0.0, 0.0, 0.0))
    tell(arm, "151#010600AD00020000")  # MIT, on the left side
    arm.step(0.5)
    assert arm.joints_deg[0] > 10.0
