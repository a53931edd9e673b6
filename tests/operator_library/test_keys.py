"""Keys, the search, the order of the list, and what it says when it is empty."""

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QWidget

from armui.trajectory.library.store import Library
from armui.trajectory.points.program import Trajectory
from armui.ui.dialogs.files import FileDialog
from armui.ui.trajectory.editor.editor_window import EditorWindow
from armui.ui.trajectory.library.library_model import LibraryColumn
from armui.ui.trajectory.recording.recording_window import RecordingWindow
from tests.operator_library.actions import CTRL, POINT, FileStore


def test_enter_opens(shelf):
    shelf.choose("three")
    shelf.key(Qt.Key.Key_Return)
    assert shelf.app_driver.dialog(EditorWindow).document.name == "three"


def test_f2_renames_whichever_cell_was_clicked(shelf):
    index = shelf.table.model().index(1, LibraryColumn.MODIFIED)
    place = shelf.table.visualRect(index).center()
    QTest.mouseClick(shelf.table.viewport(), Qt.MouseButton.LeftButton, pos=place)
    shelf.key(Qt.Key.Key_F2)
    shelf.type_name("drei")
    assert shelf.names() == ["drei", "one", "two"]


def test_delete_deletes_in_the_list_and_letters_in_the_search(shelf):
    shelf.choose("one")
    shelf.key(Qt.Key.Key_F, CTRL)
    search = shelf.child("search")
    assert search.hasFocus()
    QTest.keyClicks(search, "te")
    QTest.keyClick(search, Qt.Key.Key_Left)
    QTest.keyClick(search, Qt.Key.Key_Delete)
    assert shelf.names() == ["three", "two"]
    QTest.keyClick(search, Qt.Key.Key_Down)
    assert shelf.table.hasFocus()
    shelf.key(Qt.Key.Key_Delete)
    assert shelf.names() == ["two"]


def test_escape_clears_the_search_before_it_closes_the_window(shelf):
    shelf.key(Qt.Key.Key_F, CTRL)
    QTest.keyClicks(shelf.child("search"), "tw")
    assert shelf.names() == ["two"]
    shelf.key(Qt.Key.Key_Escape)
    assert shelf.names() == ["one", "three", "two"]
    assert shelf.window.isVisible()
    shelf.key(Qt.Key.Key_Escape)
    assert not shelf.window.isVisible()


def test_the_other_keys(shelf):
    shelf.key(Qt.Key.Key_N, CTRL)
    shelf.app_driver.dialog(EditorWindow).close()
    shelf.key(Qt.Key.Key_O, CTRL)
    shelf.app_driver.dialog(FileDialog).close()
    shelf.key(Qt.Key.Key_R, CTRL)
    shelf.app_driver.dialog(RecordingWindow).close()
    shelf.choose("two")
    shelf.key(Qt.Key.Key_D, CTRL)
    assert shelf.names() == ["one", "three", "Trajectory", "two", "two 2"]


def test_tips_name_the_keys(shelf):
    shelf.choose("one")
    tips = {name: shelf.child(name).toolTip() for name in ("import", "delete", "rename", "search")}
    assert tips == {
        "import": "Import files (Ctrl+O)",
        "delete": "Delete (Del)",
        "rename": "Rename (F2)",
        "search": "Search in names and notes (Ctrl+F)",
    }
    shelf.choose("one", "two")
    assert shelf.child("rename").toolTip() == "Choose one trajectory alone"


# The order ----------------------------------------------------------------------------------------


def sort_by(shelf, column):
    header = shelf.table.horizontalHeader()
    middle = header.sectionViewportPosition(column) + header.sectionSize(column) // 2
    place = header.rect().center()
    place.setX(middle)
    QTest.mouseClick(header.viewport(), Qt.MouseButton.LeftButton, pos=place)


def test_a_click_on_a_title_sorts_and_the_order_stays(shelf):
    sort_by(shelf, LibraryColumn.POINTS)
    assert shelf.names() == ["one", "three", "two"]  # 1, 2, 3 points
    sort_by(shelf, LibraryColumn.POINTS)
    assert shelf.names() == ["two", "three", "one"]
    shelf.choose("three")
    shelf.click("duplicate")
    assert shelf.names() == ["two", "three 2", "three", "one"]
    shelf.window.close()
    shelf.app_driver.click("library_button")
    assert shelf.names() == ["two", "three 2", "three", "one"]


def test_the_choice_stays_when_the_order_changes(shelf):
    shelf.choose("three")
    sort_by(shelf, LibraryColumn.NAME)
    assert shelf.names() == ["two", "three", "one"]
    assert [entry.name for entry in shelf.window.chosen()] == ["three"]


def test_every_column_can_be_sorted_by(app_driver):
    library = Library(app_driver.library_folder)
    for count, (name, note) in enumerate((("run 10", "b"), ("Run 9", "a"), ("run 2", ""))):
        library.save(Trajectory(name, note, (POINT,) * count))
    library.mark("run 2", check="errors", length_s=3.0)
    library.mark("Run 9", check="ok", length_s=20.0)
    shelf = FileStore(app_driver)
    assert shelf.names() == ["run 2", "Run 9", "run 10"]
    expected = {
        LibraryColumn.POINTS: ["run 10", "Run 9", "run 2"],
        LibraryColumn.LENGTH: ["run 10", "run 2", "Run 9"],
        LibraryColumn.MODIFIED: ["run 10", "Run 9", "run 2"],
        LibraryColumn.CHECK: ["run 2", "run 10", "Run 9"],
        LibraryColumn.NOTE: ["run 2", "Run 9", "run 10"],
    }
    for column, names in expected.items():
        sort_by(shelf, column)
        assert shelf.names() == names, column


# Nothing to list ----------------------------------------------------------------------------------


def hint(shelf):
    title = shelf.child("hint_title")
    return (title.text(), shelf.child("hint").text()) if title.isVisible() else None


def test_an_empty_library_says_what_to_do(app_driver):
    shelf = FileStore(app_driver)
    title, text = hint(shelf)
    assert title == "No trajectories yet"
    for word in ("Create", "record", "import", "dropped"):
        assert word in text
    assert not shelf.child("clear_search").isVisible()
    shelf.click("create")
    assert hint(shelf) is None


def test_a_search_that_finds_nothing_says_so_and_is_cleared_by_a_click(shelf):
    assert hint(shelf) is None
    QTest.keyClicks(shelf.child("search"), "x(")
    assert hint(shelf)[0] == "Nothing is found for “x(”"
    shelf.app_driver.click(shelf.window.findChild(QWidget, "library_clear_search"))
    assert shelf.child("search").text() == ""
    assert hint(shelf) is None
    assert shelf.names() == ["one", "three", "two"]


def test_what_is_new_is_seen_although_something_else_was_searched_for(shelf):
    QTest.keyClicks(shelf.child("search"), "one")
    shelf.click("create")
    assert shelf.child("search").text() == ""
    assert [entry.name for entry in shelf.window.chosen()] == ["Trajectory"]
