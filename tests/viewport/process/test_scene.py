"""The picture, pixel by pixel."""

import numpy as np
import pytest
import trimesh

from armui.system.paths import URDF
from armui.viewport.camera import HOME_CAMERA
from armui.viewport.messages import SceneError
from armui.viewport.palette import DARK, LIGHT, rgb
from armui.viewport.process.scene import Scene
from armui.viewport.process.urdf_file import load_robot
from tests.viewport.foreign import mesh, write_arm
from tests.viewport.pinhole import HEIGHT, WIDTH, project

REST = (0.0,) * 6
RAISED = (30.0, 70.0, -60.0, 20.0, 40.0, 10.0)


@pytest.fixture(scope="module")
def robot():
    return load_robot(URDF / "piper" / "piper.urdf")


@pytest.fixture
def scene():
    scene = Scene(WIDTH, HEIGHT)
    scene.load(URDF / "piper" / "piper.urdf")
    scene.set_joints(RAISED, 35.0)
    yield scene
    scene.close()


def picture(scene: Scene) -> np.ndarray:
    return scene.render(smooth=False).top_down()[:, :, :3].astype(int)


def changed(first: np.ndarray, second: np.ndarray) -> np.ndarray:
    """Which pixels differ visibly; (rows, columns) of bools."""
    return np.abs(first - second).max(axis=2) > 8


def seen_box(robot, links, angles_deg, gripper_mm) -> tuple[np.ndarray, np.ndarray]:
    """Corners (low, high) of the pixels that some links cover in the first view."""
    poses = robot.link_poses(angles_deg, gripper_mm)
    points = [
        trimesh.transform_points(part.surface.vertices, poses[part.link])
        for part in robot.parts
        if part.link in links
    ]
    pixels = project(np.concatenate(points))
    return pixels.min(axis=0), pixels.max(axis=0)


def test_the_arm_is_in_the_picture_where_it_should_be(scene, robot):
    shown = picture(scene)
    background = np.array(rgb(LIGHT.background)) * 255.0
    far_from_background = np.abs(shown - background).max(axis=2) > 40
    rows, columns = np.nonzero(far_from_background)
    low, high = seen_box(robot, robot.joint_numbers(), RAISED, 35.0)
    assert far_from_background.mean() > 0.04
    assert rows.min() == pytest.approx(low[1], abs=3.0)
    assert columns.max() == pytest.approx(high[0], abs=3.0)


def test_the_picture_changes_where_the_arm_moved_and_nowhere_else(scene, robot):
    before = picture(scene)
    bent = (*RAISED[:4], -30.0, 60.0)
    scene.set_joints(bent, 35.0)
    differs = changed(before, picture(scene))
    moved = ("link5", "link6", "gripper_base", "finger_left", "finger_right")
    boxes = [seen_box(robot, moved, angles, 35.0) for angles in (RAISED, bent)]
    low, high = (np.array(corner) for corner in zip(*boxes, strict=True))
    rows, columns = np.nonzero(differs)
    assert differs.sum() > 500
    inside = np.zeros(len(rows), bool)
    for box_low, box_high in zip(low, high, strict=True):
        inside |= (
            (columns >= box_low[0] - 2)
            & (columns <= box_high[0] + 2)
            & (rows >= box_low[1] - 2)
            & (rows <= box_high[1] + 2)
        )
    assert inside.all()
    for (left, top), (right, bottom) in zip(low, high, strict=True):
        assert differs[int(top) : int(bottom) + 1, int(left) : int(right) + 1].mean() > 0.1


def test_the_fingers_move_with_the_opening(scene):
    before = picture(scene)
    scene.set_joints(RAISED, 70.0)
    assert 20 < changed(before, picture(scene)).sum() < 0.05 * WIDTH * HEIGHT


def test_the_same_state_gives_the_same_picture(scene):
    first = picture(scene)
    scene.set_joints(REST, 0.0)
    assert changed(first, picture(scene)).any()
    scene.set_joints(RAISED, 35.0)
    np.testing.assert_array_equal(first, picture(scene))


def test_smoothing_touches_edges_only(scene):
    rough, smooth = picture(scene), scene.render(smooth=True).top_down()[:, :, :3].astype(int)
    assert 0.001 < changed(rough, smooth).mean() < 0.2


def test_turning_changes_the_picture_and_the_first_view_returns(scene):
    first = picture(scene)
    scene.camera = scene.camera.orbit(40.0, 10.0).zoom(2.0).pan(10.0, 5.0, HEIGHT)
    assert changed(first, picture(scene)).mean() > 0.05
    scene.camera = HOME_CAMERA
    np.testing.assert_array_equal(first, picture(scene))


def test_a_theme_paints_the_background(scene):
    scene.set_palette(DARK)
    np.testing.assert_allclose(
        picture(scene)[0, 0], np.array(rgb(DARK.background)) * 255.0, atol=1.0
    )


