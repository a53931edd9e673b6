"""The gripper in words: its figures, what is done to it, what it complains of."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP, QCoreApplication

from armui.arm.gripper import GripperFault
from armui.protocol.codes import EndLoad
from armui.ui.words.text import sentence

_FIGURES: Final[Mapping[str, object]] = {
    "opening": QT_TRANSLATE_NOOP("GripperFigure", "Opening"),
    "torque": QT_TRANSLATE_NOOP("GripperFigure", "Torque"),
    "angle": QT_TRANSLATE_NOOP("GripperFigure", "Angle"),
    "speed": QT_TRANSLATE_NOOP("GripperFigure", "Speed"),
}

_ACTS: Final[Mapping[str, object]] = {
    "enable": QT_TRANSLATE_NOOP("GripperAct", "Enable"),
    "disable": QT_TRANSLATE_NOOP("GripperAct", "Disable"),
    "clear": QT_TRANSLATE_NOOP("GripperAct", "Clear error"),
    "zero": QT_TRANSLATE_NOOP("GripperAct", "Set zero"),
}

_FAULTS: Final[Mapping[GripperFault, object]] = {
    GripperFault.UNDERVOLTAGE: QT_TRANSLATE_NOOP("GripperFault", "supply voltage too low"),
    GripperFault.MOTOR_OVERTEMPERATURE: QT_TRANSLATE_NOOP("GripperFault", "motor too hot"),
    GripperFault.OVERCURRENT: QT_TRANSLATE_NOOP("GripperFault", "driver overcurrent"),
    GripperFault.DRIVER_OVERTEMPERATURE: QT_TRANSLATE_NOOP("GripperFault", "driver too hot"),
    GripperFault.SENSOR: QT_TRANSLATE_NOOP("GripperFault", "sensor abnormal"),
    GripperFault.DRIVER: QT_TRANSLATE_NOOP("GripperFault", "driver error"),
}


_LOADS: Final[Mapping[EndLoad, object]] = {
    EndLoad.EMPTY: QT_TRANSLATE_NOOP("EndLoad", "No load"),
    EndLoad.HALF: QT_TRANSLATE_NOOP("EndLoad", "Half load"),
    EndLoad.FULL: QT_TRANSLATE_NOOP("EndLoad", "Full load"),
    EndLoad.NOT_GIVEN: QT_TRANSLATE_NOOP("EndLoad", "Not given"),
}


def end_load(load: EndLoad) -> str:
    """What the arm carries («半载»)."""
    return QCoreApplication.translate("EndLoad", str(_LOADS[load]))


def gripper_figure(name: str) -> str:
    """What a figure of the gripper's command is called («开度»)."""
    return sentence("GripperFigure", _FIGURES.get(name, name), {})


def gripper_act(name: str) -> str:
    """What is done to the gripper («清除错误»)."""
    return sentence("GripperAct", _ACTS.get(name, name), {})


def gripper_fault(fault: GripperFault) -> str:
    """What its driver complains of («电机过温»)."""
    return QCoreApplication.translate("GripperFault", str(_FAULTS[fault]))
