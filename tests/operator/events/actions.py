"""The window 事件 in the hands of an operator."""

from __future__ import annotations

from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMenu

from armui.ui.watch.events.event_page import EventPage
from armui.ui.watch.events.event_table import EventColumn

LEFT = Qt.MouseButton.LeftButton


class Events:
    """The page, opened by its button and taken out."""

    def __init__(self, driver):
        self.driver = driver
        driver.click("events_button")
        self.window = driver.taken_out(EventPage)
        self.model, self.bar, self.table = (
            self.window.model,
            self.window.bar,
            self.window.table,
        )
        self.look()

    def look(self):
        """Let the window look at the log, as its timer does."""
        self.window.refresh()
        QApplication.processEvents()

    def read(self, column=EventColumn.TEXT):
        """What stands in a column, from top to bottom."""
        return [self.model.index(row, column).data() or "" for row in range(self.model.rowCount())]

    def row(self, text):
        """The first row with a text in it."""
        return next(row for row, each in enumerate(self.read()) if text in each)

    def cell(self, row, column):
        return self.model.index(row, column).data() or ""

    def place(self, row) -> QPoint:
        index = self.model.index(row, EventColumn.TEXT)
        self.table.scrollTo(index)
        return self.table.visualRect(index).center()

    def click(self, row, modifier=Qt.KeyboardModifier.NoModifier):
        QTest.mouseClick(self.table.viewport(), LEFT, modifier, self.place(row))

    def double_click(self, row):
        place = self.place(row)
        QTest.mouseClick(self.table.viewport(), LEFT, pos=place)
        QTest.mouseDClick(self.table.viewport(), LEFT, pos=place)

    def search(self, text):
        self.bar.search.clear()
        QTest.keyClicks(self.bar.search, text)
        self.driver.wait(lambda: not self.model.searching)

    def menu(self, row) -> QMenu:
        """The menu of a row, opened by the right button."""
        self.click(row)
        self.window.table.customContextMenuRequested.emit(self.place(row))
        popup = QApplication.activePopupWidget()
        assert isinstance(popup, QMenu)
        return popup

    def choose(self, menu, text):
        action = next(each for each in menu.actions() if each.text() == text)
        action.trigger()
        menu.close()
