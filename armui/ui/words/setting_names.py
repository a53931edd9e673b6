"""What the settings of the program are called where one of them is wrong."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

SETTING_NAMES: Final[Mapping[str, object]] = {
    "language": QT_TRANSLATE_NOOP("SettingName", "language"),
    "theme": QT_TRANSLATE_NOOP("SettingName", "theme"),
    "jog_step_deg": QT_TRANSLATE_NOOP("SettingName", "jog step"),
    "models": QT_TRANSLATE_NOOP("SettingName", "models of the arms"),
    "urdf_path": QT_TRANSLATE_NOOP("SettingName", "robot description"),
    "tool": QT_TRANSLATE_NOOP("SettingName", "tool centre point"),
    "gamepad": QT_TRANSLATE_NOOP("SettingName", "jogging by gamepad"),
    "gamepad_mode": QT_TRANSLATE_NOOP("SettingName", "what a gamepad moves"),
    "gamepad_one_axis": QT_TRANSLATE_NOOP("SettingName", "one axis at a time by gamepad"),
    "gamepad_buttons": QT_TRANSLATE_NOOP("SettingName", "buttons of the gamepads"),
    "session_folder": QT_TRANSLATE_NOOP("SettingName", "folder of the session recordings"),
    "session_format": QT_TRANSLATE_NOOP("SettingName", "format of the session recordings"),
    "session_rotate_mb": QT_TRANSLATE_NOOP("SettingName", "size at which a new file is begun"),
    "picture_direction": QT_TRANSLATE_NOOP("SettingName", "view of the 3D picture"),
    "picture_orthographic": QT_TRANSLATE_NOOP("SettingName", "3D picture without perspective"),
    "picture_tool_frame": QT_TRANSLATE_NOOP("SettingName", "tool frame in the 3D picture"),
    "picture_trail_s": QT_TRANSLATE_NOOP("SettingName", "way of the tool in the 3D picture"),
    "session_save_at_faults": QT_TRANSLATE_NOOP("SettingName", "saving at faults and stops"),
}
"""By the field of `armui.settings.Settings`."""
