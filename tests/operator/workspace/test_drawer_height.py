"""The drawer has its height in every panel, whichever was seen before."""

import pytest
from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractItemView, QListWidget, QWidget

from armui.ui.shell.drawer import DRAWER_PX
from armui.ui.trajectory.editor import findings_pane
from armui.ui.watch.bus.bus_page import BusPage
from tests.app_driver import PANELS
from tests.gallery_scenes import trajectories
from tests.operator.editor.actions import BACK, OUT, UP, Editor, to
from tests.operator.library.actions import LibraryDriver
from tests.operator.workspace.actions import rect_in_window

pytestmark = pytest.mark.styled


def test_no_panel_takes_the_room_of_the_drawer_in_itself_or_in_another(pages):
    pages.driver.window.resize(1440, 900)
    pages.driver.click("events_button")
    for panel in (*PANELS, *PANELS):
        pages.driver.click(f"menu_{panel}")
        pages.driver.wait(lambda: True)
        assert pages.driver.find("drawer").height() == DRAWER_PX, panel


def test_a_window_may_be_low_after_every_panel_was_seen(pages):
    for panel in PANELS:
        pages.driver.click(f"menu_{panel}")
    pages.driver.window.resize(1024, 640)
    assert pages.driver.window.height() == 640
    assert pages.driver.find("status_bar").geometry().bottom() < 640


def is_in_sight(driver, name):
    """Whether a press in the middle of a widget reaches it."""
    driver.run(0.1)
    widget = next(each for each in driver.window.findChildren(QWidget, name) if each.isVisible())
    middle = widget.mapTo(driver.window, widget.rect().center())
    inside = driver.window.rect().contains(middle)
    return inside and driver.window.childAt(middle) is widget


@pytest.mark.parametrize("size", [(1280, 800), (1024, 720)])
def test_send_is_in_sight_whatever_is_open_above_and_below_it(pages, size):
    pages.driver.ready()
    pages.driver.window.resize(*size)
    pages.driver.click("events_button")
    library = pages.open_library()
    assert is_in_sight(pages.driver, "run_send")
    pages.driver.click(library.findChild(QWidget, "library_create"))
    assert is_in_sight(pages.driver, "run_send")
    assert is_in_sight(pages.driver, "library_name")
    QTest.keyClick(library.findChild(QWidget, "library_name"), Qt.Key.Key_Escape)
    editor = pages.open_editor()
    assert is_in_sight(pages.driver, "run_send")
    editor._actions["jog"].trigger()
    editor._find_bar.open()
    assert is_in_sight(pages.driver, "run_send")


@pytest.mark.parametrize("row", [0, 1])
def test_the_chosen_row_of_the_library_is_in_sight_above_the_drawer(pages, row):
    pages.driver.ready()
    pages.driver.window.resize(1280, 800)
    table = pages.open_library()._table
    table.selectRow(row)
    pages.driver.click("events_button")
    pages.driver.run(0.2)
    middle = table.visualRect(table.model().index(row, 0)).center()
    in_window = table.viewport().mapTo(pages.driver.window, middle)
    assert pages.driver.window.childAt(in_window) is table.viewport()


@pytest.mark.parametrize("where", ["library", "editor"])
def test_the_question_of_a_check_is_in_sight_too(pages, where):
    pages.driver.ready()
    pages.driver.window.resize(1280, 800)
    pages.driver.click("events_button")
    page = pages.open_editor() if where == "editor" else pages.open_library()
    if where == "library":
        page._table.selectRow(0)
    pages.driver.click(page.findChild(QWidget, "run_send"))
    assert is_in_sight(pages.driver, "accept_warnings")
    assert is_in_sight(pages.driver, "run_send")


