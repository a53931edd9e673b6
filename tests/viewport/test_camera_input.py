"""The operator's hand on the camera, without a view."""

import pytest
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication

from armui.viewport.camera import HOME_CAMERA
from armui.viewport.camera_input import Drag, press_key

LEFT, MIDDLE, RIGHT = (
    Qt.MouseButton.LeftButton,
    Qt.MouseButton.MiddleButton,
    Qt.MouseButton.RightButton,
)


def mouse(kind, x_px, button=LEFT, modifiers=Qt.KeyboardModifier.NoModifier):
    at = QPointF(x_px, 10.0)
    return QMouseEvent(kind, at, at, button, button, modifiers)


def press(drag, x_px=100.0, button=LEFT):
    drag.press(mouse(QEvent.Type.MouseButtonPress, x_px, button))


def move(drag, x_px, button=LEFT, modifiers=Qt.KeyboardModifier.NoModifier):
    event = mouse(QEvent.Type.MouseMove, x_px, button, modifiers)
    return drag.move(event, HOME_CAMERA, 400.0)


def release(drag, x_px):
    return drag.release(mouse(QEvent.Type.MouseButtonRelease, x_px))


def test_each_move_goes_on_from_the_last(qapp):
    drag = Drag()
    press(drag)
    assert move(drag, 105.0) == HOME_CAMERA.orbit(5.0, 0.0)
    assert move(drag, 108.0) == HOME_CAMERA.orbit(3.0, 0.0)
    assert move(drag, 110.0, MIDDLE) == HOME_CAMERA.pan(2.0, 0.0, 400.0)
    shift = Qt.KeyboardModifier.ShiftModifier
    assert move(drag, 114.0, modifiers=shift) == HOME_CAMERA.pan(4.0, 0.0, 400.0)


def test_a_release_near_the_press_was_a_click(qapp):
    near_px = QApplication.startDragDistance() - 1
    drag = Drag()
    press(drag)
    assert release(drag, 100.0 + near_px) == QPointF(100.0 + near_px, 10.0)
    press(drag)
    assert release(drag, 101.0 + near_px) is None


def test_nothing_is_dragged_without_a_press_or_after_the_end(qapp):
    drag = Drag()
    assert move(drag, 5.0) is None
    press(drag, button=RIGHT)
    assert move(drag, 5.0) is None
    press(drag)
    drag.cancel()
    assert move(drag, 5.0) is None
    assert release(drag, 100.0) is None


@pytest.mark.parametrize(
    ("key", "camera"),
    [
        (Qt.Key.Key_Left, HOME_CAMERA.orbit(-20.0, 0.0)),
        (Qt.Key.Key_Down, HOME_CAMERA.orbit(0.0, 20.0)),
        (Qt.Key.Key_Equal, HOME_CAMERA.zoom(1.0)),
        (Qt.Key.Key_Minus, HOME_CAMERA.zoom(-1.0)),
        (Qt.Key.Key_A, None),
    ],
)
def test_keys(key, camera):
    assert press_key(key, HOME_CAMERA) == camera
