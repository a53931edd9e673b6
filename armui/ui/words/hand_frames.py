"""Frames sent by hand: what they do to the arm, and why one is not sent."""

from __future__ import annotations

from typing import Final

from armui.arm.refusal_codes import RefusalCode
from armui.control.safety.hand_frame import FrameEffect
from armui.ui.words.text import Texts

HAND_FRAME_REFUSALS: Final = Texts("Refusal") | {
    RefusalCode.FRAME_ID_BAD: (
        "Identifier: “{value}” is no hexadecimal number. Enter 000 to 7FF, for example 151."
    ),
    RefusalCode.FRAME_ID_TOO_HIGH: (
        "Identifier: {value} has more than 11 bits, and the arm knows none of those. Enter 000 to "
        "7FF."
    ),
    RefusalCode.FRAME_DATA_BAD: (
        "Data: “{value}” are no whole bytes. Enter two hexadecimal figures for each byte, for "
        "example 01 0A FF."
    ),
    RefusalCode.FRAME_DATA_LONG: "Data: {count} bytes do not fit into a frame. Enter 8 at most.",
    RefusalCode.FRAME_IS_THE_ARMS: (
        "{frame} is what an arm itself says: two senders of one identifier disturb the bus, and "
        "others would take it for the arm's word. Choose an identifier that hosts send."
    ),
    RefusalCode.FRAME_OF_UPGRADE: (
        "{frame} is kept for firmware upgrades: what it does is not public, and it may leave the "
        "arm without firmware. Use the maker's upgrade program."
    ),
    RefusalCode.FRAME_RESUMES: (
        "This frame ends an emergency stop and lets the arm drop. Use Resume in the main window, "
        "once the arm is supported."
    ),
    RefusalCode.FRAME_NOT_HELD: (
        "This frame acts on the arm: hold the button for a second to send it."
    ),
}

_EFFECTS: Final = Texts("FrameEffect") | {
    FrameEffect.HARMLESS: "A question or a lamp: nothing moves. A press sends it.",
    FrameEffect.ENDS: "The motion under way ends or pauses; the joints keep their power.",
    FrameEffect.SINKS: (
        "An emergency stop: the motors go limp and the arm sinks. Hold the arm. The stop button "
        "above is faster, reaches every identifier and is repeated until the arm confirms."
    ),
    FrameEffect.DROPS: (
        "Motors lose their power and there are no brakes: the ARM DROPS. Hold the arm."
    ),
    FrameEffect.LIMP: (
        "The joints go limp until their next setpoint: the ARM FALLS unless setpoints follow at "
        "once. Support the arm. Only a reset leads back from there."
    ),
    FrameEffect.DIRECT: (
        "Drives one motor past the arm's own planning and limits. With gains of 0 its joint has "
        "no strength and falls. Support the arm, keep away from it."
    ),
    FrameEffect.MOVES: "The arm may set out at once, without any check. Keep away from it.",
    FrameEffect.GRIPPER: (
        "The gripper may close, open or lose its power and let go, without any check. Keep your "
        "fingers away."
    ),
    FrameEffect.HAND: (
        "The joints give way to a hand, and sink if the load is not set. Hold the arm."
    ),
    FrameEffect.POWER: "Motors get their power: joints may jerk. Keep away from the arm.",
    FrameEffect.ROLE: (
        "Changes whether the arm leads or follows, or its identifiers. It is kept when the arm is "
        "switched off, and the arm may fall silent to this program."
    ),
    FrameEffect.SETTING: (
        "Changes something the arm keeps, also when it is switched off: zeros, limits, levels or "
        "the load. Read it anew in its panel afterwards."
    ),
    FrameEffect.SILENCE: (
        "The arm is told to say nothing: nobody sees what it does until it is told to speak again "
        "or is switched off and on."
    ),
    FrameEffect.UNKNOWN: (
        "No public text says what this frame does. Expect anything: support the arm, keep away "
        "from it."
    ),
}


def frame_effect(effect: FrameEffect) -> str:
    """What a frame physically does, as a sentence before it is sent."""
    return _EFFECTS.text(effect)
