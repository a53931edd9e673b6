"""The drawer below panels and picture: folded away at first, one page at a time, taken out."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QWidget

from armui.ui.guide.guide_page import GuidePage
from armui.ui.watch.bus.bus_page import BusPage
from armui.ui.watch.events.event_page import EventPage
from armui.ui.watch.joint_status_page import JointStatusPage
from armui.ui.watch.plots_area import PlotPage
from armui.ui.watch.recordings.sessions_page import SessionsPage
from tests.operator.workspace.actions import rect_in_window

pytestmark = pytest.mark.styled

KINDS = {
    "plots": PlotPage,
    "events": EventPage,
    "bus": BusPage,
    "sessions": SessionsPage,
    "joint_status": JointStatusPage,
}


def test_it_is_folded_away_at_first(pages):
    assert not pages.driver.find("drawer").isVisible()


@pytest.mark.parametrize("key", KINDS)
def test_each_button_opens_it_at_its_page(pages, key):
    pages.driver.click(f"{key}_button")
    page = pages.driver.page(KINDS[key])
    assert page.window() is pages.driver.window
    assert pages.driver.find(f"drawer_{key}").isChecked()
    drawer, view = rect_in_window(pages.driver.find("drawer")), rect_in_window(pages.view)
    assert drawer.top() > view.bottom()
    assert pages.driver.window.size().toTuple() == (1280, 800)
    assert pages.driver.find("status_bar").isVisible()


def test_a_tab_changes_the_page_and_what_is_not_seen_does_not_listen(pages):
    pages.driver.click("bus_button")
    bus = pages.driver.page(BusPage)
    assert bus._timer.isActive()
    pages.driver.click("drawer_events")
    assert pages.driver.page(EventPage)
    assert not bus.isVisible()
    assert not bus._timer.isActive()


@pytest.mark.parametrize("way", ["button", "escape"])
def test_it_is_folded_away_and_opens_where_it_was(pages, way):
    pages.driver.click("events_button")
    page = pages.driver.page(EventPage)
    height = pages.driver.find("drawer").height()
    if way == "button":
        pages.driver.click("drawer_fold")
    else:
        QTest.keyClick(page.table, Qt.Key.Key_Escape)
    assert not pages.driver.find("drawer").isVisible()
    assert not page.isVisible()
    pages.driver.click("events_button")
    assert pages.driver.page(EventPage) is page
    assert pages.driver.find("drawer").height() == height


def test_a_page_of_it_is_taken_out_and_put_back(pages):
    pages.driver.click("bus_button")
    bus = pages.driver.taken_out(BusPage)
    window = bus.window()
    assert window is not pages.driver.window
    assert window.stop_button.isVisible()
    assert not pages.driver.find("drawer").isVisible()
    pages.driver.click("events_button")
    pages.driver.click("drawer_bus")  # raises the window, and leaves the drawer as it is
    assert pages.driver.page(EventPage).isVisible()
    assert pages.driver.find("drawer_events").isChecked()
    pages.driver.click(window.findChild(QWidget, "page_put_back"))
    assert bus.window() is pages.driver.window
    assert not pages.driver.page(BusPage).window().isHidden()
    assert pages.driver.find("drawer_bus").isChecked()


def test_page_and_drawer_stand_together(pages):
    editor = pages.open_editor()
    pages.driver.click("events_button")
    drawer = rect_in_window(pages.driver.find("drawer"))
    area = rect_in_window(pages.driver.find("page_area"))
    assert editor.isVisible()
    assert area.bottom() < drawer.top()
    assert pages.driver.window.size().toTuple() == (1280, 800)


def test_the_help_of_the_picture_opens_below_it(pages):
    pages.driver.click("help_button")
    page = pages.driver.page(GuidePage)
    pages.driver.wait(lambda: page.shown == "view")
    assert page.window() is pages.driver.window
    assert pages.driver.find("drawer_guide").isChecked()
    QTest.keyClick(page.browser, Qt.Key.Key_Escape)
    assert not page.isVisible()


@pytest.mark.each_value(full="each key in both languages")
@pytest.mark.parametrize("key", ["plots", "events", "bus", "joint_status", "sessions", "guide"])
@pytest.mark.parametrize("language", ["en", "zh"])
def test_the_drawer_of_a_small_window_scrolls_no_page_of_its_own(pages, key, language):
    """What is longer scrolls within the page: its list, its text."""
    pages.driver.store.change(language=language)
    pages.driver.click("events_button")
    pages.driver.click(f"drawer_{key}")
    area = pages.driver.find("drawer")._stack
    pages.driver.wait(lambda: area.verticalScrollBar().maximum() == 0)
    pages.driver.run(0.1)
    assert area.verticalScrollBar().maximum() == 0
    assert area.horizontalScrollBar().maximum() == 0


@pytest.mark.parametrize("language", ["en", "zh"])
def test_three_frames_are_seen_in_the_bus_monitor_at_1280_800(pages, language):
    pages.driver.connect()
    pages.driver.store.change(language=language)
    pages.driver.click("bus_button")
    tree = pages.driver.find("bus_tree")
    pages.driver.run_until(lambda: tree.model().rowCount() > 3)
    third = tree.visualRect(tree.model().index(2, 0))
    assert tree.viewport().rect().contains(third.center())


def test_undo_is_for_where_the_keys_go(pages):
    """Curves in the drawer have an undo of their own."""
    editor = pages.open_editor()
    pages.change(editor)
    pages.driver.click("plots_button")
    plots = pages.driver.page(PlotPage)
    pages.driver.wait(lambda: plots.board.built)
    editor.table.setFocus()
    QTest.keyClick(editor.table, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert editor.document.saved
