"""The widget, used as an operator would."""

import subprocess
import sys
import threading
from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QApplication

from armui.arm.refusal import Refusal
from armui.paths import URDF
from armui.viewport.camera import HOME_CAMERA
from armui.viewport.palette import DARK
from armui.viewport.process.urdf_file import load_robot
from armui.viewport.view import ArmView
from tests.viewport.foreign import write_arm
from tests.viewport.pinhole import HEIGHT, WIDTH, project

LIMIT_MS = 20_000
RAISED = (30.0, 70.0, -60.0, 20.0, 40.0, 10.0)


@pytest.fixture(params=[True, False], ids=["threaded", "inline"])
def view(request, qtbot):
    view = ArmView(threaded=request.param)
    qtbot.addWidget(view)
    view.resize(WIDTH, HEIGHT)
    view.set_joints(RAISED, 35.0)
    # The first picture and its refinement: whatever is drawn later has a reason of its own.
    with qtbot.waitSignals([view._renderer.frame_ready] * 2, timeout=LIMIT_MS):
        view.show()
    settle(view, qtbot)
    yield view
    view.shutdown()
    assert not [t for t in threading.enumerate() if t.name == "armui-viewport"]


def next_frame(view, qtbot):
    return qtbot.waitSignal(view._renderer.frame_ready, timeout=LIMIT_MS)


def settle(view, qtbot):
    """Until the last picture drawn is on the screen."""
    qtbot.wait_until(lambda: view._image is not None and not view._is_frame_new, timeout=LIMIT_MS)


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
    with next_frame(view, qtbot):
        drag(view, qtbot, Qt.MouseButton.LeftButton)
    # 40 px to the right and 20 px down at 0.4° a pixel
    assert view.camera.azimuth_deg == pytest.approx((HOME_CAMERA.azimuth_deg - 16.0) % 360.0)
    assert view.camera.elevation_deg == pytest.approx(HOME_CAMERA.elevation_deg + 8.0)
    assert view.camera.focus_m == HOME_CAMERA.focus_m


@pytest.mark.parametrize(
    ("button", "modifier"),
    [
        (Qt.MouseButton.MiddleButton, Qt.KeyboardModifier.NoModifier),
        (Qt.MouseButton.LeftButton, Qt.KeyboardModifier.ShiftModifier),
    ],
)
def test_a_middle_or_shift_drag_moves(view, qtbot, button, modifier):
    with next_frame(view, qtbot):
        drag(view, qtbot, button, modifier)
    assert view.camera.focus_m != HOME_CAMERA.focus_m
    assert view.camera.azimuth_deg == HOME_CAMERA.azimuth_deg


def test_the_wheel_zooms(view, qtbot):
    with next_frame(view, qtbot):
        wheel(view, 2)
    assert view.camera.distance_m < HOME_CAMERA.distance_m
    wheel(view, -2)
    assert view.camera.distance_m == pytest.approx(HOME_CAMERA.distance_m)


def test_the_keyboard_turns_zooms_and_resets(view, qtbot):
    qtbot.keyClick(view, Qt.Key.Key_Left)
    qtbot.keyClick(view, Qt.Key.Key_Up)
    qtbot.keyClick(view, Qt.Key.Key_Plus)
    assert view.camera.azimuth_deg != HOME_CAMERA.azimuth_deg
    assert view.camera.elevation_deg != HOME_CAMERA.elevation_deg
    assert view.camera.distance_m < HOME_CAMERA.distance_m
    qtbot.keyClick(view, Qt.Key.Key_Home)
    assert view.camera == HOME_CAMERA


def test_reset_returns_to_the_first_picture(view, qtbot):
    first = view._image
    with next_frame(view, qtbot):
        drag(view, qtbot, Qt.MouseButton.LeftButton)
    assert view._image != first
    view.reset_view()
    assert view.camera == HOME_CAMERA
    qtbot.wait_until(lambda: view._image == first, timeout=LIMIT_MS)


