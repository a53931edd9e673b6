"""Other hosts, leader arms and held-back motions in the operator's language."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QCoreApplication

from armui.arm.refusal_codes import RefusalCode
from armui.ui.words.hand_frames import HAND_FRAME_REFUSALS
from armui.ui.words.text import Texts

OTHER_HOST_REFUSALS: Final = Texts("Refusal") | {
    **HAND_FRAME_REFUSALS,
    RefusalCode.FEEDBACK_SILENT: (
        "{frames} of the arm has not been heard for {seconds} s: nobody knows where it is. Check "
        "its power and the CAN cable; nothing is sent until it is heard again."
    ),
    RefusalCode.OTHER_HOST: (
        "Another program controls the arm ({frames}). Wait until it has been quiet for 2 s and the "
        "arm rests, or take over when it pauses. The stop works at any time."
    ),
    RefusalCode.LEADER_ARM: (
        "A leader arm moves this arm ({frames}). Switch the leader off, or make it a motion "
        "output. The stop works at any time."
    ),
    RefusalCode.OTHER_MODE: (
        "Another program drives the arm in {other_mode} mode: a mode word of ours would leave its "
        "joints limp. End that program, hold the arm, and take the way back that the line above "
        "the panels offers."
    ),
    RefusalCode.OTHER_HOST_STREAMS: (
        "The other program is still sending ({frames}): it can be taken over half a second after "
        "its last frame. Against a stream only the stop wins."
    ),
    RefusalCode.LISTEN_ONLY: (
        "This connection only listens: nothing is sent but the emergency stop. Connect without "
        "Listen only to command the arm."
    ),
    RefusalCode.NOBODY_ELSE: "No other program moves the arm.",
    RefusalCode.HELD_AT_ZERO: (
        "The arm holds back a motion at 0 %. Hold Continue or press Give up in the line above the "
        "panels first."
    ),
    RefusalCode.NOTHING_HELD: "No motion is held back.",
    RefusalCode.COMMAND_OVER: (
        "Something else has ended this motion. Look at the arm, then start again."
    ),
    RefusalCode.TOO_FAST: (
        "Joint {joint} moves at {value} °/s, where {maximum} °/s is shown. Set the speed again "
        "before the next motion."
    ),
    RefusalCode.TOOL_TOO_FAST: (
        "The tool moves at {value} mm/s, where {maximum} mm/s is shown. Set the speed again before "
        "the next motion."
    ),
    RefusalCode.TOOL_TURNS_TOO_FAST: (
        "The tool turns at {value} °/s, where {maximum} °/s is shown. Set the speed again before "
        "the next motion."
    ),
}

_MODES: Final = Texts("OtherMode") | {
    "mit": "MIT",
    "cpv": "CPV",
    "high_follow": "high-follow",
}


def other_mode(mode: str) -> str:
    """A mode another host has put the arm in."""
    return _MODES.text(mode)


def held_target(angles_deg: object) -> str:
    """Where a motion held back leads: six angles in degrees, or that they are not known."""
    if not isinstance(angles_deg, tuple):
        return QCoreApplication.translate("HeldTarget", "a target this program does not know")
    return ", ".join(f"{angle:.1f}°" for angle in angles_deg)
