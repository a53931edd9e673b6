"""Every reason against reading or setting a parameter of the arm."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

from armui.arm.parameters import KINDS, Parameter
from armui.ui.words.parameters import full_name, value_text

SETTING_REFUSALS: Final[Mapping[str, object]] = {
    "generation_unknown": QT_TRANSLATE_NOOP(
        "Refusal",
        "The program is still finding out which protocol the arm speaks. Wait a second.",
    ),
    "setting_out_of_range": QT_TRANSLATE_NOOP(
        "Refusal",
        "{parameter}: {value} is out of range. Enter a value from {minimum} to {maximum}.",
    ),
    "setting_not_a_number": QT_TRANSLATE_NOOP(
        "Refusal",
        "{parameter}: “{value}” is not a number. Enter a value from {minimum} to {maximum}.",
    ),
    "setting_no_choice": QT_TRANSLATE_NOOP(
        "Refusal", "{parameter}: {value} is not possible. Choose one of {choices}."
    ),
    "setting_not_kept": QT_TRANSLATE_NOOP(
        "Refusal",
        "This arm's protocol (generation {generation}) has no such settings; generation 2 has.",
    ),
    "setting_unknown": QT_TRANSLATE_NOOP(
        "Refusal",
        "{parameter} would have to be sent along unchanged and has not been read from the arm. "
        "Read it first.",
    ),
    "setting_corrupt": QT_TRANSLATE_NOOP(
        "Refusal",
        "{parameter} would have to be sent along, and what the arm holds there is corrupt. Enter "
        "a value for it as well.",
    ),
    "limits_crossed": QT_TRANSLATE_NOOP(
        "Refusal",
        "Joint {joint}: the min. angle {minimum}° must be below the max. angle {maximum}°. Change "
        "one of them.",
    ),
    "setting_unanswered": QT_TRANSLATE_NOOP(
        "Refusal",
        "The arm did not answer (0x476). Nothing says that it took this over: read the values "
        "again, then save once more.",
    ),
    "order_too_late": QT_TRANSLATE_NOOP(
        "Refusal",
        "Nothing was sent: the arm was still being set or asked something a second after the "
        "press. Try again.",
    ),
    "arm_changed": QT_TRANSLATE_NOOP(
        "Refusal",
        "The arm was silent meanwhile, or another arm answers: nothing more was sent. See that it "
        "is the right arm, then try again.",
    ),
    "setting_not_read_back": QT_TRANSLATE_NOOP(
        "Refusal",
        "The arm did not answer when asked for the value: what it holds is not known. Read again.",
    ),
    "setting_not_taken": QT_TRANSLATE_NOOP(
        "Refusal",
        "{parameter}: {value} was sent and answered, but the arm holds {held}. It did not take "
        "this value; try another one.",
    ),
}


def with_units(params: dict[str, object]) -> dict[str, object]:
    """Figures of a sentence about a parameter, as the operator reads them."""
    name = params.get("parameter")
    if not isinstance(name, str) or name not in KINDS:
        return params
    joint = params.get("joint")
    words = dict(params)
    words["parameter"] = full_name(Parameter(name, joint if isinstance(joint, int) else 0))
    for key in ("value", "held", "minimum", "maximum"):
        value = params.get(key)
        if isinstance(value, int | float):
            words[key] = value_text(name, value)
    return words
