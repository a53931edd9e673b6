"""Uncommanded motion in the operator's language: of an arm that is not held, or has no command."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from armui.control.safety.uncommanded_motion import MotionKind, Unheld
from armui.ui.words.text import Text, Texts

if TYPE_CHECKING:
    from armui.control.safety.uncommanded_motion import UncommandedMotion

_SENTENCES: Final = Texts("UncommandedMotion") | {
    "sinks": "The arm sinks: {down} mm lower after {seconds} s (J{joint} {turned}°), now at "
    "{speed} mm/s. Below it: {below}. Hold it.",
    "sinks_powered": "The arm sinks though its motors are on: {down} mm lower after {seconds} s "
    "(J{joint} {turned}°), now at {speed} mm/s. Below it: {below}. Hold it.",
    "sinks_level": "The arm gives way, the tool no lower: J{joint} by {turned}° in {seconds} s, "
    "now at {speed} mm/s. Below it: {below}. Hold it.",
    "unheld": "The arm moves, and no motor holds it: J{joint} by {turned}° in {seconds} s, now at "
    "{speed} mm/s.",
    "unheld_joint": "The arm moves, and no motor holds J{joint}: by {turned}° in {seconds} s, now "
    "at {speed} mm/s.",
    "untold": "The arm moves, and nothing told it to: J{joint} by {turned}° in {seconds} s, now "
    "at {speed} mm/s.",
    "in_drag": "The arm moves, by a hand or its own weight: J{joint} by {turned}° in {seconds} s, "
    "{down} mm lower, now at {speed} mm/s.",
    "own_replay": "The arm moves by itself along its taught path, or to its start: J{joint} by "
    "{turned}° in {seconds} s, now at {speed} mm/s.",
    "unstopped": "The arm still moves: J{joint} by {turned}° in {seconds} s, now at {speed} mm/s.",
    "led": "The arm is moved by hand, at {speed} mm/s.",
    "unheard": "The arm may be moving: it was last heard {ago} ago.",
    "unheard_stood": "The arm may be moving: it stood still when last heard, {ago} ago.",
    "unheard_moved": "The arm may be moving: it moved at {speed} mm/s when last heard, {ago} ago.",
}
_SHORT: Final = Texts("UncommandedMotionShort") | {
    MotionKind.SINKS: "Sinks {down} mm, {speed} mm/s",
    MotionKind.MOVES: "Moves, {speed} mm/s",
    MotionKind.LED: "Moved by hand",
    MotionKind.UNHEARD: "May be moving",
}
_WORDS: Final = Texts("UncommandedMotionWord") | {
    MotionKind.SINKS: "Sinking",
    MotionKind.MOVES: "Moving",
    MotionKind.UNMEASURED: "No power",
    MotionKind.UNHEARD: "Not heard",
}
_HOLD: Final = Text("UncommandedMotionShort", "Hold it. {does}.")
_BELOW: Final = Texts("UncommandedMotion") | {"nothing": "table or floor"}
_AGO: Final = Texts("UncommandedMotion") | {"s": "{count} s", "min": "{count} min"}
_OF_CAUSE: Final = {
    Unheld.JOINTS_OFF: "unheld_joint",
    Unheld.NOT_TOLD: "untold",
    Unheld.DRAG_TEACHING: "in_drag",
    Unheld.OWN_REPLAY: "own_replay",
    Unheld.STOP_AWAITED: "unstopped",
}
_MINUTE_S: Final = 60


def what_is_below(names: str) -> str:
    """Return the names of what is below an arm, or the words for places without an area."""
    return names or _BELOW.word("nothing")


def uncommanded_motion(motion: UncommandedMotion) -> str:
    """Return the sentences on an uncommanded motion, with its figures; "" if it is not measured."""
    if motion.kind is MotionKind.UNMEASURED:
        return ""
    return _SENTENCES.text(_sentence_of(motion), _figures(motion))


def uncommanded_motion_short(motion: UncommandedMotion) -> str:
    """Return the same in a few words, for a place that is seen with everything else."""
    kind = MotionKind.MOVES if motion.is_level else motion.kind
    return _SHORT.text(kind, _figures(motion)) if kind in _SHORT else ""


def what_to_do(motion: UncommandedMotion) -> str:
    """Return the same in a few words, with what to do first, for where there is little room."""
    short = uncommanded_motion_short(motion)
    return _HOLD.text().format(does=short) if motion.kind is MotionKind.SINKS else short


def uncommanded_motion_word(kind: MotionKind) -> str:
    """Return what the arm does as one word."""
    return _WORDS.text(kind)


def _sentence_of(motion: UncommandedMotion) -> str:
    if motion.kind is MotionKind.UNHEARD:
        known = motion.speed_mm_s is not None
        seen = "unheard_moved" if motion.speed_mm_s else "unheard_stood"
        return seen if known else "unheard"
    if motion.kind is MotionKind.LED:
        return "led"
    if motion.is_level:
        return "untold" if motion.cause is Unheld.NOT_TOLD else "sinks_level"
    if motion.kind is MotionKind.SINKS:
        return "sinks_powered" if motion.cause is Unheld.NOT_TOLD else "sinks"
    return "unheld" if motion.cause is None else _OF_CAUSE.get(motion.cause, "unheld")


def _figures(motion: UncommandedMotion) -> dict[str, object]:
    long = motion.seconds >= _MINUTE_S
    count = motion.seconds // _MINUTE_S if long else motion.seconds
    ago = _AGO.text("min" if long else "s", {"count": count})
    return motion.figures() | {"below": what_is_below(motion.below), "ago": ago}
