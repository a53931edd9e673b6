"""Every reason against reading or setting a parameter of the arm."""

from __future__ import annotations

from typing import Final

from armui.arm.refusal_codes import RefusalCode
from armui.ui.words.text import Texts

SETTING_REFUSALS: Final = Texts("Refusal") | {
    RefusalCode.GENERATION_UNKNOWN: (
        "The program is still finding out which protocol the arm speaks. Wait a second."
    ),
    RefusalCode.SETTING_OUT_OF_RANGE: (
        "{parameter}: {value} is out of range. Enter a value from {minimum} to {maximum}."
    ),
    RefusalCode.SETTING_NOT_A_NUMBER: (
        "{parameter}: “{value}” is not a number. Enter a value from {minimum} to {maximum}."
    ),
    RefusalCode.SETTING_NO_CHOICE: "{parameter}: {value} is not possible. Choose one of {choices}.",
    RefusalCode.SETTING_NOT_KEPT: (
        "This arm's protocol (generation {generation}) has no such settings; generation 2 has."
    ),
    RefusalCode.NEEDS_FIRMWARE: (
        "The arm's firmware {firmware} does not have this: it came with {since}. Updates come from "
        "the maker's support."
    ),
    RefusalCode.FIRMWARE_UNKNOWN: (
        "The arm has not named its firmware, and only {since} and later have this. Connect again "
        "to ask for it."
    ),
    RefusalCode.MODE_UNKNOWN: (
        "The arm's control mode is not known, or another one has the command: it would be changed "
        "along with this. Bring the arm to standby or CAN control first."
    ),
    RefusalCode.SETTING_UNKNOWN: (
        "{parameter} would have to be sent along unchanged and has not been read from the arm. "
        "Read it first."
    ),
    RefusalCode.SETTING_CORRUPT: (
        "{parameter} would have to be sent along, and what the arm holds there is corrupt. Enter "
        "a value for it as well."
    ),
    RefusalCode.LIMITS_CROSSED: (
        "Joint {joint}: the min. angle {minimum}° must be below the max. angle {maximum}°. Change "
        "one of them."
    ),
    RefusalCode.SETTING_UNANSWERED: (
        "The arm did not answer (0x476). Nothing says that it took this over: read the values "
        "again, then save once more."
    ),
    RefusalCode.ORDER_TOO_LATE: (
        "Nothing was sent: the arm was still being set or asked something a second after the "
        "press. Try again."
    ),
    RefusalCode.ARM_CHANGED: (
        "The arm was silent meanwhile, or another arm answers: nothing more was sent. See that it "
        "is the right arm, then try again."
    ),
    RefusalCode.SETTING_NOT_READ_BACK: (
        "The arm did not answer when asked for the value: what it holds is not known. Read again."
    ),
    RefusalCode.SETTING_NOT_TAKEN: (
        "{parameter}: {value} was sent and answered, but the arm holds {held}. It did not take "
        "this value; try another one."
    ),
}


def with_units(params: dict[str, object]) -> dict[str, object]:
    """Figures of a sentence about a parameter, as the operator reads them."""
    name = params.get("parameter")
    if name is None:
        return params
    from armui.arm.parameters import KINDS, Parameter  # noqa: PLC0415 - faster start
    from armui.ui.words.parameters import full_name, value_text  # noqa: PLC0415 - as above

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
