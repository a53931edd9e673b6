"""What speaks against a motor's zero, a command of the gripper, or another linkage."""

from __future__ import annotations

from typing import Final

from armui.arm.refusal_codes import RefusalCode
from armui.ui.words.text import Texts

MOTOR_REFUSALS: Final = Texts("Refusal") | {
    RefusalCode.LOAD_NOT_CHOSEN: "No end load is chosen. Choose one first.",
    RefusalCode.LOAD_WHILE_MOVING: (
        "The arm is moving. Wait until it stands still, then set the end load."
    ),
    RefusalCode.END_FEEDBACK_GOES_ON: "The arm has answered, but goes on reporting. Try again.",
    RefusalCode.CONTROL_OFFSET_UNKNOWN: (
        "Whether the arm takes commands on the identifiers in use is not proven, so it is not "
        "moved; stop and halt reach it. To prove it, set the offsets again in Linkage with the "
        "arm in standby: they count once the arm has answered."
    ),
    RefusalCode.OFFSET_NOT_POSSIBLE: (
        "An offset of {value} is not possible. Choose 0x00, 0x10 or 0x20."
    ),
    RefusalCode.LINKAGE_WHILE_MOVING: (
        "The arm is moving. Wait until it stands still, then set the linkage."
    ),
    RefusalCode.GRIPPER_SILENT: (
        "No gripper is heard. If one is mounted, check its cable and its power."
    ),
    RefusalCode.GRIPPER_NO_ZERO: "The gripper of a generation 1 arm has no command for its zero.",
    RefusalCode.GRIPPER_OUT_OF_RANGE: (
        "{gripper}: {value} {unit} is out of range. Enter a value from {minimum} to {maximum} "
        "{unit}."
    ),
    RefusalCode.GRIPPER_NOT_A_NUMBER: (
        "{gripper}: “{value}” is not a number. Enter a value from {minimum} to {maximum} {unit}."
    ),
    RefusalCode.SPEED_UNKNOWN: (
        "Whether these joints stand still is not known: {joints}. Their drivers report no speed: "
        "check the arm's power and the CAN cable."
    ),
    RefusalCode.JOINTS_MOVING: (
        "These joints are moving: {joints}. Wait until the arm stands still."
    ),
    RefusalCode.ZERO_NOT_SET: (
        "The arm answered that it did not set the zero of these joints: {joints}. Let the arm "
        "stand still, clear its errors, then try again."
    ),
    RefusalCode.ZERO_NOT_TAKEN: (
        "The arm answered that the zero is set, but these joints do not read 0°: {joints}. Do not "
        "move the arm before the zero is set anew."
    ),
    RefusalCode.ZERO_MOVED: (
        "Joint {joints} does not stand where it stood at the press: no zero was sent. Try again "
        "where it shall be."
    ),
    RefusalCode.ENDED_BY_STOP: (
        "The stop came first; it is not sent again. Look at what the arm shows, then repeat it."
    ),
}
