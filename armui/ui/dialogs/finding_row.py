"""One finding of the diagnosis: severity, text, and the buttons or commands that remedy it."""

from __future__ import annotations

from functools import partial
from typing import Final, Protocol

from PySide6.QtCore import QCoreApplication, QEvent, Qt
from PySide6.QtGui import QFontDatabase, QGuiApplication
from PySide6.QtWidgets import QHBoxLayout, QLabel, QLineEdit, QPushButton, QWidget

from armui.doctor.facts import Diagnosis, DiagnosisLevel
from armui.doctor.report import Words
from armui.ui.theme import colors_of
from armui.ui.widgets import icons
from armui.ui.widgets.buttons import push_button
from armui.ui.widgets.layouts import STRETCH, empty_grid, in_row
from armui.ui.widgets.text_label import text_label
from armui.ui.words.text import Texts

_ICON_PX: Final = 18
_GAP_PX: Final = 10

WORDS: Final = Words(QCoreApplication.translate)
"""The texts of the diagnosis in the present language."""


_KBIT: Final = {"1000000": "1 Mbit/s", "500000": "500 kbit/s"}
_REMEDIES: Final = Texts("FindingRow") | {
    "up": "Switch on: {bitrate}",
    "reset": "Bring back to the bus",
    "down": "Switch off",
    "forget": "Forget…",
    "open": "Let me open it…",
    "remember": "Name and always at start: {channel}…",
}

Remedy = tuple[str, ...]
"""A verb of the adapter's helper with its arguments, as in a finding."""


class SetsUpAdapters(Protocol):
    """Carries out remedies."""

    def is_there(self) -> bool:
        """Return whether the helper of the package is installed."""

    def choose(self, remedy: Remedy) -> None:
        """Carry out the remedy of a pressed button."""


def remedy_label(remedy: Remedy) -> str:
    """Return the text of a remedy's button."""
    verb, subject, *rest = remedy
    bitrate = rest[0] if rest else ""
    text = _REMEDIES.entry("open" if verb == "remember" and not rest else verb).text()
    return text.format(bitrate=_KBIT.get(bitrate, bitrate), channel=subject)


class FindingRow(QWidget):
    """Shows a finding.

    Args:
        finding: The finding.
        adapter: Carries out its remedies; without it commands are shown for copying.
    """

    def __init__(self, finding: Diagnosis, adapter: SetsUpAdapters | None = None) -> None:
        super().__init__()
        self._level = finding.severity
        # the mark is for those who do not see the colour
        text, mark = WORDS.text(finding), WORDS.mark(finding.severity)
        self._icon = QLabel()
        self._icon.setFixedWidth(_ICON_PX)
        self._icon.setToolTip(mark)
        label = text_label(text=text, wraps=True, plain=True)
        label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        label.setAccessibleName(f"{mark} {text}")
        grid = empty_grid(self, gaps=(_GAP_PX, 4), margins=0)
        grid.setColumnStretch(1, 1)
        grid.addWidget(self._icon, 0, 0, Qt.AlignmentFlag.AlignTop)
        grid.addWidget(label, 0, 1)
        self.copy_buttons: list[QPushButton] = []
        self.remedy_buttons: list[QPushButton] = []
        if adapter is not None and finding.remedies and adapter.is_there():
            grid.addLayout(self._remedies(finding, adapter), 1, 1)
        else:
            for row, command in enumerate(finding.commands, 1):
                grid.addLayout(self._command(command), row, 1)
        self._draw_icon()

    def _remedies(self, finding: Diagnosis, adapter: SetsUpAdapters) -> QHBoxLayout:
        """Return a row with a button for each remedy; the tooltips hold the commands."""
        for remedy in finding.remedies:
            button = push_button("adapter_remedy", remedy_label(remedy), on_enter=False)
            button.setToolTip("\n".join(finding.commands))
            button.clicked.connect(partial(adapter.choose, remedy))
            self.remedy_buttons.append(button)
        return in_row(*self.remedy_buttons, STRETCH, spacing=8)

    def _command(self, command: str) -> QHBoxLayout:
        field = QLineEdit(command, readOnly=True)
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
        """Redraw the icon after a change of colours."""
        if event.type() == QEvent.Type.PaletteChange:
            self._draw_icon()
        super().changeEvent(event)


def _copy(command: str) -> None:
    QGuiApplication.clipboard().setText(command)
