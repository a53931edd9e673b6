"""Signals on the bus and their codes in words; the DBC files have them in English."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QT_TRANSLATE_NOOP, QCoreApplication

from armui.ui import format as fmt
from armui.ui.words.messages import message_name
from armui.ui.words.text import sentence

if TYPE_CHECKING:
    from armui.protocol.layout import SignalLayout

_SIGNALS: Final[Mapping[str, object]] = {
    "Acceleration": QT_TRANSLATE_NOOP("SignalName", "Acceleration"),
    "AccelerationValid": QT_TRANSLATE_NOOP("SignalName", "Acceleration valid"),
    "Action": QT_TRANSLATE_NOOP("SignalName", "Action"),
    "Angle": QT_TRANSLATE_NOOP("SignalName", "Angle"),
    "AngularAcceleration": QT_TRANSLATE_NOOP("SignalName", "Angular acceleration"),
    "AngularSpeed": QT_TRANSLATE_NOOP("SignalName", "Angular speed"),
    "Blue": QT_TRANSLATE_NOOP("SignalName", "Blue"),
    "BusCurrent": QT_TRANSLATE_NOOP("SignalName", "Supply current"),
    "ClearError": QT_TRANSLATE_NOOP("SignalName", "Clear error"),
    "CollisionProtection": QT_TRANSLATE_NOOP("SignalName", "Collision protection"),
    "Command": QT_TRANSLATE_NOOP("SignalName", "Command"),
    "ControlMode": QT_TRANSLATE_NOOP("SignalName", "Control mode"),
    "ControlOffset": QT_TRANSLATE_NOOP("SignalName", "Offset of the commands"),
    "Counter": QT_TRANSLATE_NOOP("SignalName", "Counter"),
    "Crc16": QT_TRANSLATE_NOOP("SignalName", "Check sum (CRC16)"),
    "Crc4": QT_TRANSLATE_NOOP("SignalName", "Check sum (4 bits)"),
    "Current": QT_TRANSLATE_NOOP("SignalName", "Current"),
    "Deceleration": QT_TRANSLATE_NOOP("SignalName", "Deceleration"),
    "DriverFault": QT_TRANSLATE_NOOP("SignalName", "Driver fault"),
    "DriverOvertemperature": QT_TRANSLATE_NOOP("SignalName", "Driver too hot"),
    "DriverTemperature": QT_TRANSLATE_NOOP("SignalName", "Driver temperature"),
    "DwellTime": QT_TRANSLATE_NOOP("SignalName", "Dwell time"),
    "EmergencyStop": QT_TRANSLATE_NOOP("SignalName", "Emergency stop"),
    "Enable": QT_TRANSLATE_NOOP("SignalName", "Enable"),
    "Enabled": QT_TRANSLATE_NOOP("SignalName", "Enabled"),
    "EndFeedback": QT_TRANSLATE_NOOP("SignalName", "Feedback of the end's motion"),
    "FeedbackOffset": QT_TRANSLATE_NOOP("SignalName", "Offset of the feedback"),
    "Friction": QT_TRANSLATE_NOOP("SignalName", "Friction"),
    "Green": QT_TRANSLATE_NOOP("SignalName", "Green"),
    "Homed": QT_TRANSLATE_NOOP("SignalName", "Zero found"),
    "Index": QT_TRANSLATE_NOOP("SignalName", "Answers"),
    "Joint": QT_TRANSLATE_NOOP("SignalName", "Joint"),
    "Kd": QT_TRANSLATE_NOOP("SignalName", "Kd"),
    "Kind": QT_TRANSLATE_NOOP("SignalName", "Kind"),
    "Kp": QT_TRANSLATE_NOOP("SignalName", "Kp"),
    "Lamp": QT_TRANSLATE_NOOP("SignalName", "Lamp"),
    "LinearAcceleration": QT_TRANSLATE_NOOP("SignalName", "Linear acceleration"),
    "LinearSpeed": QT_TRANSLATE_NOOP("SignalName", "Linear speed"),
    "Load": QT_TRANSLATE_NOOP("SignalName", "Load"),
    "LoadValid": QT_TRANSLATE_NOOP("SignalName", "Load valid"),
    "MaxAcceleration": QT_TRANSLATE_NOOP("SignalName", "Highest acceleration"),
    "MaxAngle": QT_TRANSLATE_NOOP("SignalName", "Largest angle"),
    "MaxAngularAcceleration": QT_TRANSLATE_NOOP("SignalName", "Highest angular acceleration"),
    "MaxAngularSpeed": QT_TRANSLATE_NOOP("SignalName", "Highest angular speed"),
    "MaxLinearAcceleration": QT_TRANSLATE_NOOP("SignalName", "Highest linear acceleration"),
    "MaxLinearSpeed": QT_TRANSLATE_NOOP("SignalName", "Highest linear speed"),
    "MaxSpeed": QT_TRANSLATE_NOOP("SignalName", "Highest speed"),
    "Measure": QT_TRANSLATE_NOOP("SignalName", "Told as"),
    "MinAngle": QT_TRANSLATE_NOOP("SignalName", "Smallest angle"),
    "MitMode": QT_TRANSLATE_NOOP("SignalName", "Follow mode"),
    "Mode": QT_TRANSLATE_NOOP("SignalName", "Mode"),
    "MotionState": QT_TRANSLATE_NOOP("SignalName", "Target"),
    "MotorOvertemperature": QT_TRANSLATE_NOOP("SignalName", "Motor too hot"),
    "MotorTemperature": QT_TRANSLATE_NOOP("SignalName", "Motor temperature"),
    "Mounting": QT_TRANSLATE_NOOP("SignalName", "Mounting"),
    "MoveMode": QT_TRANSLATE_NOOP("SignalName", "Move mode"),
    "NameIndex": QT_TRANSLATE_NOOP("SignalName", "Index of the name"),
    "Opening": QT_TRANSLATE_NOOP("SignalName", "Opening"),
    "Overcurrent": QT_TRANSLATE_NOOP("SignalName", "Overcurrent"),
    "Point": QT_TRANSLATE_NOOP("SignalName", "Point"),
    "Position": QT_TRANSLATE_NOOP("SignalName", "Position"),
    "PositionKp": QT_TRANSLATE_NOOP("SignalName", "Position loop Kp"),
    "PositionTarget": QT_TRANSLATE_NOOP("SignalName", "Target position"),
    "ProfileSpeed": QT_TRANSLATE_NOOP("SignalName", "Profile speed"),
    "Query": QT_TRANSLATE_NOOP("SignalName", "Question"),
    "Red": QT_TRANSLATE_NOOP("SignalName", "Red"),
    "Reset": QT_TRANSLATE_NOOP("SignalName", "Factory reset"),
    "Role": QT_TRANSLATE_NOOP("SignalName", "Role"),
    "SensorFault": QT_TRANSLATE_NOOP("SignalName", "Sensor fault"),
    "SetZero": QT_TRANSLATE_NOOP("SignalName", "Set zero"),
    "Speed": QT_TRANSLATE_NOOP("SignalName", "Speed"),
    "SpeedKi": QT_TRANSLATE_NOOP("SignalName", "Speed loop Ki"),
    "SpeedKp": QT_TRANSLATE_NOOP("SignalName", "Speed loop Kp"),
    "SpeedPercent": QT_TRANSLATE_NOOP("SignalName", "Speed percentage"),
    "SpeedTarget": QT_TRANSLATE_NOOP("SignalName", "Target speed"),
    "StallProtection": QT_TRANSLATE_NOOP("SignalName", "Stall protection"),
    "Status": QT_TRANSLATE_NOOP("SignalName", "Status"),
    "StrokeLimit": QT_TRANSLATE_NOOP("SignalName", "Stroke"),
    "TargetOffset": QT_TRANSLATE_NOOP("SignalName", "Offset of what a leader sends"),
    "TeachingCommand": QT_TRANSLATE_NOOP("SignalName", "Teaching command"),
    "TeachingRange": QT_TRANSLATE_NOOP("SignalName", "Range of the handle"),
    "TeachingState": QT_TRANSLATE_NOOP("SignalName", "Teaching state"),
    "Torque": QT_TRANSLATE_NOOP("SignalName", "Torque"),
    "TrajectoryCommand": QT_TRANSLATE_NOOP("SignalName", "Trajectory command"),
    "TrajectoryPoint": QT_TRANSLATE_NOOP("SignalName", "Trajectory point"),
    "Transfer": QT_TRANSLATE_NOOP("SignalName", "Transfer"),
    "Undervoltage": QT_TRANSLATE_NOOP("SignalName", "Voltage too low"),
    "Velocity": QT_TRANSLATE_NOOP("SignalName", "Speed"),
    "Voltage": QT_TRANSLATE_NOOP("SignalName", "Voltage"),
    "ZeroLearning": QT_TRANSLATE_NOOP("SignalName", "Zero learning"),
    "ZeroSet": QT_TRANSLATE_NOOP("SignalName", "Zero"),
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
    source = _SIGNALS.get(signal)
    if source is not None:
        return sentence("SignalName", source, {})
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