def test_an_arm_not_heard_stands_faded_at_zero(scene):
    scene.set_joints(REST, 0.0)
    measured = picture(scene)
    scene.set_joints(None, None)
    faded = picture(scene)
    scene.set_joints(REST, 0.0, stale=True)
    np.testing.assert_array_equal(faded, picture(scene))
    background = np.array(rgb(LIGHT.background)) * 255.0
    assert np.abs(faded - background).sum() < 0.7 * np.abs(measured - background).sum()


def test_a_highlighted_joint_is_coloured(scene, robot):
    before = picture(scene)
    scene.highlight_joint(3)
    differs = changed(before, picture(scene))
    (left, top), (right, bottom) = seen_box(robot, ("link3",), RAISED, 35.0)
    rows, columns = np.nonzero(differs)
    assert differs.sum() > 300
    assert columns.min() >= left - 2
    assert columns.max() <= right + 2
    assert rows.min() >= top - 2
    assert rows.max() <= bottom + 2
    scene.highlight_joint(None)
    np.testing.assert_array_equal(before, picture(scene))


@pytest.mark.parametrize(
    ("place_in_link", "link", "joint"),
    [
        ((0.13, -0.026, 0.02), "link2", 2),
        ((-0.022, -0.185, 0.0), "link3", 3),
        ((0.0, -0.06, 0.0), "link5", 5),
        ((0.0, 0.0, 0.03), "gripper_base", 6),
        ((0.0, 0.0, 0.04), "base_link", None),
    ],
)
def test_a_click_finds_the_joint_of_a_link(scene, robot, place_in_link, link, joint):
    pose = robot.link_poses(RAISED, 35.0)[link]
    ((x, y),) = project((pose @ np.array([*place_in_link, 1.0]))[np.newaxis, :3])
    assert scene.pick(x, y) == joint


def test_a_click_beside_the_arm_finds_nothing(scene):
    assert scene.pick(3.0, 3.0) is None


def test_size_follows_and_a_tall_picture_still_shows_the_whole_width(scene):
    scene.resize(200, 400, 1.0)
    tall = picture(scene)
    assert tall.shape == (400, 200, 3)
    background = np.array(rgb(LIGHT.background)) * 255.0
    columns = np.nonzero((np.abs(tall - background).max(axis=2) > 40).any(axis=0))[0]
    assert columns.min() > 0
    assert columns.max() < 199


def test_a_robot_that_fails_leaves_the_old_one(scene, tmp_path):
    before = picture(scene)
    with pytest.raises(SceneError):
        scene.load(write_arm(tmp_path, hinges=4))
    np.testing.assert_array_equal(before, picture(scene))


@pytest.mark.parametrize("kind", ["stl", "ply", "obj", "glb"])
def test_meshes_of_other_formats_are_shown(scene, tmp_path, kind):
    trimesh.creation.icosphere(subdivisions=2, radius=60.0).export(tmp_path / f"ball.{kind}")
    scene.set_joints(REST, 0.0)
    before = picture(scene)
    # in millimetres: the scale makes metres of them
    scene.load(write_arm(tmp_path, visual=mesh(f"ball.{kind}", scale="0.001 0.001 0.001")))
    assert changed(before, picture(scene)).mean() > 0.01
    x, y = project(np.array([[0.0, 0.0, 0.0]]))[0]
    assert scene.pick(x, y) is None  # the ball of the base
    ((x, y),) = project(np.array([[0.0, 0.0, 0.65]]))
    assert scene.pick(x, y) == 6


def test_a_robot_whose_mesh_fails_leaves_the_old_one(scene, tmp_path):
    (tmp_path / "bad.stl").write_bytes(b"solid nothing\nendsolid nothing\n")
    before = picture(scene)
    with pytest.raises(SceneError, match="mesh_empty"):
        scene.load(write_arm(tmp_path, visual=mesh("bad.stl")))
    np.testing.assert_array_equal(before, picture(scene))


def test_a_computer_without_opengl_is_told_apart(monkeypatch):
    # VTK's last resort, and its library is not there: drawing would end the process.
    monkeypatch.setenv("VTK_DEFAULT_OPENGL_WINDOW", "vtkOSOpenGLRenderWindow")
    monkeypatch.setattr("ctypes.util.find_library", lambda _name: None)
    with pytest.raises(SceneError, match="no_opengl"):
        Scene()


def test_moving_joints_leaves_every_mesh_alone(scene):
    meshes = [actor.GetMapper().GetInput() for actor in scene._robot.actors]
    times = [mesh.GetMTime() for mesh in meshes]
    scene.set_joints(REST, 10.0)
    scene.render()
    assert [actor.GetMapper().GetInput() for actor in scene._robot.actors] == meshes
    assert [mesh.GetMTime() for mesh in meshes] == times
