"""S6: release is offered only while 0x2A1, heard, says stopped; the red place always stops."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from armui.control.devices.motors import NOT_STOPPED
from armui.control.operating_state import StopState
from armui.ui.widgets.stop_button import StopButton
from tests.faulty_arm import FaultyDrivers
from tests.sim.talk import RESUME, STOP, frame


@pytest.fixture
def stopped(any_driver):
    any_driver.connect_by_hand()
    any_driver.controller.emergency_stop()
    any_driver.run_until(lambda: any_driver.controller.operating_state.stop is StopState.STOPPED)
    return any_driver


def test_with_a_silent_status_the_button_stops(stopped):
    app_driver = stopped
    faults = FaultyDrivers(app_driver.firmware)
    faults.missing = {0x2A1}
    app_driver.run(0.6)
    app_driver.firmware.on_frame(frame(RESUME))  # another host has resumed; nobody hears of it
    button = app_driver.window.findChild(StopButton)
    assert button.text() == "Emergency stop"
    assert app_driver.controller.motors.resume().reason == NOT_STOPPED
    assert not app_driver.find("recovery_hold_button").isVisible()
    app_driver.press(button)
    app_driver.run(0.1)
    assert app_driver.firmware.condition.stopped


def test_while_it_is_heard_release_is_a_held_press_in_the_line(stopped):
    """The red place goes on stopping; what lets the arm drop stands elsewhere."""
    stopped.run(2.0)
    stopped.node.heard.clear()
    stopped.press(stopped.window.findChild(StopButton))
    stopped.run(0.5)
    assert frame(RESUME) not in stopped.node.heard
    assert stopped.firmware.condition.stopped
    button = stopped.find("recovery_hold_button")
    assert button.isVisible()
    assert button.text() == "Release (the arm drops)"
    stopped.click("recovery_hold_button")
    stopped.run(0.5)
    assert stopped.firmware.condition.stopped
    stopped.hold_button("recovery_hold_button")
    stopped.run_until(lambda: not stopped.firmware.condition.stopped)


@pytest.mark.each_value(full="each key in both generations")
@pytest.mark.parametrize("key", [Qt.Key.Key_F12, Qt.Key.Key_Pause])
def test_a_stop_while_release_is_held_is_the_last_word(stopped, key):
    """The hold was meant for the stop before; it ends without effect, even with the button down."""
    button = stopped.find("recovery_hold_button")
    stopped.run_until(button.isEnabled)
    stopped.node.heard.clear()
    stopped.press(button)
    QTest.keyClick(stopped.window, key)
    button.progress.setCurrentTime(button.progress.duration())
    stopped.run(0.5)
    assert frame(STOP) in stopped.node.heard
    assert frame(RESUME) not in stopped.node.heard
    assert stopped.firmware.condition.stopped


def test_a_running_arm_offers_no_release(any_driver):
    any_driver.connect_by_hand()
    any_driver.run(0.5)
    assert not any_driver.find("recovery_hold_button").isVisible()
    assert any_driver.controller.motors.resume().reason == NOT_STOPPED
