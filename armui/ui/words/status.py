"""The codes of the arm's status frame in words (frame 0x2A1, table «机械臂状态反馈»).

Both generations share the tables: generation 2 only adds codes at their ends. A code that is in
no table is shown as unknown with its number, never as its nearest neighbour.
"""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP, QCoreApplication

from armui.ui.words.text import Texts, sentence

_CONTROL_MODES: Final = Texts("ControlMode") | {
    0x00: "Standby mode",
    0x01: "CAN command control mode",
    0x02: "Teaching mode",
    0x03: "Ethernet control mode",
    0x04: "Wi-Fi control mode",
    0x05: "Remote controller mode",
    0x06: "Linked teaching input mode",
    0x07: "Offline trajectory mode",
}

_SHORT_CONTROL_MODES: Final = Texts("ControlModeShort") | {
    0x00: "Standby",
    0x01: "CAN commands",
    0x02: "Teaching",
    0x03: "Ethernet",
    0x04: "Wi-Fi",
    0x05: "Remote controller",
    0x06: "Linked teaching input",
    0x07: "Offline trajectory",
}

_ARM_STATUSES: Final = Texts("ArmStatus") | {
    0x00: "Normal",
    0x01: "Emergency stop",
    0x02: "No solution",
    0x03: "Singularity",
    0x04: "Target angle beyond limit",
    0x05: "Joint communication fault",
    0x06: "Joint brake not released",
    0x07: "Collision",
    0x08: "Overspeed in drag teaching",
    0x09: "Joint status fault",
    0x0A: "Other fault",
    0x0B: "Teaching: recording",
    0x0C: "Teaching: replaying",
    0x0D: "Teaching: paused",
    0x0E: "Main controller too hot",
    0x0F: "Brake resistor too hot",
}

_MOVE_MODES: Final = Texts("MoveMode") | {
    0x00: "Point mode",
    0x01: "Joint mode",
    0x02: "Linear mode",
    0x03: "Arc mode",
    0x04: "MIT mode",
    0x05: "CPV mode",
    0x06: "MIT mode",
}

_TEACHING_STATES: Final = Texts("Teaching") | {
    0x00: "Off",
    0x01: "Start of recording (drag teaching on)",
    0x02: "End of recording (drag teaching off)",
    0x03: "Replaying the taught trajectory",
    0x04: "Replay paused",
    0x05: "Replay resumed",
    0x06: "Replay terminated",
    0x07: "Moving to the start of the trajectory",
}


def control_mode(code: int) -> str:
    """Who commands the arm, byte 0, in the protocol's words («待机模式»)."""
    return _word(_CONTROL_MODES, code)


def control_mode_short(code: int) -> str:
    """Who commands the arm, byte 0, as short as the manual's status bar has it («待机»)."""
    return _word(_SHORT_CONTROL_MODES, code)


def arm_status(code: int) -> str:
    """How the arm is, byte 1 («正常»)."""
    return _word(_ARM_STATUSES, code)


def move_mode(code: int) -> str:
    """How the arm travels to a target, byte 2 («点位模式»)."""
    return _word(_MOVE_MODES, code)


def teaching(code: int) -> str:
    """What drag teaching does, byte 3 («关闭»)."""
    return _word(_TEACHING_STATES, code)


def reached(is_reached: bool) -> str:
    """Whether the arm is where it was sent, byte 4 («已达指定点»)."""
    if is_reached:
        return QCoreApplication.translate("Reached", "Target reached")
    return QCoreApplication.translate("Reached", "Target not reached")


def _word(table: Texts[int], code: int) -> str:
    if code in table:
        return table.text(code)
    unknown = QT_TRANSLATE_NOOP("UnknownCode", "unknown ({code})")
    return sentence("UnknownCode", unknown, {"code": f"0x{code:02X}"})
