"""The titles of the pages and windows, by their keys."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from armui.ui.words.text import Text

PLACES: Final[Mapping[str, Text]] = {
    "everywhere": Text("Place", "In every window"),
    "window": Text("Place", "Main window"),
    "view": Text("Place", "3D view"),
    "jogging": Text("Place", "Jogging by keys"),
    "parameters": Text("Place", "Panels with parameters"),
    "library": Text("LibraryButton", "Trajectory library"),
    "editor": Text("Place", "Trajectory editor"),
    "recording": Text("RecordingPage", "Recording"),
    "drawer": Text("Place", "Drawer"),
    "plots": Text("WatchMenu", "Curves"),
    "events": Text("WatchMenu", "Events"),
    "bus": Text("WatchMenu", "Bus"),
    "sessions": Text("SessionsPage", "Session recordings"),
    "guide": Text("WatchMenu", "Guide"),
    "help": Text("HelpPage", "Help: 3D view"),
    "replay": Text("Place", "Replay"),
    "connect": Text("ConnectDialog", "Connect arm"),
    "settings": Text("SettingsDialog", "Settings"),
    "joint_status": Text("JointStatusPage", "Joint status"),
    "about_arm": Text("AboutArmDialog", "About this arm"),
    "doctor": Text("DoctorDialog", "Diagnosis"),
    "reference": Text("ReferenceDialog", "Reference check"),
    "report": Text("ProblemReportDialog", "Report a problem"),
    "about": Text("AboutDialog", "About armui"),
    "run": Text("Place", "Run"),
}
"""The titles by the keys of the places; `operation_area.PANELS` has those of the panels."""

MOVABLE: Final = (
    *("library", "editor", "recording"),
    *("plots", "events", "bus", "sessions", "joint_status", "guide", "help"),
)
"""The keys of the pages that can be moved into a window of their own."""
