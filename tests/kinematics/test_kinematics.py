"""The closed form against the modified DH table, multiplied out here from the table itself."""

import itertools

import numpy as np
import pytest

from armui.kinematics.arm_kinematics import Kinematics
from armui.kinematics.geometry import Geometry
from armui.kinematics.poses import Pose, matrix_to_pose, pose_to_matrix
from armui.kinematics.singularity import smallest_singular_values

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


def agrees(kinematics, solution, matrix, *, rotation=1e-8, mm=1e-6):
    there = kinematics.matrix(solution)
    return (
        np.abs(there[:3, 3] - matrix[:3, 3]).max() < mm
        and np.abs(there[:3, :3] - matrix[:3, :3]).max() < rotation
    )


def check_round_trip(kinematics, joints_deg):
    """1e-6 mm and (1e-8 rad) 1e-6°, every solution; the nearest is where the joints were."""
    matrix = kinematics.matrix(joints_deg)
    solutions = kinematics.inverse(kinematics.forward(joints_deg), joints_deg)
    assert solutions
    assert all(agrees(kinematics, solution, matrix) for solution in solutions)
    assert solutions[0] == pytest.approx(tuple(joints_deg), abs=1e-6)
    distances = [np.linalg.norm(np.subtract(solution, joints_deg)) for solution in solutions]
    assert distances == pytest.approx(sorted(distances), abs=1e-9)
    return solutions


@pytest.mark.parametrize("geometry", Geometry)
def test_the_way_back_from_random_poses(geometry):
    kinematics = Kinematics(geometry)
    for joints in np.random.default_rng(5).uniform(_LOW, _HIGH, size=(150, 6)):
        check_round_trip(kinematics, joints)


def test_the_way_back_with_a_stretched_wrist():
    kinematics = Kinematics()
    joints = np.random.default_rng(6).uniform(_LOW, _HIGH, size=(100, 6))
    joints[:, 4] = 0.0
    for each in (*joints, np.zeros(6)):
        check_round_trip(kinematics, each)


def test_a_stretched_wrist_leaves_joint_4_where_it_is_and_joint_6_makes_up_for_it():
    kinematics = Kinematics()
    zero = kinematics.forward((0,) * 6)
    nearest = kinematics.inverse(zero, (0, 0, 0, 30, 0, -20))[0]
    assert nearest == pytest.approx((0, 0, 0, 30, 0, -30), abs=1e-6)


def test_a_pose_rounded_to_the_protocols_steps_does_not_turn_the_wrist_about():
    kinematics = Kinematics()
    for joints in np.random.default_rng(8).uniform(_LOW, _HIGH, size=(100, 6)):
        joints[4] = 0.0
        rounded = Pose(*(round(value, 3) for value in kinematics.forward(joints)))
        nearest = kinematics.inverse(rounded, joints)[0]
        assert nearest == pytest.approx(tuple(joints), abs=0.01)


def test_the_way_back_from_the_limits():
    kinematics = Kinematics()
    for joints in itertools.product(*zip(_LOW, _HIGH, strict=True)):
        check_round_trip(kinematics, joints)


def stretched_elbow():
    """Forearm and upper arm in line: atan(21.98 / 250.75) off the forearm's own direction."""
    return float(-360.0 + 192.78 + np.degrees(np.arctan2(21.98, 250.75)))


def test_the_way_back_from_the_edge_of_reach():
    kinematics = Kinematics()
    elbow = stretched_elbow()
    for shoulder in (5.0, 60.0, 90.0, 130.0):
        joints = (20.0, shoulder, elbow, 10.0, 30.0, -40.0)
        matrix = kinematics.matrix(joints)
        solutions = kinematics.inverse(kinematics.forward(joints), joints)
        # at the edge 1e-6 mm are worth some 0.01° of the elbow
        assert solutions[0] == pytest.approx(joints, abs=0.02)
        assert all(agrees(kinematics, each, matrix, mm=1e-5, rotation=1e-6) for each in solutions)


@pytest.mark.parametrize(("beyond_mm", "reachable"), [(-0.01, True), (0.01, False)])
def test_where_the_reach_ends(beyond_mm, reachable):
    """Along the stretched arm itself."""
    kinematics = Kinematics()
    joints = (0.0, 100.0, stretched_elbow(), 0.0, 0.0, 0.0)
    matrix = kinematics.matrix(joints)
    centre = matrix[:3, 3] - 91.0 * matrix[:3, 2]
    outward = centre - (0, 0, 123)
    matrix[:3, 3] += beyond_mm * outward / np.linalg.norm(outward)
    assert bool(kinematics.inverse(matrix_to_pose(matrix), joints)) is reachable


def test_no_way_to_what_is_no_pose():
    assert Kinematics().inverse(Pose(float("nan"), 0, 300, 0, 0, 0), (0,) * 6) == []


@pytest.mark.parametrize(
    ("joints", "singular"),
    [
        ((0, 90, -90, 0, 0, 0), True),  # joints 4 and 6 in line
        ((0, 100, stretched_elbow(), 0, 40, 0), True),  # upper arm and forearm in line
        ((0, 90, -90, 0, 40, 0), False),
    ],
)
def test_singular_poses(joints, singular):
    smallest = smallest_singular_values(Geometry.CURRENT, np.array(joints, dtype=float))
    assert smallest < 1e-9 if singular else smallest > 0.05
