"""Undoing, the last first; and what was deleted before the program was started."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QTableWidget, QWidget

from armui.trajectory.library.store import Library
from armui.trajectory.points.program import Trajectory
from armui.ui.trajectory.editor.editor_page import EditorPage
from armui.ui.trajectory.library.bin_dialog import BinDialog
from tests.operator.library.actions import POINT, LibraryDriver


def test_every_deletion_is_undone_by_keys_the_last_first(driver):
    for name in ("one", "three"):
        driver.choose(name)
        driver.key(Qt.Key.Key_Delete)
    assert driver.names() == ["two"]
    assert driver.child("undo").text() == "Undo deleting “three”"
    assert driver.child("undo").toolTip() == "Undo deleting “three” (Ctrl+Z)\nRestores it."
    driver.undo()
    assert driver.names() == ["three", "two"]
    assert driver.message() == "Restored: three"
    assert [entry.name for entry in driver.window.chosen()] == ["three"]
    assert driver.child("undo").text() == "Undo deleting “one”"
    driver.undo()
    assert driver.names() == ["one", "three", "two"]
    assert driver.library.load("three").points == (POINT, POINT)
    assert not driver.child("undo").isVisible()
    driver.undo()
    assert driver.names() == ["one", "three", "two"]


def test_a_window_closed_and_opened_again_still_undoes(driver):
    driver.choose("one")
    driver.click("delete")
    driver.window.close()
    driver.app_driver.click("library_button")
    assert driver.names() == ["three", "two"]
    driver.click("undo")
    assert driver.names() == ["one", "three", "two"]


def test_names_and_copies_are_undone_too(driver):
    driver.choose("one")
    driver.rename("uno")
    driver.click("duplicate")
    assert driver.names() == ["three", "two", "uno", "uno 2"]
    assert driver.child("undo").text() == "Undo copying to “uno 2”"
    driver.click("undo")
    assert driver.names() == ["three", "two", "uno"]
    assert driver.child("undo").text() == "Undo renaming to “uno”"
    driver.click("undo")
    assert driver.names() == ["one", "three", "two"]
    assert driver.message() == "“uno” is called “one” again."


def test_what_is_open_is_not_taken_away_by_undoing(driver):
    driver.create()
    editor = driver.app_driver.page(EditorPage)
    driver.click("undo")
    assert "“Trajectory” is open" in driver.message()
    assert "Trajectory" in driver.names()
    editor.close()
    driver.click("undo")
    assert driver.names() == ["one", "three", "two"]


def test_undoing_what_was_made_says_so_and_goes_once_it_was_worked_on(driver):
    driver.create()
    assert driver.child("undo").accessibleName() == "Undo creating “Trajectory”"
    editor = driver.app_driver.page(EditorPage)
    driver.app_driver.click(editor.findChild(QWidget, "editor_insert_measured"))
    editor.document.set_note("mine", "note")
    editor.save()
    assert editor.document.saved
    editor.close()
    assert not driver.child("undo").isVisible()
    driver.undo()
    assert driver.message() == ""
    assert driver.library.load("Trajectory").note == "mine"


def test_what_another_program_made_impossible_is_not_offered(driver):
    driver.choose("one")
    driver.rename("uno")
    driver.choose("two")
    driver.click("delete")
    other = Library(driver.library.folder)
    other.restore(other.recently_deleted()[0])
    for path in (driver.library.folder / ".deleted").rglob("*.log"):
        path.unlink()
    other.save(Trajectory("one", points=(POINT,)))
    driver.window.refresh()
    assert driver.names() == ["one", "three", "two", "uno"]
    assert not driver.child("undo").isVisible()


@pytest.mark.parametrize(
    ("how", "said"),
    [("delete", "撤销删除“one”"), ("duplicate", "撤销复制为“one 2”"), ("create", "撤销创建“轨迹”")],
)
def test_it_says_in_chinese_what_is_undone(driver, how, said):
    driver.app_driver.store.change(language="zh")
    driver.choose("one")
    driver.create() if how == "create" else driver.click(how)
    assert driver.child("undo").accessibleName() == said


def test_in_the_search_the_key_undoes_typing(driver):
    driver.choose("one")
    driver.click("delete")
    driver.key(Qt.Key.Key_F, Qt.KeyboardModifier.ControlModifier)
    QTest.keyClicks(driver.child("search"), "tw")
    driver.undo()
    assert driver.child("search").text() == ""
    assert driver.names() == ["three", "two"]


class Bin:
    """The window of what was deleted recently."""

    def __init__(self, driver):
        self.driver = driver
        driver.click("bin")
        self.window = driver.app_driver.dialog(BinDialog)

    @property
    def table(self):
        return self.window.findChild(QTableWidget, "bin_table")

    def names(self):
        return [self.table.item(row, 0).text() for row in range(self.table.rowCount())]

    def choose(self, row, modifier=Qt.KeyboardModifier.NoModifier):
        place = self.table.visualItemRect(self.table.item(row, 0)).center()
        QTest.mouseClick(self.table.viewport(), Qt.MouseButton.LeftButton, modifier, place)

    def back(self):
        self.driver.app_driver.click(self.window.findChild(QWidget, "bin_back"))

    def text(self, name):
        return self.window.findChild(QWidget, f"bin_{name}").text()


def test_nothing_deleted_is_said(driver):
    bin_ = Bin(driver)
    assert bin_.text("text") == "Nothing has been deleted in the last 30 days."
    back = bin_.window.findChild(QWidget, "bin_back")
    assert not back.isEnabled()
    assert back.toolTip() == "Choose what to restore"


def test_what_was_deleted_in_an_earlier_run_is_brought_back(app_driver):
    earlier = Library(app_driver.library_folder)
    driver = LibraryDriver(app_driver, "one", "three", "two")
    two = earlier.load("two")
    assert isinstance(two, Trajectory)
    earlier.save_draft("never saved", two)
    earlier.delete(["one", "three"])
    earlier.delete(["never saved"])
    bin_ = Bin(driver)
    assert bin_.names() == ["never saved *", "one", "three"]
    assert "30 days" in bin_.text("text")
    bin_.choose(2)
    bin_.back()
    assert bin_.names() == ["never saved *", "one"]
    assert bin_.text("message") == "Restored: three"
    assert driver.names() == ["three", "two"]
    bin_.choose(0)
    bin_.choose(1, Qt.KeyboardModifier.ControlModifier)
    bin_.back()
    assert bin_.names() == []
    assert driver.names() == ["never saved *", "one", "three", "two"]


def test_what_was_brought_back_there_is_not_undone_again(driver):
    driver.choose("one", "two")
    driver.click("delete")
    bin_ = Bin(driver)
    bin_.choose(bin_.names().index("one"))
    bin_.back()
    bin_.window.close()
    assert driver.child("undo").text() == "Undo deleting “two”"
    driver.click("undo")
    assert driver.names() == ["one", "three", "two"]
    assert not driver.child("undo").isVisible()


def test_what_undoing_brings_back_leaves_the_list_of_the_deleted(driver):
    driver.choose("one")
    driver.click("delete")
    bin_ = Bin(driver)
    assert bin_.names() == ["one"]
    driver.click("undo")
    assert bin_.names() == []


def test_what_was_done_is_told_in_the_language_that_is_chosen_afterwards(driver):
    driver.choose("one")
    driver.click("delete")
    assert driver.message() == "Deleted: one"
    driver.app_driver.store.change(language="zh")
    driver.app_driver.wait(lambda: driver.message() == "已删除：one")
