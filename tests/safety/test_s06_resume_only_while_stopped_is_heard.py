"""S6: «resume» is offered only while 0x2A1, heard, says stopped; otherwise the button stops."""

import pytest

from armui.control.devices.motors import NOT_STOPPED
from armui.control.operating_state import StopState
from armui.ui.widgets.stop_button import StopButton
from tests.faulty_arm import FaultyDrivers
from tests.sim.talk import RESUME, frame


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
    app_driver.time_s += 2.0  # no double click
    app_driver.press(button)
    app_driver.run(0.1)
    assert app_driver.firmware.stopped


def test_while_it_is_heard_the_button_resumes(stopped):
    stopped.run(2.0)
    assert stopped.window.findChild(StopButton).text() == "Resume"
