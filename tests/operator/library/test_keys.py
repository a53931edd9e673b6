"""Keys, the search, the order of the list, and what it says when it is empty."""

from dataclasses import replace

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QWidget

from armui.control.parameters.arm_model import arm_model
from armui.trajectory.library.store import Library
from armui.trajectory.points.program import Trajectory
from armui.ui.actions.keys import key_text
from armui.ui.dialogs.files import FileDialog
from armui.ui.trajectory.editor.editor_page import EditorPage
from armui.ui.trajectory.library.library_model import LibraryColumn
from armui.ui.trajectory.recording.recording_page import RecordingPage
from tests.operator.library.actions import CTRL, POINT, LibraryDriver


def test_enter_opens(driver):
    driver.choose("three")
    driver.key(Qt.Key.Key_Return)
    assert driver.app_driver.page(EditorPage).document.name == "three"


@pytest.mark.styled
@pytest.mark.parametrize(("language", "lines"), [("en", 3), ("zh", 2)])
def test_a_button_opens_too_and_takes_no_further_line_at_1280_800(app_driver, language, lines):
    app_driver.store.change(language=language)
    driver = LibraryDriver(app_driver, "one", "three")
    assert not driver.child("edit").isEnabled()
    driver.choose("one", "three")
    assert not driver.child("edit").isEnabled()
    driver.choose("three")
    assert driver.child("edit").toolTip().endswith(f"({key_text('library.edit')})")
    assert driver.window._bar.height() <= lines * 36
    driver.click("edit")
    assert driver.app_driver.page(EditorPage).document.name == "three"


def test_f2_renames_whichever_cell_was_clicked(driver):
    index = driver.table.model().index(1, LibraryColumn.MODIFIED)
    place = driver.table.visualRect(index).center()
    QTest.mouseClick(driver.table.viewport(), Qt.MouseButton.LeftButton, pos=place)
    driver.key(Qt.Key.Key_F2)
    driver.type_name("drei")
    assert driver.names() == ["drei", "one", "two"]


def test_delete_deletes_in_the_list_and_letters_in_the_search(driver):
    driver.choose("one")
    driver.key(Qt.Key.Key_F, CTRL)
    search = driver.child("search")
    assert search.hasFocus()
    QTest.keyClicks(search, "te")
    QTest.keyClick(search, Qt.Key.Key_Left)
    QTest.keyClick(search, Qt.Key.Key_Delete)
    assert driver.names() == ["three", "two"]
    QTest.keyClick(search, Qt.Key.Key_Down)
    assert driver.table.hasFocus()
    driver.key(Qt.Key.Key_Delete)
    assert driver.names() == ["two"]


def test_escape_clears_the_search_and_leaves_the_library_where_it_is(driver):
    driver.key(Qt.Key.Key_F, CTRL)
    QTest.keyClicks(driver.child("search"), "tw")
    assert driver.names() == ["two"]
    driver.key(Qt.Key.Key_Escape)
    assert driver.names() == ["one", "three", "two"]
    assert driver.window.isVisible()
    driver.key(Qt.Key.Key_Escape)
    assert driver.window.isVisible()


def test_the_other_keys(driver):
    driver.key(Qt.Key.Key_N, CTRL)
    QTest.keyClick(driver.child("name"), Qt.Key.Key_Return)
    driver.app_driver.page(EditorPage).close()
    driver.key(Qt.Key.Key_O, CTRL)
    driver.app_driver.dialog(FileDialog).close()
    driver.key(Qt.Key.Key_R, CTRL)
    driver.app_driver.page(RecordingPage).close()
    driver.choose("two")
    driver.key(Qt.Key.Key_D, CTRL)
    assert driver.names() == ["one", "three", "Trajectory", "two", "two 2"]


def test_tips_name_the_keys(driver):
    driver.choose("one")
    tips = {name: driver.child(name).toolTip() for name in ("import", "delete", "rename", "search")}
    assert tips == {
        "import": "Import files (Ctrl+O)",
        "delete": "Delete (Del)",
        "rename": "Rename (F2)",
        "search": "Search in names and notes (Ctrl+F)",
    }
    driver.choose("one", "two")
    assert driver.child("rename").toolTip() == "Choose one trajectory alone"


