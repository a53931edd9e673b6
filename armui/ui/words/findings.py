"""What a check before running has found, as sentences: what, its value and limit, the remedy."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

from armui.trajectory.planning.findings import Finding, FindingCode
from armui.ui.words.text import sentence

_FINDINGS: Final[Mapping[FindingCode, object]] = {
    FindingCode.EMPTY: QT_TRANSLATE_NOOP(
        "Finding", "There is nothing to run. Add points, or record."
    ),
    FindingCode.TARGET_BEYOND_LIMIT: QT_TRANSLATE_NOOP(
        "Finding",
        "Joint {joint} would be at {value}°, beyond its limits {minimum}° to {maximum}°. Change "
        "the point.",
    ),
    FindingCode.PATH_BEYOND_LIMIT: QT_TRANSLATE_NOOP(
        "Finding",
        "On the way joint {joint} would come to {value}°, beyond its limits {minimum}° to "
        "{maximum}°. Put another point between, or use MOVE J.",
    ),
    FindingCode.OUT_OF_REACH: QT_TRANSLATE_NOOP(
        "Finding",
        "The flange cannot get there: the point is {missing} mm too far. Move it nearer.",
    ),
    FindingCode.PATH_OUT_OF_REACH: QT_TRANSLATE_NOOP(
        "Finding",
        "After {gone} % of the way the tool would be out of reach. Put another point between, or "
        "use MOVE J.",
    ),
    FindingCode.PATH_SINGULAR: QT_TRANSLATE_NOOP(
        "Finding",
        "After {gone} % of the way joint {joint} would have to leap: the arm is in a singular "
        "pose there. Put another point between, or use MOVE J.",
    ),
    FindingCode.ARC_NO_CIRCLE: QT_TRANSLATE_NOOP(
        "Finding",
        "The point before, the middle and the end lie on a line or upon one another: that is no "
        "arc. Move the middle aside, or use MOVE L.",
    ),
    FindingCode.START_UNKNOWN: QT_TRANSLATE_NOOP(
        "Finding",
        "This would begin where row {before} ends, and the arm does not come there. Change row "
        "{before} first.",
    ),
    FindingCode.LINKS_COLLIDE: QT_TRANSLATE_NOOP(
        "Finding",
        "The arm would hit itself: {other} against {one}. Put another point between, or change "
        "the point.",
    ),
    FindingCode.JOINT_TOO_FAST: QT_TRANSLATE_NOOP(
        "Finding",
        "Joint {joint} would have to turn at {value}°/s; its limit is {maximum}°/s. Replay at "
        "{percent} % of this speed at most.",
    ),
    FindingCode.GRIPPER_BEYOND_STROKE: QT_TRANSLATE_NOOP(
        "Finding",
        "The gripper would have to open {value} mm; it opens {maximum} mm at most. Enter less.",
    ),
    FindingCode.NEAR_SINGULAR: QT_TRANSLATE_NOOP(
        "Finding",
        "The way passes near a singular pose ({value}, should be {minimum} or more): joints turn "
        "fast there and the tool is slow. Use MOVE J, or turn the wrist.",
    ),
    FindingCode.FAR_FROM_START: QT_TRANSLATE_NOOP(
        "Finding",
        "The first point is far from where the arm is: joint {joint} turns {value}°. Watch the "
        "way there in the preview, or bring the arm nearer first.",
    ),
    FindingCode.LARGE_TURN: QT_TRANSLATE_NOOP(
        "Finding",
        "Joint {joint} turns {value}° to hold this pose. If that is not meant, give the point as "
        "joint angles.",
    ),
    FindingCode.SAMPLE_JUMP: QT_TRANSLATE_NOOP(
        "Finding",
        "Joint {joint} jumps {value}° from the sample before. Trim the recording there, or record "
        "again.",
    ),
    FindingCode.TOOL_TOO_FAST: QT_TRANSLATE_NOOP(
        "Finding",
        "The tool would go at {value} mm/s; its limit is {maximum} mm/s, and the arm does not keep "
        "it here by itself. Lower the speed.",
    ),
    FindingCode.BELOW_FLOOR: QT_TRANSLATE_NOOP(
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
