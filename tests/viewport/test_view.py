"""The widget, used as an operator would."""

import subprocess
import sys
import time
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QApplication

from armui.system.paths import URDF
from armui.viewport.client import PictureClient
from armui.viewport.hud import Hud
from armui.viewport.palette import DARK
from armui.viewport.process.urdf_file import URDF_JOINT_COUNT, load_robot
from armui.viewport.view import ArmView
from armui.viewport.viewpoint import ViewMode
from tests.viewport.foreign import write_arm
from tests.viewport.pinhole import project

LIMIT_MS = 50_000
RAISED = (30.0, 70.0, -60.0, 20.0, 40.0, 10.0)


def next_frame(view, qtbot):
    return qtbot.waitSignal(view._client.frame_ready, timeout=LIMIT_MS)


def settle(view, qtbot):
    """Until the newest state is on the screen."""
    qtbot.wait_until(lambda: view.is_settled, timeout=LIMIT_MS)


def image_of(view):
    """A copy of the picture: the next one is drawn into the same memory."""
    return view._picture.image.copy()


def drag(view, qtbot, button, modifier=Qt.KeyboardModifier.NoModifier):
    start, end = QPoint(300, 250), QPoint(340, 270)
    qtbot.mousePress(view, button, modifier, start)
    # QTest moves the mouse without buttons and modifiers; an operator doesn't.
    event = QMouseEvent(
        QMouseEvent.Type.MouseMove,
        QPointF(end),
        QPointF(view.mapToGlobal(end)),
        Qt.MouseButton.NoButton,
        button,
        modifier,
    )
    QApplication.sendEvent(view, event)
    qtbot.mouseRelease(view, button, modifier, end)