# The order ----------------------------------------------------------------------------------------


def sort_by(driver, column):
    header = driver.table.horizontalHeader()
    middle = header.sectionViewportPosition(column) + header.sectionSize(column) // 2
    place = header.rect().center()
    place.setX(middle)
    QTest.mouseClick(header.viewport(), Qt.MouseButton.LeftButton, pos=place)


def test_a_click_on_a_title_sorts_and_the_order_stays(driver):
    sort_by(driver, LibraryColumn.POINTS)
    assert driver.names() == ["one", "three", "two"]  # 1, 2, 3 points
    sort_by(driver, LibraryColumn.POINTS)
    assert driver.names() == ["two", "three", "one"]
    driver.choose("three")
    driver.click("duplicate")
    assert driver.names() == ["two", "three 2", "three", "one"]
    driver.window.close()
    driver.app_driver.click("library_button")
    assert driver.names() == ["two", "three 2", "three", "one"]


def test_the_choice_stays_when_the_order_changes(driver):
    driver.choose("three")
    sort_by(driver, LibraryColumn.NAME)
    assert driver.names() == ["two", "three", "one"]
    assert [entry.name for entry in driver.window.chosen()] == ["three"]


def test_every_column_can_be_sorted_by(app_driver):
    library = Library(app_driver.library_folder)
    for count, (name, note) in enumerate((("run 10", "b"), ("Run 9", "a"), ("run 2", ""))):
        library.save(Trajectory(name, note, (replace(POINT, dwell_s=2.0 - count),) * count))
    arm = arm_model(app_driver.controller).fingerprint
    library.mark("run 2", check="errors", arm=arm)
    library.mark("Run 9", check="ok", arm=arm)
    driver = LibraryDriver(app_driver)
    assert driver.names() == ["run 2", "Run 9", "run 10"]
    app_driver.wait(lambda: {row[2] for row in driver.rows()} == {"—", "≈ 0.0 s", "≈ 1.0 s"})
    expected = {
        LibraryColumn.POINTS: ["run 10", "Run 9", "run 2"],
        LibraryColumn.LENGTH: ["run 10", "run 2", "Run 9"],
        LibraryColumn.MODIFIED: ["run 10", "Run 9", "run 2"],
        LibraryColumn.CHECK: ["run 2", "run 10", "Run 9"],
        LibraryColumn.NOTE: ["run 2", "Run 9", "run 10"],
    }
    for column, names in expected.items():
        sort_by(driver, column)
        assert driver.names() == names, column


# Nothing to list ----------------------------------------------------------------------------------


def hint(driver):
    title = driver.child("hint_title")
    return (title.text(), driver.child("hint").text()) if title.isVisible() else None


def test_an_empty_library_says_what_to_do(app_driver):
    driver = LibraryDriver(app_driver)
    title, text = hint(driver)
    assert title == "No trajectories yet"
    for word in ("Create", "record", "import", "dropped"):
        assert word in text
    assert not driver.child("clear_search").isVisible()
    driver.create()
    assert hint(driver) is None


def test_a_search_that_finds_nothing_says_so_and_is_cleared_by_a_click(driver):
    assert hint(driver) is None
    QTest.keyClicks(driver.child("search"), "x(")
    assert hint(driver)[0] == "Nothing found for “x(”"
    driver.app_driver.click(driver.window.findChild(QWidget, "library_clear_search"))
    assert driver.child("search").text() == ""
    assert hint(driver) is None
    assert driver.names() == ["one", "three", "two"]


def test_what_is_new_is_seen_although_something_else_was_searched_for(driver):
    QTest.keyClicks(driver.child("search"), "one")
    driver.create()
    assert driver.child("search").text() == ""
    assert [entry.name for entry in driver.window.chosen()] == ["Trajectory"]