def place_on_forearm() -> QPoint:
    """Where the first view shows the round end of the forearm."""
    pose = load_robot(URDF / "piper.urdf").link_poses(RAISED, 35.0)["link3"]
    ((x, y),) = project((pose @ np.array([-0.022, -0.185, 0.0, 1.0]))[np.newaxis, :3])
    return QPoint(round(x), round(y))


def test_a_double_click_on_a_link_picks_and_marks_its_joint(view, qtbot):
    with qtbot.waitSignal(view.joint_picked, timeout=LIMIT_MS) as picked:
        qtbot.mouseDClick(view, Qt.MouseButton.LeftButton, pos=place_on_forearm())
    assert picked.args == [3]
    assert view.highlighted_joint == 3


def test_a_double_click_beside_the_arm_takes_the_mark_away(view, qtbot):
    view.highlight_joint(2)
    with qtbot.waitSignal(view._renderer.joint_picked, timeout=LIMIT_MS):
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
    expected = {"path": str(broken), "found": 2, "wanted": 6}
    assert failed.args == [Refusal("urdf_joint_count", expected)]
    before = view._image
    ball = '<visual><geometry><sphere radius="0.05"/></geometry></visual>'
    view.set_robot(write_arm(tmp_path, visual=ball))
    qtbot.wait_until(lambda: view._image != before, timeout=LIMIT_MS)
    view.set_robot(None)
    qtbot.wait_until(lambda: view._image == before, timeout=LIMIT_MS)


def test_a_hidden_view_draws_nothing_and_catches_up_when_shown(view, qtbot):
    settle(view, qtbot)
    view.hide()
    view.set_joints((0.0,) * 6, 0.0)
    assert not view._renderer._mailbox.has_item
    with next_frame(view, qtbot):
        view.show()


def test_a_new_size_gets_a_picture_of_that_size(view, qtbot):
    view.resize(500, 300)
    qtbot.wait_until(
        lambda: (
            view._image is not None and view._image.deviceIndependentSize().toSize() == view.size()
        ),
        timeout=LIMIT_MS,
    )


def test_closing_ends_the_drawing_and_later_calls_are_harmless(view):
    view.close()
    assert not view._renderer.is_running
    view.set_joints(RAISED, 0.0)
    view.show()
    view.shutdown()


def test_without_opengl_the_widget_says_so(qtbot, monkeypatch):
    monkeypatch.setenv("VTK_DEFAULT_OPENGL_WINDOW", "vtkOSOpenGLRenderWindow")
    monkeypatch.setattr("ctypes.util.find_library", lambda _name: None)
    view = ArmView()
    qtbot.addWidget(view)
    view.show()
    loading, loading_text = view.grab().toImage(), view._notice()
    with qtbot.waitSignal(view._renderer.failed, timeout=LIMIT_MS):
        pass
    assert "OpenGL" in view._notice()
    assert view._notice() != loading_text
    assert view.grab().toImage() != loading
    view.shutdown()


def test_an_unforeseen_error_is_said_in_the_view(view, qtbot, caplog):
    with qtbot.waitSignal(view._renderer.failed, timeout=LIMIT_MS):
        view._show(replace(view._state, angles_deg=(0.0,)))
    assert "(ValueError: " in view._notice()
    assert "3D view stopped" in caplog.text


def test_a_view_never_shown_starts_no_thread(qtbot):
    view = ArmView()
    qtbot.addWidget(view)
    view.set_joints(RAISED, 0.0)
    assert not view._renderer.is_running
    view.shutdown()


def test_importing_the_view_imports_nothing_slow():
    code = (
        "import sys, armui.viewport.view; "
        "slow = {'pyvista', 'vtkmodules', 'trimesh', 'yourdfpy', 'scipy'} & set(sys.modules); "
        "sys.exit(', '.join(slow) or None)"
    )
    result = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=False, timeout=60
    )
    assert result.returncode == 0, result.stderr
