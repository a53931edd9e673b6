"""The window 曲线 in the hands of an operator."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QContextMenuEvent, QDragEnterEvent, QDropEvent, QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMenu, QWidget

from armui.ui.watch import plot_pane
from armui.ui.watch.plots_area import PlotPage

LEFT = Qt.MouseButton.LeftButton


class Plots:
    """The page, opened by its button and taken out, its plots in sight."""

    def __init__(self, driver, monkeypatch):
        self.driver = driver
        self.monkeypatch = monkeypatch
        driver.click("plots_button")
        self.window = driver.taken_out(PlotPage)
        self.window.window().resize(1180, 840)
        self.board = self.window.board
        self.wait_built()

    def wait_built(self):
        self.driver.wait(lambda: self.board.built and self.window._known)
        QApplication.processEvents()

    def draw(self):
        """As the next pictures do."""
        self.board.draw(self.board.now_s())
        for pane in self.board.panes:
            pane.show_values(self.board.now_s())
        self.window.cursor_table.refresh()
        QApplication.processEvents()

    def find(self, kind, name):
        found = self.window.findChild(kind, name)
        assert found is not None, name
        return found

    def click(self, name):
        self.driver.click(self.find(QWidget, name))

    def choose(self, name, text):
        """An entry of a combo box, as a click on it does."""
        box = self.find(QWidget, name)
        place = box.findText(text)
        assert place >= 0, [box.itemText(each) for each in range(box.count())]
        box.setCurrentIndex(place)
        box.activated.emit(place)
        self.wait_built()

    def keys(self):
        """For each plot what is drawn."""
        return [[each.key for each in pane.quantities] for pane in self.board.panes]

    def values(self, place):
        """What the legend of a plot says, by key."""
        return {entry.key: entry.value for entry in self.board.panes[place].legend.entries}

    def table(self):
        """The rows of the cursors' table."""
        table = self.window.cursor_table.table
        return {
            table.item(row, 0).text(): [table.item(row, column).text() for column in (1, 2, 3)]
            for row in range(table.rowCount())
        }

    def place(self, plot, time_s, share=0.5):
        """A place in a plot: a time on the axis, and a share of its height from above."""
        graph = self.board.panes[plot].graphs[0]
        low, high = graph.heights
        at = graph.box.mapViewToScene(QPointF(time_s, high - share * (high - low)))
        return graph.viewport(), graph.mapFromScene(at)

    def drag_in(self, plot, start, end, button=LEFT, modifier=Qt.KeyboardModifier.NoModifier):
        """Drag with the mouse from one (time, share) to another."""
        viewport, first = self.place(plot, *start)
        _viewport, last = self.place(plot, *end)
        QTest.mousePress(viewport, button, modifier, first)
        for step in range(1, 6):
            place = first + (last - first) * step / 5
            send_move(viewport, place, button, modifier)
            # pyqtgraph takes no more moves a second than a hand makes
            QTest.qWait(15)
        QTest.mouseRelease(viewport, button, modifier, last)
        QApplication.processEvents()

    def carry(self, source, start: QPoint, target, end: QPoint):
        """Drag what lies in one widget and drop it over another.

        Without a display Qt's own drag ends at once: what it carries is dropped by hand.
        """
        carried = []

        class Drag:
            def __init__(self, widget):
                self.widget = widget

            def setMimeData(self, data):  # noqa: N802
                carried.append(data)

            def exec(self, action):
                self.action = action

        self.monkeypatch.setattr(plot_pane, "QDrag", Drag)
        QTest.mousePress(source, LEFT, pos=start)
        for step in (8, 24, 40):
            move = QPoint(step, step // 4)
            send_move(source, start + move, LEFT)
        QTest.mouseRelease(source, LEFT, pos=start)
        assert len(carried) == 1
        kind: Any
        for kind in (QDragEnterEvent, QDropEvent):
            place = end if kind is QDragEnterEvent else QPointF(end)
            event = kind(
                place, Qt.DropAction.CopyAction | Qt.DropAction.MoveAction, carried[0], LEFT,
                Qt.KeyboardModifier.NoModifier,
            )  # fmt: skip
            QApplication.sendEvent(target, event)
            assert event.isAccepted()
        self.wait_built()

    def menu_at(self, widget, place):
        """The menu that the right button opens."""
        ask_for_menu(widget, place)
        menu = QApplication.activePopupWidget()
        assert isinstance(menu, QMenu)
        return menu


def send_move(widget, place, button, modifier=Qt.KeyboardModifier.NoModifier):
    """Move the mouse with a button held."""
    on_screen = QPointF(widget.mapToGlobal(place))
    event = QMouseEvent(
        QEvent.Type.MouseMove, QPointF(place), on_screen, button, button, modifier
    )  # fmt: skip
    QApplication.sendEvent(widget, event)


def ask_for_menu(widget, place):
    """Press the right button, as the window system tells it."""
    event = QContextMenuEvent(QContextMenuEvent.Reason.Mouse, place, widget.mapToGlobal(place))
    QApplication.sendEvent(widget, event)


def trigger(menu, text):
    """Choose an entry of a menu by its words."""
    action = next(each for each in menu.actions() if each.text() == text)
    QTest.mouseClick(menu, LEFT, pos=menu.actionGeometry(action).center())
