"""The closed form against the modified DH table, multiplied out here from the table itself."""

import itertools

import numpy as np
import pytest

from armui.arm.models import model_data
from armui.kinematics.arm_kinematics import Kinematics
from armui.kinematics.forward import flange_transforms
from armui.kinematics.inverse import solutions
from armui.kinematics.poses import Pose, matrix_to_pose, pose_to_matrix
from armui.kinematics.singularity import smallest_singular_values
from armui.protocol.generation import PiperModel
from tests.family import GEOMETRIES, MODELS, PIPER, ranges

# a(i-1) mm, alpha(i-1) deg, d(i) mm, theta offset deg; the tables of the maker's software
_TABLES = {
    PiperModel.PIPER: (
        (0, 0, 123, 0), (0, -90, 0, -172.22), (285.03, 0, 0, -102.78), (-21.98, 90, 250.75, 0),
        (0, -90, 0, 0), (0, 90, 91, 0),
    ),
    PiperModel.PIPER_H: (
        (0, 0, 123, 0), (0, -90, 0, -172.22), (285.03, 0, 0, -102.78), (-21.98, 90, 255.75, 0),
        (0, -90, 0, 0), (0, 90, 96.3, 0),
    ),
    PiperModel.PIPER_L: (
        (0, 0, 123, 0), (0, -90, 0, -172.22), (338.23, 0, 0, -102.78), (-23.01, 90, 320.75, 0),
        (0, -90, 0, 0), (0, 90, 91, 0),
    ),
    PiperModel.PIPER_X: (
        (0, 0, 123, 180), (0, 90, 0, 7.78), (285.03, 0, 0, 162.61), (273.64, 0, 0, 4.62),
        (74.66, -90, 0, 90), (0, 90, 35.26, 0),
    ),
}  # fmt: skip
_ZERO_POSES = {
    PiperModel.PIPER: (56.128, 0, 213.266, 0, 85, 0),
    PiperModel.PIPER_H: (66.388, 0, 214.164, 0, 85, 0),
    PiperModel.PIPER_L: (73.061, 0, 227.595, 0, 85, 0),
    PiperModel.PIPER_X: (96.897, 0, 216.827, -85.01, 0, -90),
}
_OLDER_DEG = (0, -2, 2, 0, 0, 0)
_LOW = (-150, 0, -170, -100, -70, -120)
_HIGH = (150, 180, 0, 100, 70, 120)

every_arm = pytest.mark.parametrize("name", GEOMETRIES)


def modified_dh(joints_deg, name):
    transform = np.eye(4)
    older = name.endswith("-older")
    table = _TABLES[PiperModel(name.removesuffix("-older"))]
    for row, joint_deg, shift_deg in zip(table, joints_deg, _OLDER_DEG, strict=True):
        a, alpha_deg, d, offset_deg = row
        alpha, theta = np.radians((alpha_deg, joint_deg + offset_deg + older * shift_deg))
        ca, sa, ct, st = np.cos(alpha), np.sin(alpha), np.cos(theta), np.sin(theta)
        transform = transform @ [
            [ct, -st, 0, a],
            [st * ca, ct * ca, -sa, -d * sa],
            [st * sa, ct * sa, ca, d * ca],
            [0, 0, 0, 1],
        ]
    return transform


def joints_of(name, count, seed):
    low, high = ranges(PiperModel(name.removesuffix("-older")))
    return np.random.default_rng(seed).uniform(low, high, size=(count, 6))


@every_arm
def test_the_closed_form_agrees_with_the_dh_table(name):
    kinematics = Kinematics(GEOMETRIES[name])
    worst = max(
        np.abs(kinematics.matrix(angles) - modified_dh(angles, name)).max()
        for angles in joints_of(name, 500, 7)
    )
    assert worst < 1e-9


@pytest.mark.parametrize(("model", "zero_pose"), _ZERO_POSES.items())
def test_the_zero_pose_is_the_one_of_the_facts(model, zero_pose):
    pose = Kinematics(model_data(model).geometry).forward((0,) * 6)
    assert pose == pytest.approx(Pose(*zero_pose), abs=5e-4 if zero_pose[4] else 5e-3)


