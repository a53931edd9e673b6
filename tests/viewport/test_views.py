"""The widget's views: the arm fills the picture, by pixels; what stands over it is where it is."""

from functools import partial

import numpy as np
import pytest
from PySide6.QtCore import QPoint
from PySide6.QtGui import QColor, QImage

from armui.viewport.camera import ViewDirection
from armui.viewport.client import PictureClient
from armui.viewport.palette import LIGHT
from armui.viewport.path_picture import Reach
from armui.viewport.projection import Projection
from armui.viewport.robot_shape import composed, moved, pose_rows
from armui.viewport.view import ArmView
from armui.viewport.viewpoint import ViewMode
from tests.viewport.pinhole import HEIGHT, WIDTH
from tests.waiting import wait_until

LIMIT_MS = 50_000
RAISED = (30.0, 70.0, -60.0, 20.0, 40.0, 10.0)
ASIDE = (-120.0, *RAISED[1:])
UPRIGHT = (0.0, 90.0, -88.0, 0.0, -70.0, 0.0)
LIMITS_DEG = ((-150, 150), (0, 180), (-170, 0), (-100, 100), (-70, 70), (-120, 120))


def settle(view, qtbot):
    qtbot.wait_until(lambda: view.is_settled, timeout=LIMIT_MS)


def pixels(image: QImage) -> np.ndarray:
    image = image.convertToFormat(QImage.Format.Format_RGB32)
    raw = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.width(), 4)
    return raw[:, :, :3][:, :, ::-1].astype(int)


def arm_pixels(view, qtbot, angles):
    """Where the picture changes when the arm is taken out of it: it fades to almost nothing."""
    view.set_joints(angles, 35.0)
    view.fit()
    settle(view, qtbot)
    with_arm = pixels(view._picture.image.copy())
    camera = view.camera
    view.set_joints(angles, 35.0, stale=True)
    settle(view, qtbot)
    assert view.camera == camera
    faded = pixels(view._picture.image.copy())
    view.set_joints(angles, 35.0)
    settle(view, qtbot)
    return np.abs(with_arm - faded).max(axis=2) > 8


@pytest.mark.each_value(full="each size with both poses")
@pytest.mark.parametrize("size", [(450, 350), (380, 640), (900, 420)])
@pytest.mark.parametrize("angles", [RAISED, UPRIGHT])
def test_the_arm_fills_the_picture_and_stands_beside_the_figures(view, qtbot, size, angles):
    view.resize(*size)
    arm = arm_pixels(view, qtbot, angles)
    rows, columns = np.nonzero(arm)
    height, width = arm.shape
    figures = view._hud_painter.frame(view.font())
    assert rows.min() > 2
    assert columns.min() > 2
    assert rows.max() < height - 3
    assert columns.max() < width - 3
    assert not arm[: int(figures.bottom()), : int(figures.right())].any()
    tall = (rows.max() - rows.min()) / (height - figures.bottom())
    wide = (columns.max() - columns.min()) / width
    beside = (columns.max() - columns.min()) / max(1.0, width - figures.right())
    assert max(tall, wide, beside) > 0.7


@pytest.mark.parametrize("direction", ViewDirection)
def test_a_direction_is_looked_from_and_the_whole_arm_seen(view, qtbot, direction):
    view.look_from(direction)
    arm = arm_pixels(view, qtbot, RAISED)
    rows, columns = np.nonzero(arm)
    assert arm.mean() > 0.02
    assert rows.min() > 2
    assert columns.max() < arm.shape[1] - 3


@pytest.mark.parametrize("orthographic", [False, True])
@pytest.mark.parametrize("direction", [ViewDirection.TOP, ViewDirection.ISO])
def test_what_is_drawn_over_the_picture_is_where_the_picture_shows_it(
    view, qtbot, orthographic, direction
):
    """The tip of the base's X axis is drawn red by the process; the window projects it there."""
    view.set_joints(ASIDE, 35.0)  # from above, an arm over the axis would hide it
    view.set_orthographic(wanted=orthographic)
    view.look_from(direction)
    settle(view, qtbot)
    image = view._picture.image.copy()
    projection = view.projection
    red = QColor(LIGHT.axes[0])
    for share in (0.12, 0.13, 0.14):
        pixel = projection.pixel((share, 0.0, 0.0))
        assert pixel is not None
        x, y = (round(part) for part in pixel)
        if not image.rect().contains(QPoint(x, y)):
            continue
        near = [QColor(image.pixel(x + dx, y + dy)) for dx in (-1, 0, 1) for dy in (-1, 0, 1)]
        assert (
            min(abs(each.hue() - red.hue()) % 358 for each in near if each.saturation() > 60) < 20
        )
    view.set_orthographic(wanted=False)


def test_an_orbit_about_a_camera_without_perspective_keeps_the_scale(view, qtbot):
    view.set_orthographic(wanted=True)
    assert view.camera.orthographic
    view.reset_view()
    assert view.camera.orthographic
    view.set_orthographic(wanted=False)
    settle(view, qtbot)


