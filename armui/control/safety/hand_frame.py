"""Parses a frame typed by the operator, and determines its effect on the arm: pure."""

from __future__ import annotations

import enum
import re
from typing import Final

from armui.arm.refusal import Reason, Refusal
from armui.protocol.codes import (
    ControlMode,
    CpvAction,
    MitMode,
    MotorAction,
    StopCommand,
    TeachingState,
    TrajectoryCommand,
)
from armui.protocol.frame import Frame
from armui.protocol.motion_frames import command_id
from armui.telemetry.bus_senders import VERSION_ID, speaks_for_arm

FRAME_ID_BAD = Reason(
    "frame_id_bad",
    "Identifier: “{value}” is not a hexadecimal number. Enter 000 to 7FF, for example 151.",
)
FRAME_ID_TOO_HIGH = Reason(
    "frame_id_too_high",
    "Identifier: {value} has more than 11 bits; the arm uses none of those. Enter 000 to 7FF.",
)
FRAME_DATA_BAD = Reason(
    "frame_data_bad",
    "Data: “{value}” is not whole bytes. Enter two hexadecimal figures for each byte, for "
    "example 01 0A FF.",
)
FRAME_DATA_LONG = Reason(
    "frame_data_long", "Data: {count} bytes do not fit into a frame. Enter 8 at most."
)
FRAME_IS_THE_ARMS = Reason(
    "frame_is_the_arms",
    "{frame} is sent by the arm itself: two senders of one identifier disturb the bus, and "
    "others would take it for the arm's feedback. Choose an identifier that hosts send.",
)
FRAME_OF_UPGRADE = Reason(
    "frame_of_upgrade",
    "{frame} is kept for firmware upgrades: what it does is not public, and it may leave the "
    "arm without firmware. Use the maker's upgrade program.",
)
FRAME_RESUMES = Reason(
    "frame_resumes",
    "This frame ends an emergency stop and lets the arm drop. Use Release in the main window, "
    "once the arm is supported.",
)

_MODE_ID: Final = 0x151
"""The mode word, without an offset."""
_CPV_IDS: Final = range(0x181, 0x188)
_UPGRADE: Final = (range(0x0A0, 0x0C0), range(0x4A0, 0x4D0))
_HIGHEST: Final = 0x7FF
"""The highest standard identifier: 11 bits."""
_BYTES: Final = 8
_LIMP_MODES: Final = frozenset({0x04, 0x05, 0x06})
"""MOVE M, MOVE CPV, and MOVE M from firmware S-V1.8-8 on."""
_ENDING: Final = frozenset(
    {
        TrajectoryCommand.PAUSE,
        TrajectoryCommand.CLEAR_CURRENT,
        TrajectoryCommand.CLEAR_ALL,
        TrajectoryCommand.ABORT,
    }
)
_ENDING_TEACHING: Final = frozenset(
    {TeachingState.STOP_RECORDING, TeachingState.PAUSE, TeachingState.ABORT}
)

_HEX: Final = re.compile(r"(?:0[xX])?([0-9a-fA-F]+)")
_BETWEEN: Final = re.compile(r"[\s,.:_-]+")


class FrameEffect(enum.StrEnum):
    """The effects of a frame on the arm."""

    HARMLESS = "harmless"
    """The frame is a question, or sets a lamp."""
    ENDS = "ends"
    """The motion under way ends or pauses."""
    SINKS = "sinks"
    """An emergency stop: the joints only brake."""
    DROPS = "drops"
    """Motors lose their power and the arm drops: it has no brakes."""
    LIMP = "limp"
    """The mode leaves the joints limp until their next setpoint."""
    DIRECT = "direct"
    """The frame is a setpoint of one motor, past the arm's own planning."""
    MOVES = "moves"
    GRIPPER = "gripper"
    HAND = "hand"
    """Drag teaching: the joints give way to a hand."""
    POWER = "power"
    """Motors get their power."""
    ROLE = "role"
    """The role of leader or follower changes, or the identifiers (0x470)."""
    SETTING = "setting"
    """The arm keeps a setting."""
    SILENCE = "silence"
    """The arm is told to say nothing (0x422)."""
    UNKNOWN = "unknown"
    """The effect is not published."""


NEVER_REFUSED: Final = frozenset({FrameEffect.ENDS, FrameEffect.SINKS, FrameEffect.DROPS})
"""The effects that are always permitted, also beside other hosts: they end a motion."""
MOVING: Final = frozenset(
    {
        FrameEffect.LIMP,
        FrameEffect.DIRECT,
        FrameEffect.MOVES,
        FrameEffect.GRIPPER,
        FrameEffect.HAND,
        FrameEffect.POWER,
    }
)
"""The effects by which the arm moves or may move: by itself, by gravity or by a hand."""

