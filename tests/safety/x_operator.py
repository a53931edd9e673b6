"""The program on an X server, told by lines on its standard input what to open.

It is run by ``test_s01_on_an_x_server.py`` as a process of its own, because a process has one
window system. Each line names something to open; the answer is a line of JSON. The mouse and the
keys are the X server's.
"""

import json
import os
import sys
import tempfile
from pathlib import Path

from PySide6.QtCore import QPoint, QSocketNotifier, Qt, QTimer
from PySide6.QtWidgets import (
    QApplication,
    QComboBox,
    QLineEdit,
    QListWidget,
    QListWidgetItem,
    QToolTip,
    QWidget,
)

from armui.protocol.generation import Generation
from armui.ui.dialogs.files import FileDialog, choose_file
from armui.ui.dialogs.settings import SettingsDialog
from armui.ui.widgets.stop_button import StopButton
from tests.app_driver import AppDriver


class Operator:
    """Opens what it is told, and counts what reaches the controller."""

    def __init__(self, app_driver: AppDriver) -> None:
        self.app_driver = app_driver
        self.stops = self.halts = 0
        app_driver.controller.emergency_stop = self._stop
        app_driver.controller.halt_and_hold = self._halt
        self._notifier = QSocketNotifier(sys.stdin.fileno(), QSocketNotifier.Type.Read)
        self._notifier.activated.connect(self._on_line)
        self._list: QListWidget | None = None

    def _stop(self) -> None:
        self.stops += 1

    def _halt(self) -> None:
        self.halts += 1

    def _on_line(self) -> None:
        words = sys.stdin.readline().split()
        if not words:
            QApplication.exit(0)
            return
        answer = getattr(self, words[0])(*words[1:])
        print(json.dumps(answer), flush=True)

    # what can be asked

    def counts(self):
        return {"stops": self.stops, "halts": self.halts, "popup": _popup()}

    def place(self, name):
        """Where the middle of a widget of the main window is on the screen."""
        return _middle(self.app_driver.find(name))

    def dialog_stop(self):
        """Where the stop button of the dialog is that was opened last."""
        dialogs = [each for each in _dialogs() if each.findChild(StopButton) is not None]
        return _middle(dialogs[-1].findChild(StopButton))

    def combo_box(self):
        dialog = self._settings()
        return _middle(dialog.findChild(QComboBox))

    def text_field(self):
        dialog = self._settings()
        return _middle(dialog.findChild(QLineEdit))

    def tool_tip(self):
        place = self.app_driver.window.mapToGlobal(QPoint(60, 300))
        QToolTip.showText(place, "a tip", self.app_driver.window)
        return QToolTip.isVisible()

    def file_dialog(self):
        dialog = choose_file(
            self.app_driver.window,
            self.app_driver.controller,
            title="t",
            name_filter="all (*);;some (*.log)",
            on_chosen=lambda _path: None,
            start=Path.home(),
        )
        dialog.move(self.app_driver.window.mapToGlobal(QPoint(60, 160)))
        box = dialog.findChild(QComboBox, "fileTypeCombo")
        return _middle(box) if box is not None else None

    def draggable(self):
        """A list whose rows can be dragged, with the main window's stop beside it."""
        self._list = QListWidget(self.app_driver.window)
        self._list.setDragEnabled(True)
        self._list.setAcceptDrops(True)
        for number in range(5):
            QListWidgetItem(f"row {number}", self._list)
        self._list.setGeometry(80, 300, 200, 200)
        self._list.show()
        return _place(self._list, QPoint(30, 12))

    def close_all(self):
        while (popup := QApplication.activePopupWidget()) is not None:
            popup.close()
        for dialog in _dialogs():
            dialog.close()
        if self._list is not None:
            self._list.hide()
        QToolTip.hideText()
        self.stops = self.halts = 0
        return True

    def _settings(self):
        self.app_driver.window.pages.show("settings")
        dialog = self.app_driver.dialog(SettingsDialog)
        dialog.move(self.app_driver.window.mapToGlobal(QPoint(60, 220)))
        return dialog


def _dialogs():
    return [
        each
        for each in QApplication.topLevelWidgets()
        if isinstance(each, SettingsDialog | FileDialog) and each.isVisible()
    ]


def _popup():
    popup = QApplication.activePopupWidget()
    return None if popup is None else type(popup).__name__


def _middle(widget: QWidget):
    return _place(widget, widget.rect().center())


def _place(widget: QWidget, point: QPoint):
    where = widget.mapToGlobal(point)
    return [where.x(), where.y()]


def main() -> None:
    """Show the main window and obey until the input ends."""
    app = QApplication(sys.argv[:1])
    app.setAttribute(Qt.ApplicationAttribute.AA_DontShowIconsInMenus)
    with tempfile.TemporaryDirectory() as folder:
        app_driver = AppDriver(
            app, f"x-operator-{os.getpid()}", Path(folder) / "s.json", Generation.TWO
        )
        app_driver.window.move(0, 0)
        operator = Operator(app_driver)
        QTimer.singleShot(0, lambda: print(json.dumps("ready"), flush=True))
        app.exec()
        del operator
        app_driver.close()


if __name__ == "__main__":
    main()
