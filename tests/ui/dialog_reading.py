"""How the tests of dialogs and pages show one and read what it says."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLabel, QWidget
from pytestqt.qtbot import QtBot

from armui.ui.widgets.hold_button import HoldButton
from armui.ui.widgets.message_line import MessageLine


def shown(qtbot: QtBot, dialog: QWidget) -> None:
    qtbot.addWidget(dialog)
    dialog.show()
    qtbot.waitExposed(dialog)


def message(dialog: QWidget) -> str:
    line = dialog.findChild(MessageLine)
    assert line is not None
    return line.text()


def words_of(dialog: QWidget) -> str:
    return "\n".join(label.text() for label in dialog.findChildren(QLabel))


def hold(button: HoldButton) -> None:
    """Press a button that must be held, for as long as it takes: its time passes at once."""
    QTest.mousePress(button, Qt.MouseButton.LeftButton)
    button.progress.setCurrentTime(button.progress.duration())
