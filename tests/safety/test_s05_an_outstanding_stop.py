"""S5: a stop asked for and not confirmed outlives cable, connection and failed parts."""

import errno

import can
import pytest

from armui.arm.device import Device
from armui.control.recovery_steps import Action, Kind
from armui.control.situation import LinkState, StopState
from armui.ui.widgets.stop_button import StopButton
from tests.faulty_arm import HardOfHearing

GONE = can.CanOperationError("gone", error_code=errno.ENODEV)


def lose_cable(bench, qtbot):
    bench.unplug(GONE)
    qtbot.waitUntil(lambda: bench.controller.situation.link is LinkState.LOST)


def pass_time(bench, seconds):
    """Time in which nothing is connected."""
    bench.time_s += seconds
    bench.controller.tick()


def reconnect(bench):
    bench.plug_in()
    bench.controller.disconnect_device()
    bench.controller.connect_device(bench.device)


@pytest.fixture
def moving(bench):
    bench.ready()
    bench.controller.motion.send_joints((80.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    bench.run_until(lambda: bench.controller.situation.moving)
    return bench


def test_it_goes_out_by_itself_on_a_new_connection_to_the_same_device(moving, qtbot):
    bench = moving
    lose_cable(bench, qtbot)
    bench.controller.emergency_stop()
    pass_time(bench, 5.0)
    reconnect(bench)
    assert bench.controller.situation.stop is StopState.REQUESTED
    bench.run_until(lambda: bench.firmware.stopped)
    bench.run_until(lambda: "stop_confirmed" in bench.codes())
    assert bench.controller.situation.stop is StopState.STOPPED


def test_after_ten_seconds_the_operator_is_asked(moving, qtbot):
    bench = moving
    lose_cable(bench, qtbot)
    bench.controller.emergency_stop()
    pass_time(bench, 10.5)
    assert bench.controller.recovery.step.kind is Kind.STOP_LAPSED_AWAY
    reconnect(bench)
    bench.run(2.0)
    assert not bench.firmware.stopped
    assert "stop_lapsed" in bench.codes()
    step = bench.controller.recovery.step
    assert (step.kind, step.action) == (Kind.STOP_LAPSED, Action.WITHDRAW_STOP)
    assert bench.controller.situation.cannot_move.code == "stop_requested"
    bench.controller.emergency_stop()
    bench.run_until(lambda: bench.controller.situation.stop is StopState.STOPPED)


def test_it_lapses_while_nothing_is_connected_too(moving, qtbot):
    bench = moving
    lose_cable(bench, qtbot)
    bench.controller.emergency_stop()
    bench.plug_in()
    bench.controller.disconnect_device()
    bench.time_s += 11.0
    bench.controller.connect_device(bench.device)
    bench.run(1.0)
    assert not bench.firmware.stopped
    assert bench.controller.recovery.step.kind is Kind.STOP_LAPSED


def test_a_withdrawn_stop_is_over(moving, qtbot):
    bench = moving
    lose_cable(bench, qtbot)
    bench.controller.emergency_stop()
    pass_time(bench, 11.0)
    reconnect(bench)
    bench.run_until(lambda: bench.controller.recovery.step.kind is Kind.STOP_LAPSED)
    assert bench.controller.recovery.act(bench.controller.recovery.step) is None
    bench.run(1.0)
    assert not bench.firmware.stopped
    assert bench.controller.situation.stop is StopState.RUNNING
    assert bench.codes().count("stop_withdrawn") == 1


def test_an_arm_heard_all_the_time_is_told_for_as_long_as_it_takes(bench):
    bench.ready()
    ear = HardOfHearing(bench.firmware)
    ear.deaf_to = {0x150, 0x160, 0x170}
    bench.controller.emergency_stop()
    bench.run(12.0)
    ear.deaf_to = set()
    bench.run(0.3)
    assert bench.firmware.stopped


def test_a_stop_is_not_sent_to_another_device(moving, qtbot):
    bench = moving
    lose_cable(bench, qtbot)
    bench.controller.emergency_stop()
    bench.plug_in()
    other = Device("virtual", bench.channel, None, simulated=True, generation=1)
    bench.controller.disconnect_device()
    bench.controller.connect_device(other)
    bench.run(1.0)
    assert not bench.firmware.stopped
    (told,) = [each for each in bench.notices if each.code == "stop_abandoned"]
    assert told.params["device"] == bench.device


def test_the_line_does_not_lose_sight_of_it(moving, qtbot):
    bench = moving
    lose_cable(bench, qtbot)
    bench.controller.emergency_stop()
    bench.controller.disconnect_device()
    step = bench.controller.recovery.step
    assert (step.kind, step.action) == (Kind.STOP_WAITS_FOR_DEVICE, Action.CONNECT)


def test_the_button_says_that_it_is_outstanding(desk, qtbot):
    desk.connect_by_hand()
    lose_cable(desk, qtbot)
    desk.controller.emergency_stop()
    pass_time(desk, 11.0)
    button = desk.window.findChild(StopButton)
    assert button.text() == "Stop outstanding"
    reconnect(desk)
    desk.run(1.0)
    assert button.text() == "Stop outstanding"
    desk.press(button)
    desk.run_until(lambda: desk.firmware.stopped)


def test_it_outlives_a_part_that_fails(bench, monkeypatch):
    bench.ready()
    ear = HardOfHearing(bench.firmware)
    ear.deaf_to = {0x150, 0x160, 0x170}

    def fail():
        raise RuntimeError("on purpose")

    for part in (bench.controller.motion, bench.controller.player, bench.controller.recovery):
        monkeypatch.setattr(part, "advance", fail)
        monkeypatch.setattr(part, "halt", fail)
    bench.controller.emergency_stop()
    bench.run(0.5)
    ear.deaf_to = set()
    bench.run(0.3)
    assert bench.firmware.stopped
