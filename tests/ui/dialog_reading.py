"""How the dialogs' tests show a dialog and read what it says."""

from __future__ import annotations

from PySide6.QtWidgets import QDialog, QLabel
from pytestqt.qtbot import QtBot

from armui.ui.widgets.message_line import MessageLine


def shown(qtbot: QtBot, dialog: QDialog) -> None:
    qtbot.addWidget(dialog)
    dialog.show()
    qtbot.waitExposed(dialog)


def message(dialog: QDialog) -> str:
    line = dialog.findChild(MessageLine)
    assert line is not None
    return line.text()


def words_of(dialog: QDialog) -> str:
    return "\n".join(label.text() for label in dialog.findChildren(QLabel))
