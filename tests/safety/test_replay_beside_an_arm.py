"""S1: an arm that is connected while a log is replayed keeps its stop, its faults and its words."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from armui.control.operating_state import StopState
from armui.protocol.generation import Generation
from armui.ui.widgets.halt_button import HaltButton
from armui.ui.widgets.stop_button import StopButton
from armui.ui.widgets.stop_shortcut import HALT_KEY
from tests.accepted import accepted
from tests.operator.replay_actions import Replay
from tests.session.recordings import START_S, frames, greeting, write

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture(scope="module")
def log(tmp_path_factory):
    path = tmp_path_factory.mktemp("log") / "old.blf"
    write(path, frames(3.0, asked=greeting(Generation.TWO)))
    return path


@pytest.fixture
def replay(app_driver, monkeypatch, log):
    """An arm under way to a far target, and a log that plays in a window in front."""
    app_driver.ready()
    accepted(app_driver.controller.motion.send_joints((60.0, 0.0, 0.0, 0.0, 0.0, 0.0)))
    app_driver.run(0.5)
    replay = Replay(app_driver, monkeypatch)
    replay.open(log)
    replay.replay.set_speed(0.1)
    replay.replay.play(on=True)
    app_driver.heard()
    yield replay
    replay.window.close()


def stopped(replay):
    driver = replay.driver
    driver.run_until(lambda: driver.controller.operating_state.stop is StopState.STOPPED, 1.0)
    return driver.firmware.condition.stopped


def test_the_stop_in_the_replay_window_stops_the_arm_at_the_press(replay):
    button = replay.window.findChild(StopButton)

    QTest.mousePress(button, LEFT, pos=button.rect().center())

    assert replay.driver.heard()[0].data[0] == 1
    assert stopped(replay)
    assert replay.replay.is_playing  # and the log goes on, unmoved
    QTest.mouseRelease(button, LEFT, pos=button.rect().center())


@pytest.mark.parametrize("key", [Qt.Key.Key_F12, Qt.Key.Key_Pause])
def test_the_keys_stop_the_arm_from_the_replay_window(replay, key):
    replay.window.activateWindow()

    QTest.keyPress(replay.view.time_line, key)

    assert stopped(replay)


def test_halt_in_the_replay_window_halts_the_arm(replay):
    button = replay.window.findChild(HaltButton)

    QTest.mousePress(button, LEFT, pos=button.rect().center())

    assert replay.driver.heard()[0].data[1] == 6
    QTest.mouseRelease(button, LEFT, pos=button.rect().center())


def test_the_halt_key_halts_the_arm_from_the_replay_window(replay):
    QTest.keyPress(replay.window, HALT_KEY)

    assert replay.driver.heard()[0].data[1] == 6


def test_no_stop_button_of_the_window_belongs_to_the_log(replay):
    live = replay.driver.controller
    for button in (
        *replay.window.findChildren(StopButton),
        *replay.window.findChildren(HaltButton),
    ):
        assert button._controller is live


def test_faults_of_the_arm_are_in_sight_and_not_those_of_the_log(replay):
    driver, strip = replay.driver, replay.window.live_strip
    assert strip.isVisible()

    driver.firmware.set_communication_fault(4, present=True)
    driver.run(0.5)

    assert "4" in strip._text.text()
    assert "J4" in strip.status._labels["joints"].text()
    assert replay.view.status._labels["joints"].isHidden()


def test_nothing_of_the_log_reaches_the_arm(replay):
    driver = replay.driver
    replay.replay.set_speed(20.0)
    driver.wait(lambda: not replay.replay.is_playing)
    for since_s in (0.5, 2.5, 1.0):
        replay.replay.go_to(START_S + since_s)
        replay.arrive()
        replay.replay.controller.tick()
        driver.run(0.1)

    assert driver.heard() == []
    assert driver.controller.state.angles_deg() is not None
    assert driver.controller.state.angles_deg() != (0.0,) * 6


def test_without_an_arm_there_is_no_strip(replay):
    driver = replay.driver

    driver.controller.disconnect_device()

    assert replay.window.live_strip.isHidden()
    assert replay.window.findChild(StopButton).isVisible()
