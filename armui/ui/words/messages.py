"""What the messages of the protocol are called."""

from __future__ import annotations

from typing import Final

from armui.ui.words.text import Texts

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


def message_name(message: str) -> str:
    """What a message of the DBC files is called."""
    family, joint = message[:-1], message[-1:]
    if message not in _MESSAGES and family in _MESSAGES:
        return _MESSAGES.text(family, {"joint": joint})
    return _MESSAGES.word(message)
