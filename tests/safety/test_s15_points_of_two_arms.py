"""S15: what was measured of one arm is not put together with what is measured of another."""

import pytest

from armui.control.cell.cell_reasons import CAPTURED_OF_ANOTHER
from armui.sim.firmware import Firmware
from armui.sim.node import Node
from armui.ui import words
from armui.ui.widgets.message_line import MessageLine
from tests.control.jogger import BENT_DEG
from tests.operator import frame_actions, tip_actions


@pytest.fixture
def arm_repeats():
    return False


def exchange(driver):
    """The cable goes to another arm that is enabled and lies elsewhere."""
    driver.powered = False
    driver.run(1.0)
    elsewhere = [angle + 7.0 for angle in BENT_DEG]
    driver.firmware = Firmware(driver.firmware.generation, joints_deg=elsewhere)
    driver.node = Node(driver.firmware, driver._arm_bus)
    driver.powered = True
    driver.run(3.0)


def a_short_silence(driver):
    driver.firmware.feedback_stopped = True
    driver.run(1.0)
    driver.firmware.feedback_stopped = False
    driver.run(3.0)


def says(driver, reason):
    text = words.refusal(reason())
    lines = driver.window.findChildren(MessageLine)
    return any(text in each.text() for each in lines if each.isVisible())


def test_poses_of_a_tip_are_dropped_with_the_arm_they_are_of(app_driver):
    tip_actions.search(app_driver)
    tip_actions.take(app_driver, 0, 1)
    assert app_driver.find("tip_restart").isEnabled()
    exchange(app_driver)
    assert not app_driver.find("tip_restart").isEnabled()
    assert says(app_driver, CAPTURED_OF_ANOTHER)


def test_points_of_a_frame_are_dropped_with_the_arm_they_are_of(app_driver):
    frame_actions.at_frames(app_driver)
    app_driver.click("cell_frame_by_points")
    frame_actions.take(app_driver, 0, 1)
    exchange(app_driver)
    assert not app_driver.find("frame_points_restart").isEnabled()
    assert app_driver.window._view._frames == ()


def test_poses_stay_over_a_silence_of_the_same_arm(app_driver):
    tip_actions.search(app_driver)
    tip_actions.take(app_driver, 0, 1)
    a_short_silence(app_driver)
    assert app_driver.controller.cell.confirmed
    assert app_driver.find("tip_restart").isEnabled()
