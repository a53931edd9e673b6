"""What a check before running has found, as sentences: what, its value and limit, the remedy."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

from armui.trajectory.planning.findings import Finding
from armui.ui.words.text import sentence

_FINDINGS: Final[Mapping[str, object]] = {
    "empty": QT_TRANSLATE_NOOP("Finding", "There is nothing to run. Add points, or record."),
    "target_beyond_limit": QT_TRANSLATE_NOOP(
        "Finding",
        "Joint {joint} would be at {value}°, beyond its limits {minimum}° to {maximum}°. Change "
        "the point.",
    ),
    "path_beyond_limit": QT_TRANSLATE_NOOP(
        "Finding",
        "On the way joint {joint} would come to {value}°, beyond its limits {minimum}° to "
        "{maximum}°. Put another point between, or use MOVE J.",
    ),
    "out_of_reach": QT_TRANSLATE_NOOP(
        "Finding",
        "The arm cannot bring its flange there: {missing} mm are missing. Move the point nearer.",
    ),
    "path_out_of_reach": QT_TRANSLATE_NOOP(
        "Finding",
        "After {gone} % of the way the tool would be out of reach. Put another point between, or "
        "use MOVE J.",
    ),
    "path_singular": QT_TRANSLATE_NOOP(
        "Finding",
        "After {gone} % of the way joint {joint} would have to leap: the arm is in a singular "
        "pose there. Put another point between, or use MOVE J.",
    ),
    "arc_no_circle": QT_TRANSLATE_NOOP(
        "Finding",
        "The point before, the middle and the end lie on a line or upon one another: that is no "
        "arc. Move the middle aside, or use MOVE L.",
    ),
    "start_unknown": QT_TRANSLATE_NOOP(
        "Finding",
        "This would begin where row {before} ends, and the arm does not come there. Change row "
        "{before} first.",
    ),
    "links_collide": QT_TRANSLATE_NOOP(
        "Finding",
        "The arm would hit itself: {other} against {one}. Put another point between, or change "
        "the point.",
    ),
    "joint_too_fast": QT_TRANSLATE_NOOP(
        "Finding",
        "Joint {joint} would have to turn at {value}°/s; its limit is {maximum}°/s. Replay at "
        "{percent} % of this speed at most.",
    ),
    "gripper_beyond_stroke": QT_TRANSLATE_NOOP(
        "Finding",
        "The gripper would have to open {value} mm; it opens {maximum} mm at most. Enter less.",
    ),
    "near_singular": QT_TRANSLATE_NOOP(
        "Finding",
        "The way passes near a singular pose ({value}, should be {minimum} or more): joints turn "
        "fast there and the tool is slow. Use MOVE J, or turn the wrist.",
    ),
    "far_from_start": QT_TRANSLATE_NOOP(
        "Finding",
        "The first point is far from where the arm is: joint {joint} turns {value}°. Watch the "
        "way there in the preview, or bring the arm nearer first.",
    ),
    "large_turn": QT_TRANSLATE_NOOP(
        "Finding",
        "Joint {joint} turns {value}° to hold this pose. If that is not meant, give the point as "
        "joint angles.",
    ),
    "sample_jump": QT_TRANSLATE_NOOP(
        "Finding",
        "Joint {joint} jumps {value}° from the sample before. Trim the recording there, or record "
        "again.",
    ),
    "tool_too_fast": QT_TRANSLATE_NOOP(
        "Finding",
        "The tool would go at {value} mm/s; its limit is {maximum} mm/s, and the arm does not keep "
        "it here by itself. Lower the speed.",
    ),
    "below_floor": QT_TRANSLATE_NOOP(
        "Finding",
        "The tool would be {value} mm below the plane the arm stands on. Accept this only if there "
        "is nothing.",
    ),
}

_PARTS: Final[Mapping[str, object]] = {
    "base": QT_TRANSLATE_NOOP("ArmPart", "the base"),
    "upper arm": QT_TRANSLATE_NOOP("ArmPart", "the upper arm"),
    "forearm": QT_TRANSLATE_NOOP("ArmPart", "the forearm"),
    "hand": QT_TRANSLATE_NOOP("ArmPart", "the wrist"),
    "gripper": QT_TRANSLATE_NOOP("ArmPart", "the gripper"),
}

CODES: Final = frozenset(_FINDINGS)
"""The findings there is a sentence for."""
PARTS: Final = frozenset(_PARTS)
"""The parts of the arm there is a word for."""


def finding(found: Finding) -> str:
    """What was found in the operator's language; the row is told beside it."""
    return sentence(
        "Finding", _FINDINGS[found.code], {k: _text(v) for k, v in found.params.items()}
    )


def _text(value: float | str) -> str:
    if isinstance(value, str):
        return sentence("ArmPart", _PARTS.get(value, value), {})
    return f"{round(value, 3):g}" if isinstance(value, float) else str(value)
