"""Why a gamepad or SpaceMouse does not move the arm, or moves it no more."""

from __future__ import annotations

from typing import Final

from armui.arm.refusal_codes import RefusalCode
from armui.ui.words.text import Texts

GAMEPAD_REFUSALS: Final = Texts("Refusal") | {
    RefusalCode.GAMEPAD_LOST: "{name} is gone. Plug it in again or switch it on.",
    RefusalCode.GAMEPAD_SILENT: (
        "Nothing more is heard of {name}. Let go of its buttons and press anew."
    ),
    RefusalCode.GAMEPAD_UNATTENDED: (
        "The dead-man button was held for {seconds} s without a movement of the device. Press anew."
    ),
    RefusalCode.GAMEPAD_NOT_IN_FRONT: (
        "The main window, or a page taken out of it, is not in front, or a menu is open. Click "
        "into one of them, then press anew."
    ),
}
"""By the code."""
