"""Why a gamepad or SpaceMouse does not move the arm, or moves it no more."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

from armui.arm.refusal_codes import RefusalCode

GAMEPAD_REFUSALS: Final[Mapping[RefusalCode, object]] = {
    RefusalCode.GAMEPAD_LOST: QT_TRANSLATE_NOOP(
        "Refusal", "{name} is gone. Plug it in again or switch it on."
    ),
    RefusalCode.GAMEPAD_SILENT: QT_TRANSLATE_NOOP(
        "Refusal", "Nothing more is heard of {name}. Let go of its buttons and press anew."
    ),
    RefusalCode.GAMEPAD_UNATTENDED: QT_TRANSLATE_NOOP(
        "Refusal",
        "The dead-man button was held for {seconds} s without a movement of the device. Press "
        "anew.",
    ),
    RefusalCode.GAMEPAD_NOT_IN_FRONT: QT_TRANSLATE_NOOP(
        "Refusal",
        "The main window, or a page taken out of it, is not in front, or a menu is open. Click "
        "into one of them, then press anew.",
    ),
}
"""By the code."""
