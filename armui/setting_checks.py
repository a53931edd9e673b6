"""The choices and limits of settings, and the check of a value."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Final, Literal, get_args

from armui.arm.json_fields import finite
from armui.arm.limits import JOINTS
from armui.arm.reference_record import read_record
from armui.arm.refusal import Reason, Refusal
from armui.protocol.generation import PiperModel

SETTING_BAD = Reason(
    "setting_bad",
    "Setting “{field}”: “{value}” is not valid. The default is used instead.",
)
JOG_STEP_NOT_A_NUMBER = Reason(
    "jog_step_not_a_number",
    "Jog step: “{value}” is not an angle. Enter a number of degrees, for example 0.5.",
)
JOG_STEP_OUT_OF_RANGE = Reason(
    "jog_step_out_of_range",
    "Jog step {value}° is out of range. Enter a value from {minimum}° to {maximum}°.",
)
TOOL_NOT_POSSIBLE = Reason(
    "tool_not_possible",
    "Tool centre point: {value} is not possible. Enter lengths up to {maximum} mm and angles "
    "up to 180°.",
)


Language = Literal["zh", "en"]
ThemeName = Literal["light", "dark", "system"]
MountingName = Literal["level", "on_the_left_side", "on_the_right_side", "upside_down"]
PictureDirection = Literal["iso", "front", "side", "top", "below"]
SessionFormat = Literal[".blf", ".asc", ".log"]
GamepadMode = Literal["joint", "base", "tool", "user"]
GamepadButtons = Mapping[str, Mapping[str, str]]
"""The button's name for each action (`armui.gamepad.layout.ACTIONS`), by device."""

_MOST_SHOWN: Final = 60
"""The most characters of a wrong value in a message."""
_LONGEST_PATH: Final = 4096
_MOST_DEVICES: Final = 200
_LONGEST_NAME: Final = 200
_TURN_DEG: Final = 360.0
_MOST_ARMS: Final = 1000

JOG_STEP_MIN_DEG: Final = 0.001
"""The resolution of an angle on the bus."""
JOG_STEP_MAX_DEG: Final = 30.0

JOG_FLOOR_MOST_MM: Final = 500

TRAIL_LONGEST_S: Final = 600

ROTATE_MIN_MB: Final = 1
ROTATE_MAX_MB: Final = 4000
"""A size that every file system supports."""

TOOL_LONGEST_MM: Final = 500.0
_TOOL_LONGEST: Final = (TOOL_LONGEST_MM,) * 3 + (180.0,) * 3


def check(name: str, value: object) -> Refusal | None:
    """Return why a setting may not have a value, or ``None`` if it may."""
    if name == "jog_step_deg":
        return _check_jog_step(value)
    if name == "tool":
        return _check_tool(value)
    allowed = {
        "language": value in get_args(Language),
        "theme": value in get_args(ThemeName),
        "mountings": _are_of_arms(value, get_args(MountingName)),
        "home_poses": _are_home_poses(value),
        "stop_again": isinstance(value, bool),
        "jog_floor_mm": value is None or _is_whole(value, -JOG_FLOOR_MOST_MM, JOG_FLOOR_MOST_MM),
        "urdf_path": value is None or _is_path(value),
        "session_folder": value is None or _is_path(value),
        "session_format": value in get_args(SessionFormat),
        "session_rotate_mb": _is_whole(value, ROTATE_MIN_MB, ROTATE_MAX_MB),
        "session_save_at_faults": isinstance(value, bool),
        "has_jogged": isinstance(value, bool),
        "picture_direction": value in get_args(PictureDirection),
        "picture_orthographic": isinstance(value, bool),
        "picture_tool_frame": isinstance(value, bool),
        "picture_trail_s": _is_whole(value, 0, TRAIL_LONGEST_S),
        "gamepad": isinstance(value, bool),
        "gamepad_mode": value in get_args(GamepadMode),
        "gamepad_one_axis": isinstance(value, bool),
        "gamepad_buttons": _are_buttons(value),
        "cells": _are_named(value),
        "models": _are_of_arms(value, tuple(PiperModel)),
        "references": _are_references(value),
    }
    if allowed.get(name, False):
        return None
    return SETTING_BAD(field=name, value=shown(value))


