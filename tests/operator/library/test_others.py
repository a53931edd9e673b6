"""Another program, or another window, changes the library while it is open here."""

import shutil

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLineEdit, QWidget

from armui.trajectory.library.store import Library
from armui.trajectory.points.program import Trajectory
from armui.ui.trajectory.editor.editor_page import EditorPage
from tests.operator.library.actions import POINT, LibraryDriver


def other(driver):
    """The library as another program has it open."""
    return Library(driver.app_driver.library_folder)


def test_what_others_do_is_seen_by_itself(driver):
    driver.choose("two")
    other(driver).delete(["one"])
    driver.app_driver.wait(lambda: driver.names() == ["three", "two"])
    other(driver).rename("three", "drei")
    driver.app_driver.wait(lambda: driver.names() == ["drei", "two"])
    other(driver).save(Trajectory("new", points=(POINT,)))
    driver.app_driver.wait(lambda: driver.names() == ["drei", "new", "two"])
    assert [entry.name for entry in driver.window.chosen()] == ["two"]


def test_the_first_trajectory_of_an_empty_library_is_seen_too(app_driver):
    driver = LibraryDriver(app_driver)
    driver.create()
    app_driver.page(EditorPage).close()
    other(driver).save(Trajectory("new", points=(POINT,)))
    app_driver.wait(lambda: driver.names() == ["new", "Trajectory"])


def test_a_name_being_typed_is_not_disturbed(driver):
    driver.choose("two")
    driver.click("rename")
    field = driver.table.viewport().findChild(QLineEdit)
    QTest.keyClicks(field, "zw")
    other(driver).delete(["one"])
    driver.window._on_folder()
    assert driver.names() == ["one", "three", "two"]
    QTest.keyClicks(field, "ei")
    QTest.keyClick(field, Qt.Key.Key_Return)
    driver.app_driver.wait(lambda: driver.names() == ["three", "zwei"])


def silently(driver, change):
    """Others change the library and the system does not say so, as on network disks."""
    driver.window._watch.blockSignals(True)
    change(other(driver))


def test_what_is_gone_is_told_and_leaves_the_list(driver):
    silently(driver, lambda library: library.delete(["one", "two", "three"]))
    driver.window.open_trajectory("one")
    assert driver.message() == "one: It is not in the library any more."
    assert driver.names() == []


def test_what_is_gone_is_neither_copied_nor_renamed_nor_deleted(app_driver):
    actions = {
        "duplicate": lambda driver: driver.click("duplicate"),
        "rename": lambda driver: driver.rename("neu"),
    }
    for name, act in actions.items():
        driver = LibraryDriver(app_driver, *([name, "stays"] if name == "duplicate" else [name]))
        driver.window.refresh()
        driver.choose(name)
        silently(driver, lambda library, name=name: library.delete([name]))
        act(driver)
        assert driver.message() == f"{name}: It is not in the library any more."
        assert driver.names() == ["stays"]


def test_what_is_gone_already_needs_no_deletion(driver):
    driver.choose("one", "two")
    silently(driver, lambda library: library.delete(["one"]))
    driver.click("delete")
    assert driver.names() == ["three"]
    assert driver.message() == "Deleted: two"
    driver.undo()
    assert driver.names() == ["three", "two"]


def test_a_name_another_program_has_taken_is_refused(driver):
    driver.choose("two")
    silently(driver, lambda library: library.rename("one", "zwei"))
    driver.rename("zwei")
    assert "There is a “zwei” already" in driver.message()
    assert driver.names() == ["three", "two", "zwei"]


def test_what_is_edited_here_and_deleted_there_is_saved_anew(driver):
    driver.window.open_trajectory("one")
    editor = driver.app_driver.page(EditorPage)
    other(driver).delete(["one"])
    editor.document.set_note("mine", "note")
    driver.app_driver.click(editor.findChild(QWidget, "editor_save"))
    assert driver.library.load("one").note == "mine"
    assert "one" in driver.names()
    editor.close()


def test_a_folder_that_vanishes_is_an_empty_library(driver):
    driver.choose("one")
    shutil.rmtree(driver.app_driver.library_folder)
    driver.window.refresh()
    assert driver.names() == []
    assert driver.child("hint_title").isVisible()
    driver.create()
    driver.app_driver.page(EditorPage).close()
    assert driver.names() == ["Trajectory"]


def test_marks_made_here_and_there_are_both_kept(driver):
    there = other(driver)
    there.mark("one", check="ok")
    driver.library.entries()
    driver.library.mark("two", check="errors")
    marks = {entry.name: entry.check for entry in other(driver).entries()}
    assert marks == {"one": "ok", "three": None, "two": "errors"}
