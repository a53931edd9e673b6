"""What the table of the joints says, in the words of the manual (section 1.0.10)."""

from __future__ import annotations

from typing import Final

from armui.arm.joint_status import Item, StatusVerdict, Word
from armui.ui.words.text import Texts

_ITEMS: Final = Texts("JointItem") | {
    Item.STATUS_CODE: "Status code:",
    Item.SUPPLY_VOLTAGE: "Supply voltage:",
    Item.MOTOR_TEMPERATURE: "Motor temperature:",
    Item.DRIVER_CURRENT: "Driver current:",
    Item.DRIVER_TEMPERATURE: "Driver temperature:",
    Item.SENSOR: "Sensor:",
    Item.COLLISION_PROTECTION: "Collision protection:",
    Item.DRIVER_FAULT: "Driver error:",
    Item.DRIVER_ENABLED: "Driver enabled:",
    Item.HOMED: "Homing:",
    Item.STALL_PROTECTION: "Stall protection:",
    Item.COMMUNICATION: "Joint communication:",
}

_WORDS: Final = Texts("JointWord") | {
    Word.NORMAL: "Normal",
    Word.TOO_LOW: "Too low",
    Word.TOO_HOT: "Too hot",
    Word.OVERCURRENT: "Overcurrent",
    Word.ABNORMAL: "Abnormal",
    Word.ERROR: "Error",
    Word.TRIGGERED: "Triggered",
    Word.ENABLED: "Enabled",
    Word.DISABLED: "Disabled",
    Word.NOT_HOMED: "Not homed",
    Word.HOMED: "Homed",
}

_VERDICTS: Final = Texts("JointVerdict") | {
    StatusVerdict.NORMAL: "Normal",
    StatusVerdict.DISABLED: "Disabled",
    StatusVerdict.UNKNOWN: "Unknown",
    StatusVerdict.FAULT: "Fault",
    StatusVerdict.OFFLINE: "Offline",
}


def joint_item(item: Item) -> str:
    """The name of a row («电源电压:»)."""
    return _ITEMS.text(item)


def joint_word(word: Word) -> str:
    """What a cell says («过低»)."""
    return _WORDS.text(word)


def joint_verdict(verdict: StatusVerdict) -> str:
    """How the six joints are («有故障»)."""
    return _VERDICTS.text(verdict)
