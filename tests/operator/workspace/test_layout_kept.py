"""What is kept between two runs of the program, and what a smaller screen makes of it."""

import itertools
import json

import pytest
from PySide6.QtCore import QRect, Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QSplitter, QTableView, QWidget

from armui.protocol.generation import Generation
from armui.ui.actions.operator_view import operator_view, set_operator_view
from armui.ui.shell.workspace import PageWindow
from tests.app_driver import AppDriver
from tests.operator.workspace.actions import Pages


@pytest.fixture
def started(qapp, request, tmp_path):
    """Starts the program, as often as is wanted, on the same settings; ends the one before."""
    drivers: list[AppDriver] = []
    numbers = itertools.count()

    def start():
        end()
        name = f"{request.node.nodeid} {next(numbers)}"
        drivers.append(AppDriver(qapp, name, tmp_path / "settings.json", Generation.TWO))
        return Pages(drivers[-1])

    def end():
        while drivers:
            driver = drivers.pop()
            driver.window.close()
            driver.close()

    yield start
    end()


def file_of(tmp_path):
    return tmp_path / "workspace.json"


def drag_border(pages, to_px):
    splitter = pages.driver.window.findChild(QSplitter, "splitter")
    splitter.moveSplitter(to_px, 2)


def test_widths_of_panels_and_pages_are_kept_apart(started):
    pages = started()
    drag_border(pages, 500)
    pages.open_library()
    drag_border(pages, 760)
    share = pages.driver.find("page_area").width() / pages.driver.find("splitter").width()
    pages = started()
    assert pages.driver.find("operation_area").width() == 500
    pages.open_library()
    area, splitter = pages.driver.find("page_area"), pages.driver.find("splitter")
    assert area.width() / splitter.width() == pytest.approx(share, abs=0.01)


def test_order_and_columns_of_the_list_are_kept(started):
    pages = started()
    table = pages.open_library().findChild(QTableView, "library_table")
    table.sortByColumn(0, Qt.SortOrder.DescendingOrder)
    table.setColumnWidth(0, 222)
    assert table.names() == ["two", "one"]
    pages = started()
    table = pages.open_library().findChild(QTableView, "library_table")
    assert table.columnWidth(0) == 222
    assert table.names() == ["two", "one"]


def test_columns_of_the_points_are_kept(started):
    pages = started()
    pages.open_editor().table.setColumnWidth(1, 99)
    pages = started()
    assert pages.open_editor().table.columnWidth(1) == 99


def test_what_was_taken_out_stands_where_it_stood(started):
    pages = started()
    pages.open_library()
    pages.take_out().setGeometry(40, 60, 640, 480)
    pages = started()
    pages.driver.click("library_button")
    assert pages.driver.dialog(PageWindow).geometry() == QRect(40, 60, 640, 480)


def test_windows_that_were_open_open_again_where_they_stood(started):
    pages = started()
    pages.open_editor("two")
    pages.take_out().setGeometry(30, 50, 700, 500)
    pages.driver.click("events_button")
    pages.driver.click("drawer_take_out")
    (events,) = (each for each in pages.windows() if each.objectName() == "events_window")
    events.setGeometry(5, 90, 790, 440)
    pages = started()
    assert not pages.windows(), "a start waits for no other window"
    reopen(pages)
    where = {each.windowTitle(): each.geometry() for each in pages.windows()}
    assert where == {"two": QRect(30, 50, 700, 500), "Events": QRect(5, 90, 790, 440)}
    assert not pages.driver.find("page_area").isVisible()
    assert pages.driver.find("drawer").isHidden()


@pytest.mark.parametrize("key", ["sessions", "joint_status", "guide"])
def test_so_does_every_page_of_the_drawer(started, key):
    pages = started()
    pages.driver.click("events_button")
    pages.driver.click(f"drawer_{key}")
    pages.driver.click("drawer_take_out")
    (window,) = pages.windows()
    window.setGeometry(8, 90, 780, 470)
    stood = window.geometry()
    pages = started()
    reopen(pages)
    (window,) = pages.windows()
    assert window.objectName() == f"{key}_window"
    assert window.geometry() == stood


def test_the_drawer_opens_again_at_its_page(started):
    pages = started()
    pages.driver.click("events_button")
    pages.driver.click("drawer_bus")
    pages = started()
    assert pages.driver.find("drawer").isHidden()
    reopen(pages)
    assert pages.driver.find("drawer").isVisible()
    assert pages.driver.find("drawer_bus").isChecked()
    assert not pages.windows()
    pages.driver.click("drawer_fold")
    pages = started()
    reopen(pages)
    assert pages.driver.find("drawer").isHidden()


