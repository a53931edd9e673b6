"""Another program, or another window, changes the library while it is open here."""

import shutil

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLineEdit, QWidget

from armui.trajectory.library.store import Library
from armui.trajectory.points.program import Trajectory
from armui.ui.trajectory.editor.editor_window import EditorWindow
from tests.operator_library.actions import POINT, FileStore


def other(shelf):
    """The library as another program has it open."""
    return Library(shelf.app_driver.library_folder)


def test_what_others_do_is_seen_by_itself(shelf):
    shelf.choose("two")
    other(shelf).delete(["one"])
    shelf.app_driver.wait(lambda: shelf.names() == ["three", "two"])
    other(shelf).rename("three", "drei")
    shelf.app_driver.wait(lambda: shelf.names() == ["drei", "two"])
    other(shelf).save(Trajectory("new", points=(POINT,)))
    shelf.app_driver.wait(lambda: shelf.names() == ["drei", "new", "two"])
    assert [entry.name for entry in shelf.window.chosen()] == ["two"]


def test_the_first_trajectory_of_an_empty_library_is_seen_too(app_driver):
    shelf = FileStore(app_driver)
    shelf.click("create")
    app_driver.dialog(EditorWindow).close()
    other(shelf).save(Trajectory("new", points=(POINT,)))
    app_driver.wait(lambda: shelf.names() == ["new", "Trajectory"])


def test_a_name_being_typed_is_not_disturbed(shelf):
    shelf.choose("two")
    shelf.click("rename")
    field = shelf.table.viewport().findChild(QLineEdit)
    QTest.keyClicks(field, "zw")
    other(shelf).delete(["one"])
    shelf.window._on_folder()
    assert shelf.names() == ["one", "three", "two"]
    QTest.keyClicks(field, "ei")
    QTest.keyClick(field, Qt.Key.Key_Return)
    shelf.app_driver.wait(lambda: shelf.names() == ["three", "zwei"])


def silently(shelf, change):
    """Others change the library and the system does not say so, as on network disks."""
    shelf.window._watch.blockSignals(True)
    change(other(shelf))


def test_what_is_gone_is_told_and_leaves_the_list(shelf):
    silently(shelf, lambda library: library.delete(["one", "two", "three"]))
    shelf.window.open_trajectory("one")
    assert shelf.message() == "one: It is not in the library any more."
    assert shelf.names() == []


def test_what_is_gone_is_neither_copied_nor_renamed_nor_deleted(app_driver):
    actions = {
        "duplicate": lambda shelf: shelf.click("duplicate"),
        "rename": lambda shelf: shelf.rename("neu"),
    }
    for name, act in actions.items():
        shelf = FileStore(app_driver, *([name, "stays"] if name == "duplicate" else [name]))
        shelf.window.refresh()
        shelf.choose(name)
        silently(shelf, lambda library, name=name: library.delete([name]))
        act(shelf)
        assert shelf.message() == f"{name}: It is not in the library any more."
        assert shelf.names() == ["stays"]


def test_what_is_gone_already_needs_no_deletion(shelf):
    shelf.choose("one", "two")
    silently(shelf, lambda library: library.delete(["one"]))
    shelf.click("delete")
    assert shelf.names() == ["three"]
    assert shelf.message() == "Deleted: two"
    shelf.undo()
    assert shelf.names() == ["three", "two"]


def test_a_name_another_program_has_taken_is_refused(shelf):
    shelf.choose("two")
    silently(shelf, lambda library: library.rename("one", "zwei"))
    shelf.rename("zwei")
    assert "There is a “zwei” already" in shelf.message()
    assert shelf.names() == ["three", "two", "zwei"]


def test_what_is_edited_here_and_deleted_there_is_saved_anew(shelf):
    shelf.window.open_trajectory("one")
    editor = shelf.app_driver.dialog(EditorWindow)
    other(shelf).delete(["one"])
    editor.document.set_note("mine", "note")
    shelf.app_driver.click(editor.findChild(QWidget, "editor_save"))
    assert shelf.library.load("one").note == "mine"
    assert "one" in shelf.names()
    editor.close()


def test_a_folder_that_vanishes_is_an_empty_library(shelf):
    shelf.choose("one")
    shutil.rmtree(shelf.app_driver.library_folder)
    shelf.window.refresh()
    assert shelf.names() == []
    assert shelf.child("hint_title").isVisible()
    shelf.click("create")
    shelf.app_driver.dialog(EditorWindow).close()
    assert shelf.names() == ["Trajectory"]


def test_marks_made_here_and_there_are_both_kept(shelf):
    there = other(shelf)
    there.mark("one", check="ok", length_s=1.0)
    shelf.library.entries()
    shelf.library.mark("two", check="errors", length_s=2.0)
    marks = {entry.name: entry.check for entry in other(shelf).entries()}
    assert marks == {"one": "ok", "three": None, "two": "errors"}
