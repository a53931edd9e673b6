"""S14: what was checked is what is sent; Ctrl+K sends no target that the operator has not seen."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton

from armui.trajectory.library.store import Library
from armui.trajectory.points.program import Trajectory
from armui.ui.trajectory.library.library_page import LibraryPage
from tests.operator.library.actions import POINT
from tests.operator.test_palette import command

pytestmark = pytest.mark.styled


@pytest.fixture
def driver(app_driver):
    """The arm ready, a target typed in 运动控制 and a trajectory open, neither of them in sight."""
    Library(app_driver.library_folder).save(Trajectory("one", points=(POINT, POINT)))
    app_driver.ready()
    app_driver.type_into("target_field_1", "90")
    app_driver.click("library_button")
    app_driver.page(LibraryPage).open_trajectory("one")
    app_driver.click("menu_light")
    app_driver.run(0.2)
    return app_driver


def is_going(driver):
    state = driver.controller.operating_state
    return state.moving or state.running


@pytest.mark.parametrize(
    ("words", "button"),
    [
        ("send motion control", "send_button"),
        ("send trajectory editor", "run_send"),
        ("go to this point", "editor_go_to"),
    ],
)
def test_a_target_out_of_sight_is_shown_and_sent_by_a_press_of_its_own(driver, words, button):
    command(driver, words)
    driver.run(0.5)
    assert not is_going(driver)
    shown = [
        each
        for each in driver.window.findChildren(QAbstractButton, button)
        if each.isVisible() and each.hasFocus()
    ]
    assert len(shown) == 1
    pressed = []
    shown[0].clicked.connect(lambda: pressed.append(True))
    QTest.keyClick(shown[0], Qt.Key.Key_Space)
    assert pressed == [True]
    if button != "run_send":  # a run is checked first, and asks
        driver.run_until(lambda: is_going(driver))


def test_a_target_in_sight_is_sent(driver):
    driver.click("menu_motion")
    command(driver, "send motion control")
    driver.run_until(lambda: is_going(driver))
