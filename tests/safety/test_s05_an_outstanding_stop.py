"""S5: a stop asked for and not confirmed outlives cable, connection and failed parts."""

import errno

import can
import pytest

from armui.arm.device import Device
from armui.control.link.link_state import LinkState
from armui.control.operating_state import StopState
from armui.control.safety.interlocks import STOP_REQUESTED
from armui.control.safety.recovery_steps import Action, StepKind
from armui.ui.widgets.stop_button import StopButton
from tests.faulty_arm import HardOfHearing
from tests.moments import now

GONE = can.CanOperationError("gone", error_code=errno.ENODEV)


def lose_cable(rig, qtbot):
    rig.unplug(GONE)
    qtbot.waitUntil(lambda: rig.controller.operating_state.link is LinkState.LOST)


def pass_time(rig, seconds):
    """Time in which nothing is connected."""
    rig.time_s += seconds
    rig.controller.tick()


def reconnect(rig):
    rig.plug_in()
    rig.controller.disconnect_device()
    rig.controller.connect_device(rig.device)


@pytest.fixture
def moving(rig):
    rig.ready()
    rig.controller.motion.send_joints((80.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    rig.run_until(lambda: rig.controller.operating_state.moving)
    return rig


def test_it_goes_out_by_itself_on_a_new_connection_to_the_same_device(moving, qtbot):
    rig = moving
    lose_cable(rig, qtbot)
    rig.controller.emergency_stop()
    pass_time(rig, 5.0)
    reconnect(rig)
    assert now(rig.controller.operating_state.stop) is StopState.REQUESTED
    rig.run_until(lambda: rig.firmware.condition.stopped)
    rig.run_until(lambda: "stop_confirmed" in rig.codes())
    assert now(rig.controller.operating_state.stop) is StopState.STOPPED


def test_after_ten_seconds_the_operator_is_asked(moving, qtbot):
    rig = moving
    lose_cable(rig, qtbot)
    rig.controller.emergency_stop()
    pass_time(rig, 10.5)
    assert rig.controller.recovery.step.kind is StepKind.STOP_LAPSED_AWAY
    reconnect(rig)
    rig.run(2.0)
    assert not rig.firmware.condition.stopped
    assert "stop_lapsed" in rig.codes()
    step = rig.controller.recovery.step
    assert (step.kind, step.action) == (StepKind.STOP_LAPSED, Action.WITHDRAW_STOP)
    assert rig.controller.operating_state.cannot_move.reason == STOP_REQUESTED
    rig.controller.emergency_stop()
    rig.run_until(lambda: rig.controller.operating_state.stop is StopState.STOPPED)


def test_it_lapses_while_nothing_is_connected_too(moving, qtbot):
    rig = moving
    lose_cable(rig, qtbot)
    rig.controller.emergency_stop()
    rig.plug_in()
    rig.controller.disconnect_device()
    rig.time_s += 11.0
    rig.controller.connect_device(rig.device)
    rig.run(1.0)
    assert not rig.firmware.condition.stopped
    assert rig.controller.recovery.step.kind is StepKind.STOP_LAPSED


def test_a_withdrawn_stop_is_over(moving, qtbot):
    rig = moving
    lose_cable(rig, qtbot)
    rig.controller.emergency_stop()
    pass_time(rig, 11.0)
    reconnect(rig)
    rig.run_until(lambda: rig.controller.recovery.step.kind is StepKind.STOP_LAPSED)
    assert rig.controller.recovery.act(rig.controller.recovery.step) is None
    rig.run(1.0)
    assert not rig.firmware.condition.stopped
    assert rig.controller.operating_state.stop is StopState.RUNNING
    assert rig.codes().count("stop_withdrawn") == 1


def test_an_arm_heard_all_the_time_is_told_for_as_long_as_it_takes(rig):
    rig.ready()
    ear = HardOfHearing(rig.firmware)
    ear.deaf_to = {0x150, 0x160, 0x170}
    rig.controller.emergency_stop()
    rig.run(12.0)
    ear.deaf_to = set()
    rig.run(0.3)
    assert rig.firmware.condition.stopped


def test_a_stop_is_not_sent_to_another_device(moving, qtbot):
    rig = moving
    lose_cable(rig, qtbot)
    rig.controller.emergency_stop()
    rig.plug_in()
    other = Device("virtual", rig.channel, None, simulated=True, generation=1)
    rig.controller.disconnect_device()
    rig.controller.connect_device(other)
    rig.run(1.0)
    assert not rig.firmware.condition.stopped
    (told,) = [each for each in rig.events if each.code == "stop_abandoned"]
    assert told.params["device"] == rig.device


def test_the_line_does_not_lose_sight_of_it(moving, qtbot):
    rig = moving
    lose_cable(rig, qtbot)
    rig.controller.emergency_stop()
    rig.controller.disconnect_device()
    step = rig.controller.recovery.step
    assert (step.kind, step.action) == (StepKind.STOP_WAITS_FOR_DEVICE, Action.CONNECT)


def test_the_button_says_that_it_is_outstanding(app_driver, qtbot):
    app_driver.connect_by_hand()
    lose_cable(app_driver, qtbot)
    app_driver.controller.emergency_stop()
    pass_time(app_driver, 11.0)
    button = app_driver.window.findChild(StopButton)
    assert button.text() == "Stop outstanding"
    reconnect(app_driver)
    app_driver.run(1.0)
    assert button.text() == "Stop outstanding"
    app_driver.press(button)
    app_driver.run_until(lambda: app_driver.firmware.condition.stopped)


def test_it_outlives_a_part_that_fails(rig, monkeypatch):
    rig.ready()
    ear = HardOfHearing(rig.firmware)
    ear.deaf_to = {0x150, 0x160, 0x170}

    def fail():
        raise RuntimeError("on purpose")

    for part in (rig.controller.motion, rig.controller.player, rig.controller.recovery):
        monkeypatch.setattr(part, "follow_arm", fail)
        monkeypatch.setattr(part, "halt", fail)
    rig.controller.emergency_stop()
    rig.run(0.5)
    ear.deaf_to = set()
    rig.run(0.3)
    assert rig.firmware.condition.stopped
