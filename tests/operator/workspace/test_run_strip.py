"""A run is told once, in the main window, whatever page or panel is seen."""

import errno

import can
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QWidget

from armui.control.events import Level
from armui.control.run.replay import Replay
from armui.control.safety.interlocks import SPEED_ZERO
from armui.control.safety.recovery_steps import Step, StepKind
from armui.ui.trajectory.editor.editor_page import EditorPage
from armui.ui.trajectory.running.run_strip import END_MS
from tests.accepted import accepted
from tests.control.test_replayer import wave
from tests.operator.workspace.actions import Pages, rect_in_window


@pytest.fixture
def running(app_driver):
    pages = Pages(app_driver)
    app_driver.ready()
    editor = pages.open_editor()
    app_driver.click(editor.findChild(QWidget, "run_send"))
    accept = editor.findChild(QWidget, "accept_warnings")
    if accept.isVisible():
        app_driver.click(accept)
    app_driver.run_until(lambda: app_driver.controller.player.running)
    return pages


def strip(pages):
    return pages.driver.find("run_strip")


def test_before_a_run_there_is_none(pages):
    pages.open_editor()
    assert not pages.driver.window.findChildren(QWidget, "run_strip")


def test_it_says_what_runs_and_how_far_it_is(running):
    assert strip(running).isVisible()
    assert running.driver.read("run_name") == "one"
    assert running.driver.read("run_text").startswith("point 1 of 2 · ")
    assert "left" in running.driver.read("run_text")


@pytest.mark.styled
def test_its_progress_stands_in_line_with_its_buttons(running):
    running.driver.run(0.2)
    bar, stop = (rect_in_window(running.driver.find(each)) for each in ("run_bar", "run_stop"))
    assert abs(bar.center().y() - stop.center().y()) <= 2


@pytest.mark.parametrize("panel", ["menu_motion", "menu_gripper", "menu_teaching"])
def test_it_is_seen_from_every_panel(running, panel):
    running.driver.click(panel)
    line = rect_in_window(strip(running))
    assert strip(running).isVisible()
    assert not line.intersects(rect_in_window(running.view))
    assert not line.intersects(rect_in_window(running.driver.find("operation_area")))


def test_its_pause_is_not_taken_for_the_pause_key(running):
    tip = running.driver.find("run_pause").toolTip()
    assert "The Pause key of the keyboard stays the emergency stop." in tip


def test_it_is_seen_when_the_page_is_taken_out_and_ends_the_run(running):
    window = running.take_out()
    assert window.isVisible()
    assert strip(running).window() is running.driver.window
    running.driver.click("run_stop")
    running.driver.run_until(lambda: not running.driver.controller.player.running)
    assert running.driver.read("run_text").endswith("ended")


def test_its_end_is_told_and_can_be_put_away(running):
    running.driver.run_until(lambda: not running.driver.controller.player.running, 60.0)
    assert running.driver.read("run_text").endswith("done")
    assert not running.driver.find("run_stop").isVisible()
    running.driver.click("run_close")
    running.driver.wait(lambda: not strip(running).isVisible())
    running.driver.page(EditorPage).findChild(QWidget, "run_send").click()
    running.driver.run_until(lambda: strip(running).isVisible())


def test_the_end_that_is_told_is_of_what_ran_last(running):
    driver, replayer = running.driver, running.driver.controller.replayer
    driver.run_until(lambda: not driver.controller.player.running, 60.0)
    for halted, end in ((False, "100 % of the recording · done"), (True, "· ended")):
        accepted(replayer.start(Replay(wave(seconds=1.0))))
        driver.run_until(lambda: replayer.progress.done > 0.2, 60.0)
        if halted:
            QTest.keyClick(driver.window, Qt.Key.Key_F9)
        driver.run_until(lambda: not replayer.running, 60.0)
        driver.run(0.2)
        assert driver.read("run_name") == "wave"
        assert end in driver.read("run_text")
        full = driver.find("run_bar").maximum()
        assert (driver.find("run_bar").value() == full) is not halted


def test_its_end_goes_by_itself_after_5_s(running):
    driver = running.driver
    driver.run_until(lambda: not driver.controller.player.running, 60.0)
    assert END_MS == 5000
    assert strip(running)._ends.interval() == END_MS
    assert strip(running)._ends.isActive()
    strip(running)._ends.timeout.emit()
    assert not strip(running).isVisible()
    assert driver.find("recovery_line").isVisible()


