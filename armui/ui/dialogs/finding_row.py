"""One finding of the diagnosis: how grave, what, and the commands that mend it, to be copied."""

from __future__ import annotations

from functools import partial
from typing import Final

from PySide6.QtCore import QCoreApplication, QEvent, Qt
from PySide6.QtGui import QFontDatabase, QGuiApplication
from PySide6.QtWidgets import QHBoxLayout, QLabel, QLineEdit, QPushButton, QWidget

from armui.doctor.facts import Diagnosis, DiagnosisLevel
from armui.doctor.report import Words
from armui.ui.theme import colors_of
from armui.ui.widgets import icons
from armui.ui.widgets.buttons import push_button
from armui.ui.widgets.layouts import empty_grid, in_row

_ICON_PX: Final = 18
_GAP_PX: Final = 10

WORDS: Final = Words(QCoreApplication.translate)
"""The words of the diagnosis in the language chosen."""


class FindingRow(QWidget):
    """Shows a finding.

    Args:
        finding: What was found.
    """

    def __init__(self, finding: Diagnosis) -> None:
        super().__init__()
        self._level = finding.severity
        # the mark is for those who do not see the colour
        text, mark = WORDS.text(finding), WORDS.mark(finding.severity)
        self._icon = QLabel()
        self._icon.setFixedWidth(_ICON_PX)
        self._icon.setToolTip(mark)
        label = QLabel(text)
        label.setTextFormat(Qt.TextFormat.PlainText)
        label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        label.setWordWrap(True)
        label.setAccessibleName(f"{mark} {text}")
        grid = empty_grid(self, gaps=(_GAP_PX, 4), margins=0)
        grid.setColumnStretch(1, 1)
        grid.addWidget(self._icon, 0, 0, Qt.AlignmentFlag.AlignTop)
        grid.addWidget(label, 0, 1)
        self.copy_buttons: list[QPushButton] = []
        for row, command in enumerate(finding.commands, 1):
            grid.addLayout(self._command(command), row, 1)
        self._draw_icon()

    def _command(self, command: str) -> QHBoxLayout:
        field = QLineEdit(command)
        field.setReadOnly(True)
        field.setFont(QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont))
        field.setCursorPosition(0)
        field.setToolTip(command)
        field.setAccessibleName(command)
        button = push_button("copy_command", self.tr("Copy"), on_enter=False)
        button.clicked.connect(partial(_copy, command))
        self.copy_buttons.append(button)
        return in_row((field, 1), button, spacing=8)

    def _draw_icon(self) -> None:
        colors = colors_of(self)
        name, ink = {
            DiagnosisLevel.OK: ("done", colors.ok),
            DiagnosisLevel.NOTE: ("info", colors.accent),
            DiagnosisLevel.WARNING: ("warning", colors.warn),
            DiagnosisLevel.FAULT: ("warning", colors.stop_ink),
        }[self._level]
        self._icon.setPixmap(icons.pixmap(name, ink, _ICON_PX, self.devicePixelRatioF()))

    def changeEvent(self, event: QEvent) -> None:
        """Follow the colours."""
        if event.type() == QEvent.Type.PaletteChange:
            self._draw_icon()
        super().changeEvent(event)


def _copy(command: str) -> None:
    QGuiApplication.clipboard().setText(command)
