"""The library and its editor beside the picture: there, back, and what is not saved."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDialog, QWidget

from armui.control.operating_state import StopState
from armui.ui.dialogs.confirm_dialog import LeaveQuestion
from armui.ui.shell.operation_area import OperationArea
from armui.ui.trajectory.editor.editor_page import EditorPage
from armui.ui.trajectory.library.library_page import LibraryPage
from tests.operator.library.actions import CTRL
from tests.operator.workspace.actions import rect_in_window

pytestmark = pytest.mark.styled

ALWAYS = ("stop_button", "halt_button", "recovery_text", "status_bar", "menu_motion")


@pytest.mark.parametrize("size", [(1280, 800), (1440, 900)])
def test_a_page_stands_beside_the_picture_and_takes_three_fifths(pages, size):
    pages.driver.window.resize(*size)
    page = pages.open_library()
    assert not [each for each in QApplication.topLevelWidgets() if isinstance(each, QDialog)]
    page_rect, view_rect = rect_in_window(page), rect_in_window(pages.view)
    assert not page_rect.intersects(view_rect)
    area = rect_in_window(pages.driver.find("page_area"))
    share = area.width() / (area.width() + view_rect.width())
    assert share == pytest.approx(0.6, abs=0.01)
    assert pages.driver.window.size().toTuple() == size  # nothing has pushed it wider
    for name in ALWAYS:
        assert pages.driver.find(name).isVisible()


def test_the_panel_comes_back_as_wide_as_it_was(pages):
    panels = pages.driver.window.findChild(OperationArea, "operation_area")
    width = panels.width()
    page = pages.open_library()
    assert not panels.isVisible()
    pages.driver.click("page_back")
    assert not page.isVisible()
    assert panels.isVisible()
    assert panels.width() == width
    assert pages.driver.find("menu_motion").isChecked()


def test_a_double_click_opens_the_points_and_the_line_above_says_where_one_is(pages):
    page = pages.open_library()
    assert pages.path() == "Trajectory library"
    editor = pages.open_editor("two")
    assert editor.document.name == "two"
    assert not page.isVisible()
    assert pages.path() == "Trajectory library › two"
    pages.change(editor)
    assert pages.path() == "Trajectory library › two *"


@pytest.mark.parametrize("way", ["back", "crumb", "escape"])
def test_back_leads_to_the_library(pages, way):
    editor = pages.open_editor()
    if way == "back":
        pages.driver.click("page_back")
    elif way == "crumb":
        pages.crumb()
    else:
        pages.escape(editor)
    assert pages.driver.page(LibraryPage).isVisible()
    assert pages.path() == "Trajectory library"


def test_back_asks_what_shall_become_of_what_is_not_saved(pages):
    editor = pages.open_editor()
    pages.change(editor)
    pages.crumb()
    question = pages.driver.dialog(LeaveQuestion)
    pages.driver.click(question.cancel_button)
    assert pages.driver.page(EditorPage) is editor
    pages.driver.click("page_back")
    pages.driver.click(pages.driver.dialog(LeaveQuestion).save_button)
    assert pages.driver.page(LibraryPage).isVisible()
    assert pages.path() == "Trajectory library"


def test_a_panel_in_between_loses_nothing_and_asks_nothing(pages):
    editor = pages.open_editor()
    pages.change(editor)
    pages.driver.click("menu_gripper")
    assert not editor.isVisible()
    assert pages.driver.find("menu_gripper").isChecked()
    assert not pages.driver.find("library_button").isChecked()
    pages.driver.click("library_button")  # back to where one was
    assert pages.driver.page(EditorPage) is editor
    assert not editor.document.saved
    assert pages.driver.find("library_button").isChecked()
    assert not pages.driver.find("menu_gripper").isChecked()


def test_from_an_editor_the_button_leads_to_the_library_and_the_editor_stays_open(pages):
    editor = pages.open_editor()
    pages.change(editor)
    pages.driver.click("library_button")
    assert pages.path() == "Trajectory library"
    again = pages.open_editor("one")
    assert again is editor
    assert not editor.document.saved


def test_two_editors_lie_over_each_other(pages):
    one = pages.open_editor("one")
    two = pages.open_editor("two")
    pages.driver.click("page_back")
    assert pages.driver.page(LibraryPage).isVisible()
    assert pages.open_editor("one") is one
    assert one is not two


def test_the_same_keys_count_in_the_page_that_is_seen_alone(pages):
    library = pages.open_library()
    editor = pages.open_editor()
    QTest.keyClick(editor.table, Qt.Key.Key_F, CTRL)
    assert editor.findChild(QWidget, "find_text").isVisible()
    assert not library.findChild(QWidget, "library_search").hasFocus()


def test_what_is_not_seen_does_no_work(pages):
    library = pages.open_library()
    seen = []
    library._model.modelReset.connect(lambda: seen.append("listed"))
    pages.driver.click("menu_motion")
    pages.driver.window.activateWindow()
    library._watch.changed.emit()
    assert seen == []


def test_a_stop_is_in_reach_of_every_page(pages):
    pages.driver.ready()
    pages.open_editor()
    pages.driver.click("stop_button")
    pages.driver.run_until(
        lambda: pages.driver.controller.operating_state.stop is StopState.STOPPED
    )
