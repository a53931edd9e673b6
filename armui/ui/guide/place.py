"""Finds the guide's section for the place where the operator is."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Final

from PySide6.QtWidgets import QApplication, QWidget

FIRST: Final = "start"

_WINDOWS: Final[Mapping[str, str]] = {
    "AboutArmDialog": "about_arm",
    "AboutDialog": "about",
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
    "FaultsDialog": "simulated",
    "GamepadDialog": "gamepad",
    "ImportReport": "files",
    "InterfaceDialog": "interface",
    "JointStatusPage": "joint_status",
    "KeepDialog": "doctor",
    "LibraryPage": "library",
    "PlotPage": "plots",
    "ProblemReportDialog": "report",
    "RecordingPage": "recording",
    "InspectionDialog": "inspection",
    "ReferenceDialog": "reference",
    "ReplayWindow": "replay",
    "SessionsPage": "sessions",
    "SettingsDialog": "settings",
    "ShortcutList": "keys",
}
"""The section by the class of a window or of a page in the main window."""

_GUIDE: Final = "GuidePage"
_REGIONS: Final[Mapping[str, str]] = {
    "ArmView": "view",
    "Drawer": "drawer",
    "GamepadStrip": "gamepad",
    "LeaseBar": "interface",
    "RecoveryLine": "recovery",
    "SpeedControl": "window",
    "StatusBar": "window",
    "TopBar": "window",
}
"""The section by the class of the part of the main window that has the focus."""


def section_of(pages: Iterable[QWidget | None], panel: str) -> str:
    """Return the section for the place that has the focus.

    Args:
        pages: The pages in the main window.
        panel: The key of the panel that is chosen there.
    """
    focus = QApplication.focusWidget()
    each = focus or QApplication.activeWindow()
    while each is not None:
        name = type(each).__name__
        if name == _GUIDE:
            break  # somebody who reads the guide wants help with the page beside it
        section = _WINDOWS.get(name) or _REGIONS.get(name)
        if section is not None:
            return section
        each = each.parentWidget()
    seen = (page for page in pages if page is not None and page.isVisible())
    return next((_WINDOWS.get(type(page).__name__, "") for page in seen), "") or panel
