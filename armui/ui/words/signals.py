"""Signals on the bus and their codes in words; the DBC files have them in English."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QT_TRANSLATE_NOOP, QCoreApplication

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
    "ClearError": "Clear error",
    "CollisionProtection": "Collision protection",
    "Command": "Command",
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

_WORDS: Final = (
    QT_TRANSLATE_NOOP("SignalWord", "Abort"),
    QT_TRANSLATE_NOOP("SignalWord", "Acceleration"),
    QT_TRANSLATE_NOOP("SignalWord", "Acceleration limit"),
    QT_TRANSLATE_NOOP("SignalWord", "All joints"),
    QT_TRANSLATE_NOOP("SignalWord", "All lamps"),
    QT_TRANSLATE_NOOP("SignalWord", "Angle"),
    QT_TRANSLATE_NOOP("SignalWord", "Angle and speed limits"),
    QT_TRANSLATE_NOOP("SignalWord", "Answer"),
    QT_TRANSLATE_NOOP("SignalWord", "Beyond limit"),
    QT_TRANSLATE_NOOP("SignalWord", "Both to zero"),
    QT_TRANSLATE_NOOP("SignalWord", "Brake resistor too hot"),
    QT_TRANSLATE_NOOP("SignalWord", "CAN control"),
    QT_TRANSLATE_NOOP("SignalWord", "Clear all"),
    QT_TRANSLATE_NOOP("SignalWord", "Clear current"),
    QT_TRANSLATE_NOOP("SignalWord", "Clear error"),
    QT_TRANSLATE_NOOP("SignalWord", "Collision"),
    QT_TRANSLATE_NOOP("SignalWord", "Collision levels"),
    QT_TRANSLATE_NOOP("SignalWord", "Continue"),
    QT_TRANSLATE_NOOP("SignalWord", "Deceleration"),
    QT_TRANSLATE_NOOP("SignalWord", "Disable"),
    QT_TRANSLATE_NOOP("SignalWord", "Disabled"),
    QT_TRANSLATE_NOOP("SignalWord", "Drag assistance"),
    QT_TRANSLATE_NOOP("SignalWord", "Emergency stop"),
    QT_TRANSLATE_NOOP("SignalWord", "Empty"),
    QT_TRANSLATE_NOOP("SignalWord", "Enable"),
    QT_TRANSLATE_NOOP("SignalWord", "Enabled"),
    QT_TRANSLATE_NOOP("SignalWord", "End"),
    QT_TRANSLATE_NOOP("SignalWord", "End limits"),
    QT_TRANSLATE_NOOP("SignalWord", "End limits to factory"),
    QT_TRANSLATE_NOOP("SignalWord", "End of trajectory"),
    QT_TRANSLATE_NOOP("SignalWord", "Ethernet control"),
    QT_TRANSLATE_NOOP("SignalWord", "Fault"),
    QT_TRANSLATE_NOOP("SignalWord", "Full"),
    QT_TRANSLATE_NOOP("SignalWord", "Get current"),
    QT_TRANSLATE_NOOP("SignalWord", "Half"),
    QT_TRANSLATE_NOOP("SignalWord", "Ignore"),
    QT_TRANSLATE_NOOP("SignalWord", "Joint brake closed"),
    QT_TRANSLATE_NOOP("SignalWord", "Joint communication fault"),
    QT_TRANSLATE_NOOP("SignalWord", "Joint limits to factory"),
    QT_TRANSLATE_NOOP("SignalWord", "Joint status abnormal"),
    QT_TRANSLATE_NOOP("SignalWord", "Large gripper"),
    QT_TRANSLATE_NOOP("SignalWord", "Leader and follower"),
    QT_TRANSLATE_NOOP("SignalWord", "Leader to zero"),
    QT_TRANSLATE_NOOP("SignalWord", "Leave silence"),
    QT_TRANSLATE_NOOP("SignalWord", "Leave unchanged"),
    QT_TRANSLATE_NOOP("SignalWord", "Level"),
    QT_TRANSLATE_NOOP("SignalWord", "Linked teaching input"),
    QT_TRANSLATE_NOOP("SignalWord", "MIT"),
    QT_TRANSLATE_NOOP("SignalWord", "MOVE C"),
    QT_TRANSLATE_NOOP("SignalWord", "MOVE CPV"),
    QT_TRANSLATE_NOOP("SignalWord", "MOVE J"),
    QT_TRANSLATE_NOOP("SignalWord", "MOVE L"),
    QT_TRANSLATE_NOOP("SignalWord", "MOVE M"),
    QT_TRANSLATE_NOOP("SignalWord", "MOVE M from 1.8-8"),
    QT_TRANSLATE_NOOP("SignalWord", "MOVE P"),
    QT_TRANSLATE_NOOP("SignalWord", "Main controller too hot"),
    QT_TRANSLATE_NOOP("SignalWord", "Middle"),
    QT_TRANSLATE_NOOP("SignalWord", "Motion output"),
    QT_TRANSLATE_NOOP("SignalWord", "Move to start"),
    QT_TRANSLATE_NOOP("SignalWord", "No"),
    QT_TRANSLATE_NOOP("SignalWord", "No action"),
    QT_TRANSLATE_NOOP("SignalWord", "No change"),
    QT_TRANSLATE_NOOP("SignalWord", "No offset"),
    QT_TRANSLATE_NOOP("SignalWord", "No solution"),
    QT_TRANSLATE_NOOP("SignalWord", "None"),
    QT_TRANSLATE_NOOP("SignalWord", "Normal"),
    QT_TRANSLATE_NOOP("SignalWord", "Not given"),
    QT_TRANSLATE_NOOP("SignalWord", "Not reached"),
    QT_TRANSLATE_NOOP("SignalWord", "Not set"),
    QT_TRANSLATE_NOOP("SignalWord", "Off"),
    QT_TRANSLATE_NOOP("SignalWord", "Offline trajectory"),
    QT_TRANSLATE_NOOP("SignalWord", "Offset 0x10"),
    QT_TRANSLATE_NOOP("SignalWord", "Offset 0x20"),
    QT_TRANSLATE_NOOP("SignalWord", "On"),
    QT_TRANSLATE_NOOP("SignalWord", "On the left side"),
    QT_TRANSLATE_NOOP("SignalWord", "On the right side"),
    QT_TRANSLATE_NOOP("SignalWord", "Opening"),
    QT_TRANSLATE_NOOP("SignalWord", "Other fault"),
    QT_TRANSLATE_NOOP("SignalWord", "Overspeed while teaching"),
    QT_TRANSLATE_NOOP("SignalWord", "Pause"),
    QT_TRANSLATE_NOOP("SignalWord", "Position Kp"),
    QT_TRANSLATE_NOOP("SignalWord", "Position target"),
    QT_TRANSLATE_NOOP("SignalWord", "Position-velocity"),
    QT_TRANSLATE_NOOP("SignalWord", "Profile speed"),
    QT_TRANSLATE_NOOP("SignalWord", "Reached"),
    QT_TRANSLATE_NOOP("SignalWord", "Read"),
    QT_TRANSLATE_NOOP("SignalWord", "Received"),
    QT_TRANSLATE_NOOP("SignalWord", "Remote control"),
    QT_TRANSLATE_NOOP("SignalWord", "Resume"),
    QT_TRANSLATE_NOOP("SignalWord", "Run recording"),
    QT_TRANSLATE_NOOP("SignalWord", "Send again"),
    QT_TRANSLATE_NOOP("SignalWord", "Set"),
    QT_TRANSLATE_NOOP("SignalWord", "Set zero"),
    QT_TRANSLATE_NOOP("SignalWord", "Silence for controller upgrade"),
    QT_TRANSLATE_NOOP("SignalWord", "Silence for driver upgrade"),
    QT_TRANSLATE_NOOP("SignalWord", "Singularity"),
    QT_TRANSLATE_NOOP("SignalWord", "Small gripper"),
    QT_TRANSLATE_NOOP("SignalWord", "Speed Ki"),
    QT_TRANSLATE_NOOP("SignalWord", "Speed Kp"),
    QT_TRANSLATE_NOOP("SignalWord", "Speed target"),
    QT_TRANSLATE_NOOP("SignalWord", "Standby"),
    QT_TRANSLATE_NOOP("SignalWord", "Start"),
    QT_TRANSLATE_NOOP("SignalWord", "Start recording"),
    QT_TRANSLATE_NOOP("SignalWord", "Stop recording"),
    QT_TRANSLATE_NOOP("SignalWord", "Take over"),
    QT_TRANSLATE_NOOP("SignalWord", "Target beyond limit"),
    QT_TRANSLATE_NOOP("SignalWord", "Teaching"),
    QT_TRANSLATE_NOOP("SignalWord", "Teaching input"),
    QT_TRANSLATE_NOOP("SignalWord", "Teaching paused"),
    QT_TRANSLATE_NOOP("SignalWord", "Teaching recording"),
    QT_TRANSLATE_NOOP("SignalWord", "Teaching running"),
    QT_TRANSLATE_NOOP("SignalWord", "Teaching setting"),
    QT_TRANSLATE_NOOP("SignalWord", "Trajectory index"),
    QT_TRANSLATE_NOOP("SignalWord", "Transfer"),
    QT_TRANSLATE_NOOP("SignalWord", "Transfer ends"),
    QT_TRANSLATE_NOOP("SignalWord", "Unchanged"),
    QT_TRANSLATE_NOOP("SignalWord", "Upside down"),
    QT_TRANSLATE_NOOP("SignalWord", "Valid"),
    QT_TRANSLATE_NOOP("SignalWord", "WiFi control"),
    QT_TRANSLATE_NOOP("SignalWord", "Within"),
    QT_TRANSLATE_NOOP("SignalWord", "Write"),
    QT_TRANSLATE_NOOP("SignalWord", "Yes"),
    QT_TRANSLATE_NOOP("SignalWord", "Zero learning"),
)
"""The words of the value tables, as the DBC files have them."""

_KNOWN_WORDS: Final = frozenset(str(word) for word in _WORDS)

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
        beyond = found[2] == "LimitExceeded"
        text = (
            QCoreApplication.translate("SignalName", "J{joint} limit")
            if beyond
            else QCoreApplication.translate("SignalName", "J{joint} communication")
        )
        return text.format(joint=found[1])
    if found := _BYTE.fullmatch(signal):
        return QCoreApplication.translate("SignalName", "Byte {place}").format(place=found[1])
    return signal


def signal_word(word: str) -> str:
    """A word of a value table in the operator's language."""
    if found := _JOINT.fullmatch(word):
        return f"J{found[1]}"
    if word in _KNOWN_WORDS:
        return QCoreApplication.translate("SignalWord", word)
    return message_name(word)  # 0x476 names the message that it answers


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
