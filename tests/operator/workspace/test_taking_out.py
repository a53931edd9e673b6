"""A page in a window of its own, and back; the stops go with it."""

import pytest
from PySide6.QtCore import QCoreApplication, QEvent, QPoint, Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractScrollArea, QWidget
from shiboken6 import isValid

from armui.control.operating_state import StopState
from armui.ui.dialogs.confirm_dialog import LeaveQuestion
from armui.ui.dialogs.settings import SettingsDialog
from armui.ui.guide.guide_page import GuidePage
from armui.ui.shell.operation_area import OperationArea
from armui.ui.trajectory.editor.editor_page import EditorPage
from armui.ui.trajectory.library.library_page import LibraryPage
from armui.ui.widgets.page import Page

pytestmark = pytest.mark.styled


def test_a_page_is_taken_out_and_the_panel_is_seen_again(pages):
    page = pages.open_library()
    window = pages.take_out()
    assert page.window() is window
    assert page.isVisible()
    assert window.windowTitle() == "Trajectory library"
    assert pages.driver.window.findChild(OperationArea, "operation_area").isVisible()
    assert not pages.driver.find("page_area").isVisible()


def test_it_opens_where_it_stood_wholly_on_the_screen_and_beside_the_picture(pages):
    pages.driver.window.resize(1280, 800)  # larger than the rig's screen
    page = pages.open_library()
    width = page.width()
    window = pages.take_out()
    screen = QGuiApplication.primaryScreen().availableGeometry()
    assert screen.contains(window.geometry())
    assert window.width() <= width + 60


def test_a_page_of_the_drawer_gets_a_window_that_shows_something(pages):
    pages.driver.click("events_button")
    pages.driver.click("drawer_take_out")
    (window,) = pages.windows()
    assert window.height() >= 400
    assert QGuiApplication.primaryScreen().availableGeometry().contains(window.geometry())


def test_it_is_put_back(pages):
    editor = pages.open_editor()
    pages.change(editor)
    window = pages.take_out()
    assert pages.driver.page(LibraryPage).window() is pages.driver.window
    pages.driver.click(window.findChild(QWidget, "page_put_back"))
    assert not pages.windows()
    assert pages.driver.page(EditorPage) is editor
    assert editor.window() is pages.driver.window
    assert pages.path() == "Trajectory library › one *"
    assert not editor.document.saved


@pytest.mark.parametrize(
    "opened", ["library", "editor", "events", "bus", "plots", "sessions", "joint_status"]
)
def test_a_page_that_was_put_back_has_nothing_that_is_deleted(pages, opened):
    """PySide takes the control with the keyboard for a child of the window that is asked."""
    if opened in {"library", "editor"}:
        page = pages.open_library() if opened == "library" else pages.open_editor()
        window = pages.take_out()
    else:
        pages.driver.click(f"{opened}_button")
        pages.driver.click("drawer_take_out")
        (window,) = pages.windows()
        page = window.findChild(Page)
    made_by_qt = [each.viewport() for each in page.findChildren(QAbstractScrollArea)]
    assert made_by_qt
    for each in page.findChildren(QWidget):
        if each.isVisible():
            each.setFocus()
            window.focusWidget()
            window.childAt(each.mapTo(window, each.rect().center()))
    pages.driver.click(window.findChild(QWidget, "page_put_back"))
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete.value)
    assert not isValid(window)
    assert all(isValid(each) for each in made_by_qt)


def test_closing_the_window_asks_as_the_way_back_does(pages):
    editor = pages.open_editor()
    pages.change(editor)
    window = pages.take_out()
    window.close()
    pages.driver.click(pages.driver.dialog(LeaveQuestion).cancel_button)
    assert window.isVisible()
    assert editor.isVisible()
    window.close()
    pages.driver.click(pages.driver.dialog(LeaveQuestion).action_button)
    assert not pages.windows()


