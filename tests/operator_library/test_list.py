"""The list: what it tells of each trajectory, and what is done to them."""

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QWidget

from armui.ui.trajectory.editor.editor_window import EditorWindow
from tests.operator_library.actions import POINT


def test_the_list_tells_of_each(shelf):
    name, points, length, modified, check, note = shelf.rows()[1]
    assert (name, points, length, check, note) == ("three", "2", "—", "—", "")
    assert modified.startswith("20")


def test_what_needs_a_choice_says_so(shelf):
    assert not shelf.child("delete").isEnabled()
    assert "Choose a trajectory" in shelf.child("delete").toolTip()
    shelf.choose("one", "two")
    assert shelf.child("delete").isEnabled()
    assert not shelf.child("rename").isEnabled()


def test_a_new_one_is_created_and_opened(shelf):
    shelf.click("create")
    editor = shelf.app_driver.dialog(EditorWindow)
    assert editor.windowTitle() == "Trajectory"
    QTest.keyClick(editor.table, Qt.Key.Key_Return, Qt.KeyboardModifier.ControlModifier)
    shelf.app_driver.click(editor.findChild(QWidget, "editor_insert_measured"))
    assert "No arm is connected" in editor.findChild(QWidget, "editor_message").text()
    assert "Trajectory" in shelf.names()


def test_a_double_click_opens_the_second_level(shelf):
    index = shelf.table.model().index(2, 1)
    place = shelf.table.visualRect(index).center()
    QTest.mouseClick(shelf.table.viewport(), Qt.MouseButton.LeftButton, pos=place)
    QTest.mouseDClick(shelf.table.viewport(), Qt.MouseButton.LeftButton, pos=place)
    editor = shelf.app_driver.dialog(EditorWindow)
    assert editor.document.name == "two"
    assert len(editor.document.points) == 3


def test_several_are_deleted_and_brought_back(shelf):
    shelf.choose("one", "three")
    shelf.click("delete")
    assert shelf.names() == ["two"]
    assert shelf.message() == "Deleted: one, three"
    shelf.click("undo")
    assert shelf.names() == ["one", "three", "two"]
    assert shelf.library.load("three").points == (POINT, POINT)
    assert not shelf.child("undo").isVisible()


def test_one_that_is_open_is_not_deleted(shelf):
    shelf.window.open_trajectory("one")
    shelf.choose("one")
    shelf.click("delete")
    assert "one" in shelf.names()
    assert "“one” is open" in shelf.message()


def test_a_copy_gets_a_name_of_its_own(shelf):
    shelf.choose("two")
    shelf.click("duplicate")
    assert shelf.names() == ["one", "three", "two", "two 2"]
    assert shelf.library.load("two 2").points == shelf.library.load("two").points


def test_another_name_is_typed_into_the_list(shelf):
    shelf.choose("two")
    shelf.rename("zwei/2")
    assert shelf.names() == ["one", "three", "zwei/2"]
    assert len(shelf.library.load("zwei/2").points) == 3


def test_a_name_that_is_taken_is_refused(shelf):
    shelf.choose("two")
    shelf.rename("one")
    assert shelf.names() == ["one", "three", "two"]
    assert "one" in shelf.message()


def test_only_what_is_searched_for_is_listed(shelf):
    QTest.keyClicks(shelf.child("search"), "T")
    assert shelf.names() == ["three", "two"]


def test_a_damaged_file_is_listed_and_stays_as_it_is(shelf):
    path = shelf.app_driver.library_folder / "one.log"
    path.write_text("armui trajectory 1\nJ 1 2")
    shelf.window.refresh()
    assert shelf.rows()[0][4] == "✕ damaged"
    shelf.window.open_trajectory("one")
    assert "one.log, line 2" in shelf.message()
    assert path.read_text() == "armui trajectory 1\nJ 1 2"