def wheel(view, steps):
    place = QPointF(200.0, 200.0)
    event = QWheelEvent(
        place,
        view.mapToGlobal(place),
        QPoint(),
        QPoint(0, 120 * steps),
        Qt.MouseButton.NoButton,
        Qt.KeyboardModifier.NoModifier,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(view, event)


def test_a_left_drag_turns(view, qtbot):
    first = view.camera
    with next_frame(view, qtbot):
        drag(view, qtbot, Qt.MouseButton.LeftButton)
    # 40 px to the right and 20 px down at 0.4° a pixel
    assert view.camera.azimuth_deg == pytest.approx((first.azimuth_deg - 16.0) % 360.0)
    assert view.camera.elevation_deg == pytest.approx(first.elevation_deg + 8.0)
    assert view.mode is ViewMode.FREE


@pytest.mark.parametrize(
    ("button", "modifier"),
    [
        (Qt.MouseButton.MiddleButton, Qt.KeyboardModifier.NoModifier),
        (Qt.MouseButton.LeftButton, Qt.KeyboardModifier.ShiftModifier),
    ],
)
def test_a_middle_or_shift_drag_moves(view, qtbot, button, modifier):
    first = view.camera
    with next_frame(view, qtbot):
        drag(view, qtbot, button, modifier)
    assert view.camera.focus_m != first.focus_m
    assert view.camera.azimuth_deg == first.azimuth_deg
    assert view.mode is ViewMode.FREE


def test_the_wheel_zooms(view, qtbot):
    first = view.camera
    with next_frame(view, qtbot):
        wheel(view, 2)
    assert view.camera.distance_m < first.distance_m
    wheel(view, -2)
    assert view.camera.distance_m == pytest.approx(first.distance_m)


def test_the_keyboard_turns_zooms_and_resets(view, qtbot):
    first = view.camera
    qtbot.keyClick(view, Qt.Key.Key_Left)
    qtbot.keyClick(view, Qt.Key.Key_Up)
    qtbot.keyClick(view, Qt.Key.Key_Plus)
    assert view.camera.azimuth_deg != first.azimuth_deg
    assert view.camera.elevation_deg != first.elevation_deg
    assert view.camera.distance_m < first.distance_m
    qtbot.keyClick(view, Qt.Key.Key_Home)
    assert view.camera == first


def test_reset_returns_to_the_first_picture(view, qtbot):
    first, camera = image_of(view), view.camera
    with next_frame(view, qtbot):
        drag(view, qtbot, Qt.MouseButton.LeftButton)
    assert image_of(view) != first
    view.reset_view()
    assert view.camera == camera
    settle(view, qtbot)
    assert image_of(view) == first


def place_on_forearm(view) -> QPoint:
    """Where the view shows the round end of the forearm."""
    pose = load_robot(URDF / "piper" / "piper.urdf").link_poses(RAISED, 35.0)["link3"]
    place = (pose @ np.array([-0.022, -0.185, 0.0, 1.0]))[np.newaxis, :3]
    ((x, y),) = project(place, view.camera)
    return QPoint(round(x), round(y))


def test_a_double_click_on_a_link_picks_and_marks_its_joint(view, qtbot):
    with qtbot.waitSignal(view.joint_picked, timeout=LIMIT_MS) as picked:
        qtbot.mouseDClick(view, Qt.MouseButton.LeftButton, pos=place_on_forearm(view))
    assert picked.args == [3]
    assert view.highlighted_joint == 3


def test_a_double_click_beside_the_arm_takes_the_mark_away(view, qtbot):
    view.highlight_joint(2)
    with qtbot.waitSignal(view._client.joint_picked, timeout=LIMIT_MS):
        qtbot.mouseDClick(view, Qt.MouseButton.LeftButton, pos=QPoint(440, 10))
    assert view.highlighted_joint is None


def test_the_arm_follows_the_measured_joints(view, qtbot):
    before = view.grab().toImage()
    with next_frame(view, qtbot):
        view.set_joints((0.0,) * 6, 0.0)
    settle(view, qtbot)
    assert view.grab().toImage() != before


def test_a_wrong_number_of_joints_is_refused_at_once(view):
    with pytest.raises(ValueError, match="5 joint angles"):
        view.set_joints((0.0,) * 5, 0.0)


def test_the_pose_changes_the_figures_without_drawing_the_arm(view, qtbot):
    settle(view, qtbot)
    before = view.grab().toImage()
    state = view._state
    view.set_pose((1.0, 2.0, 3.0, 4.0, 5.0, 6.0))
    assert view._state is state
    assert view.grab().toImage() != before


def test_a_theme_is_shown(view, qtbot):
    with next_frame(view, qtbot):
        view.set_theme(DARK)
    settle(view, qtbot)
    assert view.grab().toImage().pixelColor(445, 5).lightness() < 60


def test_another_robot_is_shown_a_broken_one_told_and_ours_comes_back(view, qtbot, tmp_path):
    broken = write_arm(tmp_path, hinges=2, name="broken.urdf")
    with qtbot.waitSignal(view.load_failed, timeout=LIMIT_MS) as failed:
        view.set_robot(broken)
    expected: dict[str, str | int] = {"path": str(broken), "found": 2, "wanted": 6}
    assert failed.args == [URDF_JOINT_COUNT(**expected)]
    settle(view, qtbot)
    before = image_of(view)
    ball = '<visual><geometry><sphere radius="0.05"/></geometry></visual>'
    view.set_robot(write_arm(tmp_path, visual=ball))
    settle(view, qtbot)
    assert image_of(view) != before
    view.set_robot(None)
    settle(view, qtbot)
    assert image_of(view) == before


def test_a_hidden_view_draws_nothing_and_catches_up_when_shown(view, qtbot):
    view.hide()
    view.set_joints((0.0,) * 6, 0.0)
    assert view._client._state.angles_deg == RAISED
    with next_frame(view, qtbot):
        view.show()


def test_a_new_size_gets_a_picture_of_that_size(view, qtbot):
    view.resize(500, 300)
    qtbot.wait_until(
        lambda: view._picture.image.deviceIndependentSize().toSize() == view.size(),
        timeout=LIMIT_MS,
    )


def test_an_arm_that_reports_the_last_digit_anew_is_not_drawn_anew(view, qtbot):
    before = view._client._sequence
    view.set_joints(tuple(angle + 0.001 for angle in RAISED), 35.0)
    assert view._client._sequence == before
    assert view._hud.angles_deg[0] == 30.001
    view.set_joints(tuple(angle + 0.006 for angle in RAISED), 35.0)
    assert view._client._sequence == before + 1
    settle(view, qtbot)


def test_a_picture_for_small_pixels_has_more_of_them(view, qtbot):
    state = view._state
    with next_frame(view, qtbot) as drawn:
        view._client.show(replace(state, width_px=675, height_px=525, pixel_ratio=1.5))
    image = drawn.args[0].image
    assert (image.width(), image.height(), image.devicePixelRatio()) == (675, 525, 1.5)
    assert image.deviceIndependentSize().toSize() == view.size()
    view._client.show(state)
    settle(view, qtbot)


def test_a_covered_view_has_no_more_drawn_than_it_can_hold(view, qtbot):
    """Three images fit into the memory: the one on the screen must not be drawn over."""
    frames: list[Any] = []
    view._client.frame_ready.connect(frames.append)
    view.setUpdatesEnabled(False)  # nothing is painted: no picture is used
    shown = view._picture.frame
    for angle_deg in range(40):
        view.set_joints((float(angle_deg),) * 6, 0.0)
        if angle_deg < 2:
            qtbot.wait_until(lambda n=angle_deg: len(frames) > n, timeout=LIMIT_MS)
    qtbot.wait_until(lambda: view._client._link._mailbox._item is not None, timeout=LIMIT_MS)
    assert len(frames) == 2
    assert shown.slot not in {picture.frame.slot for picture in frames}
    view.setUpdatesEnabled(True)
    settle(view, qtbot)
    view._client.frame_ready.disconnect(frames.append)
    assert frames[-1].frame.drawn.sequence == view._client._sequence


def test_a_view_never_shown_starts_no_process(qtbot):
    view = ArmView()
    qtbot.addWidget(view)
    view.set_joints(RAISED, 0.0)
    assert not view._client.is_running
    assert view._client.pid is None
    view.shutdown()


def test_importing_the_view_imports_nothing_slow():
    code = (
        "import sys, armui.viewport.view; "
        "slow = {'pyvista', 'vtkmodules', 'trimesh', 'yourdfpy', 'scipy', 'numpy'} "
        "& set(sys.modules); "
        "sys.exit(', '.join(slow) or None)"
    )
    result = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=False, timeout=60
    )
    assert result.returncode == 0, result.stderr


def test_figures_wait_for_the_picture_of_the_same_moment_but_not_for_long(view, qtbot, monkeypatch):
    painted, paint = [], Hud.paint

    def noted(hud, *args):
        painted.append(time.monotonic())
        paint(hud, *args)

    monkeypatch.setattr(Hud, "paint", noted)
    monkeypatch.setattr(PictureClient, "is_settled", False)
    monkeypatch.setattr(PictureClient, "show", lambda _client, _state: None)  # none ever comes
    began_s = time.monotonic()
    view.set_pose((6.0, 5.0, 4.0, 3.0, 2.0, time.monotonic()))
    qtbot.wait_until(lambda: bool(painted), timeout=LIMIT_MS)
    assert painted[0] - began_s >= 0.03
