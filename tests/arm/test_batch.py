"""The array kinematics against the closed form, pose by pose."""

import math

import numpy as np
import pytest

from armui.kinematics.batch import arm_ways, flange_heights, flanges, jacobians, margins, solutions
from armui.kinematics.kinematics import Geometry, Kinematics, matrix_to_pose

LOW = (-150, 0, -170, -100, -70, -120)
HIGH = (150, 180, 0, 100, 70, 120)


@pytest.fixture(params=Geometry)
def kinematics(request):
    return Kinematics(request.param)


@pytest.fixture
def joints():
    rows = np.random.default_rng(5).uniform(LOW, HIGH, size=(300, 6))
    return np.vstack((rows, np.zeros(6), (0, 90, -90, 0, 0, 0), (30, 90, -100, 20, 0, 40)))


def test_the_flange_is_where_the_closed_form_has_it(kinematics, joints):
    one_by_one = [kinematics.matrix(row) for row in joints]

    assert flanges(kinematics, joints) == pytest.approx(np.array(one_by_one), abs=1e-9)


def test_the_jacobian_is_the_same(kinematics, joints):
    one_by_one = [kinematics.jacobian(row) for row in joints]

    assert jacobians(kinematics, joints) == pytest.approx(np.array(one_by_one), abs=1e-12)


def test_the_ways_of_the_arm_are_those_of_the_library(kinematics, joints):
    targets = flanges(kinematics, joints)

    for theirs, ours in zip(
        kinematics.arm_branches(targets), arm_ways(kinematics, targets), strict=True
    ):
        turned = np.abs((theirs[None] - ours[:, None] + 180.0) % 360.0 - 180.0).max(axis=2)
        assert turned.min(axis=0).max() < 1e-4
        assert turned.min(axis=1).max() < 1e-4


def test_a_way_keeps_its_place_along_a_path(kinematics):
    path = np.linspace((-60, 40, -40, 10, 20, -30), (60, 110, -110, 40, 50, 30), 400)

    ways = arm_ways(kinematics, flanges(kinematics, path))

    on_it = np.abs(ways - path[:, None, :3]).max(axis=2) < 1e-6
    assert on_it.all(axis=0).sum() == 1


def test_out_of_reach_there_is_no_way(kinematics):
    far = np.eye(4)
    far[:3, 3] = (900.0, 0.0, 0.0)
    at_shoulder = np.eye(4)
    at_shoulder[:3, 3] = (0.0, 0.0, 123.0 + 91.0)

    ways = arm_ways(kinematics, np.stack((far, at_shoulder)))

    assert np.isnan(ways).all()


def test_a_stretched_arm_loses_no_way_to_rounding(kinematics):
    # elbow, wrist and shoulder on a line: the forearm's bar leans by its atan(21.98 / 250.75)
    bar_deg = 90.0 + math.degrees(math.atan2(21.98, 250.75))
    straight_deg = bar_deg + kinematics.shoulder_zero_deg - kinematics.forearm_zero_deg - 360.0
    for j2_deg in np.linspace(10, 170, 33):
        joints = np.array([[20.0, j2_deg, straight_deg, 5.0, 20.0, 0.0]])
        target = flanges(kinematics, joints)
        ways = arm_ways(kinematics, target)

        assert math.dist(target[0, :3, 3] - 91.0 * target[0, :3, 2], (0, 0, 123)) == (
            pytest.approx(285.03 + math.hypot(250.75, 21.98), abs=1e-9)
        )
        assert np.abs(ways - joints[:, None, :3]).max(axis=2).min() < 1e-2
        assert not np.isnan(ways).any()


def test_the_solutions_are_those_found_pose_by_pose(kinematics, joints):
    targets = flanges(kinematics, joints)[:100]

    for target, near, found in zip(
        targets, joints, solutions(kinematics, targets)[0], strict=False
    ):
        one_by_one = np.array(kinematics.inverse(matrix_to_pose(target), near))
        gaps = np.abs((one_by_one[:, None] - found[None] + 180.0) % 360.0 - 180.0).max(axis=2)
        assert gaps.min(axis=1).max() < 1e-3


def test_a_stretched_wrist_is_told(kinematics):
    rows = np.array([(0, 90, -90, 0, 0, 0), (0, 90, -90, 0, 30, 0)], dtype=float)

    least_bent = solutions(kinematics, flanges(kinematics, rows))[1]

    assert least_bent[0] < 1e-6
    assert least_bent[1] > 1.0


def test_the_height_of_the_flange_alone_is_the_same(kinematics, joints):
    heights = flange_heights(kinematics, joints)

    assert heights == pytest.approx(flanges(kinematics, joints)[:, 2, 3], abs=1e-9)


def test_a_margin_is_the_volume_of_the_jacobian(kinematics, joints):
    volumes = np.abs(np.linalg.det(jacobians(kinematics, joints)))
    bars = 0.28503 * math.hypot(0.25075, 0.02198) * (0.28503 + math.hypot(0.25075, 0.02198))

    assert margins(kinematics, joints) * bars == pytest.approx(volumes, abs=1e-12)
