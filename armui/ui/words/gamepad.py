"""The names of axes and buttons of gamepads and SpaceMice, and of their functions."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

from armui.gamepad.device_state import DeviceKind
from armui.gamepad.layout import JogMode
from armui.kinematics.axes import AXES
from armui.ui.words.text import Texts, sentence

GAMEPAD_AXES: Final = Texts("GamepadAxis") | {
    "left_x": "Left stick ↔",
    "left_y": "Left stick ↕",
    "right_x": "Right stick ↔",
    "right_y": "Right stick ↕",
    "right_trigger": "Right trigger",
    "dpad_up": "D-pad ↕",
    "dpad_right": "D-pad ↔",
    "x": "Push away / pull",
    "y": "Push left / right",
    "z": "Lift / press",
    "rx": "Tilt left / right",
    "ry": "Tilt away / towards",
    "rz": "Turn",
}
_BUTTONS: Final[Mapping[str, str]] = {
    "a": "A / ✕",
    "b": "B / ○",
    "x": "X / □",
    "y": "Y / △",
    "left_shoulder": "LB / L1",
    "right_shoulder": "RB / R1",
    "back": "Back / Share",
    "start": "Start / Options",
    "left_stick": "L3",
    "right_stick": "R3",
    "guide": "Guide / PS",
    "dpad_up": "↑",
    "dpad_down": "↓",
    "dpad_left": "←",
    "dpad_right": "→",
}
"""The labels of buttons as printed on the two kinds of gamepads."""

_MODES: Final = Texts("GamepadMode") | {
    JogMode.JOINT: "Joints",
    JogMode.BASE: "Base frame",
    JogMode.TOOL: "Tool frame",
    JogMode.USER: "User frame",
}
GAMEPAD_ACTIONS: Final = Texts("GamepadAction") | {
    "dead_man": "Dead man (hold to move)",
    "stop": "Emergency stop",
    "halt": "Halt",
    "mode": "Next mode",
    "episode": "Begin or end an episode",
    "discard": "Discard the last episode",
}


def gamepad_button(kind: DeviceKind, name: str) -> str:
    """Return the name of a button as printed on the device."""
    if kind is DeviceKind.SPACE_MOUSE:
        source = QT_TRANSLATE_NOOP("GamepadButton", "Button {number}")
        return sentence("GamepadButton", source, {"number": name})
    return _BUTTONS.get(name, name)


def gamepad_mode(mode: JogMode) -> str:
    """Return the name of the axes' mode."""
    return _MODES.text(mode)


def moved_axis(mode: JogMode, place: int) -> str:
    """Return the name of the arm's axis at an index: J1, or X."""
    return f"J{place + 1}" if mode is JogMode.JOINT else AXES[place]
