"""The gripper in words: its figures, what is done to it, what it complains of."""

from __future__ import annotations

from typing import Final

from armui.arm.state import GripperFault
from armui.protocol.codes import EndLoad
from armui.ui.words.text import Texts

_FIGURES: Final = Texts("GripperFigure") | {
    "opening": "Opening",
    "torque": "Torque",
    "angle": "Angle",
    "speed": "Speed",
}

_ACTS: Final = Texts("GripperAct") | {
    "enable": "Enable",
    "disable": "Disable",
    "clear": "Clear error",
    "zero": "Set zero",
}

_FAULTS: Final = Texts("GripperFault") | {
    GripperFault.UNDERVOLTAGE: "supply voltage too low",
    GripperFault.MOTOR_OVERTEMPERATURE: "motor too hot",
    GripperFault.OVERCURRENT: "driver overcurrent",
    GripperFault.DRIVER_OVERTEMPERATURE: "driver too hot",
    GripperFault.SENSOR: "sensor abnormal",
    GripperFault.DRIVER: "driver error",
}


_LOADS: Final = Texts("EndLoad") | {
    EndLoad.EMPTY: "No load",
    EndLoad.HALF: "Half load",
    EndLoad.FULL: "Full load",
    EndLoad.NOT_GIVEN: "Not given",
}


def end_load(load: EndLoad) -> str:
    """What the arm carries («半载»)."""
    return _LOADS.text(load)


def gripper_figure(name: str) -> str:
    """What a figure of the gripper's command is called («开度»)."""
    return _FIGURES.word(name)


def gripper_act(name: str) -> str:
    """What is done to the gripper («清除错误»)."""
    return _ACTS.word(name)


def gripper_fault(fault: GripperFault) -> str:
    """What its driver complains of («电机过温»)."""
    return _FAULTS.text(fault)
