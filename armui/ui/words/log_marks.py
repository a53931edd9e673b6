"""What a mark on the time line of a log stands for."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

from armui.ui.words import status
from armui.ui.words.text import sentence

if TYPE_CHECKING:
    from armui.session.session import SessionMark

_MARKS: Final[Mapping[str, object]] = {
    "status": QT_TRANSLATE_NOOP("LogMark", "Arm status: {status}"),
    "stopped": QT_TRANSLATE_NOOP("LogMark", "The arm is in emergency stop"),
    "stop_sent": QT_TRANSLATE_NOOP("LogMark", "Emergency stop sent"),
    "resume_sent": QT_TRANSLATE_NOOP("LogMark", "Resume sent"),
    "enable_sent": QT_TRANSLATE_NOOP("LogMark", "Motors: enable sent"),
    "disable_sent": QT_TRANSLATE_NOOP("LogMark", "Motors: disable sent"),
    "motion_command": QT_TRANSLATE_NOOP("LogMark", "Trajectory or drag teaching command sent"),
    "silent": QT_TRANSLATE_NOOP("LogMark", "Nothing heard of the arm"),
    "no_communication": QT_TRANSLATE_NOOP("LogMark", "J{joint}: no communication"),
    "beyond_limit": QT_TRANSLATE_NOOP("LogMark", "J{joint}: beyond its angle limit"),
}
_TARGETS: Final[Mapping[str, object]] = {
    "JointTarget12": QT_TRANSLATE_NOOP("LogMark", "Joint targets begin"),
    "CartesianTarget1": QT_TRANSLATE_NOOP("LogMark", "Pose targets begin"),
    "MitControl1": QT_TRANSLATE_NOOP("LogMark", "MIT control begins"),
    "GripperCommand": QT_TRANSLATE_NOOP("LogMark", "Gripper commands begin"),
}
_JOINT: Final[Mapping[str, object]] = {
    "Undervoltage": QT_TRANSLATE_NOOP("LogMark", "J{joint}: supply voltage too low"),
    "MotorOvertemperature": QT_TRANSLATE_NOOP("LogMark", "J{joint}: motor too hot"),
    "Overcurrent": QT_TRANSLATE_NOOP("LogMark", "J{joint}: driver overcurrent"),
    "DriverOvertemperature": QT_TRANSLATE_NOOP("LogMark", "J{joint}: driver too hot"),
    "SensorFault": QT_TRANSLATE_NOOP("LogMark", "J{joint}: sensor abnormal"),
    "CollisionProtection": QT_TRANSLATE_NOOP("LogMark", "J{joint}: collision protection"),
    "DriverFault": QT_TRANSLATE_NOOP("LogMark", "J{joint}: driver error"),
    "StallProtection": QT_TRANSLATE_NOOP("LogMark", "J{joint}: stall protection"),
}


def log_mark(mark: SessionMark) -> str:
    """What happened at a mark, in the operator's language."""
    entry = dict(mark.entry)
    code, what = str(entry.get("code", "")), str(entry.get("what", ""))
    if isinstance(entry.get("status"), int):
        entry["status"] = status.arm_status(int(str(entry["status"])))
    source = _MARKS.get(code)
    if code == "joint":
        source = _JOINT.get(what)
    elif code == "target":
        source = _TARGETS.get(str(entry.get("message", "")))
    return sentence("LogMark", source, entry) if source is not None else code
