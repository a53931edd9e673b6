"""A new trajectory is named in place, before there is one."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDialog

from armui.trajectory.library import store
from armui.trajectory.library.store import Library, LibraryError
from armui.trajectory.points.program import Trajectory
from armui.ui.trajectory.editor.editor_page import EditorPage
from tests.operator.library.actions import POINT


@pytest.fixture
def asked(driver):
    driver.click("create")
    return driver


def field(driver):
    return driver.child("name")


def said(driver):
    return driver.child("name_message").text()


def editors():
    return [each for each in QApplication.allWidgets() if isinstance(each, EditorPage)]


def test_a_free_name_stands_there_to_be_taken_or_typed_over(asked):
    assert field(asked).text() == field(asked).selectedText() == "Trajectory"
    assert field(asked).hasFocus()
    shown = [each for each in QApplication.topLevelWidgets() if isinstance(each, QDialog)]
    assert not any(dialog.isVisible() for dialog in shown)
    assert asked.names() == ["one", "three", "two"], "nothing is made before Enter"


def test_enter_creates_it_under_the_name_and_opens_it(driver):
    driver.click("create")
    field(driver).setText("  Pick 料 ")
    QTest.keyClick(field(driver), Qt.Key.Key_Return)
    assert driver.app_driver.page(EditorPage).title == "Pick 料"
    assert "Pick 料" in driver.names()
    assert not field(driver).isVisible()


def test_escape_leaves_nothing_behind(asked):
    QTest.keyClicks(field(asked), "Pick")
    QTest.keyClick(field(asked), Qt.Key.Key_Escape)
    assert not field(asked).isVisible()
    assert asked.window.isVisible(), "Escape leaves the page only when no name is asked for"
    assert asked.table.hasFocus()
    assert asked.names() == ["one", "three", "two"]
    assert sorted(path.stem for path in asked.library.folder.glob("*.log")) == asked.names()
    asked.click("create")
    assert field(asked).text() == "Trajectory"


@pytest.mark.parametrize(
    ("name", "why"),
    [("one", "There is a “one” already"), (" ", "name"), ("x" * 300, "300")],
)
def test_a_name_that_cannot_be_is_told_beside_the_field_while_it_is_typed(asked, name, why):
    QTest.keyClicks(field(asked), name)
    assert why in said(asked)
    assert not asked.child("name_give").isEnabled()
    QTest.keyClick(field(asked), Qt.Key.Key_Return)
    assert asked.names() == ["one", "three", "two"]
    assert field(asked).isVisible()
    assert not editors()
    field(asked).selectAll()
    QTest.keyClicks(field(asked), "four")
    assert said(asked) == ""
    asked.app_driver.click("library_name_give")
    assert "four" in asked.names()


def test_a_name_another_program_takes_meanwhile_is_refused_and_another_offered(driver):
    driver.click("create")
    other = Library(driver.library.folder)
    driver.window._watch.blockSignals(True)
    other.save(Trajectory("Trajectory", points=(POINT,)))
    QTest.keyClick(field(driver), Qt.Key.Key_Return)
    assert not editors()
    assert len(other.load("Trajectory").points) == 1
    assert field(driver).text() == field(driver).selectedText() == "Trajectory 2"
    QTest.keyClick(field(driver), Qt.Key.Key_Return)
    assert driver.app_driver.page(EditorPage).title == "Trajectory 2"


def test_what_the_disk_refuses_is_said_and_can_be_tried_again(asked, monkeypatch):
    def refuse(*_):
        raise PermissionError(13, "Permission denied")

    with monkeypatch.context() as full:
        full.setattr(store, "write_content", refuse)
        QTest.keyClick(field(asked), Qt.Key.Key_Return)
        assert "Permission denied" in said(asked)
        assert field(asked).isVisible()
        assert asked.names() == ["one", "three", "two"]
    QTest.keyClick(field(asked), Qt.Key.Key_Return)
    assert "Trajectory" in asked.names()


def test_unsaved_changes_without_a_trajectory_keep_their_name(tmp_path):
    library = Library(tmp_path)
    library.save_draft("Trajectory", Trajectory("Trajectory", points=(POINT,)))
    with pytest.raises(LibraryError, match="name_taken"):
        library.create("Trajectory")
    assert len(library.draft("Trajectory").points) == 1