_EFFECTS: Final = {
    **dict.fromkeys((0x121, 0x472, VERSION_ID), FrameEffect.HARMLESS),
    **dict.fromkeys((0x474, 0x475, 0x479, 0x47A, 0x47D, 0x487), FrameEffect.SETTING),
    0x191: FrameEffect.MOVES,
    **dict.fromkeys(_CPV_IDS, FrameEffect.DIRECT),
    0x470: FrameEffect.ROLE,
}
"""The effects of identifiers that 0x470 does not shift, whatever their bytes are."""


def parse_frame(identifier: str, data: str) -> Frame | Refusal:
    """Return the frame in two fields of hexadecimal digits, or what is wrong with them.

    Args:
        identifier: ``155``, ``0x155``.
        data: ``00 00 27 10``, ``00002710``; empty for no byte.
    """
    found = _HEX.fullmatch(identifier.strip())
    if found is None:
        return FRAME_ID_BAD(value=identifier.strip())
    arbitration_id = int(found[1], 16) if len(found[1]) <= _BYTES else _HIGHEST + 1
    if arbitration_id > _HIGHEST:
        return FRAME_ID_TOO_HIGH(value=f"0x{found[1].upper()}")
    parts = [part.removeprefix("0x") for part in _BETWEEN.split(data.strip().lower()) if part]
    for part in parts:
        if not re.fullmatch(r"[0-9a-f]+", part) or len(part) % 2:
            return FRAME_DATA_BAD(value=part)
    payload = bytes.fromhex("".join(parts))
    if len(payload) > _BYTES:
        return FRAME_DATA_LONG(count=len(payload))
    return Frame(arbitration_id, payload)


def why_never(frame: Frame) -> Refusal | None:
    """Return the reason against ever sending a frame by hand, or ``None``."""
    name = {"frame": f"0x{frame.arbitration_id:03X}"}
    if speaks_for_arm(frame.arbitration_id):
        return FRAME_IS_THE_ARMS(**name)
    if is_upgrade(frame.arbitration_id):
        return FRAME_OF_UPGRADE(**name)
    resumes = _byte(frame, 0) == StopCommand.RESUME
    if command_id(frame.arbitration_id) == 0x150 and resumes:
        return FRAME_RESUMES()
    return None


def is_upgrade(arbitration_id: int) -> bool:
    """Return whether an identifier is kept for firmware upgrades."""
    return arbitration_id != VERSION_ID and any(arbitration_id in each for each in _UPGRADE)


def sets_mode(frame: Frame) -> bool:
    """Return whether a frame is a mode word (0x151) under any offset."""
    return command_id(frame.arbitration_id) == _MODE_ID


def effect_of(frame: Frame) -> FrameEffect:
    """Return the effect of a frame, on an arm with any offset (0x470)."""
    arbitration_id = frame.arbitration_id
    base = command_id(arbitration_id)
    if base is not None:
        return _command_effect(frame, base)
    if arbitration_id == 0x471:
        off = _byte(frame, 1) == MotorAction.DISABLE
        return FrameEffect.DROPS if off else FrameEffect.POWER
    if arbitration_id == 0x477:
        return FrameEffect.SETTING if any(frame.data[1:4]) else FrameEffect.HARMLESS
    if arbitration_id in _CPV_IDS and _byte(frame, 0) == CpvAction.READ:
        return FrameEffect.HARMLESS
    if arbitration_id == 0x422:
        return FrameEffect.SILENCE if _byte(frame, 0) else FrameEffect.HARMLESS
    return _EFFECTS.get(arbitration_id, FrameEffect.UNKNOWN)


def _command_effect(frame: Frame, base: int) -> FrameEffect:
    if base == 0x150:
        return _motion_command_effect(frame)
    if base == _MODE_ID:
        if _byte(frame, 1) in _LIMP_MODES or _byte(frame, 3) == MitMode.MIT:
            return FrameEffect.LIMP
        teaches = _byte(frame, 0) == ControlMode.TEACHING
        return FrameEffect.HAND if teaches else FrameEffect.MOVES
    if base == 0x159:
        return FrameEffect.GRIPPER
    return FrameEffect.DIRECT if base >= 0x15A else FrameEffect.MOVES


def _motion_command_effect(frame: Frame) -> FrameEffect:
    if _byte(frame, 0):
        return FrameEffect.SINKS
    plan, teaching = _byte(frame, 1), _byte(frame, 2)
    if teaching == TeachingState.START_RECORDING:
        return FrameEffect.HAND
    ends = plan in _ENDING or teaching in _ENDING_TEACHING
    starts = (plan and plan not in _ENDING) or (teaching and teaching not in _ENDING_TEACHING)
    return FrameEffect.ENDS if ends and not starts else FrameEffect.MOVES


def _byte(frame: Frame, place: int) -> int:
    return frame.data[place] if len(frame.data) > place else 0
