"""What the messages of the protocol are called."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

from armui.ui.words.text import sentence

_MESSAGES: Final[Mapping[str, object]] = {
    "LightControl": QT_TRANSLATE_NOOP("FrameName", "Lamp of a joint"),
    "MotionCommand": QT_TRANSLATE_NOOP("FrameName", "Stop, trajectory and teaching command"),
    "ModeControl": QT_TRANSLATE_NOOP("FrameName", "Control mode, kind of motion, speed"),
    "CartesianTarget1": QT_TRANSLATE_NOOP("FrameName", "Target X, Y"),
    "CartesianTarget2": QT_TRANSLATE_NOOP("FrameName", "Target Z, RX"),
    "CartesianTarget3": QT_TRANSLATE_NOOP("FrameName", "Target RY, RZ"),
    "JointTarget12": QT_TRANSLATE_NOOP("FrameName", "Target angles J1, J2"),
    "JointTarget34": QT_TRANSLATE_NOOP("FrameName", "Target angles J3, J4"),
    "JointTarget56": QT_TRANSLATE_NOOP("FrameName", "Target angles J5, J6"),
    "ArcPoint": QT_TRANSLATE_NOOP("FrameName", "Point of the arc"),
    "GripperCommand": QT_TRANSLATE_NOOP("FrameName", "Gripper command"),
    "MitControl": QT_TRANSLATE_NOOP("FrameName", "MIT setpoint of J{joint}"),
    "CpvControl": QT_TRANSLATE_NOOP("FrameName", "CPV of J{joint}"),
    "CpvGripper": QT_TRANSLATE_NOOP("FrameName", "CPV of the gripper"),
    "LeaderZero": QT_TRANSLATE_NOOP("FrameName", "Leader arm to zero"),
    "DriverFast": QT_TRANSLATE_NOOP("FrameName", "Driver of J{joint}, fast values"),
    "DriverSlow": QT_TRANSLATE_NOOP("FrameName", "Driver of J{joint}, slow values"),
    "ArmStatus": QT_TRANSLATE_NOOP("FrameName", "Arm status"),
    "EndPose1": QT_TRANSLATE_NOOP("FrameName", "End pose X, Y"),
    "EndPose2": QT_TRANSLATE_NOOP("FrameName", "End pose Z, RX"),
    "EndPose3": QT_TRANSLATE_NOOP("FrameName", "End pose RY, RZ"),
    "JointFeedback12": QT_TRANSLATE_NOOP("FrameName", "Angles of J1, J2"),
    "JointFeedback34": QT_TRANSLATE_NOOP("FrameName", "Angles of J3, J4"),
    "JointFeedback56": QT_TRANSLATE_NOOP("FrameName", "Angles of J5, J6"),
    "GripperFeedback": QT_TRANSLATE_NOOP("FrameName", "Gripper"),
    "IkSolution12": QT_TRANSLATE_NOOP("FrameName", "Solution of the pose J1, J2"),
    "IkSolution34": QT_TRANSLATE_NOOP("FrameName", "Solution of the pose J3, J4"),
    "IkSolution56": QT_TRANSLATE_NOOP("FrameName", "Solution of the pose J5, J6"),
    "BusSilence": QT_TRANSLATE_NOOP("FrameName", "Bus silence"),
    "LinkageSetting": QT_TRANSLATE_NOOP("FrameName", "Linkage setting"),
    "MotorEnable": QT_TRANSLATE_NOOP("FrameName", "Motors on and off"),
    "LimitQuery": QT_TRANSLATE_NOOP("FrameName", "Question: limits of a joint"),
    "LimitFeedback": QT_TRANSLATE_NOOP("FrameName", "Answer: angle and speed limits"),
    "LimitSetting": QT_TRANSLATE_NOOP("FrameName", "Setting: angle and speed limits"),
    "JointSetting": QT_TRANSLATE_NOOP("FrameName", "Setting of a joint"),
    "SettingResponse": QT_TRANSLATE_NOOP("FrameName", "Answer to a setting"),
    "ParameterCommand": QT_TRANSLATE_NOOP("FrameName", "Parameter question and command"),
    "EndLimitFeedback": QT_TRANSLATE_NOOP("FrameName", "Answer: limits of the end"),
    "EndLimitSetting": QT_TRANSLATE_NOOP("FrameName", "Setting: limits of the end"),
    "CollisionSetting": QT_TRANSLATE_NOOP("FrameName", "Setting: collision levels"),
    "CollisionFeedback": QT_TRANSLATE_NOOP("FrameName", "Answer: collision levels"),
    "AccelerationFeedback": QT_TRANSLATE_NOOP("FrameName", "Answer: acceleration limit"),
    "TeachingSetting": QT_TRANSLATE_NOOP("FrameName", "Setting: teaching handle, gripper"),
    "TeachingFeedback": QT_TRANSLATE_NOOP("FrameName", "Answer: teaching handle, gripper"),
    "DragAssistanceSetting": QT_TRANSLATE_NOOP("FrameName", "Setting: drag assistance"),
    "DragAssistanceFeedback": QT_TRANSLATE_NOOP("FrameName", "Answer: drag assistance"),
    "EndMotion": QT_TRANSLATE_NOOP("FrameName", "End motion, part of J{joint}"),
    "FirmwareVersion": QT_TRANSLATE_NOOP("FrameName", "Firmware version"),
}


def message_name(message: str) -> str:
    """What a message of the DBC files is called."""
    source = _MESSAGES.get(message)
    if source is not None:
        return sentence("FrameName", source, {})
    family = _MESSAGES.get(message[:-1])
    return message if family is None else sentence("FrameName", family, {"joint": message[-1]})