def test_the_window_has_both_stops(pages):
    pages.driver.ready()
    pages.open_library()
    window = pages.take_out()
    assert window.halt_button.isVisible()
    pages.driver.click(window.stop_button)
    pages.driver.run_until(
        lambda: pages.driver.controller.operating_state.stop is StopState.STOPPED
    )


def test_what_was_taken_out_opens_in_a_window_the_next_time(pages):
    pages.open_editor()
    pages.take_out().close()
    editor = pages.open_editor("two")
    (window,) = pages.windows()
    assert editor.window() is window
    assert pages.driver.page(LibraryPage).window() is pages.driver.window


def test_a_library_that_was_taken_out_is_raised_by_its_button(pages):
    page = pages.open_library()
    window = pages.take_out()
    window.close()
    assert not page.isVisible()
    pages.driver.click("library_button")
    assert page.isVisible()
    assert page.window() is not pages.driver.window
    assert not pages.driver.find("library_button").isChecked()


def test_from_a_library_that_was_taken_out_an_editor_opens_beside_the_picture(pages):
    page = pages.open_library()
    pages.take_out()
    page.open_trajectory("one")
    editor = pages.driver.page(EditorPage)
    assert editor.window() is pages.driver.window
    assert pages.path() == "Trajectory library › one"


def test_escape_leaves_a_page_that_was_taken_out(pages):
    editor = pages.open_editor()
    window = pages.take_out()
    pages.driver.wait(window.isActiveWindow)
    QTest.keyClick(editor.table, Qt.Key.Key_Escape)
    assert not pages.windows()


def test_all_words_follow_the_language(pages):
    pages.open_editor()
    window = pages.take_out()
    pages.driver.store.change(language="zh")
    put_back = window.findChild(QWidget, "page_put_back")
    pages.driver.wait(lambda: put_back.text() == "放回")
    pages.driver.click("library_button")
    assert pages.path() == "轨迹库"


# The guide, asked for in a window that lies over it -----------------------------------------------


def ask_for_guide(pages, window):
    window.activateWindow()
    pages.driver.wait(window.isActiveWindow)
    QTest.keyClick(window.focusWidget() or window, Qt.Key.Key_F1)
    return pages.driver.page(GuidePage)


def test_a_dialog_over_the_drawer_gives_the_guide_a_window_this_time(pages):
    pages.driver.window.pages.show("settings")
    dialog = pages.driver.dialog(SettingsDialog)
    pages.driver.click("events_button")
    dialog.move(pages.driver.find("drawer").mapToGlobal(QPoint(20, -200)))
    guide = ask_for_guide(pages, dialog)
    (window,) = pages.windows()
    assert guide.window() is window
    assert guide.shown == "settings"
    assert window.stop_button.isVisible()
    window.move(50, 60)
    window.close()
    dialog.close()
    assert ask_for_guide(pages, pages.driver.window).window() is pages.driver.window
    assert "guide" not in pages.driver.window._keeper.layout.taken_out
    assert not pages.driver.window._keeper.layout.open_windows


def test_a_dialog_beside_the_drawer_leaves_the_guide_there(pages):
    pages.driver.window.pages.show("settings")
    dialog = pages.driver.dialog(SettingsDialog)
    dialog.resize(dialog.minimumSizeHint())
    dialog.move(pages.driver.window.mapToGlobal(QPoint(2000, 0)))
    guide = ask_for_guide(pages, dialog)
    assert guide.window() is pages.driver.window
    assert guide.shown == "settings"
    assert dialog.isActiveWindow()
    assert not pages.windows()


def test_a_guide_that_the_operator_has_taken_out_stays_in_its_window(pages):
    ask_for_guide(pages, pages.driver.window)
    pages.driver.click("drawer_take_out")
    (window,) = pages.windows()
    window.close()
    assert ask_for_guide(pages, pages.driver.window).window() is not pages.driver.window
    assert "guide" in pages.driver.window._keeper.layout.taken_out
