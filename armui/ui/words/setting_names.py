"""What the settings of the program are called where one of them is wrong."""

from __future__ import annotations

from typing import Final

from armui.ui.words.text import Texts

SETTING_NAMES: Final = Texts("SettingName") | {
    "language": "language",
    "theme": "theme",
    "jog_step_deg": "jog step",
    "jog_floor_mm": "lowest height for jogs",
    "models": "models of the arms",
    "urdf_path": "robot description",
    "tool": "tool centre point",
    "gamepad": "jogging by gamepad",
    "gamepad_mode": "what a gamepad moves",
    "gamepad_one_axis": "one axis at a time by gamepad",
    "gamepad_buttons": "buttons of the gamepads",
    "session_folder": "folder of the session recordings",
    "session_format": "format of the session recordings",
    "session_rotate_mb": "size at which a new file is begun",
    "picture_direction": "view of the 3D picture",
    "picture_orthographic": "3D picture without perspective",
    "picture_tool_frame": "tool frame in the 3D picture",
    "picture_trail_s": "way of the tool in the 3D picture",
    "session_save_at_faults": "saving at faults and stops",
}
"""By the field of `armui.settings.Settings`."""
