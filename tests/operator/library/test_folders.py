"""Folders of the library by the operator's clicks."""

import pytest
from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtTest import QTest

from armui.trajectory.library.store import Library
from armui.ui.trajectory.editor.editor_page import EditorPage


def act(driver, button, text):
    menu = driver.child(button).menu()
    action = next(each for each in menu.actions() if each.text() == text)
    assert action.isEnabled()
    action.trigger()
    QCoreApplication.processEvents()


def give(driver, text):
    field = driver.child("name")
    field.selectAll()
    QTest.keyClicks(field, text)
    QTest.keyClick(field, Qt.Key.Key_Return)
    QCoreApplication.processEvents()


def make(driver, name):
    act(driver, "folder_menu", "New folder…")
    give(driver, name)


def show(driver, name):
    box = driver.child("folder")
    place = box.findText(name)
    assert place >= 0
    box.setCurrentIndex(place)
    box.activated.emit(place)


def search_for(text):
    return lambda driver: QTest.keyClicks(driver.child("search"), text)


@pytest.fixture
def cell(driver):
    """“one” and “two” lie in a folder, which is listed."""
    make(driver, "cell")
    show(driver, "All folders")
    driver.choose("one", "two")
    act(driver, "move", "cell")
    show(driver, "cell")
    return driver


def test_a_new_folder_is_listed_and_empty(driver):
    make(driver, "cell")
    assert driver.child("folder").currentText() == "cell"
    assert driver.names() == []
    assert "Nothing in this folder yet" in driver.child("hint_title").text()
    assert (driver.library.folder / "cell").is_dir()


def test_what_is_moved_is_listed_there_and_told_in_the_whole_list(cell):
    assert cell.names() == ["one", "two"]
    assert cell.message() == "Moved to the folder “cell”: one, two"
    show(cell, "All folders")
    assert cell.names() == ["one · cell", "three", "two · cell"]
    cell.undo()
    assert cell.names() == ["one", "three", "two"]


@pytest.mark.parametrize("look", [lambda cell: show(cell, "cell"), search_for("two")])
def test_what_is_no_longer_listed_is_not_chosen(cell, look):
    show(cell, "All folders")
    cell.choose("three")
    assert cell.child("delete").isEnabled()
    look(cell)
    assert not cell.child("delete").isEnabled()
    assert not cell.child("duplicate").isEnabled()


def test_a_search_goes_over_all_folders(cell):
    QTest.keyClicks(cell.child("search"), "t")
    assert cell.names() == ["three", "two · cell"]
    cell.child("search").clear()
    assert cell.names() == ["one", "two"]


def test_a_new_trajectory_is_made_in_the_folder_that_is_listed(cell):
    cell.create("new")
    editor = cell.app_driver.page(EditorPage)
    assert editor.title == "cell › new"
    editor.close()
    assert cell.names() == ["new", "one", "two"]
    assert (cell.library.folder / "cell" / "new.log").is_file()


def test_the_editor_says_where_its_trajectory_lies_and_follows_it(cell):
    cell.window.open_trajectory("one")
    editor = cell.app_driver.page(EditorPage)
    assert editor.title == "cell › one"
    cell.window.open()
    cell.choose("one")
    act(cell, "move", "Into no folder")
    assert editor.title == "one"
    assert cell.names() == ["two"]
    editor.close()


def test_a_folder_is_renamed_and_stays_listed(cell):
    act(cell, "folder_menu", "Rename the folder…")
    assert cell.child("name").text() == "cell"
    give(cell, "line")
    assert cell.child("folder").currentText() == "line"
    assert cell.names() == ["one", "two"]


def test_a_name_that_is_none_is_told_beside_the_field(cell):
    act(cell, "folder_menu", "New folder…")
    field = cell.child("name")
    assert cell.child("name_message").text() == ""
    assert "needs a name" in cell.child("name_give").toolTip()
    QTest.keyClicks(field, "a")
    for text, told in (("", "needs a name"), ("a/b", "“a_b” would do"), ("Cell", "Choose another")):
        field.selectAll()
        QTest.keyClick(field, Qt.Key.Key_Delete)
        QTest.keyClicks(field, text)
        assert told in cell.child("name_message").text()
        assert not cell.child("name_give").isEnabled()


def test_a_folder_that_holds_something_is_kept(cell):
    act(cell, "folder_menu", "Delete the folder")
    assert "is not empty and is kept: one.log, two.log" in cell.message()
    assert cell.names() == ["one", "two"]
    cell.choose("one", "two")
    cell.click("delete")
    act(cell, "folder_menu", "Delete the folder")
    assert cell.child("folder").currentText() == "All folders"
    assert cell.names() == ["three"]


def test_what_is_brought_back_is_in_its_folder_again(cell):
    cell.choose("one")
    cell.click("delete")
    cell.undo()
    assert cell.names() == ["one", "two"]


def test_without_a_choice_nothing_is_moved_and_the_reason_is_told(driver):
    button = driver.child("move")
    assert not button.isEnabled()
    assert "Choose a trajectory" in button.toolTip()
    driver.choose("one")
    assert "no folder yet" in button.toolTip()
    menu = driver.child("folder_menu").menu()
    actions = {each.text(): each for each in menu.actions()}
    assert not actions["Delete the folder"].isEnabled()
    assert not actions["Rename the folder…"].isEnabled()
    assert menu.toolTipsVisible()
    assert actions["Rename the folder…"].toolTip() == "Choose the folder in the list first"


def test_a_folder_that_somebody_renames_is_told_of(cell):
    Library(cell.library.folder).rename_folder("cell", "line")
    cell.app_driver.wait(lambda: cell.child("folder").currentText() == "All folders")
    assert "The folder “cell” is gone" in cell.message()
    assert cell.names() == ["one · line", "three", "two · line"]


def test_what_somebody_puts_into_a_folder_is_seen_by_itself(cell):
    (cell.library.folder / "cell" / "one.log").unlink()
    cell.app_driver.wait(lambda: cell.names() == ["two"])
