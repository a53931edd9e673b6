"""What the axes and buttons of a gamepad or SpaceMouse are called, and what they do."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

from armui.gamepad.device_state import DeviceKind
from armui.gamepad.layout import AxisSource, JogMode
from armui.kinematics.axes import AXES
from armui.ui.words.text import sentence

_AXES: Final[Mapping[str, object]] = {
    "left_x": QT_TRANSLATE_NOOP("GamepadAxis", "Left stick ↔"),
    "left_y": QT_TRANSLATE_NOOP("GamepadAxis", "Left stick ↕"),
    "right_x": QT_TRANSLATE_NOOP("GamepadAxis", "Right stick ↔"),
    "right_y": QT_TRANSLATE_NOOP("GamepadAxis", "Right stick ↕"),
    "right_trigger": QT_TRANSLATE_NOOP("GamepadAxis", "Right trigger"),
    "dpad_up": QT_TRANSLATE_NOOP("GamepadAxis", "D-pad ↕"),
    "dpad_right": QT_TRANSLATE_NOOP("GamepadAxis", "D-pad ↔"),
    "x": QT_TRANSLATE_NOOP("GamepadAxis", "Push away / pull"),
    "y": QT_TRANSLATE_NOOP("GamepadAxis", "Push left / right"),
    "z": QT_TRANSLATE_NOOP("GamepadAxis", "Lift / press"),
    "rx": QT_TRANSLATE_NOOP("GamepadAxis", "Tilt left / right"),
    "ry": QT_TRANSLATE_NOOP("GamepadAxis", "Tilt away / towards"),
    "rz": QT_TRANSLATE_NOOP("GamepadAxis", "Turn"),
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
"""As they are printed on the two kinds of gamepads there are."""

_MODES: Final[Mapping[JogMode, object]] = {
    JogMode.JOINT: QT_TRANSLATE_NOOP("GamepadMode", "Joints"),
    JogMode.BASE: QT_TRANSLATE_NOOP("GamepadMode", "Base frame"),
    JogMode.TOOL: QT_TRANSLATE_NOOP("GamepadMode", "Tool frame"),
}
_ACTIONS: Final[Mapping[str, object]] = {
    "dead_man": QT_TRANSLATE_NOOP("GamepadAction", "Dead man (hold to move)"),
    "stop": QT_TRANSLATE_NOOP("GamepadAction", "Emergency stop"),
    "halt": QT_TRANSLATE_NOOP("GamepadAction", "Halt"),
    "mode": QT_TRANSLATE_NOOP("GamepadAction", "Next mode"),
}


def gamepad_source(source: AxisSource) -> str:
    """What is pushed to move an axis of the arm."""
    return sentence("GamepadAxis", _AXES[source.axis or source.plus], {})


def gamepad_axis(name: str) -> str:
    """An axis of the device."""
    return sentence("GamepadAxis", _AXES[name], {})


def gamepad_button(kind: DeviceKind, name: str) -> str:
    """A button as the operator finds it on the device."""
    if kind is DeviceKind.SPACE_MOUSE:
        source = QT_TRANSLATE_NOOP("GamepadButton", "Button {number}")
        return sentence("GamepadButton", source, {"number": name})
    return _BUTTONS.get(name, name)


def gamepad_mode(mode: JogMode) -> str:
    """What the axes move."""
    return sentence("GamepadMode", _MODES[mode], {})


def gamepad_action(action: str) -> str:
    """What a button does."""
    return sentence("GamepadAction", _ACTIONS[action], {})


def moved_axis(mode: JogMode, place: int) -> str:
    """The axis of the arm at a place: J1, or X."""
    return f"J{place + 1}" if mode is JogMode.JOINT else AXES[place]
