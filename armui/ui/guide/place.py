"""Which section of the guide belongs to where the operator is."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtWidgets import QAbstractButton, QApplication, QWidget

from armui.ui.actions.places import PANELS
from armui.ui.widgets.page import Page

FIRST: Final = "start"

_WINDOWS: Final[Mapping[str, str]] = {
    "AboutArmDialog": "about_arm",
    "BackupDialog": "backup",
    "BinDialog": "library",
    "BusPage": "bus",
    "ColumnsPage": "files",
    "CommandPalette": "keys",
    "ColorDialog": "light",
    "ConnectDialog": "connect",
    "DoctorDialog": "doctor",
    "DragAssistanceDialog": "teaching",
    "EditorPage": "editor",
    "EventPage": "events",
    "ExportDialog": "export",
    "GamepadDialog": "gamepad",
    "HelpDialog": "view",
    "ImportReport": "files",
    "JointStatusDialog": "joint_status",
    "LibraryPage": "library",
    "PlotPage": "plots",
    "RecordingPage": "recording",
    "ReplayWindow": "replay",
    "SessionsWindow": "sessions",
    "SettingsDialog": "settings",
    "ShortcutList": "keys",
}
"""By the class of a window or of a page in the main window."""

_REGIONS: Final[Mapping[str, str]] = {
    "ArmView": "view",
    "Drawer": "drawer",
    "GamepadStrip": "gamepad",
    "RecoveryLine": "recovery",
    "SpeedControl": "window",
    "StatusBar": "window",
    "TopBar": "window",
}
"""By the class of a part of the main window that has the keyboard."""


def section_of(window: QWidget) -> str:
    """The section of the place that has the keyboard.

    Args:
        window: The main window.
    """
    focus = QApplication.focusWidget()
    each = focus or QApplication.activeWindow()
    while each is not None:
        name = type(each).__name__
        section = _WINDOWS.get(name) or _REGIONS.get(name)
        if section is not None:
            return section
        each = each.parentWidget()
    return _page(window) or _panel(window)


def _page(window: QWidget) -> str:
    """Of the page beside the picture, if one is shown there."""
    pages = (each for each in window.findChildren(Page) if each.isVisible())
    return next((_WINDOWS.get(type(each).__name__, "") for each in pages), "")


def _panel(window: QWidget) -> str:
    for panel in PANELS:
        entry = window.findChild(QAbstractButton, f"menu_{panel}")
        if entry is not None and entry.isChecked():
            return panel
    return FIRST


def windows_named() -> set[str]:
    """The classes of the windows and pages that have a section."""
    return set(_WINDOWS)


def sections_named() -> set[str]:
    """Every section that some place leads to."""
    return {FIRST, *PANELS, *_WINDOWS.values(), *_REGIONS.values()}
