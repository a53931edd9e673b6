"""The closed form for arrays: shapes, the ways of the arm, and py-opw-kinematics as the oracle."""

import math

import numpy as np
import pytest
from py_opw_kinematics import KinematicModel, Robot
from scipy.spatial.transform import RigidTransform

from armui.kinematics.arm_kinematics import Kinematics
from armui.kinematics.forward import flange_transforms
from armui.kinematics.inverse import missing_mm, solutions
from armui.kinematics.poses import matrix_to_pose
from armui.kinematics.singularity import jacobians, margins
from armui.kinematics.spherical import arm_joints
from armui.protocol.generation import PiperModel
from tests.family import GEOMETRIES, ranges

OPW_MM = {
    PiperModel.PIPER: {"a2": -21.98, "c2": 285.03, "c3": 250.75, "c4": 91.0},
    PiperModel.PIPER_H: {"a2": -21.98, "c2": 285.03, "c3": 255.75, "c4": 96.3},
    PiperModel.PIPER_L: {"a2": -23.01, "c2": 338.23, "c3": 320.75, "c4": 91.0},
}
OPW_OFFSETS_DEG = (0.0, 82.22, 192.78, 180.0, 0.0, 180.0)
OPW_OLDER_OFFSETS_DEG = (0.0, 84.22, 190.78, 180.0, 0.0, 180.0)


@pytest.fixture(params=GEOMETRIES)
def name(request):
    return request.param


@pytest.fixture(params=[name for name in GEOMETRIES if not name.startswith("piper_x")])
def opw_name(request):
    return request.param


@pytest.fixture
def geometry(request):
    fixtures = request.fixturenames
    return GEOMETRIES[request.getfixturevalue("opw_name" if "opw_name" in fixtures else "name")]


@pytest.fixture
def library(opw_name):
    """The same arm as py-opw-kinematics has it."""
    older = opw_name.endswith("-older")
    model = KinematicModel(
        c1=123.0,
        **OPW_MM[PiperModel(opw_name.removesuffix("-older"))],
        offsets=OPW_OLDER_OFFSETS_DEG if older else OPW_OFFSETS_DEG,
        flip_axes=(False, False, False, False, True, False),
    )
    return Robot(model)


@pytest.fixture
def joints(request):
    fixtures = request.fixturenames
    name = request.getfixturevalue("opw_name" if "opw_name" in fixtures else "name")
    low, high = ranges(PiperModel(name.removesuffix("-older")))
    rows = np.random.default_rng(5).uniform(low, high, size=(300, 6))
    return np.vstack((rows, np.zeros(6), (0, 90, -90, 0, 0, 0), (30, 90, -100, 20, 0, 40)))


def apart_deg(some, others):
    """How far the nearest of others is from each of some, as angles."""
    gaps = np.abs((some[:, None] - others[None] + 180.0) % 360.0 - 180.0)
    return gaps.max(axis=2).min(axis=1)


def test_many_poses_are_what_each_of_them_is(name, geometry, joints):
    kinematics = Kinematics(geometry)

    together = flange_transforms(geometry, joints.reshape(3, 101, 6))

    one_by_one = np.array([kinematics.matrix(row) for row in joints])
    assert together == pytest.approx(one_by_one.reshape(3, 101, 4, 4), abs=1e-9)


def test_the_library_finds_the_same_solutions(opw_name, geometry, library, joints):
    """Where it finds them: with a bent wrist all of them."""
    bent = joints[np.abs(joints[:, 4]) > 0.1]
    targets = flange_transforms(geometry, bent)
    ours = solutions(geometry, targets)[0]

    theirs = library.reach(RigidTransform.from_matrix(targets)).joints

    assert len(bent) > 290
    for pair in zip(ours, theirs, strict=True):
        our, their = (each[~np.isnan(each[:, 0])] for each in pair)
        assert len(our) == len(their) >= 2
        assert apart_deg(their, our).max() < 1e-6
        assert apart_deg(our, their).max() < 1e-6


def test_the_library_says_the_same_of_what_is_out_of_reach(opw_name, geometry, library):
    places = np.random.default_rng(12).uniform(-900, 900, size=(200, 3))
    targets = np.broadcast_to(np.eye(4), (200, 4, 4)).copy()
    targets[:, :3, 3] = places

    extensions_mm = library.reach(RigidTransform.from_matrix(targets)).extension

    missing = [missing_mm(geometry, target) for target in targets]
    assert missing == pytest.approx(np.maximum(0.0, -extensions_mm), abs=1e-9)
    assert 20 < np.count_nonzero(missing) < 200
    assert np.isnan(arm_joints(geometry, targets)[np.array(missing) > 0.0]).all()


def test_a_way_keeps_its_place_along_a_path(opw_name, geometry):
    path = np.linspace((-60, 40, -40, 10, 20, -30), (60, 110, -110, 40, 50, 30), 400)

    ways = arm_joints(geometry, flange_transforms(geometry, path))

    on_it = np.abs(ways - path[:, None, :3]).max(axis=2) < 1e-6
    assert on_it.all(axis=0).sum() == 1


def test_one_way_is_that_of_all(opw_name, geometry, joints):
    targets = flange_transforms(geometry, joints)
    wanted = np.arange(len(joints)) % 4

    one = arm_joints(geometry, targets, wanted)

    every = arm_joints(geometry, targets)
    assert np.array_equal(one, every[np.arange(len(joints)), wanted], equal_nan=True)


