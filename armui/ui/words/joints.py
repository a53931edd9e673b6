"""What the table of the joints says, in the words of the manual (section 1.0.10)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP, QCoreApplication

from armui.arm.joint_status import Item, StatusVerdict, Word

_ITEMS: Final[Mapping[Item, object]] = {
    Item.STATUS_CODE: QT_TRANSLATE_NOOP("JointItem", "Status code:"),
    Item.SUPPLY_VOLTAGE: QT_TRANSLATE_NOOP("JointItem", "Supply voltage:"),
    Item.MOTOR_TEMPERATURE: QT_TRANSLATE_NOOP("JointItem", "Motor temperature:"),
    Item.DRIVER_CURRENT: QT_TRANSLATE_NOOP("JointItem", "Driver current:"),
    Item.DRIVER_TEMPERATURE: QT_TRANSLATE_NOOP("JointItem", "Driver temperature:"),
    Item.SENSOR: QT_TRANSLATE_NOOP("JointItem", "Sensor:"),
    Item.COLLISION_PROTECTION: QT_TRANSLATE_NOOP("JointItem", "Collision protection:"),
    Item.DRIVER_FAULT: QT_TRANSLATE_NOOP("JointItem", "Driver error:"),
    Item.DRIVER_ENABLED: QT_TRANSLATE_NOOP("JointItem", "Driver enabled:"),
    Item.HOMED: QT_TRANSLATE_NOOP("JointItem", "Homing:"),
    Item.STALL_PROTECTION: QT_TRANSLATE_NOOP("JointItem", "Stall protection:"),
    Item.COMMUNICATION: QT_TRANSLATE_NOOP("JointItem", "Joint communication:"),
}

_WORDS: Final[Mapping[Word, object]] = {
    Word.NORMAL: QT_TRANSLATE_NOOP("JointWord", "Normal"),
    Word.TOO_LOW: QT_TRANSLATE_NOOP("JointWord", "Too low"),
    Word.TOO_HOT: QT_TRANSLATE_NOOP("JointWord", "Too hot"),
    Word.OVERCURRENT: QT_TRANSLATE_NOOP("JointWord", "Overcurrent"),
    Word.ABNORMAL: QT_TRANSLATE_NOOP("JointWord", "Abnormal"),
    Word.ERROR: QT_TRANSLATE_NOOP("JointWord", "Error"),
    Word.TRIGGERED: QT_TRANSLATE_NOOP("JointWord", "Triggered"),
    Word.ENABLED: QT_TRANSLATE_NOOP("JointWord", "Enabled"),
    Word.DISABLED: QT_TRANSLATE_NOOP("JointWord", "Disabled"),
    Word.NOT_HOMED: QT_TRANSLATE_NOOP("JointWord", "Not homed"),
    Word.HOMED: QT_TRANSLATE_NOOP("JointWord", "Homed"),
}

_VERDICTS: Final[Mapping[StatusVerdict, object]] = {
    StatusVerdict.NORMAL: QT_TRANSLATE_NOOP("JointVerdict", "Normal"),
    StatusVerdict.DISABLED: QT_TRANSLATE_NOOP("JointVerdict", "Disabled"),
    StatusVerdict.UNKNOWN: QT_TRANSLATE_NOOP("JointVerdict", "Unknown"),
    StatusVerdict.FAULT: QT_TRANSLATE_NOOP("JointVerdict", "Fault"),
    StatusVerdict.OFFLINE: QT_TRANSLATE_NOOP("JointVerdict", "Offline"),
}


def joint_item(item: Item) -> str:
    """The name of a row («电源电压:»)."""
    return QCoreApplication.translate("JointItem", str(_ITEMS[item]))


def joint_word(word: Word) -> str:
    """What a cell says («过低»)."""
    return QCoreApplication.translate("JointWord", str(_WORDS[word]))


def joint_verdict(verdict: StatusVerdict) -> str:
    """How the six joints are («有故障»)."""
    return QCoreApplication.translate("JointVerdict", str(_VERDICTS[verdict]))
