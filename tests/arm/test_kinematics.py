"""The closed form against the modified DH table, multiplied out here from the table itself."""

import numpy as np
import pytest

from armui.arm.kinematics import Geometry, Kinematics, Pose, matrix_to_pose, pose_to_matrix

# a(i-1) mm, alpha(i-1) deg, d(i) mm
_TABLE = ((0, 0, 123), (0, -90, 0), (285.03, 0, 0), (-21.98, 90, 250.75), (0, -90, 0), (0, 90, 91))
_THETA_OFFSETS = {
    Geometry.CURRENT: (0, -172.22, -102.78, 0, 0, 0),
    Geometry.BEFORE_V1_6_3: (0, -174.22, -100.78, 0, 0, 0),
}
_LOW = (-150, 0, -170, -100, -70, -120)
_HIGH = (150, 180, 0, 100, 70, 120)


def modified_dh(joints_deg, geometry):
    transform = np.eye(4)
    for (a, alpha_deg, d), joint_deg, offset_deg in zip(
        _TABLE, joints_deg, _THETA_OFFSETS[geometry], strict=True
    ):
        alpha, theta = np.radians((alpha_deg, joint_deg + offset_deg))
        ca, sa, ct, st = np.cos(alpha), np.sin(alpha), np.cos(theta), np.sin(theta)
        transform = transform @ [
            [ct, -st, 0, a],
            [st * ca, ct * ca, -sa, -d * sa],
            [st * sa, ct * sa, ca, d * ca],
            [0, 0, 0, 1],
        ]
    return transform


@pytest.mark.parametrize("geometry", Geometry)
def test_the_closed_form_agrees_with_the_dh_table(geometry):
    kinematics = Kinematics(geometry)
    joints = np.random.default_rng(7).uniform(_LOW, _HIGH, size=(500, 6))
    worst = max(
        np.abs(kinematics.matrix(angles) - modified_dh(angles, geometry)).max() for angles in joints
    )
    assert worst < 1e-9


def test_the_zero_pose_is_the_one_of_the_facts():
    pose = Kinematics().forward((0,) * 6)
    assert pose == pytest.approx(Pose(56.128, 0, 213.266, 0, 85, 0), abs=5e-4)


def test_a_pose_survives_the_way_to_a_matrix_and_back():
    rng = np.random.default_rng(3)
    for _ in range(200):
        pose = Pose(*rng.uniform(-600, 600, 3), *rng.uniform((-180, -89.9, -180), (180, 89.9, 180)))
        assert matrix_to_pose(pose_to_matrix(pose)) == pytest.approx(pose, abs=1e-9)


@pytest.mark.parametrize("pitch_deg", [90.0, -90.0])
def test_pointing_straight_down_or_up_is_the_same_orientation_though_not_the_same_angles(pitch_deg):
    matrix = pose_to_matrix(Pose(1, 2, 3, 30, pitch_deg, 50))
    assert pose_to_matrix(matrix_to_pose(matrix)) == pytest.approx(matrix, abs=1e-9)
