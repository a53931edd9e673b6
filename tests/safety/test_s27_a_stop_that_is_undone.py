"""S27: an operator's stop that another host undoes is a fault, said at once."""

import pytest
from PySide6.QtWidgets import QCheckBox

from armui.control.events import Level
from armui.control.operating_state import StopState
from armui.ui.dialogs.settings import SettingsDialog
from tests.accepted import accepted
from tests.faulty_arm import HardOfHearing
from tests.moments import now
from tests.sim.talk import RESUME


@pytest.fixture
def stopped(rig):
    rig.ready()
    rig.controller.emergency_stop()
    rig.run_until(lambda: rig.controller.operating_state.stop is StopState.STOPPED)
    return rig


def test_it_is_said_at_once_and_not_stopped_again(stopped, other_host):
    other_host.say(RESUME)
    stopped.run(0.5)
    told = [each for each in stopped.events if each.code == "stop_undone"]
    assert [each.level for each in told] == [Level.FAULT]
    assert not stopped.firmware.condition.stopped
    assert stopped.controller.operating_state.stop is StopState.RUNNING


def test_as_a_setting_it_stops_again(stopped, other_host):
    stopped.controller.stop_again_when_undone(True)
    other_host.say(RESUME)
    stopped.run(0.5)
    assert "stop_undone" in stopped.codes()
    assert stopped.firmware.condition.stopped
    other_host.say(RESUME)  # as often as it takes
    stopped.run(0.5)
    assert stopped.firmware.condition.stopped


def test_a_resume_from_here_is_none(stopped):
    stopped.controller.stop_again_when_undone(True)
    accepted(stopped.controller.motors.resume())
    stopped.run_until(lambda: "resumed" in stopped.codes())
    stopped.run(1.0)
    assert "stop_undone" not in stopped.codes()
    assert not stopped.firmware.condition.stopped


def test_a_resume_from_here_that_was_in_vain_excuses_nobody(stopped, other_host):
    ear = HardOfHearing(stopped.firmware)
    ear.deaf_to = {0x150}
    accepted(stopped.controller.motors.resume())
    stopped.run_until(lambda: "resume_failed" in stopped.codes())
    stopped.run(0.1)  # heard stopped after it
    ear.deaf_to = set()
    other_host.say(RESUME)
    stopped.run(0.5)
    assert "stop_undone" in stopped.codes()


def test_another_hosts_stop_may_be_undone_by_it(rig, other_host):
    rig.ready()
    other_host.say("150#0100000000000000")
    rig.run_until(lambda: rig.controller.operating_state.stop is StopState.STOPPED)
    other_host.say(RESUME)
    rig.run(0.5)
    assert "stop_undone" not in rig.codes()


def test_the_setting_is_off_until_the_operator_chooses_it(app_driver):
    assert now(app_driver.store.settings.stop_again) is False
    app_driver.window.pages.show("settings")
    app_driver.click(app_driver.dialog(SettingsDialog).findChild(QCheckBox, "stop_again_box"))
    assert now(app_driver.store.settings.stop_again) is True
    assert app_driver.controller._stop.stop_again is True
