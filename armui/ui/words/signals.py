"""Signals on the bus and their codes in words; the DBC files have them in English."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QCoreApplication

from armui.ui import format as fmt
from armui.ui.words.messages import message_name
from armui.ui.words.text import Texts

if TYPE_CHECKING:
    from armui.protocol.layout import SignalLayout

_SIGNALS: Final = Texts("SignalName") | {
    "Acceleration": "Acceleration",
    "AccelerationValid": "Acceleration valid",
    "Action": "Action",
    "Angle": "Angle",
    "AngularAcceleration": "Angular acceleration",
    "AngularSpeed": "Angular speed",
    "Blue": "Blue",
    "BusCurrent": "Supply current",
    "Byte": "Byte {place}",
    "ClearError": "Clear error",
    "CollisionProtection": "Collision protection",
    "Command": "Command",
    "CommunicationFault": "J{joint} communication",
    "ControlMode": "Control mode",
    "ControlOffset": "Offset of the commands",
    "Counter": "Counter",
    "Crc16": "Check sum (CRC16)",
    "Crc4": "Check sum (4 bits)",
    "Current": "Current",
    "Deceleration": "Deceleration",
    "DriverFault": "Driver fault",
    "DriverOvertemperature": "Driver too hot",
    "DriverTemperature": "Driver temperature",
    "DwellTime": "Dwell time",
    "EmergencyStop": "Emergency stop",
    "Enable": "Enable",
    "Enabled": "Enabled",
    "EndFeedback": "Feedback of the end's motion",
    "FeedbackOffset": "Offset of the feedback",
    "Friction": "Friction",
    "Green": "Green",
    "Homed": "Zero found",
    "Index": "Answers",
    "Joint": "Joint",
    "Kd": "Kd",
    "Kind": "Kind",
    "Kp": "Kp",
    "Lamp": "Lamp",
    "LimitExceeded": "J{joint} limit",
    "LinearAcceleration": "Linear acceleration",
    "LinearSpeed": "Linear speed",
    "Load": "Load",
    "LoadValid": "Load valid",
    "MaxAcceleration": "Highest acceleration",
    "MaxAngle": "Largest angle",
    "MaxAngularAcceleration": "Highest angular acceleration",
    "MaxAngularSpeed": "Highest angular speed",
    "MaxLinearAcceleration": "Highest linear acceleration",
    "MaxLinearSpeed": "Highest linear speed",
    "MaxSpeed": "Highest speed",
    "Measure": "Told as",
    "MinAngle": "Smallest angle",
    "MitMode": "Follow mode",
    "Mode": "Mode",
    "MotionState": "Target",
    "MotorOvertemperature": "Motor too hot",
    "MotorTemperature": "Motor temperature",
    "Mounting": "Mounting",
    "MoveMode": "Move mode",
    "NameIndex": "Index of the name",
    "Opening": "Opening",
    "Overcurrent": "Overcurrent",
    "Point": "Point",
    "Position": "Position",
    "PositionKp": "Position loop Kp",
    "PositionTarget": "Target position",
    "ProfileSpeed": "Profile speed",
    "Query": "Question",
    "Red": "Red",
    "Reset": "Factory reset",
    "Role": "Role",
    "SensorFault": "Sensor fault",
    "SetZero": "Set zero",
    "Speed": "Speed",
    "SpeedKi": "Speed loop Ki",
    "SpeedKp": "Speed loop Kp",
    "SpeedPercent": "Speed percentage",
    "SpeedTarget": "Target speed",
    "StallProtection": "Stall protection",
    "Status": "Status",
    "StrokeLimit": "Stroke",
    "TargetOffset": "Offset of what a leader sends",
    "TeachingCommand": "Teaching command",
    "TeachingRange": "Range of the handle",
    "TeachingState": "Teaching state",
    "Torque": "Torque",
    "TrajectoryCommand": "Trajectory command",
    "TrajectoryPoint": "Trajectory point",
    "Transfer": "Transfer",
    "Undervoltage": "Voltage too low",
    "Velocity": "Speed",
    "Voltage": "Voltage",
    "ZeroLearning": "Zero learning",
    "ZeroSet": "Zero",
}

_OF_JOINT: Final = re.compile(r"J([1-6])(LimitExceeded|CommunicationFault)")
_JOINT: Final = re.compile(r"Joint ([1-6])")
_BYTE: Final = re.compile(r"Byte([0-7])")
_UNITS: Final[Mapping[str, str]] = {
    "deg": "°",
    "degC": "°C",
    "N.m": "N·m",
    "rad/s^2": "rad/s²",
    "m/s^2": "m/s²",
}
_MOST_DECIMALS: Final = 4


def signal_name(signal: str) -> str:
    """What a signal of the DBC files is called; J1, X, RX are names in any language."""
    if signal in _SIGNALS:
        return _SIGNALS.text(signal)
    if found := _OF_JOINT.fullmatch(signal):
        return _SIGNALS.text(found[2], {"joint": found[1]})
    if found := _BYTE.fullmatch(signal):
        return _SIGNALS.text("Byte", {"place": found[1]})
    return signal


def signal_word(word: str) -> str:
    """A word of a value table of the DBC files in the operator's language."""
    if found := _JOINT.fullmatch(word):
        return f"J{found[1]}"
    name = message_name(word)  # 0x476 names the message that it answers
    return QCoreApplication.translate("SignalWord", word) if name == word else name


def signal_value(signal: SignalLayout, value: float) -> str:
    """A value with its unit, or a code with its word."""
    word = signal.words.get(round(signal.to_steps(value))) if signal.words else None
    if word is not None:
        return f"{signal_word(word)} ({value:g})"
    decimals = 0
    if signal.is_scaled:
        decimals = min(max(0, math.ceil(-math.log10(signal.scale))), _MOST_DECIMALS)
    unit = _UNITS.get(signal.unit, signal.unit)
    gap = "" if unit in {"", "°"} else " "
    return f"{fmt.number(value, decimals)}{gap}{unit}"
