"""S6: «resume» is offered only while 0x2A1, heard, says stopped; otherwise the button stops."""

import pytest

from armui.control.situation import StopState
from armui.ui.widgets.stop_button import StopButton
from tests.faulty_arm import FaultyDrivers
from tests.sim.talk import RESUME, frame


@pytest.fixture
def stopped(any_desk):
    any_desk.connect_by_hand()
    any_desk.controller.emergency_stop()
    any_desk.run_until(lambda: any_desk.controller.situation.stop is StopState.STOPPED)
    return any_desk


def test_with_a_silent_status_the_button_stops(stopped):
    desk = stopped
    faults = FaultyDrivers(desk.firmware)
    faults.missing = {0x2A1}
    desk.run(0.6)
    desk.firmware.on_frame(frame(RESUME))  # another host has resumed; nobody hears of it
    button = desk.window.findChild(StopButton)
    assert button.text() == "Emergency stop"
    assert desk.controller.motors.resume().code == "not_stopped"
    desk.time_s += 2.0  # no double click
    desk.press(button)
    desk.run(0.1)
    assert desk.firmware.stopped


def test_while_it_is_heard_the_button_resumes(stopped):
    stopped.run(2.0)
    assert stopped.window.findChild(StopButton).text() == "Resume"