@pytest.mark.parametrize("model", MODELS)
def test_all_ways_lead_to_the_pose_within_a_millionth_of_a_micrometre(model):
    """1,000 random poses; one way is where the joints are, and there are up to eight."""
    geometry = model_data(model).geometry
    joints = joints_of(model, 1000, 11)
    targets = flange_transforms(geometry, joints)

    ways = solutions(geometry, targets)[0]

    found = ~np.isnan(ways[..., 0])
    there = flange_transforms(geometry, np.nan_to_num(ways))
    off_mm = np.abs(there - targets[:, None])[..., :3, 3].max(axis=2)
    turned = np.abs(there - targets[:, None])[..., :3, :3].max(axis=(2, 3))
    own = np.abs((ways - joints[:, None] + 180.0) % 360.0 - 180.0).max(axis=2)
    assert off_mm[found].max() < 1e-9
    assert turned[found].max() < 1e-11
    assert np.nanmin(own, axis=1).max() < 1e-7
    assert found.sum(axis=1).min() >= 4
    assert found.sum(axis=1).max() == 8


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


@every_arm
def test_the_way_back_from_random_poses(name):
    kinematics = Kinematics(GEOMETRIES[name])
    for joints in joints_of(name, 80, 5):
        check_round_trip(kinematics, joints)


def test_the_way_back_with_a_stretched_wrist():
    kinematics = Kinematics(PIPER)
    joints = np.random.default_rng(6).uniform(_LOW, _HIGH, size=(100, 6))
    joints[:, 4] = 0.0
    for each in (*joints, np.zeros(6)):
        check_round_trip(kinematics, each)


def test_a_stretched_wrist_leaves_joint_4_where_it_is_and_joint_6_makes_up_for_it():
    kinematics = Kinematics(PIPER)
    zero = kinematics.forward((0,) * 6)
    nearest = kinematics.inverse(zero, (0, 0, 0, 30, 0, -20))[0]
    assert nearest == pytest.approx((0, 0, 0, 30, 0, -30), abs=1e-6)


def test_a_square_parallel_wrist_stays_as_it_lies():
    """Joint 5 at 90°: joints 4 and 6 turn about parallel axes, and joints 2 and 3 could follow."""
    kinematics = Kinematics(GEOMETRIES["piper_x"])
    for joints in joints_of("piper_x", 100, 9):
        joints[4] = 90.0
        nearest = kinematics.inverse(kinematics.forward(joints), joints)[0]
        assert nearest == pytest.approx(tuple(joints), abs=1e-6)


def test_a_pose_rounded_to_the_protocols_steps_does_not_turn_the_wrist_about():
    kinematics = Kinematics(PIPER)
    for joints in np.random.default_rng(8).uniform(_LOW, _HIGH, size=(100, 6)):
        joints[4] = 0.0
        rounded = Pose(*(round(value, 3) for value in kinematics.forward(joints)))
        nearest = kinematics.inverse(rounded, joints)[0]
        assert nearest == pytest.approx(tuple(joints), abs=0.01)


def test_the_way_back_from_the_limits():
    kinematics = Kinematics(PIPER)
    for joints in itertools.product(*zip(_LOW, _HIGH, strict=True)):
        check_round_trip(kinematics, joints)


def stretched_elbow():
    """Forearm and upper arm in line: atan(21.98 / 250.75) off the forearm's own direction."""
    return float(-360.0 + 192.78 + np.degrees(np.arctan2(21.98, 250.75)))


def test_the_way_back_from_the_edge_of_reach():
    kinematics = Kinematics(PIPER)
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
    kinematics = Kinematics(PIPER)
    joints = (0.0, 100.0, stretched_elbow(), 0.0, 0.0, 0.0)
    matrix = kinematics.matrix(joints)
    centre = matrix[:3, 3] - 91.0 * matrix[:3, 2]
    outward = centre - (0, 0, 123)
    matrix[:3, 3] += beyond_mm * outward / np.linalg.norm(outward)
    assert bool(kinematics.inverse(matrix_to_pose(matrix), joints)) is reachable


def test_no_way_to_what_is_no_pose():
    assert Kinematics(PIPER).inverse(Pose(float("nan"), 0, 300, 0, 0, 0), (0,) * 6) == []


@pytest.mark.parametrize(
    ("joints", "singular"),
    [
        ((0, 90, -90, 0, 0, 0), True),  # joints 4 and 6 in line
        ((0, 100, stretched_elbow(), 0, 40, 0), True),  # upper arm and forearm in line
        ((0, 90, -90, 0, 40, 0), False),
    ],
)
def test_singular_poses(joints, singular):
    smallest = smallest_singular_values(PIPER, np.array(joints, dtype=float))
    assert smallest < 1e-9 if singular else smallest > 0.05
