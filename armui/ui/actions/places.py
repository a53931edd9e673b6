"""Where something is done: the windows and panels, by the names the operator reads."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from armui.ui.words.text import Text

PLACES: Final[Mapping[str, Text]] = {
    "everywhere": Text("Place", "In every window"),
    "window": Text("Place", "Main window"),
    "view": Text("Place", "3D view"),
    "motion": Text("SideMenu", "Motion control"),
    "cartesian": Text("SideMenu", "Tool control"),
    "jogging": Text("Place", "Jogging by keys"),
    "light": Text("SideMenu", "Light control"),
    "linkage": Text("SideMenu", "Linkage control"),
    "joint_settings": Text("SideMenu", "Joint settings"),
    "end_limits": Text("SideMenu", "End speed limits"),
    "collision": Text("SideMenu", "Collision level"),
    "motor": Text("SideMenu", "Motor settings"),
    "gripper": Text("SideMenu", "Gripper control"),
    "gripper_settings": Text("SideMenu", "Gripper settings"),
    "end_load": Text("SideMenu", "End load"),
    "teaching": Text("SideMenu", "Drag teaching"),
    "parameters": Text("Place", "Panels with parameters"),
    "library": Text("LibraryButton", "Trajectory library"),
    "editor": Text("Place", "Trajectory editor"),
    "recording": Text("RecordingPage", "Recording"),
    "drawer": Text("Place", "Drawer"),
    "plots": Text("WatchMenu", "Curves"),
    "events": Text("WatchMenu", "Events"),
    "bus": Text("WatchMenu", "Bus"),
    "sessions": Text("SessionsWindow", "Session recordings"),
    "replay": Text("Place", "Replay"),
    "connect": Text("ConnectDialog", "Connect arm"),
    "settings": Text("SettingsDialog", "Settings"),
}
"""By their keys, in the order in which they are listed."""

PANELS: Final = (
    *("motion", "cartesian", "light", "linkage", "joint_settings", "end_limits", "collision"),
    *("motor", "gripper", "gripper_settings", "end_load", "teaching"),
)
"""The panels of the operation area, in the order of the menu."""

MOVABLE: Final = ("library", "editor", "recording", "plots", "events", "bus")
"""The pages that can be taken out into a window, by their keys."""