def test_following_keeps_the_tool_in_the_middle_of_the_widget(view, qtbot):
    tool = (0.0, 0.0, 120.0, 0.0, 0.0, 0.0)
    view.set_tool(tool)
    view.follow_tool(wanted=True)
    view.set_joints(UPRIGHT, 0.0)
    settle(view, qtbot)
    rows = composed(view.shape.flange(view.shape.links(UPRIGHT)), pose_rows(tool))
    pixel = view.projection.pixel(moved(rows, (0.0, 0.0, 0.0)))
    assert pixel == pytest.approx((view.width() / 2.0, view.height() / 2.0))
    view.follow_tool(wanted=False)
    assert view.mode is ViewMode.FIT
    view.set_tool((0.0,) * 6)
    settle(view, qtbot)


def test_the_tool_s_axes_are_drawn_where_the_tool_is(view, qtbot):
    view.show_tool_frame(wanted=False)
    settle(view, qtbot)
    before = pixels(view.grab().toImage())
    view.show_tool_frame(wanted=True)
    after = pixels(view.grab().toImage())
    rows, columns = np.nonzero(np.abs(before - after).max(axis=2) > 8)
    frame = view.shape.flange(view.shape.links(RAISED))
    tip = view.projection.pixel(moved(frame, (0.0, 0.0, 0.07)))
    start = view.projection.pixel((frame[3], frame[7], frame[11]))
    for x, y in (tip, start):
        assert np.hypot(columns - x, rows - y).min() < 2.0
    view.set_joints(RAISED, 35.0, stale=True)
    settle(view, qtbot)
    stale = pixels(view.grab().toImage())
    view.show_tool_frame(wanted=False)
    assert not np.abs(stale - pixels(view.grab().toImage())).any()  # never where the tool was


def test_the_range_of_a_joint_is_an_arc_and_goes_away(view, qtbot):
    before = pixels(view.grab().toImage())
    view.show_joint_range(2, (0.0, 180.0))
    shown = pixels(view.grab().toImage())
    differs = np.abs(before - shown).max(axis=2) > 8
    assert differs.sum() > 300
    place, _axis = view.shape.joint_frame(2, view.shape.links(RAISED))
    x, y = view.projection.pixel(place)
    rows, columns = np.nonzero(differs)
    assert np.hypot(columns - x, rows - y).min() < 4.0
    view.show_joint_range(None)
    assert not np.abs(before - pixels(view.grab().toImage())).any()


def test_the_reach_is_a_shell_that_is_all_in_the_picture(view, qtbot):
    before = pixels(view._picture.image.copy())
    near = view.camera
    view.set_reach(Reach(LIMITS_DEG))
    settle(view, qtbot)
    shown = pixels(view._picture.image.copy())
    assert view.camera.distance_m > near.distance_m
    background = np.array([0xF4, 0xF6, 0xF8])
    shell = np.abs(shown - background).max(axis=2) > 6
    assert shell.mean() > 0.1
    view.set_reach(None)
    settle(view, qtbot)
    assert not np.abs(before - pixels(view._picture.image.copy())).any()


def test_the_arm_stands_beside_what_is_said_to_lie_over_the_picture(view, qtbot):
    view.set_covered(60.0)
    arm = arm_pixels(view, qtbot, RAISED)
    assert not arm[:, 392:].any()
    view.set_covered(0.0)
    settle(view, qtbot)


def test_what_is_drawn_over_an_old_picture_goes_by_the_old_camera(view, qtbot):
    view.show_tool_frame(wanted=True)
    settle(view, qtbot)
    shown = view._shown
    view.setUpdatesEnabled(False)
    view.look_from(ViewDirection.TOP)
    assert view._shown is shown
    view.setUpdatesEnabled(True)
    settle(view, qtbot)
    assert view._shown.camera == view.camera
    assert isinstance(view.projection, Projection)
    view.show_tool_frame(wanted=False)


def test_an_arm_of_which_nothing_is_known_any_more_stays_faded_where_it_was(view, qtbot):
    view.set_joints(RAISED, 35.0, stale=True)
    settle(view, qtbot)
    stale = view._state
    view.set_joints(RAISED, 35.0)
    settle(view, qtbot)
    view.set_joints_unknown()
    settle(view, qtbot)
    assert view._state == stale
    assert view._hud.angles_deg is None


def test_two_views_on_one_process_get_their_own_first_picture(qtbot):
    client = PictureClient()
    images, pids = [], []
    for _ in range(2):
        view = ArmView(client=client)
        qtbot.addWidget(view)
        view.resize(WIDTH, HEIGHT)
        view.set_joints((0.0,) * 6, 0.0)
        view.show()
        wait_until(partial(getattr, view, "is_settled"))
        images.append(view._picture.image.copy())
        pids.append(client.pid)
        view.shutdown()
        view.close()
    client.stop()
    assert images[0] == images[1]
    assert pids[0] == pids[1] is not None
