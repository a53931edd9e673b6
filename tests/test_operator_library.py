"""An operator at 轨迹库: create, rename, copy, delete with undo, import and export of files."""

import pytest
from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QFileDialog, QLineEdit, QTableView, QWidget

from armui.protocol.codes import MoveMode
from armui.trajectory import files
from armui.trajectory.library import Library
from armui.trajectory.program import Trajectory, Waypoint
from armui.ui.dialogs.files import FileDialog
from armui.ui.trajectory.editor_window import EditorWindow
from armui.ui.trajectory.library_window import LibraryWindow

POINT = Waypoint(MoveMode.MOVE_J, (20.0, 40.0, -40.0, 10.0, 20.0, 15.0))


class Shelf:
    """The window 轨迹库 in the operator's hands.

    Attributes:
        window: It.
    """

    def __init__(self, desk, *names):
        self.desk = desk
        self.library = Library(desk.library_folder)
        for count, name in enumerate(names, 1):
            self.library.save(Trajectory(name, points=(POINT,) * count))
        desk.click("library_button")
        self.window = desk.dialog(LibraryWindow)
        desk.wait(self.window.isActiveWindow)

    @property
    def table(self):
        return self.window.findChild(QTableView, "library_table")

    def names(self):
        return [row[0] for row in self.rows()]

    def rows(self):
        model = self.table.model()
        return [
            [model.index(row, column).data() for column in range(model.columnCount())]
            for row in range(model.rowCount())
        ]

    def choose(self, *names):
        modifier = Qt.KeyboardModifier.NoModifier
        for name in names:
            index = self.table.model().index(self.names().index(name), 0)
            place = self.table.visualRect(index).center()
            viewport = self.table.viewport()
            QTest.mouseClick(viewport, Qt.MouseButton.LeftButton, modifier, place)
            modifier = Qt.KeyboardModifier.ControlModifier

    def click(self, name):
        self.desk.click(self.child(name))

    def child(self, name):
        return self.window.findChild(QWidget, f"library_{name}")

    def message(self):
        return self.child("message").text()

    def export(self, suffix):
        menu = self.child("export").menu()
        next(action for action in menu.actions() if action.text() == suffix).trigger()
        return self.desk.dialog(FileDialog)


@pytest.fixture
def shelf(desk):
    return Shelf(desk, "one", "three", "two")


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
    editor = shelf.desk.dialog(EditorWindow)
    assert editor.windowTitle() == "Trajectory"
    QTest.keyClick(editor.table, Qt.Key.Key_Return, Qt.KeyboardModifier.ControlModifier)
    shelf.desk.click(editor.findChild(QWidget, "editor_insert_measured"))
    assert "No arm is connected" in editor.findChild(QWidget, "editor_message").text()
    assert "Trajectory" in shelf.names()


def test_a_double_click_opens_the_second_level(shelf):
    index = shelf.table.model().index(2, 1)
    place = shelf.table.visualRect(index).center()
    QTest.mouseClick(shelf.table.viewport(), Qt.MouseButton.LeftButton, pos=place)
    QTest.mouseDClick(shelf.table.viewport(), Qt.MouseButton.LeftButton, pos=place)
    editor = shelf.desk.dialog(EditorWindow)
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


def rename(shelf, text):
    shelf.click("rename")
    field = shelf.table.viewport().findChild(QLineEdit)
    field.selectAll()
    QTest.keyClicks(field, text)
    QTest.keyClick(field, Qt.Key.Key_Return)
    QCoreApplication.processEvents()


def test_another_name_is_typed_into_the_list(shelf):
    shelf.choose("two")
    rename(shelf, "zwei/2")
    assert shelf.names() == ["one", "three", "zwei/2"]
    assert len(shelf.library.load("zwei/2").points) == 3


def test_a_name_that_is_taken_is_refused(shelf):
    shelf.choose("two")
    rename(shelf, "one")
    assert shelf.names() == ["one", "three", "two"]
    assert "one" in shelf.message()


def test_only_what_is_searched_for_is_listed(shelf):
    QTest.keyClicks(shelf.child("search"), "T")
    assert shelf.names() == ["three", "two"]


@pytest.mark.parametrize("suffix", files.SUFFIXES)
def test_one_is_exported_to_the_file_that_is_named(shelf, tmp_path, suffix):
    shelf.choose("two")
    chooser = shelf.export(suffix)
    assert chooser.acceptMode() is QFileDialog.AcceptMode.AcceptSave
    chooser.fileSelected.emit(str(tmp_path / f"x{suffix}"))
    chooser.close()
    assert files.load(tmp_path / f"x{suffix}").points == (POINT,) * 3
    assert shelf.message() == f"Exported: x{suffix}"


def test_several_are_exported_into_a_folder_and_write_over_nothing(shelf, tmp_path):
    (tmp_path / "one.csv").write_text("mine")
    shelf.choose("one", "two")
    chooser = shelf.export(".csv")
    chooser.fileSelected.emit(str(tmp_path))
    chooser.close()
    assert (tmp_path / "one.csv").read_text() == "mine"
    assert len(files.load(tmp_path / "one 2.csv").points) == 1
    assert len(files.load(tmp_path / "two.csv").points) == 3


def test_a_file_that_cannot_be_written_is_told(shelf, tmp_path):
    shelf.choose("one")
    chooser = shelf.export(".log")
    chooser.fileSelected.emit(str(tmp_path / "nowhere" / "x.log"))
    chooser.close()
    assert "x.log" in shelf.message()
    assert "Not exported" in shelf.message()


def test_several_files_are_imported_and_a_broken_one_is_told(shelf, tmp_path):
    for suffix in files.SUFFIXES:
        data = files.to_bytes(Trajectory("new", points=(POINT,)), suffix)
        (tmp_path / f"new{suffix}").write_bytes(data)
    (tmp_path / "bad.log").write_text("armui trajectory 1\nname: bad\n\nJ 1 2 3\n")
    shelf.click("import")
    chooser = shelf.desk.dialog(FileDialog)
    assert chooser.fileMode() is QFileDialog.FileMode.ExistingFiles
    chooser.filesSelected.emit([str(path) for path in sorted(tmp_path.glob("*.*"))])
    chooser.close()
    assert {"new", "new 2", "new 3"} <= set(shelf.names())
    assert "bad" not in shelf.names()
    assert "Imported: new, new 2, new 3" in shelf.message()
    assert "bad.log, line 4" in shelf.message()


def test_a_damaged_file_is_listed_and_stays_as_it_is(shelf):
    path = shelf.desk.library_folder / "one.log"
    path.write_text("armui trajectory 1\nJ 1 2")
    shelf.window.refresh()
    assert shelf.rows()[0][4] == "✕ damaged"
    shelf.window.open_trajectory("one")
    assert "one.log, line 2" in shelf.message()
    assert path.read_text() == "armui trajectory 1\nJ 1 2"
