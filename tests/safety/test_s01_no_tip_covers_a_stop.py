"""S1: no tooltip or hint lies over a stop, or over a lamp."""

import pytest
from PySide6.QtCore import QEvent, QPoint, QRect, Qt
from PySide6.QtGui import QHelpEvent
from PySide6.QtWidgets import QApplication, QToolTip

pytestmark = pytest.mark.styled

KEPT = ("stop_button", "halt_button", "enable_button", "joint_status_button")
HOVERED = (*KEPT, "speed_field", "communication_button", "sessions_button", "bus_button")


def on_screen(widget):
    return QRect(widget.mapToGlobal(QPoint(0, 0)), widget.size())


def visible_tip():
    windows = QApplication.topLevelWidgets()
    tips = [each for each in windows if each.windowType() is Qt.WindowType.ToolTip]
    return next((each for each in tips if each.isVisible()), None)


@pytest.fixture
def driver(app_driver):
    app_driver.ready()
    app_driver.window.resize(1280, 800)
    app_driver.window.move(0, 0)
    app_driver.run(0.5)
    yield app_driver
    QToolTip.hideText()


@pytest.mark.each_value(full="each control at both sizes")
@pytest.mark.parametrize("name", HOVERED)
@pytest.mark.parametrize("share", [0.1, 0.9])
def test_the_tip_of_a_control_beside_them_leaves_them_in_sight(driver, name, share):
    widget = driver.find(name)
    assert widget.toolTip()
    at = QPoint(round(share * widget.width()), widget.height() // 2)
    QApplication.sendEvent(widget, QHelpEvent(QEvent.Type.ToolTip, at, widget.mapToGlobal(at)))
    assert visible_tip() is not None
    driver.run(0.05)
    tip = visible_tip()
    assert tip is not None, "it was hidden though there is room"
    for kept in KEPT:
        assert not tip.geometry().intersects(on_screen(driver.find(kept))), kept


def test_the_hint_of_a_held_button_leaves_them_in_sight(driver):
    stop = driver.find("stop_button")
    driver.click(stop)
    driver.run(1.0)
    driver.click("recovery_hold_button")
    tip = visible_tip()
    assert tip is not None
    assert not any(tip.geometry().intersects(on_screen(driver.find(each))) for each in KEPT)