def test_its_end_goes_at_the_first_press_anywhere_which_does_what_it_is_for(running):
    driver = running.driver
    driver.run_until(lambda: not driver.controller.player.running, 60.0)
    driver.click("menu_gripper")
    driver.wait(lambda: not strip(running).isVisible())
    assert driver.find("menu_gripper").isChecked()
    assert not strip(running)._ends.isActive()


def test_an_end_by_a_failure_is_told_until_it_is_put_away(running):
    driver = running.driver
    driver.controller.player._fail(SPEED_ZERO())
    told = driver.read("run_text")
    assert told.startswith("point 1 of 2 · ended early")
    assert "The speed is set to 0 %" in told
    assert not strip(running)._ends.isActive()
    driver.click("menu_gripper")
    driver.run(0.2)
    assert strip(running).isVisible()
    driver.click("run_close")
    assert not strip(running).isVisible()


def test_an_end_by_a_lost_connection_is_told_where_it_is_seen(running):
    driver = running.driver
    driver.unplug(can.CanOperationError("gone", error_code=errno.ENODEV))
    driver.run(1.0)
    assert driver.read("run_text") == "ended early · point 1 of 2"
    assert "The CAN device is gone" in driver.read("recovery_text"), "the reason stands beside it"
    assert driver.read("editor_message").startswith("Ended at row 1. The CAN device is gone.")


def test_it_stands_in_the_place_of_a_step_that_says_no_more(running):
    line = running.driver.find("recovery_line")
    assert not line.isVisible()
    running.driver.click("run_pause")
    running.driver.run(0.3)
    assert running.driver.read("run_text").endswith("paused: hold “Continue” for 1 s")
    assert not line.isVisible()
    running.driver.click("run_stop")
    running.driver.run_until(lambda: not running.driver.controller.player.running)
    running.driver.click("run_close")
    assert line.isVisible()
    assert running.driver.read("recovery_text") == "Ready"


@pytest.mark.styled
@pytest.mark.parametrize("width", [1280, 1024])
def test_an_obstacle_stands_beside_it_and_its_end_is_told_as_long(running, width):
    running.driver.window.resize(width, 800)
    running.driver.click("stop_button")
    running.driver.run_until(lambda: not running.driver.controller.player.running)
    running.driver.run(1.0)
    button = running.driver.find("recovery_hold_button")
    assert button.isVisible()
    assert running.driver.read("run_text") == "ended by the emergency stop"
    parts = [running.driver.find(name) for name in ("recovery_text", "run_name", "run_text")]
    assert all(each.isVisible() and each.width() > 100 for each in parts)
    assert not rect_in_window(button).intersects(rect_in_window(strip(running)))
    place = rect_in_window(button)
    running.driver.click("run_close")
    running.driver.run(0.1)
    assert rect_in_window(button) == place, "the words of the run gave way"
    strip(running).show()
    running.driver.click(running.driver.find("recovery_text"))
    assert strip(running).isVisible()
    running.driver.hold_button(button)
    running.driver.run(1.0)
    running.driver.click("recovery_button")
    running.driver.run(2.0)
    assert running.driver.find("run_close").isVisible()
    assert not running.driver.find("recovery_line").isVisible()


def test_beside_an_obstacle_it_goes_after_a_while_when_nothing_slides_under_the_pointer(running):
    running.driver.controller.player.stop()
    running.driver.run_until(lambda: not running.driver.controller.player.running)
    running.driver.controller.step_changed.emit(
        Step(StepKind.UNDERVOLTAGE, Level.WARNING, {"joints": "2"})
    )
    line = strip(running)
    assert line.isVisible()
    row = line.parentWidget()
    for under, seen in ((True, True), (False, False)):
        row.setAttribute(Qt.WidgetAttribute.WA_UnderMouse, under)
        line._ends.timeout.emit()
        assert line.isVisible() == seen


def test_the_buttons_of_the_run_keep_their_places_beside_an_obstacle(running):
    before = rect_in_window(running.driver.find("run_stop"))
    show = running.driver.controller.step_changed.emit
    show(Step(StepKind.UNDERVOLTAGE, Level.WARNING, {"joints": "2"}))
    running.driver.window.layout().activate()
    assert running.driver.find("recovery_line").isVisible()
    assert running.driver.find("run_stop").isVisible()
    assert rect_in_window(running.driver.find("run_stop")) == before


def test_nothing_is_sent_from_an_empty_library(app_driver):
    app_driver.ready()
    app_driver.window.open_library_window()
    send = app_driver.find("run_send")
    assert not send.isEnabled()
    assert "row" in send.toolTip()