def shown(value: object) -> str:
    """Return a value as text for a sentence, shortened if it is long."""
    try:
        text = str(value)
    except (ValueError, RecursionError):  # a number of thousands of digits; lists in lists in lists
        text = f"({type(value).__name__})"
    return text if len(text) <= _MOST_SHOWN else text[:_MOST_SHOWN] + "…"


def _is_path(value: object) -> bool:
    """Return whether a value can be the name of a file, here and in Qt."""
    if not isinstance(value, str) or not 0 < len(value) <= _LONGEST_PATH or "\0" in value:
        return False
    try:
        value.encode("utf-8")
    except UnicodeEncodeError:
        return False
    return True


def _is_whole(value: object, least: int, most: int) -> bool:
    return isinstance(value, int) and not isinstance(value, bool) and least <= value <= most


def _are_buttons(value: object) -> bool:
    """Names to names to names, none of them longer than any device has."""
    if not isinstance(value, Mapping) or len(value) > _MOST_DEVICES:
        return False
    return all(
        _is_name(device)
        and isinstance(buttons, Mapping)
        and all(_is_name(what) and _is_name(button) for what, button in buttons.items())
        for device, buttons in value.items()
    )


def _are_of_arms(value: object, allowed: Sequence[object]) -> bool:
    """Return whether a value says something of arms, by what they are remembered by."""
    return (
        isinstance(value, dict)
        and len(value) <= _MOST_ARMS
        and all(isinstance(key, str) and len(key) <= _LONGEST_PATH for key in value)
        and all(each in allowed for each in value.values())
    )


def _are_named(value: object) -> bool:
    """Return whether a value names something for each arm, by what they are remembered by."""
    return (
        isinstance(value, dict)
        and len(value) <= _MOST_ARMS
        and all(isinstance(key, str) and len(key) <= _LONGEST_PATH for key in value)
        and all(_is_name(each) for each in value.values())
    )


def _are_home_poses(value: object) -> bool:
    """Six finite angles for each arm, none of them more than a turn."""
    if not isinstance(value, dict) or len(value) > _MOST_ARMS:
        return False
    return all(
        isinstance(key, str)
        and len(key) <= _LONGEST_PATH
        and isinstance(pose, list | tuple)
        and len(pose) == len(JOINTS)
        and all((angle := finite(each)) is not None and abs(angle) <= _TURN_DEG for each in pose)
        for key, pose in value.items()
    )


def _are_references(value: object) -> bool:
    if not isinstance(value, dict) or len(value) > _MOST_ARMS:
        return False
    return all(
        isinstance(key, str) and len(key) <= _LONGEST_PATH and read_record(record) is not None
        for key, record in value.items()
    )


def _is_name(value: object) -> bool:
    return isinstance(value, str) and len(value) <= _LONGEST_NAME


def _check_jog_step(value: object) -> Refusal | None:
    figure = finite(value)
    if figure is None:
        return JOG_STEP_NOT_A_NUMBER(value=shown(value))
    if not JOG_STEP_MIN_DEG <= figure <= JOG_STEP_MAX_DEG:
        bounds = {"minimum": JOG_STEP_MIN_DEG, "maximum": JOG_STEP_MAX_DEG}
        return JOG_STEP_OUT_OF_RANGE(value=figure, **bounds)
    return None


def _check_tool(value: object) -> Refusal | None:
    """Six finite figures: three lengths of a tool this arm can carry, three angles."""
    figures = list(value) if isinstance(value, list | tuple) else []
    if len(figures) != len(_TOOL_LONGEST):
        figures = [value] * len(_TOOL_LONGEST)
    for figure, longest in zip(figures, _TOOL_LONGEST, strict=True):
        size = finite(figure)
        if size is None or abs(size) > longest:
            return TOOL_NOT_POSSIBLE(value=shown(figure), maximum=round(TOOL_LONGEST_MM))
    return None
