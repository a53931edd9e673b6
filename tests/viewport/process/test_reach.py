"""What the tool can reach: the field in space against poses of the arm, and the border around."""

import time

import numpy as np
import pytest

from armui.system.paths import URDF
from armui.viewport.palette import DARK, LIGHT
from armui.viewport.path_picture import Reach
from armui.viewport.process.frame_painter import FramePainter
from armui.viewport.process.reach import VOXEL_M, reached, shell_of
from armui.viewport.process.scene import Scene
from armui.viewport.process.urdf_file import load_robot
from armui.viewport.view_state import BUILT_IN_ROBOT, ViewState

LIMITS_DEG = (
    (-150.0, 150.0),
    (0.0, 180.0),
    (-170.0, 0.0),
    (-100.0, 100.0),
    (-70.0, 70.0),
    (-120.0, 120.0),
)
LOWS, HIGHS = np.array(LIMITS_DEG).T
TOOLS_M = [(0.0, 0.0, 0.0), (0.0, 0.0, 0.14), (0.06, 0.0, 0.05)]


@pytest.fixture(scope="module")
def robot():
    return load_robot(URDF / "piper" / "piper.urdf")


@pytest.fixture(scope="module")
def volume_of(robot):
    volumes = {tool: reached(robot, Reach(LIMITS_DEG, tool)) for tool in TOOLS_M}
    return volumes.__getitem__


def place_of(robot, angles_deg, tool):
    pose = robot.link_poses(tuple(angles_deg), 0.0)
    link = next(joint.child for joint in robot.joints if joint.name == robot.arm_joints[-1])
    return pose[link][:3, :3] @ np.array(tool) + pose[link][:3, 3]


def nearest_way_m(robot, target, tool, starts, places):
    """How near the tool comes to a place within the limits; Newton's steps from near poses."""
    best = np.inf
    for start in np.argsort(np.linalg.norm(places - target, axis=1))[:4]:
        angles = starts[start].copy()
        for _ in range(20):
            there = place_of(robot, angles, tool)
            best = min(best, float(np.linalg.norm(target - there)))
            if best < 0.001:
                return best
            slopes = np.empty((3, 6))
            for joint in range(6):
                moved = angles.copy()
                moved[joint] += 0.01
                slopes[:, joint] = (place_of(robot, moved, tool) - there) / 0.01
            step = np.linalg.lstsq(slopes, target - there, rcond=1e-3)[0]
            angles = np.clip(angles + np.clip(step, -15.0, 15.0), LOWS, HIGHS)
    return best


@pytest.fixture(scope="module")
def poses_of(robot):
    starts = np.random.default_rng(5).uniform(LOWS, HIGHS, (1500, 6))
    return lambda tool: (starts, np.array([place_of(robot, each, tool) for each in starts]))


@pytest.mark.parametrize("tool", TOOLS_M)
def test_no_pose_of_the_arm_is_outside(volume_of, poses_of, tool):
    _, places = poses_of(tool)
    shares = volume_of(tool).share_at(places)
    assert shares.min() > 0.15  # at the very border the half of a voxel is reached
    assert (shares > 0.5).mean() > 0.97


@pytest.mark.parametrize("tool", TOOLS_M[:2])
def test_inside_there_is_a_way_and_outside_there_is_none(robot, volume_of, poses_of, tool):
    volume = volume_of(tool)
    starts, places = poses_of(tool)
    rng = np.random.default_rng(11)
    tried = rng.uniform(places.min(axis=0) - 0.05, places.max(axis=0) + 0.05, (4000, 3))
    shares = volume.share_at(tried)
    for target in tried[shares > 0.98][:10]:
        assert nearest_way_m(robot, target, tool, starts, places) < VOXEL_M
    near = np.array([np.linalg.norm(places - each, axis=1).min() for each in tried])
    outside = tried[(shares < 0.02) & (near < 0.15)][:10]
    assert len(outside) == 10
    for target in outside:
        assert nearest_way_m(robot, target, tool, starts, places) > 0.25 * VOXEL_M


def test_a_long_tool_has_a_hole_about_the_upright_axis(robot, volume_of, poses_of):
    tool = TOOLS_M[1]
    centre = np.array([[0.0, 0.0, 0.15]])
    assert volume_of(tool).share_at(centre)[0] < 0.01
    _, places = poses_of(tool)
    assert np.linalg.norm(places - centre, axis=1).min() > 0.04
    inner = shell_of(robot, Reach(LIMITS_DEG, tool)).inner.points
    about = inner[np.linalg.norm(inner[:, :2], axis=1) < 0.12]
    above = about[about[:, 2] > 0.0]
    assert len(above) > 50
    assert above[:, 2].max() > 0.25


def test_behind_the_arm_joint_1_leaves_a_gap(robot, volume_of):
    tool = TOOLS_M[0]
    behind, before = np.array([[-0.4, 0.0, 0.1]]), np.array([[0.4, 0.0, 0.1]])
    assert volume_of(tool).share_at(behind)[0] < 0.01
    assert volume_of(tool).share_at(before)[0] > 0.99
    round_about = ((-180.0, 180.0), *LIMITS_DEG[1:])
    assert reached(robot, Reach(round_about, tool)).share_at(behind)[0] > 0.99


def wait_for(scene):
    longest_s = time.monotonic() + 60.0
    while scene.is_unfinished and time.monotonic() < longest_s:
        time.sleep(0.01)
        scene.catch_up()


def last_of(painter):
    """The picture that nothing is missing from."""
    longest_s = time.monotonic() + 60.0
    last = np.zeros((1, 1, 4), np.uint8)
    while painter.is_rough:
        assert time.monotonic() < longest_s
        pixels = painter.refine()
        last = last if pixels is None else pixels.top_down()
        time.sleep(0.01)
    return last


def test_pictures_go_on_while_the_border_is_worked_out():
    shown = ViewState(BUILT_IN_ROBOT, width_px=300, height_px=240, reach=Reach(LIMITS_DEG))
    painter = FramePainter(print, print, print)
    try:
        first = painter.paint(ViewState(BUILT_IN_ROBOT, width_px=300, height_px=240))
        assert first is not None
        plain = first.top_down()
        assert painter.paint(shown) is not None
        assert painter.is_rough  # asked again, it has more
        last = last_of(painter)
        assert (np.abs(last[..., :3].astype(int) - plain[..., :3]).max(axis=2) > 6).mean() > 0.2
        assert painter.refine() is None
    finally:
        painter.close()


def test_the_border_follows_the_theme_and_goes():
    scene = Scene(200, 160)
    try:
        scene.load(BUILT_IN_ROBOT.path)
        robot = scene.robot
        assert robot is not None
        count = scene._canvas.renderer.GetActors().GetNumberOfItems()
        reach = Reach(LIMITS_DEG)
        for palette in (LIGHT, DARK):
            scene._reach.show(reach, robot, palette)
            wait_for(scene)
            assert scene._canvas.renderer.GetActors().GetNumberOfItems() == count + 3
        scene._reach.show(None, robot, DARK)
        assert scene._canvas.renderer.GetActors().GetNumberOfItems() == count
        assert not scene.is_unfinished
    finally:
        scene.close()
