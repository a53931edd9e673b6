"""Other hosts, leader arms and held-back motions in the operator's language."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP, QCoreApplication

OTHER_HOST_REFUSALS: Final[Mapping[str, object]] = {
    "feedback_silent": QT_TRANSLATE_NOOP(
        "Refusal",
        "{frames} of the arm has not been heard for {seconds} s: nobody knows where it is. Check "
        "its power and the CAN cable; nothing is sent until it is heard again.",
    ),
    "other_host": QT_TRANSLATE_NOOP(
        "Refusal",
        "Another program controls the arm ({frames}). Wait until it has been quiet for 2 s and the "
        "arm rests, or take over when it pauses. The stop works at any time.",
    ),
    "leader_arm": QT_TRANSLATE_NOOP(
        "Refusal",
        "A leader arm moves this arm ({frames}). Switch the leader off, or make it a motion "
        "output. The stop works at any time.",
    ),
    "other_mode": QT_TRANSLATE_NOOP(
        "Refusal",
        "Another program drives the arm in {other_mode} mode: any mode word would leave its joints "
        "limp and it would fall. End that program, support the arm and reset it.",
    ),
    "other_host_streams": QT_TRANSLATE_NOOP(
        "Refusal",
        "The other program is still sending ({frames}): it can be taken over half a second after "
        "its last frame. Against a stream only the stop wins.",
    ),
    "listen_only": QT_TRANSLATE_NOOP(
        "Refusal",
        "This connection only listens: nothing is sent but the emergency stop. Connect without "
        "Listen only to command the arm.",
    ),
    "nobody_else": QT_TRANSLATE_NOOP("Refusal", "No other program moves the arm."),
    "held_at_zero": QT_TRANSLATE_NOOP(
        "Refusal",
        "The arm holds back a motion at 0 %. Hold Continue or press Give up in the line above the "
        "panels first.",
    ),
    "nothing_held": QT_TRANSLATE_NOOP("Refusal", "No motion is held back."),
    "command_over": QT_TRANSLATE_NOOP(
        "Refusal", "Something else has ended this motion. Look at the arm, then start again."
    ),
    "too_fast": QT_TRANSLATE_NOOP(
        "Refusal",
        "Joint {joint} moves at {value} °/s, where {maximum} °/s is shown. Set the speed again "
        "before the next motion.",
    ),
}

_MODES: Final[Mapping[str, object]] = {
    "mit": QT_TRANSLATE_NOOP("OtherMode", "MIT"),
    "cpv": QT_TRANSLATE_NOOP("OtherMode", "CPV"),
    "high_follow": QT_TRANSLATE_NOOP("OtherMode", "high-follow"),
}


def other_mode(mode: str) -> str:
    """A mode another host has put the arm in."""
    return QCoreApplication.translate("OtherMode", str(_MODES[mode]))