def reopen(pages):
    """As the program does once it has loaded the rest of itself."""
    pages.driver.window.page_actions.reopen()
    pages.driver.wait(lambda: pages.driver.window.page_actions.startup_done)


def test_what_was_closed_or_put_back_does_not_open_again(started):
    pages = started()
    pages.open_editor("two")
    pages.take_out()
    (editor,) = pages.windows()
    pages.open_library()
    pages.driver.click("page_take_out")
    (library,) = (each for each in pages.windows() if each is not editor)
    editor.close()
    pages.driver.click(library.findChild(QWidget, "page_put_back"))
    pages = started()
    reopen(pages)
    assert not pages.windows()


def test_a_trajectory_that_is_gone_keeps_nothing_from_opening(started):
    pages = started()
    pages.open_editor("two")
    pages.take_out()
    pages.driver.click("events_button")
    pages.driver.click("drawer_take_out")
    for file in pages.driver.library_folder.glob("two*"):
        file.unlink()
    pages = started()
    for file in pages.driver.library_folder.glob("two*"):
        file.unlink()
    reopen(pages)
    assert [each.objectName() for each in pages.windows()] == ["events_window"]
    pages = started()
    reopen(pages)
    assert [each.objectName() for each in pages.windows()] == ["events_window"]


def test_a_program_that_ends_before_they_are_open_does_not_forget_them(started):
    pages = started()
    pages.open_library()
    pages.take_out()
    started()
    pages = started()
    reopen(pages)
    assert len(pages.windows()) == 1


def test_on_a_smaller_screen_they_open_on_it(started, tmp_path):
    far = {"taken_out": {"events": [5000, 3000, 2000, 1500]}, "open_windows": [["events", ""]]}
    file_of(tmp_path).write_text(json.dumps(far))
    pages = started()
    reopen(pages)
    (window,) = pages.windows()
    assert QGuiApplication.primaryScreen().availableGeometry().contains(window.geometry())


def test_what_was_put_back_stays_there(started):
    pages = started()
    pages.open_library()
    pages.driver.click(pages.take_out().findChild(QWidget, "page_put_back"))
    pages = started()
    page = pages.open_library()
    assert page.window() is pages.driver.window


def test_a_layout_of_a_larger_screen_is_put_right(started, tmp_path):
    far = {
        "window": [4000, -500, 3840, 2160],
        "panel_px": 3000,
        "page_share": 0.98,
        "taken_out": {"library": [5000, 3000, 2000, 1500]},
    }
    file_of(tmp_path).write_text(json.dumps(far))
    pages = started()
    screen = QGuiApplication.primaryScreen().availableGeometry()
    pages.driver.window.resize(1280, 800)  # the rig's screen is smaller than any that is sold
    view = pages.view
    assert view.width() >= 300
    pages.driver.click("library_button")
    window = pages.driver.dialog(PageWindow)
    assert screen.contains(window.geometry())
    pages.driver.click(window.findChild(QWidget, "page_put_back"))
    assert pages.view.width() >= 300


def test_the_window_itself_opens_on_a_screen_there_is(started, tmp_path):
    file_of(tmp_path).write_text(json.dumps({"window": [4000, -500, 3840, 2160]}))
    pages = started()
    screen = QGuiApplication.primaryScreen().availableGeometry()
    assert screen.contains(pages.driver.window.geometry().topLeft())


@pytest.mark.parametrize(
    "text",
    [
        *("", "{", "[]", '{"window": [1, 2], "columns": 7, "page_share": "x"}'),
        '{"open_windows": [["plots"], 7, ["nothing", "x"], [1, 2]]}',
        '{"drawer": ["bus"]}',
    ],
)
def test_no_file_keeps_the_program_from_starting(started, tmp_path, text):
    file_of(tmp_path).write_text(text)
    pages = started()
    reopen(pages)
    pages.open_editor()
    assert pages.path() == "Trajectory library › one"


@pytest.mark.parametrize(("top_px", "opens_at_px"), [(29, 29), (36, 36), (2, 36)])
def test_a_window_opens_as_high_as_it_stood_if_its_title_can_be_reached(
    started, tmp_path, top_px, opens_at_px
):
    """A frame may be narrower than the widest there is: the window must not sink at each start."""
    file_of(tmp_path).write_text(json.dumps({"window": [20, top_px, 400, 300]}))
    assert started().driver.window.geometry().y() == opens_at_px


@pytest.mark.parametrize("left", [False, True])
def test_the_operator_s_view_is_kept_until_it_is_left(started, left):
    pages = started()
    pages.driver.window._lock(wanted=True)
    if left:
        pages.driver.window._lock(wanted=False)
    started()
    try:
        assert operator_view() is not left
    finally:
        set_operator_view(wanted=False)
