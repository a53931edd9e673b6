"""The weight of the arm."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from armui.arm.limits import FACTORY_LIMITS
from armui.kinematics.arm_kinematics import Kinematics
from armui.sim.mechanics.gravity import gravity_torques_nm
from tests.family import PIPER

poses = st.tuples(*(st.floats(j.min_deg, j.max_deg) for j in FACTORY_LIMITS))
HAND_N = 9.81 * 0.6
"""Weight of the hand."""


@given(poses)
def test_joint_5_feels_the_hand_as_the_flange_moves(pose: tuple[float, ...]) -> None:
    """The hand's centre of mass lies on the line from wrist to flange, 60 of 91 mm out."""
    kinematics, bend = Kinematics(PIPER), 1e-3
    up = [*pose[:4], pose[4] + bend, pose[5]]
    down = [*pose[:4], pose[4] - bend, pose[5]]
    rise_m = (kinematics.forward(up).z_mm - kinematics.forward(down).z_mm) / 1e3
    slope_m_rad = rise_m / math.radians(2 * bend)
    expected = -HAND_N * slope_m_rad * 60.0 / 91.0
    assert gravity_torques_nm(pose)[4] == pytest.approx(expected, abs=1e-5)


@given(poses)
def test_joints_without_lever_feel_nothing(pose: tuple[float, ...]) -> None:
    torques = gravity_torques_nm(pose)
    assert (torques[0], torques[3], torques[5]) == (0.0, 0.0, 0.0)


def test_which_way_gravity_pulls_the_shoulder() -> None:
    assert gravity_torques_nm((0,) * 6)[1] < 0.0  # folded back
    assert gravity_torques_nm((0, 170, -90, 0, 0, 0))[1] > 0.0  # stretched forward


def test_the_shoulder_carries_the_stretched_arm() -> None:
    """Upper arm and forearm level, joint 2 at 172.22°, joint 3 at −167.22°.

    1.2 kg at 142.5 mm; the forearm 0.9 kg at 285.03 + 125.4 mm; the hand 0.6 kg at
    285.03 + 250.75 + 60 mm: 0.1710 + 0.3694 + 0.3575 = 0.8979 kg·m, times 9.81 m/s².
    """
    torque = gravity_torques_nm((0, 172.22, 102.78 - 270.0, 0, 0, 0))[1]
    assert torque == pytest.approx(8.808, abs=0.005)
