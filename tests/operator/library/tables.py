"""Tables of an unknown dialect, and the page that imports them in the operator's hands."""

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QComboBox, QWidget

from armui.trajectory.library.store import Library
from armui.ui.dialogs.files import FileDialog
from armui.ui.trajectory.library.library_page import LibraryPage
from armui.ui.trajectory.table_import.columns_page import ColumnsPage

DEGREES = (
    "time_ms,k1_deg,k2_deg,k3_deg,k4_deg,k5_deg,k6_deg,temperature\n"
    "1000,10,20,-30,40,50,60,31\n"
    "1020,11,21,-31,41,51,61,31\n"
)
TITLED = DEGREES.replace(",k", ",joint")
RADIANS = "0.02;0.1;0.5;-0.5;0.1;0.2;0.3;0.05\n0.01;0.1;0.6;-0.5;0.1;0.2;0.3;0.05\n"
"""As the maker records, but with another delimiter."""
ANGLES = "10 40 -40 10 20 15\n20 40 -40 10 20 15\n"


class Operator:
    """At the list of the library, with files to import."""

    def __init__(self, app_driver, folder):
        self.app_driver = app_driver
        self.folder = folder
        app_driver.click("library_button")
        self.list = app_driver.page(LibraryPage)
        self.library = Library(app_driver.library_folder)

    def bring(self, **texts):
        """Import files of these names, .csv if they have no suffix, as the chooser does."""
        paths = []
        for name, text in texts.items():
            path = self.folder / (name if "." in name else f"{name}.csv")
            path.write_bytes(text if isinstance(text, bytes) else text.encode())
            paths.append(str(path))
        self.app_driver.click(self.list.findChild(QWidget, "library_import"))
        chooser = self.app_driver.dialog(FileDialog)
        chooser.filesSelected.emit(paths)
        chooser.close()

    def open(self, **texts):
        """Import files of which nothing is known: the page for the first one opens at once."""
        self.bring(**texts)
        return self.page

    @property
    def page(self):
        return self.app_driver.page(ColumnsPage)

    @property
    def enable_or_explain(self):
        return self.list.findChild(QWidget, "library_by_columns")

    def told(self):
        return self.list.findChild(QWidget, "library_message").text()

    def child(self, name):
        return self.page.findChild(QWidget, f"columns_{name}")

    def message(self):
        return self.child("message").text()

    def columns(self):
        """What the page says of each column: `J1 °`, `-` for one that is ignored."""
        found = []
        for number in range(1, len(self.page.mapping.columns) + 1):
            quantity = self.box("quantity", number).currentText()
            unit = self.box("unit", number).currentText()
            found.append("-" if quantity == "Ignored" else f"{quantity} {unit}")
        return found

    def box(self, kind, number):
        return self.page.findChild(QComboBox, f"column_{kind}_{number}")

    def choose(self, box, text):
        """Open a list, click on an entry."""
        box.showPopup()
        view = box.view()
        index = view.model().index(box.findText(text), 0)
        assert index.isValid(), text
        view.scrollTo(index)
        QTest.mouseMove(view.viewport(), view.visualRect(index).center())
        place = view.visualRect(index).center()
        QTest.mouseClick(view.viewport(), Qt.MouseButton.LeftButton, pos=place)
        self.app_driver.wait(lambda: not view.isVisible())

    def dialect_field(self, name):
        """A field that says how the table is built."""
        return self.page.findChild(QWidget, f"dialect_{name}")

    def built(self):
        """What the page says of that: encoding, delimiter, decimal sign, first line."""
        boxes = [
            self.dialect_field(name).currentText() for name in ("encoding", "delimiter", "decimal")
        ]
        return (*boxes, self.dialect_field("line").value())

    def first_line(self, line):
        field = self.dialect_field("line")
        field.setFocus()
        field.selectAll()
        QTest.keyClicks(field, str(line))
        QTest.keyClick(field, Qt.Key.Key_Return)

    def preview(self):
        """The rows that are shown."""
        model = self.page.findChild(QWidget, "columns_preview").model()
        columns = range(model.columnCount())
        return [[model.index(row, c).data() for c in columns] for row in range(model.rowCount())]

    def call(self, number, quantity):
        self.choose(self.box("quantity", number), quantity)

    def take(self):
        page = self.page
        self.app_driver.click(self.child("import"))
        self.app_driver.wait(lambda: not page.busy)


def is_open():
    return any(
        isinstance(widget, ColumnsPage) and widget.isVisible()
        for widget in QApplication.allWidgets()
    )