def test_each_finding_that_is_agreed_to_is_in_sight_in_the_smallest_window(app_driver, monkeypatch):
    monkeypatch.setattr(findings_pane, "_COMES_S", 60.0)  # on a busy computer it comes slowly
    app_driver.window.resize(1024, 720)
    app_driver.run(0.2)
    library = trajectories.sunk(app_driver)
    found = library.findChild(QListWidget, "findings_list")
    app_driver.wait(lambda: is_in_sight(app_driver, "accept_warnings"))
    assert found.count() == 2
    assert "below the floor" in found.item(0).text()
    whole = QRect(found.viewport().rect())
    assert found.viewport().visibleRegion().boundingRect() == whole
    assert all(whole.contains(found.visualItemRect(found.item(row))) for row in range(2))
    assert library.findChild(QWidget, "accept_warnings").property("primary")


def test_the_accepting_button_leads_at_the_end_of_findings_that_need_scrolling(app_driver):
    trajectories.sunk(app_driver)
    found, accept = app_driver.find("findings_list"), app_driver.find("accept_warnings")
    found.setFixedHeight(60)
    app_driver.wait(lambda: found.verticalScrollBar().maximum() > 0)
    assert not accept.property("primary")
    assert accept.isEnabled()
    found.scrollToBottom()
    assert accept.property("primary")


def test_what_was_found_leaves_the_page_where_the_operator_went_meanwhile(app_driver):
    """No button, held or not, goes from under the pointer because the arm has moved."""
    app_driver.ready()
    app_driver.window.resize(1024, 640)
    editor = Editor(app_driver, *[to(each, holds="a thing") for each in (OUT, BACK, UP) * 20])
    editor.click("editor_check")
    app_driver.run(0.3)
    pane, bar = editor.window._findings, editor.window._area.verticalScrollBar()
    title = pane._title.text()
    pane._shown_s = float("-inf")  # it came some time ago
    bar.setValue(0)
    app_driver.controller.motion.send_joints((10.0, 20.0, -20.0, 0.0, 0.0, 0.0))
    app_driver.run(1.0)
    assert pane._title.text() != title
    assert bar.maximum() > bar.value() == 0


def test_a_message_leaves_the_list_of_the_library_where_it_was_scrolled_to(app_driver):
    app_driver.window.resize(1280, 800)
    library = LibraryDriver(app_driver, *[f"t{number:02}" for number in range(60)])
    library.choose("t00")
    bar = library.table.verticalScrollBar()
    bar.setValue(bar.maximum())
    before = bar.value()
    library.window._show_message("Something is told.")
    app_driver.run(0.2)
    assert bar.value() >= before > 0


@pytest.mark.each_value(full="each page in both languages")
@pytest.mark.parametrize("language", ["en", "zh"])
@pytest.mark.parametrize(
    ("page", "content"),
    [("plots", "quantity_tree"), ("events", "event_table"), ("bus", "bus_tree")],
)
def test_it_has_a_low_head_and_eight_rows(pages, page, content, language):
    pages.driver.ready()
    pages.driver.store.change(language=language)
    pages.driver.window.resize(1280, 800)
    pages.driver.click(f"{page}_button")
    pages.driver.run(0.2)
    if page == "bus":
        pages.driver.page(BusPage).refresh()  # what its timer would do
    rows = pages.driver.find("drawer").findChild(QAbstractItemView, content)
    head_px = rect_in_window(rows).top() - rect_in_window(pages.driver.find("drawer")).top()
    assert head_px <= 100
    assert rows.viewport().height() >= 8 * 24
    last = rows.indexAt(QPoint(5, 8 * 24 - 1)).row()
    first = rows.indexAt(QPoint(5, 0)).row()
    assert page == "plots" or last - first >= 7


def test_the_list_of_logs_has_most_of_what_the_cards_above_it_leave(pages):
    pages.driver.ready()
    pages.driver.window.resize(1280, 800)
    pages.driver.click("sessions_button")
    pages.driver.run(0.2)
    drawer = pages.driver.find("drawer")
    rows = drawer.findChild(QAbstractItemView, "sessions_table")
    assert rows.viewport().height() >= 4.5 * 24
    record, save = (
        rect_in_window(pages.driver.find(name)).top() for name in ("session_record", "ring_save")
    )
    assert abs(record - save) <= 3
