"""The pages in the operator's hands."""

from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QTableView, QToolButton, QWidget

from armui.trajectory.library.store import Library
from armui.trajectory.points.program import Trajectory
from armui.ui.shell.workspace import PageWindow
from armui.ui.trajectory.editor.editor_page import EditorPage
from armui.ui.trajectory.library.library_page import LibraryPage
from tests.operator.library.actions import POINT

LEFT = Qt.MouseButton.LeftButton


class Pages:
    """The main window with a library of two trajectories.

    Attributes:
        driver: The program.
    """

    def __init__(self, app_driver):
        self.driver = app_driver
        library = Library(app_driver.library_folder)
        for name in {"one", "two"} - {entry.name for entry in library.entries()}:
            library.save(Trajectory(name, points=(POINT, POINT)))

    @property
    def view(self):
        """The 3D picture's region."""
        return self.driver.find("view_region")

    def open_library(self):
        self.driver.click("library_button")
        page = self.driver.page(LibraryPage)
        page.window().activateWindow()
        self.driver.wait(page.isActiveWindow)
        return page

    def open_editor(self, name="one"):
        """A double click on its row."""
        table = self.open_library().findChild(QTableView, "library_table")
        row = table.names().index(name)
        viewport, place = table.viewport(), table.visualRect(table.model().index(row, 0)).center()
        QTest.mouseClick(viewport, LEFT, pos=place)
        QTest.mouseDClick(viewport, LEFT, pos=place)
        return self.driver.page(EditorPage)

    def path(self):
        """What the line above the page says: `Trajectory library › one`."""
        crumbs = [each.text() for each in self.visible(QToolButton, "page_crumb")]
        return " › ".join([*crumbs, self.driver.read("page_name")])

    def crumb(self):
        (crumb,) = self.visible(QToolButton, "page_crumb")
        self.driver.click(crumb)

    def visible(self, kind, name):
        found = self.driver.window.findChildren(kind, name)
        return [each for each in found if each.isVisible()]

    def take_out(self):
        self.driver.click("page_take_out")
        return self.driver.dialog(PageWindow)

    def windows(self):
        return [
            each
            for each in QApplication.topLevelWidgets()
            if isinstance(each, PageWindow) and each.isVisible()
        ]

    def change(self, editor):
        """Something in an editor that is not saved."""
        editor.document.set_note("changed", "Note")

    def escape(self, page):
        QTest.keyClick(page.focusWidget() or page, Qt.Key.Key_Escape)


def rect_in_window(widget: QWidget):
    """Where a widget stands in its window."""
    rect = widget.rect()
    rect.moveTo(widget.mapTo(widget.window(), QPoint(0, 0)))
    return rect
