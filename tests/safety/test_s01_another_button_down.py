"""S1: what is held ends with the finger, also beside another button of the mouse.

A right button may be down by a menu that is gone since, or forever, where a remote desktop has lost
its release. Qt then tells no widget that the left one was let go.
"""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QWidget

from tests.control.jogger import bend, hold
from tests.operator.test_jogging import angles, choose_continuous

pytestmark = pytest.mark.styled

LEFT, RIGHT = Qt.MouseButton.LeftButton, Qt.MouseButton.RightButton


@pytest.fixture
def beside_it(app_driver):
    """The right button is down, and what it was pressed on is gone."""
    bend(app_driver)
    choose_continuous(app_driver)
    gone = QWidget()
    gone.show()
    QTest.mousePress(gone, RIGHT)
    gone.close()
    gone.deleteLater()
    app_driver.window.activateWindow()
    QApplication.processEvents()
    yield app_driver
    QTest.mouseRelease(app_driver.window.windowHandle(), RIGHT)


def pressed_and_let_go(driver, name):
    """Press a button by way of the window, let go of it; return it."""
    button, window = driver.find(name), driver.window.windowHandle()
    where = button.mapTo(button.window(), button.rect().center())
    QTest.mousePress(window, LEFT, pos=where)
    hold(driver, 0.3)
    QTest.mouseRelease(window, LEFT, pos=where)
    return button


def test_a_jog_does_not_go_on(beside_it):
    before = angles(beside_it)
    button = pressed_and_let_go(beside_it, "jog_plus_1")
    assert not button.isDown()
    beside_it.run(0.5)
    assert not beside_it.controller.jogging.active
    assert angles(beside_it) == before  # none began: its end would not have been heard


def test_no_hold_runs_on_to_its_act(beside_it):
    beside_it.controller.emergency_stop()
    beside_it.run(1.0)
    button = pressed_and_let_go(beside_it, "recovery_hold_button")
    assert not button.isDown()
    assert button.share == 0.0
    assert button.progress.state() == button.progress.State.Stopped


def test_the_stop_stops_all_the_same(beside_it):
    pressed_and_let_go(beside_it, "stop_button")
    assert beside_it.controller.operating_state.stop is not None
    beside_it.run(1.0)
    assert beside_it.controller.operating_state.stop.name == "STOPPED"
