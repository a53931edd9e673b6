"""The window 轨迹库 in the operator's hands."""

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLineEdit, QTableView, QWidget

from armui.protocol.codes import MoveMode
from armui.trajectory.library.store import Library
from armui.trajectory.points.program import Trajectory, Waypoint
from armui.ui.dialogs.files import FileDialog
from armui.ui.trajectory.library.library_page import LibraryPage

POINT = Waypoint(MoveMode.MOVE_J, (20.0, 40.0, -40.0, 10.0, 20.0, 15.0))
CTRL = Qt.KeyboardModifier.ControlModifier


class LibraryDriver:
    """The window 轨迹库 in the operator's hands.

    Attributes:
        window: It.
    """

    def __init__(self, app_driver, *names):
        self.app_driver = app_driver
        self.library = Library(app_driver.library_folder)
        for count, name in enumerate(names, 1):
            self.library.save(Trajectory(name, points=(POINT,) * count))
        app_driver.click("library_button")
        self.window = app_driver.page(LibraryPage)
        app_driver.wait(self.window.isActiveWindow)

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
        self.app_driver.click(self.child(name))

    def create(self, name=""):
        """Create a trajectory; without a name, by the one that stands there."""
        self.click("create")
        field = self.child("name")
        QTest.keyClicks(field, name)
        QTest.keyClick(field, Qt.Key.Key_Return)
        QCoreApplication.processEvents()

    def child(self, name):
        return self.window.findChild(QWidget, f"library_{name}")

    def rename(self, text):
        self.click("rename")
        self.type_name(text)

    def type_name(self, text):
        field = self.table.viewport().findChild(QLineEdit)
        field.selectAll()
        QTest.keyClicks(field, text)
        QTest.keyClick(field, Qt.Key.Key_Return)
        QCoreApplication.processEvents()

    def key(self, key, modifier=Qt.KeyboardModifier.NoModifier):
        """Press a key where the focus is, as the window's own shortcuts want it."""
        QTest.keyClick(self.window.focusWidget(), key, modifier)

    def undo(self):
        self.key(Qt.Key.Key_Z, CTRL)

    def message(self):
        return self.child("message").text()

    def export(self, suffix):
        menu = self.child("export").menu()
        next(action for action in menu.actions() if action.data() == suffix).trigger()
        return self.app_driver.dialog(FileDialog)
