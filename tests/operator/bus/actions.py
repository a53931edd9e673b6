"""The window 总线 in the hands of an operator."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import QModelIndex, QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLabel, QWidget

from armui.ui.watch.bus.bus_page import BusPage
from armui.ui.watch.bus.cells import TableCell
from armui.ui.watch.bus.frame_model import FrameColumn

LEFT = Qt.MouseButton.LeftButton


class BusMonitor:
    """The page, opened by its button and taken out."""

    def __init__(self, driver):
        self.driver = driver
        driver.click("bus_button")
        self.window = driver.taken_out(BusPage)
        self.tree = self.window.tree
        self.model = self.window.model

    def find(self, name, kind=QWidget):
        found = self.window.findChild(kind, name)
        assert found is not None, name
        return found

    def run(self, seconds=0.2):
        """Let time pass, and look as the timer does."""
        self.driver.run(seconds)
        self.window.refresh()

    def click(self, name):
        self.driver.click(self.find(name))

    def unfold_filter(self):
        """Open the panel below the button; it stays open."""
        more = self.window.filter_bar.more
        more.menu().popup(more.mapToGlobal(more.rect().bottomLeft()))

    def type_into(self, name, text):
        field = self.find(name)
        field.setFocus()
        field.selectAll()
        QTest.keyClick(field, Qt.Key.Key_Delete)
        QTest.keyClicks(field, text)

    def read(self, name):
        return self.find(name, QLabel).text()

    def cell(self, index, column):
        return index.siblingAtColumn(column).data()

    def rows(self):
        """Identifier and sender of what is shown."""
        return [
            (self.cell(index, FrameColumn.ID), self.cell(index, FrameColumn.SENDER))
            for index in self.indexes()
        ]

    def ids(self):
        return [identifier for identifier, _sender in self.rows()]

    def indexes(self):
        return [self.model.index(place, 0) for place in range(self.model.rowCount())]

    def index(self, identifier, sender=None):
        found = [
            index
            for index, row in zip(self.indexes(), self.rows(), strict=True)
            if row[0] == identifier and sender in {None, row[1]}
        ]
        assert len(found) == 1, self.rows()
        return found[0]

    def details(self, index):
        """What stands below a frame: names and values."""
        return {
            self.model.index(place, FrameColumn.NAME, index).data(): self.model.index(
                place, FrameColumn.SAYS, index
            ).data()
            for place in range(self.model.rowCount(index))
        }

    def detail(self, index, name):
        place = list(self.details(index)).index(name)
        return self.model.index(place, 0, index)

    def expand(self, index: QModelIndex):
        """Click the arrow before a frame."""
        self.tree.scrollTo(index)
        box = self.tree.visualRect(index)
        arrow = QPoint(box.left() - self.tree.indentation() // 2, box.center().y())
        QTest.mouseClick(self.tree.viewport(), LEFT, pos=arrow)
        QApplication.processEvents()
        assert self.tree.isExpanded(index)

    def unlock(self):
        self.driver.hold_button(self.window.send_box.unlock)

    def write(self, identifier, data):
        self.type_into("bus_send_id", identifier)
        self.type_into("bus_send_data", data)


def painted(index: Any) -> TableCell:
    """What is painted in a cell."""
    cells: list[TableCell] = index.model().cells(index)
    return cells[index.column()]
