"""Where something is done: the windows and panels, by the names the operator reads."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final, NamedTuple

from PySide6.QtCore import QT_TRANSLATE_NOOP, QCoreApplication


class Title(NamedTuple):
    """A text in the operator's language.

    Attributes:
        context: Of the translation.
        source: The English text.
        suffix: What follows it in every language: ``J3``, ``X``.
    """

    context: str
    source: str
    suffix: str = ""

    def text(self) -> str:
        """It in the language of now."""
        said = QCoreApplication.translate(self.context, self.source)
        return f"{said} {self.suffix}".rstrip()


# fmt: off
_PLACES: Final = (
    ("everywhere", "Place", QT_TRANSLATE_NOOP("Place", "In every window")),
    ("window", "Place", QT_TRANSLATE_NOOP("Place", "Main window")),
    ("view", "Place", QT_TRANSLATE_NOOP("Place", "3D view")),
    ("motion", "SideMenu", QT_TRANSLATE_NOOP("SideMenu", "Motion control")),
    ("cartesian", "SideMenu", QT_TRANSLATE_NOOP("SideMenu", "Tool control")),
    ("jogging", "Place", QT_TRANSLATE_NOOP("Place", "Jogging by keys")),
    ("light", "SideMenu", QT_TRANSLATE_NOOP("SideMenu", "Light control")),
    ("linkage", "SideMenu", QT_TRANSLATE_NOOP("SideMenu", "Linkage control")),
    ("joint_settings", "SideMenu", QT_TRANSLATE_NOOP("SideMenu", "Joint settings")),
    ("end_limits", "SideMenu", QT_TRANSLATE_NOOP("SideMenu", "End speed limits")),
    ("collision", "SideMenu", QT_TRANSLATE_NOOP("SideMenu", "Collision level")),
    ("motor", "SideMenu", QT_TRANSLATE_NOOP("SideMenu", "Motor settings")),
    ("gripper", "SideMenu", QT_TRANSLATE_NOOP("SideMenu", "Gripper control")),
    ("gripper_settings", "SideMenu", QT_TRANSLATE_NOOP("SideMenu", "Gripper settings")),
    ("end_load", "SideMenu", QT_TRANSLATE_NOOP("SideMenu", "End load")),
    ("teaching", "SideMenu", QT_TRANSLATE_NOOP("SideMenu", "Drag teaching")),
    ("parameters", "Place", QT_TRANSLATE_NOOP("Place", "Panels with parameters")),
    ("library", "LibraryButton", QT_TRANSLATE_NOOP("LibraryButton", "Trajectory library")),
    ("editor", "Place", QT_TRANSLATE_NOOP("Place", "Trajectory editor")),
    ("recording", "RecordingPage", QT_TRANSLATE_NOOP("RecordingPage", "Recording")),
    ("drawer", "Place", QT_TRANSLATE_NOOP("Place", "Drawer")),
    ("plots", "WatchMenu", QT_TRANSLATE_NOOP("WatchMenu", "Curves")),
    ("events", "WatchMenu", QT_TRANSLATE_NOOP("WatchMenu", "Events")),
    ("bus", "WatchMenu", QT_TRANSLATE_NOOP("WatchMenu", "Bus")),
    ("sessions", "SessionsWindow", QT_TRANSLATE_NOOP("SessionsWindow", "Session recordings")),
    ("replay", "Place", QT_TRANSLATE_NOOP("Place", "Replay")),
    ("connect", "ConnectDialog", QT_TRANSLATE_NOOP("ConnectDialog", "Connect arm")),
    ("settings", "SettingsDialog", QT_TRANSLATE_NOOP("SettingsDialog", "Settings")),
)
# fmt: on

PLACES: Final[Mapping[str, Title]] = {
    key: Title(context, str(source)) for key, context, source in _PLACES
}
"""By their keys, in the order in which they are listed."""

PANELS: Final = (
    *("motion", "cartesian", "light", "linkage", "joint_settings", "end_limits", "collision"),
    *("motor", "gripper", "gripper_settings", "end_load", "teaching"),
)
"""The panels of the operation area, in the order of the menu."""
