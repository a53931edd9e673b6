"""A run is told once, in the main window, whatever page or panel is seen."""

import pytest
from PySide6.QtWidgets import QWidget

from armui.ui.trajectory.editor.editor_page import EditorPage
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


@pytest.mark.parametrize("panel", ["menu_motion", "menu_gripper", "menu_teaching"])
def test_it_is_seen_from_every_panel(running, panel):
    running.driver.click(panel)
    line = rect_in_window(strip(running))
    assert strip(running).isVisible()
    assert not line.intersects(rect_in_window(running.view))
    assert not line.intersects(rect_in_window(running.driver.find("operation_area")))


def test_it_is_seen_when_the_page_is_taken_out_and_ends_the_run(running):
    window = running.take_out()
    assert window.isVisible()
    assert strip(running).window() is running.driver.window
    running.driver.click("run_stop")
    running.driver.run_until(lambda: not running.driver.controller.player.running)
    assert running.driver.read("run_text").endswith("ended")


def test_it_stays_until_the_operator_has_seen_how_it_ended(running):
    running.driver.run_until(lambda: not running.driver.controller.player.running, 60.0)
    assert running.driver.read("run_text").endswith("done")
    assert not running.driver.find("run_stop").isVisible()
    running.driver.click("run_close")
    assert not strip(running).isVisible()
    running.driver.page(EditorPage).findChild(QWidget, "run_send").click()
    running.driver.run_until(lambda: strip(running).isVisible())


def test_nothing_is_sent_from_an_empty_library(app_driver):
    app_driver.ready()
    app_driver.window.open_library_window()
    send = app_driver.find("run_send")
    assert not send.isEnabled()
    assert "row" in send.toolTip()