def test_out_of_reach_there_is_no_way(opw_name, geometry):
    far = np.eye(4)
    far[:3, 3] = (1000.0, 0.0, 0.0)
    at_shoulder = np.eye(4)
    at_shoulder[:3, 3] = (0.0, 0.0, 123.0 + geometry.hand_mm)

    assert np.isnan(arm_joints(geometry, np.stack((far, at_shoulder)))).all()


def test_a_stretched_arm_loses_no_way_to_rounding(opw_name, geometry):
    # elbow, wrist and shoulder on a line: the forearm's bar leans by its atan(elbow / forearm)
    lean_deg = math.degrees(math.atan2(-geometry.elbow_mm, geometry.forearm_mm))
    straight_deg = 90.0 + lean_deg - geometry.plane_zeros_deg[1] - 360.0
    for j2_deg in np.linspace(10, 170, 33):
        joints = np.array([[20.0, j2_deg, straight_deg, 5.0, 20.0, 0.0]])
        target = flange_transforms(geometry, joints)
        ways = arm_joints(geometry, target)

        centre = target[0, :3, 3] - geometry.hand_mm * target[0, :3, 2]
        assert math.dist(centre, (0, 0, 123)) == (
            pytest.approx(geometry.upper_arm_mm + geometry.elbow_to_wrist_mm, abs=1e-9)
        )
        assert np.abs(ways - joints[:, None, :3]).max(axis=2).min() < 1e-2
        assert not np.isnan(ways).any()


def test_a_way_of_a_parallel_wrist_keeps_its_place_along_a_path():
    geometry = GEOMETRIES["piper_x"]
    path = np.linspace((-60, 40, -40, 10, 20, -30), (60, 110, -110, 40, 50, 30), 400)

    ways = solutions(geometry, flange_transforms(geometry, path))[0]

    on_it = np.abs(ways - path[:, None]).max(axis=2) < 1e-6
    assert on_it.all(axis=0).sum() == 1


def test_a_square_parallel_wrist_is_told():
    geometry = GEOMETRIES["piper_x"]
    rows = np.array([(0, 90, -90, 0, 90, 0), (0, 90, -90, 0, 30, 0)], dtype=float)

    off_square = solutions(geometry, flange_transforms(geometry, rows))[1]

    assert off_square == pytest.approx((0.0, 60.0), abs=1e-6)


def test_what_is_out_of_reach_of_a_parallel_wrist_is_told():
    """Along the stretched arm: the wrist straight ahead of both bars."""
    geometry = GEOMETRIES["piper_x"]
    target = np.eye(4)
    target[:3, :3] = [[0, 0, 1], [0, 1, 0], [-1, 0, 0]]  # the hand points along X
    edge_mm = 285.03 + 273.64 + 74.66 + 35.26
    for beyond_mm in (-0.01, 0.0, 7.5):
        target[:3, 3] = (edge_mm + beyond_mm, 0.0, 123.0)
        expected = max(0.0, beyond_mm)
        assert missing_mm(geometry, target) == pytest.approx(expected, abs=1e-9)
        there = solutions(geometry, target)[0]
        assert np.isnan(there).all() == (beyond_mm > 0.0)


def test_the_solutions_are_those_found_pose_by_pose(name, geometry, joints):
    targets = flange_transforms(geometry, joints)
    found = solutions(geometry, targets)[0]

    for target, near, several in zip(targets[:100], joints, found, strict=False):
        one_by_one = np.array(Kinematics(geometry).inverse(matrix_to_pose(target), near))
        assert apart_deg(one_by_one, several[~np.isnan(several[:, 0])]).max() < 1e-3


def test_a_stretched_wrist_is_told(opw_name, geometry):
    rows = np.array([(0, 90, -90, 0, 0, 0), (0, 90, -90, 0, 30, 0)], dtype=float)

    least_bent = solutions(geometry, flange_transforms(geometry, rows))[1]

    assert least_bent[0] < 1e-6
    assert least_bent[1] > 1.0


def test_the_jacobian_is_how_the_flange_moves(name, geometry, joints):
    step = 1e-4
    jacobian = jacobians(geometry, joints)
    turns = flange_transforms(geometry, joints)[:, :3, :3]
    for index, nudge in enumerate(step * np.eye(6)):
        ahead, behind = (flange_transforms(geometry, joints + sign * nudge) for sign in (1, -1))
        rate = (ahead - behind) / np.radians(2 * step)
        spin = rate[:, :3, :3] @ turns.swapaxes(1, 2)
        expected = np.column_stack(
            (rate[:, :3, 3] / 1e3, spin[:, 2, 1], spin[:, 0, 2], spin[:, 1, 0])
        )
        assert jacobian[:, :, index] == pytest.approx(expected, abs=1e-6)


def test_a_margin_is_the_volume_of_the_jacobian(name, geometry, joints):
    volumes = np.abs(np.linalg.det(jacobians(geometry, joints)))
    fore_m, upper_m = geometry.elbow_to_wrist_mm / 1e3, geometry.upper_arm_mm / 1e3
    bars = upper_m * fore_m * (upper_m + fore_m + geometry.wrist_mm / 1e3)

    assert margins(geometry, joints) * bars == pytest.approx(volumes, abs=1e-12)
