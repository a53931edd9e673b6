"""The codes of the arm's status frame in words (frame 0x2A1, table «机械臂状态反馈»).

Both generations share the tables: generation 2 only adds codes at their ends. A code that is in
no table is shown as unknown with its number, never as its nearest neighbour.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP, QCoreApplication

from armui.ui.words.text import sentence

_CONTROL_MODES: Final[Mapping[int, object]] = {
    0x00: QT_TRANSLATE_NOOP("ControlMode", "Standby mode"),
    0x01: QT_TRANSLATE_NOOP("ControlMode", "CAN command control mode"),
    0x02: QT_TRANSLATE_NOOP("ControlMode", "Teaching mode"),
    0x03: QT_TRANSLATE_NOOP("ControlMode", "Ethernet control mode"),
    0x04: QT_TRANSLATE_NOOP("ControlMode", "Wi-Fi control mode"),
    0x05: QT_TRANSLATE_NOOP("ControlMode", "Remote controller mode"),
    0x06: QT_TRANSLATE_NOOP("ControlMode", "Linked teaching input mode"),
    0x07: QT_TRANSLATE_NOOP("ControlMode", "Offline trajectory mode"),
}

_SHORT_CONTROL_MODES: Final[Mapping[int, object]] = {
    0x00: QT_TRANSLATE_NOOP("ControlModeShort", "Standby"),
    0x01: QT_TRANSLATE_NOOP("ControlModeShort", "CAN commands"),
    0x02: QT_TRANSLATE_NOOP("ControlModeShort", "Teaching"),
    0x03: QT_TRANSLATE_NOOP("ControlModeShort", "Ethernet"),
    0x04: QT_TRANSLATE_NOOP("ControlModeShort", "Wi-Fi"),
    0x05: QT_TRANSLATE_NOOP("ControlModeShort", "Remote controller"),
    0x06: QT_TRANSLATE_NOOP("ControlModeShort", "Linked teaching input"),
    0x07: QT_TRANSLATE_NOOP("ControlModeShort", "Offline trajectory"),
}

_ARM_STATUSES: Final[Mapping[int, object]] = {
    0x00: QT_TRANSLATE_NOOP("ArmStatus", "Normal"),
    0x01: QT_TRANSLATE_NOOP("ArmStatus", "Emergency stop"),
    0x02: QT_TRANSLATE_NOOP("ArmStatus", "No solution"),
    0x03: QT_TRANSLATE_NOOP("ArmStatus", "Singularity"),
    0x04: QT_TRANSLATE_NOOP("ArmStatus", "Target angle beyond limit"),
    0x05: QT_TRANSLATE_NOOP("ArmStatus", "Joint communication fault"),
    0x06: QT_TRANSLATE_NOOP("ArmStatus", "Joint brake not released"),
    0x07: QT_TRANSLATE_NOOP("ArmStatus", "Collision"),
    0x08: QT_TRANSLATE_NOOP("ArmStatus", "Overspeed in drag teaching"),
    0x09: QT_TRANSLATE_NOOP("ArmStatus", "Joint status fault"),
    0x0A: QT_TRANSLATE_NOOP("ArmStatus", "Other fault"),
    0x0B: QT_TRANSLATE_NOOP("ArmStatus", "Teaching: recording"),
    0x0C: QT_TRANSLATE_NOOP("ArmStatus", "Teaching: replaying"),
    0x0D: QT_TRANSLATE_NOOP("ArmStatus", "Teaching: paused"),
    0x0E: QT_TRANSLATE_NOOP("ArmStatus", "Main controller too hot"),
    0x0F: QT_TRANSLATE_NOOP("ArmStatus", "Brake resistor too hot"),
}

_MOVE_MODES: Final[Mapping[int, object]] = {
    0x00: QT_TRANSLATE_NOOP("MoveMode", "Point mode"),
    0x01: QT_TRANSLATE_NOOP("MoveMode", "Joint mode"),
    0x02: QT_TRANSLATE_NOOP("MoveMode", "Linear mode"),
    0x03: QT_TRANSLATE_NOOP("MoveMode", "Arc mode"),
    0x04: QT_TRANSLATE_NOOP("MoveMode", "MIT mode"),
    0x05: QT_TRANSLATE_NOOP("MoveMode", "CPV mode"),
    0x06: QT_TRANSLATE_NOOP("MoveMode", "MIT mode"),
}

_TEACHING_STATES: Final[Mapping[int, object]] = {
    0x00: QT_TRANSLATE_NOOP("Teaching", "Off"),
    0x01: QT_TRANSLATE_NOOP("Teaching", "Start of recording (drag teaching on)"),
    0x02: QT_TRANSLATE_NOOP("Teaching", "End of recording (drag teaching off)"),
    0x03: QT_TRANSLATE_NOOP("Teaching", "Replaying the taught trajectory"),
    0x04: QT_TRANSLATE_NOOP("Teaching", "Replay paused"),
    0x05: QT_TRANSLATE_NOOP("Teaching", "Replay resumed"),
    0x06: QT_TRANSLATE_NOOP("Teaching", "Replay terminated"),
    0x07: QT_TRANSLATE_NOOP("Teaching", "Moving to the start of the trajectory"),
}


def control_mode(code: int) -> str:
    """Who commands the arm, byte 0, in the protocol's words («待机模式»)."""
    return _word("ControlMode", _CONTROL_MODES, code)


def control_mode_short(code: int) -> str:
    """Who commands the arm, byte 0, as short as the manual's status bar has it («待机»)."""
    return _word("ControlModeShort", _SHORT_CONTROL_MODES, code)


def arm_status(code: int) -> str:
    """How the arm is, byte 1 («正常»)."""
    return _word("ArmStatus", _ARM_STATUSES, code)


def move_mode(code: int) -> str:
    """How the arm travels to a target, byte 2 («点位模式»)."""
    return _word("MoveMode", _MOVE_MODES, code)


def teaching(code: int) -> str:
    """What drag teaching does, byte 3 («关闭»)."""
    return _word("Teaching", _TEACHING_STATES, code)


def reached(is_reached: bool) -> str:
    """Whether the arm is where it was sent, byte 4 («已达指定点»)."""
    if is_reached:
        return QCoreApplication.translate("Reached", "Target reached")
    return QCoreApplication.translate("Reached", "Target not reached")


def _word(context: str, table: Mapping[int, object], code: int) -> str:
    if code in table:
        return QCoreApplication.translate(context, str(table[code]))
    unknown = QT_TRANSLATE_NOOP("UnknownCode", "unknown ({code})")
    return sentence("UnknownCode", unknown, {"code": f"0x{code:02X}"})
