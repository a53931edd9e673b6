"""What speaks against a motor's zero, a command of the gripper, or another linkage."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

MOTOR_REFUSALS: Final[Mapping[str, object]] = {
    "load_not_chosen": QT_TRANSLATE_NOOP("Refusal", "No end load is chosen. Choose one first."),
    "load_while_moving": QT_TRANSLATE_NOOP(
        "Refusal", "The arm is moving. Wait until it stands still, then set the end load."
    ),
    "end_feedback_goes_on": QT_TRANSLATE_NOOP(
        "Refusal", "The arm has answered, but goes on reporting. Try again."
    ),
    "control_offset_unknown": QT_TRANSLATE_NOOP(
        "Refusal",
        "Whether the arm takes commands on the identifiers in use is not proven, so it is not "
        "moved; stop and halt reach it. To prove it, set the offsets again in Linkage with the "
        "arm in standby: they count once the arm has answered.",
    ),
    "offset_not_possible": QT_TRANSLATE_NOOP(
        "Refusal", "An offset of {value} is not possible. Choose 0x00, 0x10 or 0x20."
    ),
    "linkage_while_moving": QT_TRANSLATE_NOOP(
        "Refusal", "The arm is moving. Wait until it stands still, then set the linkage."
    ),
    "gripper_silent": QT_TRANSLATE_NOOP(
        "Refusal",
        "No gripper is heard. If one is mounted, check its cable and its power.",
    ),
    "gripper_no_zero": QT_TRANSLATE_NOOP(
        "Refusal", "The gripper of a generation 1 arm has no command for its zero."
    ),
    "gripper_out_of_range": QT_TRANSLATE_NOOP(
        "Refusal",
        "{gripper}: {value} {unit} is out of range. Enter a value from {minimum} to {maximum} "
        "{unit}.",
    ),
    "gripper_not_a_number": QT_TRANSLATE_NOOP(
        "Refusal",
        "{gripper}: “{value}” is not a number. Enter a value from {minimum} to {maximum} {unit}.",
    ),
    "speed_unknown": QT_TRANSLATE_NOOP(
        "Refusal",
        "Whether these joints stand still is not known: {joints}. Their drivers report no speed: "
        "check the arm's power and the CAN cable.",
    ),
    "joints_moving": QT_TRANSLATE_NOOP(
        "Refusal", "These joints are moving: {joints}. Wait until the arm stands still."
    ),
    "zero_not_set": QT_TRANSLATE_NOOP(
        "Refusal",
        "The arm answered that it did not set the zero of these joints: {joints}. Let the arm "
        "stand still, clear its errors, then try again.",
    ),
    "zero_not_taken": QT_TRANSLATE_NOOP(
        "Refusal",
        "The arm answered that the zero is set, but these joints do not read 0°: {joints}. Do not "
        "move the arm before the zero is set anew.",
    ),
    "zero_moved": QT_TRANSLATE_NOOP(
        "Refusal",
        "Joint {joints} does not stand where it stood at the press: no zero was sent. Try again "
        "where it shall be.",
    ),
    "ended_by_stop": QT_TRANSLATE_NOOP(
        "Refusal",
        "The stop came first; it is not sent again. Look at what the arm shows, then repeat it.",
    ),
}
