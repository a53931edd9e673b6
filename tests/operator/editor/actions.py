"""The editor of points in the operator's hands: keys, clicks, menu."""

from PySide6.QtCore import QCoreApplication, QEvent, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLineEdit, QWidget

from armui.protocol.codes import MoveMode
from armui.trajectory.library.store import Library
from armui.trajectory.points.cells import PointColumn
from armui.trajectory.points.program import Trajectory, Waypoint
from armui.ui.trajectory.editor.editor_page import EditorPage
from armui.ui.trajectory.editor.point_delegate import CellEditor
from armui.ui.trajectory.library.library_page import LibraryPage

OUT = (20.0, 40.0, -40.0, 10.0, 20.0, 15.0)
BACK = (-15.0, 30.0, -30.0, -10.0, 30.0, -20.0)
UP = (0.0, 60.0, -60.0, 0.0, 20.0, 0.0)

CTRL = Qt.KeyboardModifier.ControlModifier
ALT = Qt.KeyboardModifier.AltModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier


def to(joints_deg, **more):
    return Waypoint(MoveMode.MOVE_J, joints_deg, speed_percent=100, **more)


class Editor:
    """The editor in the operator's hands.

    Attributes:
        window: It.
    """

    def __init__(self, app_driver, *points, name="Test"):
        self.app_driver = app_driver
        self.library = Library(app_driver.library_folder)
        self.library.save(Trajectory(name, points=points))
        self.window = self.open(name)

    def open(self, name="Test"):
        self.app_driver.click("library_button")
        self.app_driver.page(LibraryPage).open_trajectory(name)
        window = self.app_driver.page(EditorPage)
        self.app_driver.wait(window.isActiveWindow)
        return window

    @property
    def points(self):
        return self.window.document.points

    @property
    def table(self):
        return self.window.table

    def child(self, name, kind=QWidget):
        return self.window.findChild(kind, name)

    def cell(self, row, column):
        return self.table.visualRect(self.table.model().index(row, column)).center()

    def text(self, row, column):
        return self.table.model().index(row, column).data()

    def choose(self, row, modifier=Qt.KeyboardModifier.NoModifier):
        viewport, place = self.table.viewport(), self.cell(row, PointColumn.SPEED)
        QTest.mouseClick(viewport, Qt.MouseButton.LeftButton, modifier, place)

    def edit(self, row, column):
        """Double click into a cell; the editor that opens."""
        viewport, place = self.table.viewport(), self.cell(row, column)
        QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)  # the one before
        QTest.mouseClick(viewport, Qt.MouseButton.LeftButton, pos=place)
        QTest.mouseDClick(viewport, Qt.MouseButton.LeftButton, pos=place)
        editors = [each for each in viewport.children() if isinstance(each, CellEditor)]
        assert len(editors) == 1, editors
        return editors[0]

    def type_into(self, row, column, text):
        field = self.edit(row, column)
        assert isinstance(field, QLineEdit)
        field.selectAll()
        QTest.keyClicks(field, text)
        self.enter(field)
        return field

    @staticmethod
    def enter(field):
        """Press Enter in a cell's editor: Qt takes it over a moment later."""
        QTest.keyClick(field, Qt.Key.Key_Return)
        QCoreApplication.processEvents()

    def keys(self, key, modifier=Qt.KeyboardModifier.NoModifier):
        QTest.keyClick(self.table, key, modifier)

    def act(self, name):
        """Choose an entry of the menu of the right button."""
        action = next(
            each for each in self.table.actions() if each.objectName() == f"action_{name}"
        )
        assert action.text()
        action.trigger()

    def click(self, name):
        self.app_driver.click(self.child(name))

    def message(self):
        return self.child("editor_message").text()


def notes(editor):
    return [point.note for point in editor.points]
