"""S24: what becomes of the picture's process changes nothing for window, bus and stop."""

import sys
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QAction, QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QPushButton

from armui.control.motion.jog_path import JointJog
from armui.protocol.generation import Generation
from armui.viewport.client import PictureClient
from armui.viewport.path_picture import PathPicture, Preview
from armui.viewport.watch import Restarts
from tests import posix
from tests.accepted import accepted
from tests.app_driver import AppDriver
from tests.control.jogger import bend, hold
from tests.control.under_way import run_moving
from tests.waiting import wait_until

pytestmark = [
    pytest.mark.skipif(sys.platform == "win32", reason="signals"),
    pytest.mark.timeout(300),  # each loses a process and waits for the next
]

TARGET_DEG = (60.0, 90.0, -60.0, 40.0, 30.0, 60.0)
STOP = (0x150, "0100000000000000")


@pytest.fixture(scope="module")
def pictures(qapp):
    """One client for all: its process is lost and comes back in each test."""
    client = PictureClient()
    yield client
    client.stop()


@pytest.fixture(autouse=True)
def no_thread_outlives_the_test():
    """The client is the module's: its threads change with each process, and end with it."""


@pytest.fixture
def drawing(qapp, request, tmp_path, pictures):
    """The whole window before an enabled arm, with the picture on the screen."""
    settings = tmp_path / "settings.json"
    app_driver = AppDriver(
        qapp, request.node.nodeid, settings, Generation.TWO, draws=True, pictures=pictures
    )
    bend(app_driver)
    wait_until(lambda: app_driver.program.view.is_settled)
    pictures._link._restarts = Restarts()  # each test loses as many as it likes
    yield app_driver
    app_driver.close()


@pytest.fixture
def lost(drawing):
    """Every loss of the picture's process."""
    losses: list[Any] = []
    drawing.program.view._client.lost.connect(losses.append)
    return losses


def kill(client):
    posix.kill(client.pid)


def freeze(client):
    posix.stand_still(client.pid)


def move(app_driver):
    accepted(app_driver.controller.motion.send_joints(TARGET_DEG))
    app_driver.run(0.2)


def jog(app_driver):
    accepted(app_driver.controller.jogging.start(JointJog(1, 1)))
    hold(app_driver, 0.3)


def press_stop(app_driver):
    """Press the button; what is on the bus when the press returns."""
    app_driver.heard()
    stop = app_driver.window.findChild(QPushButton, "stop_button")
    QTest.mousePress(stop, Qt.MouseButton.LeftButton)
    frames = app_driver.heard()
    QTest.mouseRelease(stop, Qt.MouseButton.LeftButton)
    return [(frame.arbitration_id, frame.data.hex()) for frame in frames]


@pytest.mark.parametrize(
    ("harm", "begin"), [(kill, move), (freeze, jog), (kill, run_moving)], ids=lambda f: f.__name__
)
def test_the_arm_is_driven_and_stopped_as_ever_and_the_picture_comes_back(
    drawing, lost, harm, begin
):
    view = drawing.program.view
    pid = view._client.pid
    begin(drawing)
    harm(view._client)
    before = drawing.controller.state.angles_deg()
    hold(drawing, 0.3)
    after = drawing.controller.state.angles_deg()
    assert max(abs(a - b) for a, b in zip(before, after, strict=True)) > 1.0
    assert press_stop(drawing)[0] == STOP
    drawing.run_until(lambda: "stop_confirmed" in drawing.codes())
    view.set_joints(TARGET_DEG, 0.0)
    wait_until(lambda: lost)
    assert lost[0].comes_back
    drawing.run(0.1)
    wait_until(lambda: view.is_settled)
    assert view._client.pid != pid
    assert view._notice() == ""
    assert view._state.angles_deg == pytest.approx(drawing.controller.state.angles_deg(), abs=0.01)


def test_nothing_waits_for_a_picture_that_does_not_come(drawing):
    """Camera, size, preview and the program's end, too, with a process that stands still."""
    view = drawing.program.view
    freeze(view._client)
    jog(drawing)
    assert drawing.controller.jogging.active
    places = np.zeros((30_000, 3))
    path = PathPicture(places, places[:, 0], places[:1], (0,))
    view.set_preview(Preview(path))  # far more than fits into a pipe
    view.reset_view()
    drawing.window.resize(1100, 760)
    hold(drawing, 0.1)
    assert drawing.controller.jogging.active
    assert press_stop(drawing)[0] == STOP
    view._client.stop()
    assert view._client.pid is None


def drag(view, button, by_px, modifiers=Qt.KeyboardModifier.NoModifier):
    """Drag in the picture, from a place where no handle and no button is."""
    at = QPoint(view.width() // 2, view.height() - 120)
    QTest.mousePress(view, button, modifiers, at)
    for share in (0.5, 1.0):
        place = QPointF(at) + QPointF(*by_px) * share
        move = QMouseEvent(
            QMouseEvent.Type.MouseMove,
            place,
            view.mapToGlobal(place),
            Qt.MouseButton.NoButton,
            button,
            modifiers,
        )
        QApplication.sendEvent(view, move)
    QTest.mouseRelease(view, button, modifiers, at + QPoint(*by_px))


def fit(app_driver):
    app_driver.click("view_fit_button")


def orbit(app_driver):
    drag(app_driver.program.view, Qt.MouseButton.LeftButton, (90, 30))


def turned_by_keys(app_driver):
    """Until the arm would leave the picture, which does not bring it back."""
    for _ in range(6):
        QTest.keyClick(app_driver.program.view, Qt.Key.Key_Right)


def named_view(app_driver):
    app_driver.window.findChild(QAction, "view_side").trigger()


def zoom_and_pan(app_driver):
    view = app_driver.program.view
    QTest.keyClick(view, Qt.Key.Key_Plus)
    drag(view, Qt.MouseButton.MiddleButton, (40, -20))


@pytest.mark.parametrize("look", [fit, orbit, turned_by_keys, named_view, zoom_and_pan])
def test_the_camera_is_the_same_after_the_process_was_killed(drawing, lost, look):
    view = drawing.program.view
    drawing.store.change(picture_trail_s=0)  # which goes on growing shorter
    move(drawing)  # the camera has stepped back for the arm
    drawing.run_until(lambda: not drawing.controller.operating_state.moving, seconds=30.0)
    look(drawing)
    wait_until(lambda: view.is_settled and not view._rest.isActive())
    camera, mode = view.camera, view.mode
    image = view._picture.image.copy()
    kill(view._client)
    wait_until(lambda: lost)
    drawing.run(0.1)
    wait_until(lambda: view.is_settled and view.is_current)
    assert (view.camera, view.mode) == (camera, mode)
    assert view._shown.camera == camera
    assert view._picture.image == image
