"""Undoing, the last first; and what was deleted before the program was started."""

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QTableWidget, QWidget

from armui.trajectory.library.store import Library
from armui.trajectory.points.program import Trajectory
from armui.ui.trajectory.editor.editor_window import EditorWindow
from armui.ui.trajectory.library.bin_dialog import BinDialog
from tests.operator_library.actions import POINT, FileStore


def test_every_deletion_is_undone_by_keys_the_last_first(shelf):
    for name in ("one", "three"):
        shelf.choose(name)
        shelf.key(Qt.Key.Key_Delete)
    assert shelf.names() == ["two"]
    assert shelf.child("undo").text() == "Undo: bring back three"
    assert shelf.child("undo").toolTip() == "Undo: bring back three (Ctrl+Z)"
    shelf.undo()
    assert shelf.names() == ["three", "two"]
    assert shelf.message() == "Brought back: three"
    assert [entry.name for entry in shelf.window.chosen()] == ["three"]
    assert shelf.child("undo").text() == "Undo: bring back one"
    shelf.undo()
    assert shelf.names() == ["one", "three", "two"]
    assert shelf.library.load("three").points == (POINT, POINT)
    assert not shelf.child("undo").isVisible()
    shelf.undo()
    assert shelf.names() == ["one", "three", "two"]


def test_a_window_closed_and_opened_again_still_undoes(shelf):
    shelf.choose("one")
    shelf.click("delete")
    shelf.window.close()
    shelf.app_driver.click("library_button")
    assert shelf.names() == ["three", "two"]
    shelf.click("undo")
    assert shelf.names() == ["one", "three", "two"]


def test_names_and_copies_are_undone_too(shelf):
    shelf.choose("one")
    shelf.rename("uno")
    shelf.click("duplicate")
    assert shelf.names() == ["three", "two", "uno", "uno 2"]
    assert shelf.child("undo").text() == "Undo: delete uno 2"
    shelf.click("undo")
    assert shelf.names() == ["three", "two", "uno"]
    assert shelf.child("undo").text() == "Undo: call it one again"
    shelf.click("undo")
    assert shelf.names() == ["one", "three", "two"]
    assert shelf.message() == "“uno” is called “one” again."


def test_what_is_open_is_not_taken_away_by_undoing(shelf):
    shelf.click("create")
    editor = shelf.app_driver.dialog(EditorWindow)
    shelf.click("undo")
    assert "“Trajectory” is open" in shelf.message()
    assert "Trajectory" in shelf.names()
    editor.close()
    shelf.click("undo")
    assert shelf.names() == ["one", "three", "two"]


def test_what_was_worked_on_since_is_kept(shelf):
    shelf.click("create")
    editor = shelf.app_driver.dialog(EditorWindow)
    shelf.app_driver.click(editor.findChild(QWidget, "editor_insert_measured"))
    editor.document.set_note("mine", "note")
    editor.save()
    assert editor.document.saved
    editor.close()
    shelf.click("undo")
    assert "“Trajectory” has been changed since" in shelf.message()
    assert shelf.library.load("Trajectory").note == "mine"
    assert not shelf.child("undo").isVisible()


def test_in_the_search_the_key_undoes_typing(shelf):
    shelf.choose("one")
    shelf.click("delete")
    shelf.key(Qt.Key.Key_F, Qt.KeyboardModifier.ControlModifier)
    QTest.keyClicks(shelf.child("search"), "tw")
    shelf.undo()
    assert shelf.child("search").text() == ""
    assert shelf.names() == ["three", "two"]


class Bin:
    """The window of what was deleted recently."""

    def __init__(self, shelf):
        self.shelf = shelf
        shelf.click("bin")
        self.window = shelf.app_driver.dialog(BinDialog)

    @property
    def table(self):
        return self.window.findChild(QTableWidget, "bin_table")

    def names(self):
        return [self.table.item(row, 0).text() for row in range(self.table.rowCount())]

    def choose(self, row, modifier=Qt.KeyboardModifier.NoModifier):
        place = self.table.visualItemRect(self.table.item(row, 0)).center()
        QTest.mouseClick(self.table.viewport(), Qt.MouseButton.LeftButton, modifier, place)

    def back(self):
        self.shelf.app_driver.click(self.window.findChild(QWidget, "bin_back"))

    def text(self, name):
        return self.window.findChild(QWidget, f"bin_{name}").text()


def test_nothing_deleted_is_said(shelf):
    bin_ = Bin(shelf)
    assert bin_.text("text") == "Nothing has been deleted in the last 30 days."
    back = bin_.window.findChild(QWidget, "bin_back")
    assert not back.isEnabled()
    assert back.toolTip() == "Choose what to bring back"


def test_what_was_deleted_in_an_earlier_run_is_brought_back(app_driver):
    earlier = Library(app_driver.library_folder)
    shelf = FileStore(app_driver, "one", "three", "two")
    two = earlier.load("two")
    assert isinstance(two, Trajectory)
    earlier.save_draft("never saved", two)
    earlier.delete(["one", "three"])
    earlier.delete(["never saved"])
    bin_ = Bin(shelf)
    assert bin_.names() == ["never saved *", "one", "three"]
    assert "30 days" in bin_.text("text")
    bin_.choose(2)
    bin_.back()
    assert bin_.names() == ["never saved *", "one"]
    assert bin_.text("message") == "Brought back: three"
    assert shelf.names() == ["three", "two"]
    bin_.choose(0)
    bin_.choose(1, Qt.KeyboardModifier.ControlModifier)
    bin_.back()
    assert bin_.names() == []
    assert shelf.names() == ["never saved *", "one", "three", "two"]


def test_what_was_brought_back_there_is_not_undone_again(shelf):
    shelf.choose("one", "two")
    shelf.click("delete")
    bin_ = Bin(shelf)
    bin_.choose(bin_.names().index("one"))
    bin_.back()
    bin_.window.close()
    assert shelf.child("undo").text() == "Undo: bring back two"
    shelf.click("undo")
    assert shelf.names() == ["one", "three", "two"]
    assert not shelf.child("undo").isVisible()


def test_what_undoing_brings_back_leaves_the_list_of_the_deleted(shelf):
    shelf.choose("one")
    shelf.click("delete")
    bin_ = Bin(shelf)
    assert bin_.names() == ["one"]
    shelf.click("undo")
    assert bin_.names() == []
