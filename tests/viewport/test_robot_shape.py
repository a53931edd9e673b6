"""What the window knows of the robot, beside what draws it."""

import math

import numpy as np
import pytest

from armui.kinematics.arm_kinematics import Kinematics
from armui.kinematics.poses import pose_to_matrix
from armui.system.paths import URDF
from armui.viewport.process.robot import shape_of
from armui.viewport.process.urdf_file import load_robot
from armui.viewport.robot_shape import moved, pose_rows
from tests.family import PIPER

POSES = [
    (0.0,) * 6,
    (30.0, 70.0, -60.0, 20.0, 40.0, 10.0),
    (-120.0, 160.0, -30.0, -90.0, 65.0, 99.0),
]


@pytest.fixture(scope="module")
def robot():
    return load_robot(URDF / "piper" / "piper.urdf")


@pytest.mark.parametrize("pose", POSES)
@pytest.mark.parametrize("opening_mm", [0.0, 42.0, 500.0])
def test_the_links_are_where_they_are_drawn(robot, pose, opening_mm):
    shape = shape_of(robot)
    drawn = robot.link_poses(pose, opening_mm)
    links = shape.links(pose, opening_mm)
    names = [robot.root, *(joint.child for joint in robot.joints)]
    for name, rows in zip(names, links, strict=True):
        np.testing.assert_allclose(np.array(rows).reshape(3, 4), drawn[name][:3], atol=1e-12)


def test_the_points_of_a_link_reach_as_far_as_its_surface(robot):
    shape = shape_of(robot)
    for name, points in zip(
        [robot.root, *(joint.child for joint in robot.joints)], shape.points, strict=True
    ):
        clouds = [part.surface.vertices for part in robot.parts if part.link == name]
        if clouds:
            cloud = np.concatenate(clouds)
            np.testing.assert_allclose(np.min(points, axis=0), cloud.min(axis=0))
            np.testing.assert_allclose(np.max(points, axis=0), cloud.max(axis=0))


@pytest.mark.parametrize("pose", POSES)
def test_the_flange_is_where_the_kinematics_have_it(robot, pose):
    rows = shape_of(robot).flange(shape_of(robot).links(pose))
    expected = np.array(Kinematics(PIPER).forward(pose)[:3]) / 1000.0
    np.testing.assert_allclose((rows[3], rows[7], rows[11]), expected, atol=2e-4)


@pytest.mark.parametrize("number", range(1, 7))
def test_the_pointer_of_a_joint_is_square_to_its_axis_and_turns_with_it(robot, number):
    shape = shape_of(robot)
    pose = list(POSES[1])
    _, axis = shape.joint_frame(number, shape.links(pose))
    before = np.array(shape.joint_pointer(number, shape.links(pose)))
    assert before @ np.array(axis) == pytest.approx(0.0, abs=1e-9)
    pose[number - 1] += 25.0
    after = np.array(shape.joint_pointer(number, shape.links(pose)))
    turned = math.degrees(math.atan2(np.cross(before, after) @ axis, before @ after))
    assert turned == pytest.approx(25.0)


def test_a_pose_becomes_the_transform_the_kinematics_make_of_it():
    pose = (100.0, -50.0, 220.0, 30.0, -40.0, 110.0)
    rows = np.array(pose_rows(pose)).reshape(3, 4)
    expected = pose_to_matrix(pose)
    np.testing.assert_allclose(rows[:, :3], expected[:3, :3], atol=1e-12)
    assert moved(pose_rows(pose), (0.0, 0.0, 0.0)) == pytest.approx((0.1, -0.05, 0.22))
