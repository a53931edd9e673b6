"""Frames sent by hand: what they do to the arm, and why one is not sent."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP, QCoreApplication

from armui.arm.refusal_codes import RefusalCode
from armui.control.safety.hand_frame import FrameEffect

HAND_FRAME_REFUSALS: Final[Mapping[RefusalCode, object]] = {
    RefusalCode.FRAME_ID_BAD: QT_TRANSLATE_NOOP(
        "Refusal",
        "Identifier: “{value}” is no hexadecimal number. Enter 000 to 7FF, for example 151.",
    ),
    RefusalCode.FRAME_ID_TOO_HIGH: QT_TRANSLATE_NOOP(
        "Refusal",
        "Identifier: {value} has more than 11 bits, and the arm knows none of those. Enter 000 to "
        "7FF.",
    ),
    RefusalCode.FRAME_DATA_BAD: QT_TRANSLATE_NOOP(
        "Refusal",
        "Data: “{value}” are no whole bytes. Enter two hexadecimal figures for each byte, for "
        "example 01 0A FF.",
    ),
    RefusalCode.FRAME_DATA_LONG: QT_TRANSLATE_NOOP(
        "Refusal", "Data: {count} bytes do not fit into a frame. Enter 8 at most."
    ),
    RefusalCode.FRAME_IS_THE_ARMS: QT_TRANSLATE_NOOP(
        "Refusal",
        "{frame} is what an arm itself says: two senders of one identifier disturb the bus, and "
        "others would take it for the arm's word. Choose an identifier that hosts send.",
    ),
    RefusalCode.FRAME_OF_UPGRADE: QT_TRANSLATE_NOOP(
        "Refusal",
        "{frame} is kept for firmware upgrades: what it does is not public, and it may leave the "
        "arm without firmware. Use the maker's upgrade program.",
    ),
    RefusalCode.FRAME_RESUMES: QT_TRANSLATE_NOOP(
        "Refusal",
        "This frame ends an emergency stop and lets the arm drop. Use Resume in the main window, "
        "once the arm is supported.",
    ),
    RefusalCode.FRAME_NOT_HELD: QT_TRANSLATE_NOOP(
        "Refusal", "This frame acts on the arm: hold the button for a second to send it."
    ),
}

_EFFECTS: Final[Mapping[FrameEffect, object]] = {
    FrameEffect.HARMLESS: QT_TRANSLATE_NOOP(
        "FrameEffect", "A question or a lamp: nothing moves. A press sends it."
    ),
    FrameEffect.ENDS: QT_TRANSLATE_NOOP(
        "FrameEffect", "The motion under way ends or pauses; the joints keep their power."
    ),
    FrameEffect.SINKS: QT_TRANSLATE_NOOP(
        "FrameEffect",
        "An emergency stop: the motors go limp and the arm sinks. Hold the arm. The stop button "
        "above is faster, reaches every identifier and is repeated until the arm confirms.",
    ),
    FrameEffect.DROPS: QT_TRANSLATE_NOOP(
        "FrameEffect",
        "Motors lose their power and there are no brakes: the ARM DROPS. Hold the arm.",
    ),
    FrameEffect.LIMP: QT_TRANSLATE_NOOP(
        "FrameEffect",
        "The joints go limp until their next setpoint: the ARM FALLS unless setpoints follow at "
        "once. Support the arm. Only a reset leads back from there.",
    ),
    FrameEffect.DIRECT: QT_TRANSLATE_NOOP(
        "FrameEffect",
        "Drives one motor past the arm's own planning and limits. With gains of 0 its joint has "
        "no strength and falls. Support the arm, keep away from it.",
    ),
    FrameEffect.MOVES: QT_TRANSLATE_NOOP(
        "FrameEffect", "The arm may set out at once, without any check. Keep away from it."
    ),
    FrameEffect.GRIPPER: QT_TRANSLATE_NOOP(
        "FrameEffect",
        "The gripper may close, open or lose its power and let go, without any check. Keep your "
        "fingers away.",
    ),
    FrameEffect.HAND: QT_TRANSLATE_NOOP(
        "FrameEffect",
        "The joints give way to a hand, and sink if the load is not set. Hold the arm.",
    ),
    FrameEffect.POWER: QT_TRANSLATE_NOOP(
        "FrameEffect", "Motors get their power: joints may jerk. Keep away from the arm."
    ),
    FrameEffect.ROLE: QT_TRANSLATE_NOOP(
        "FrameEffect",
        "Changes whether the arm leads or follows, or its identifiers. It is kept when the arm is "
        "switched off, and the arm may fall silent to this program.",
    ),
    FrameEffect.SETTING: QT_TRANSLATE_NOOP(
        "FrameEffect",
        "Changes something the arm keeps, also when it is switched off: zeros, limits, levels or "
        "the load. Read it anew in its panel afterwards.",
    ),
    FrameEffect.SILENCE: QT_TRANSLATE_NOOP(
        "FrameEffect",
        "The arm is told to say nothing: nobody sees what it does until it is told to speak again "
        "or is switched off and on.",
    ),
    FrameEffect.UNKNOWN: QT_TRANSLATE_NOOP(
        "FrameEffect",
        "No public text says what this frame does. Expect anything: support the arm, keep away "
        "from it.",
    ),
}


def frame_effect(effect: FrameEffect) -> str:
    """What a frame physically does, as a sentence before it is sent."""
    return QCoreApplication.translate("FrameEffect", str(_EFFECTS[effect]))
