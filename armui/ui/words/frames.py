"""The names of frames on the bus, their senders, and their faults."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QT_TRANSLATE_NOOP, QCoreApplication

from armui.control.safety.hand_frame import FrameEffect, is_upgrade
from armui.protocol.codec import InvalidFrameKind
from armui.protocol.frame import FrameFlag
from armui.telemetry.bus_errors import BusError
from armui.telemetry.bus_senders import Sender
from armui.ui import format as fmt
from armui.ui.words.text import Texts, sentence

if TYPE_CHECKING:
    from armui.protocol.codec import Codec, InvalidFrame
    from armui.protocol.layout import SignalLayout


_SENDERS: Final = Texts("Sender") | {
    Sender.ARM: "arm",
    Sender.OWN: "this program",
    Sender.OTHER: "another host",
    Sender.OTHER_ARM: "another arm",
    Sender.ADAPTER: "adapter",
    Sender.UNKNOWN: "not known",
}

_ERRORS: Final = Texts("BusError") | {
    BusError.SEND_TIMEOUT: "a frame could not be sent in time",
    BusError.ARBITRATION_LOST: (
        "arbitration lost: a frame of higher priority went first, which is normal"
    ),
    BusError.CONTROLLER: "the adapter's CAN controller reports",
    BusError.RECEIVE_OVERFLOW: (
        "the adapter has lost frames: too slow for this bus, or its USB port is"
    ),
    BusError.SEND_OVERFLOW: "the adapter has lost frames to be sent",
    BusError.MANY_ERRORS: "many errors: check the cable and both terminating resistors (120 Ω)",
    BusError.ERROR_PASSIVE: (
        "error passive: check CAN_H and CAN_L, both terminating resistors and the bit rate"
    ),
    BusError.ERROR_ACTIVE: "there are few errors again",
    BusError.PROTOCOL: "disturbed frame: check the cable, its shield, and the bit rate",
    BusError.TRANSCEIVER: "transceiver: check CAN_H and CAN_L for a short or an open line",
    BusError.NO_ACKNOWLEDGE: (
        "nobody acknowledges: check the arm's power, the cable and the bit rate"
    ),
    BusError.BUS_OFF: (
        "bus off: too many errors, the adapter has left the bus. Check the cable, both "
        "terminating resistors (120 Ω) and the bit rate, then connect again"
    ),
    BusError.BUS_ERROR: "error on the bus: check the cable",
    BusError.RESTARTED: "the adapter has rejoined the bus",
}
_MESSAGES: Final = Texts("FrameName") | {
    "LightControl": "Lamp of a joint",
    "MotionCommand": "Stop, trajectory and teaching command",
    "ModeControl": "Control mode, kind of motion, speed",
    "CartesianTarget1": "Target X, Y",
    "CartesianTarget2": "Target Z, RX",
    "CartesianTarget3": "Target RY, RZ",
    "JointTarget12": "Target angles J1, J2",
    "JointTarget34": "Target angles J3, J4",
    "JointTarget56": "Target angles J5, J6",
    "ArcPoint": "Point of the arc",
    "GripperCommand": "Gripper command",
    "MitControl": "MIT setpoint of J{joint}",
    "CpvControl": "CPV of J{joint}",
    "CpvGripper": "CPV of the gripper",
    "LeaderZero": "Leader arm to zero",
    "DriverFast": "Driver of J{joint}, fast values",
    "DriverSlow": "Driver of J{joint}, slow values",
    "ArmStatus": "Arm status",
    "EndPose1": "End pose X, Y",
    "EndPose2": "End pose Z, RX",
    "EndPose3": "End pose RY, RZ",
    "JointFeedback12": "Angles of J1, J2",
    "JointFeedback34": "Angles of J3, J4",
    "JointFeedback56": "Angles of J5, J6",
    "GripperFeedback": "Gripper",
    "IkSolution12": "Solution of the pose J1, J2",
    "IkSolution34": "Solution of the pose J3, J4",
    "IkSolution56": "Solution of the pose J5, J6",
    "BusSilence": "Bus silence",
    "LinkageSetting": "Linkage setting",
    "MotorEnable": "Motors on and off",
    "LimitQuery": "Question: limits of a joint",
    "LimitFeedback": "Answer: angle and speed limits",
    "LimitSetting": "Setting: angle and speed limits",
    "JointSetting": "Setting of a joint",
    "SettingResponse": "Answer to a setting",
    "ParameterCommand": "Parameter question and command",
    "EndLimitFeedback": "Answer: limits of the end",
    "EndLimitSetting": "Setting: limits of the end",
    "CollisionSetting": "Setting: collision levels",
    "CollisionFeedback": "Answer: collision levels",
    "AccelerationFeedback": "Answer: acceleration limit",
    "TeachingSetting": "Setting: teaching handle, gripper",
    "TeachingFeedback": "Answer: teaching handle, gripper",
    "DragAssistanceSetting": "Setting: drag assistance",
    "DragAssistanceFeedback": "Answer: drag assistance",
    "EndMotion": "End motion, part of J{joint}",
    "FirmwareVersion": "Firmware version",
}
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
    "Measure": "Given as",
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
_EFFECTS: Final = Texts("FrameEffect") | {
    FrameEffect.HARMLESS: "A question or a lamp: nothing moves. A press sends it.",
    FrameEffect.ENDS: "The motion under way ends or pauses; the joints keep their power.",
    FrameEffect.SINKS: (
        "An emergency stop: the motors only brake and the arm sinks. Hold it. The stop button "
        "above is faster, reaches every identifier and is repeated until the arm confirms."
    ),
    FrameEffect.DROPS: (
        "Motors lose their power and there are no brakes: the ARM DROPS. Hold the arm."
    ),
    FrameEffect.LIMP: (
        "The joints go limp until their next setpoint: the ARM FALLS unless setpoints follow at "
        "once. Support the arm. Only a reset leads back from there."
    ),
    FrameEffect.DIRECT: (
        "Drives one motor past the arm's own planning and limits. With gains of 0 its joint has "
        "no strength and falls. Support the arm, keep away from it."
    ),
    FrameEffect.MOVES: "The arm may set out at once, without any check. Keep away from it.",
    FrameEffect.GRIPPER: (
        "The gripper may close, open or lose its power and let go, without any check. Keep your "
        "fingers away."
    ),
    FrameEffect.HAND: (
        "The joints give way to a hand, and sink if the load is not set. Hold the arm."
    ),
    FrameEffect.POWER: "Motors get their power: joints may jerk. Keep away from the arm.",
    FrameEffect.ROLE: (
        "Changes whether the arm leads or follows, or its identifiers. It is kept when the arm is "
        "switched off, and the arm may fall silent to this program."
    ),
    FrameEffect.SETTING: (
        "Changes something the arm keeps, also when it is switched off: zeros, limits, levels or "
        "the load. Read it anew in its panel afterwards."
    ),
    FrameEffect.SILENCE: (
        "The arm is told to say nothing: nobody sees what it does until it is told to speak again "
        "or is switched off and on."
    ),
    FrameEffect.UNKNOWN: (
        "No public text says what this frame does. Expect anything: support the arm, keep away "
        "from it."
    ),
}


def frame_effect(effect: FrameEffect) -> str:
    """Return the physical effect of a frame, as a sentence before it is sent."""
    return _EFFECTS.text(effect)


def message_name(message: str) -> str:
    """Return the name of a message of the DBC files."""
    family, joint = message[:-1], message[-1:]
    if message not in _MESSAGES and family in _MESSAGES:
        return _MESSAGES.text(family, {"joint": joint})
    return _MESSAGES.word(message)


def frame_sender(sender: Sender, *, leader: bool = False) -> str:
    """Return the sender of a frame in words.

    Args:
        sender: The sender by its identifier.
        leader: True if the other host is known to be a leader arm (0x470).
    """
    if leader and sender is Sender.OTHER:
        return QCoreApplication.translate("Sender", "leader arm")
    return _SENDERS.text(sender)


def frame_id(arbitration_id: int, flags: int) -> str:
    """Return an identifier in its usual form: three digits, eight for one of 29 bits."""
    kind = flags & (FrameFlag.EXTENDED | FrameFlag.ERROR)
    return f"0x{arbitration_id:0{8 if kind == FrameFlag.EXTENDED else 3}X}"


def frame_kind(arbitration_id: int, flags: int, codec: Codec | None) -> str:
    """Return the name of a frame that is no message of the protocol."""
    if flags & FrameFlag.ERROR:
        return QCoreApplication.translate("FrameKind", "Error frame of the adapter")
    if flags & FrameFlag.REMOTE:
        return QCoreApplication.translate("FrameKind", "Remote frame: a question without data")
    if flags & FrameFlag.FD:
        return QCoreApplication.translate("FrameKind", "CAN FD frame: the arm speaks classic CAN")
    if flags & FrameFlag.EXTENDED:
        return QCoreApplication.translate("FrameKind", "29-bit identifier: the arm uses none")
    if is_upgrade(arbitration_id):
        return QCoreApplication.translate("FrameKind", "Firmware upgrade: not documented")
    if codec is not None and codec.addressing.from_wire(arbitration_id) is None:
        return QCoreApplication.translate("FrameKind", "Of an arm with other identifiers (0x470)")
    return QCoreApplication.translate("FrameKind", "Unknown: not in the tables of this arm")


def bus_errors(errors: tuple[BusError, ...]) -> str:
    """Return the meaning of an error frame, with the remedy."""
    if not errors:
        return QCoreApplication.translate("BusError", "the adapter gives no further details")
    return "; ".join(_ERRORS.text(e) for e in errors)


def why_invalid(invalid: InvalidFrame, length: int, codec: Codec) -> str:
    """Return the fault of a frame that has a message's identifier.

    Args:
        invalid: The codec's finding.
        length: The length of its payload.
        codec: The codec.
    """
    layout = codec.layout(invalid.arbitration_id)
    if layout is None:
        return frame_kind(invalid.arbitration_id, 0, codec)
    if invalid.kind is InvalidFrameKind.WRONG_LENGTH:
        source = QT_TRANSLATE_NOOP("InvalidFrame", "{count} bytes instead of {wanted}")
        wanted = " / ".join(str(each) for each in layout.lengths)
        return sentence("InvalidFrame", source, {"count": length, "wanted": wanted})
    if invalid.message is None:
        return QCoreApplication.translate("InvalidFrame", "it names a joint that no arm has")
    values = invalid.message.signals
    odd = [
        f"{signal_name(name)} = {values[name]:.10g}"
        for name, legal in layout.checked
        if name in values
        if round(layout.signals[name].to_steps(values[name])) not in legal
    ]
    source = QT_TRANSLATE_NOOP("InvalidFrame", "outside its table: {signals}")
    return sentence("InvalidFrame", source, {"signals": ", ".join(odd)})


def signal_name(signal: str) -> str:
    """Return the name of a signal of the DBC files; J1, X, RX are the same in any language."""
    if signal in _SIGNALS:
        return _SIGNALS.text(signal)
    if found := _OF_JOINT.fullmatch(signal):
        return _SIGNALS.text(found[2], {"joint": found[1]})
    if found := _BYTE.fullmatch(signal):
        return _SIGNALS.text("Byte", {"place": found[1]})
    return signal


def signal_word(word: str) -> str:
    """Return a word of the DBC files' value tables in the operator's language."""
    if found := _JOINT.fullmatch(word):
        return f"J{found[1]}"
    name = message_name(word)  # 0x476 names the message that it answers
    return QCoreApplication.translate("SignalWord", word) if name == word else name


def signal_value(signal: SignalLayout, value: float) -> str:
    """Return a value with its unit, or a code as its word."""
    word = signal.words.get(round(signal.to_steps(value))) if signal.words else None
    if word is not None:
        return f"{signal_word(word)} ({value:g})"
    decimals = 0
    if signal.is_scaled:
        decimals = min(max(0, math.ceil(-math.log10(signal.scale))), _MOST_DECIMALS)
    unit = _UNITS.get(signal.unit, signal.unit)
    return fmt.with_unit(value, unit, decimals)
