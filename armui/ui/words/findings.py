"""What a check before running has found, as sentences: what, its value and limit, the remedy."""

from __future__ import annotations

from typing import Final

from armui.trajectory.planning.findings import Approach, Finding, FindingCode
from armui.ui.words.arm import arm_kind
from armui.ui.words.text import Texts

_FINDINGS: Final = Texts("Finding") | {
    FindingCode.EMPTY: "There is nothing to run. Add points, or record.",
    FindingCode.TARGET_BEYOND_LIMIT: (
        "Joint {joint} would be at {value}°, beyond its limits {minimum}° to {maximum}°. Change "
        "the point."
    ),
    FindingCode.PATH_BEYOND_LIMIT: (
        "On the way joint {joint} would come to {value}°, beyond its limits {minimum}° to "
        "{maximum}°. Put another point between, or use MOVE J."
    ),
    FindingCode.OUT_OF_REACH: (
        "The flange cannot get there: the point is {missing} mm too far. Move it nearer."
    ),
    FindingCode.PATH_OUT_OF_REACH: (
        "After {gone} % of the way the tool would be out of reach. Put another point between, or "
        "use MOVE J."
    ),
    FindingCode.PATH_SINGULAR: (
        "After {gone} % of the way joint {joint} would have to leap: the arm is in a singular "
        "pose there. Put another point between, or use MOVE J."
    ),
    FindingCode.ARC_NO_CIRCLE: (
        "The point before, the middle and the end lie on a line or upon one another: that is no "
        "arc. Move the middle aside, or use MOVE L."
    ),
    FindingCode.START_UNKNOWN: (
        "This would begin where row {before} ends, and the arm does not come there. Change row "
        "{before} first."
    ),
    FindingCode.NEVER_REPEATS: (
        "Each of the first {cycles} cycles takes another way than those before, so that the next "
        "ones cannot be checked. Give one of the points as joint angles (MOVE J), or run fewer "
        "cycles."
    ),
    FindingCode.ARC_AT_LIMIT: (
        "The arc begins with joint {joint} at its limit ({value}°): the arm may not find its way "
        "there again. End the point before a little further in, or use MOVE L."
    ),
    FindingCode.LINKS_COLLIDE: (
        "The arm would hit itself: {other} against {one}. Put another point between, or change "
        "the point."
    ),
    FindingCode.JOINT_TOO_FAST: (
        "Joint {joint} would have to turn at {value}°/s; its limit is {maximum}°/s. Replay at "
        "{percent} % of this speed at most."
    ),
    FindingCode.GRIPPER_BEYOND_STROKE: (
        "The gripper would have to open {value} mm; it opens {maximum} mm at most. Enter less."
    ),
    FindingCode.NEAR_SINGULAR: (
        "The way passes near a singular pose ({value}, should be {minimum} or more): joints turn "
        "fast there and the tool is slow. Use MOVE J, or turn the wrist."
    ),
    FindingCode.FAR_FROM_START: (
        "The first point is far from where the arm is: joint {joint} turns {value}°. Watch the "
        "way there in the preview, or bring the arm nearer first."
    ),
    FindingCode.LARGE_TURN: (
        "Joint {joint} turns {value}° to hold this pose. If that is not meant, give the point as "
        "joint angles."
    ),
    FindingCode.EITHER_WAY: (
        "Two ways to hold this pose are about equally near: joint {joint} at {value}°, which was "
        "checked, or at {other}°. Give the point as joint angles, so that it is certain which."
    ),
    FindingCode.SAMPLE_JUMP: (
        "Joint {joint} jumps {value}° from the sample before. Trim the recording there, or record "
        "again."
    ),
    FindingCode.TOOL_TOO_FAST: (
        "The tool would go at {value} mm/s; its limit is {maximum} mm/s, and the arm does not keep "
        "it here by itself. Lower the speed."
    ),
    FindingCode.OTHER_ARM: (
        "This was taught on another arm: {taught}; connected is {arm}. The same joint angles may "
        "hold the tool elsewhere. It was checked for {arm}, and nothing was converted. Watch the "
        "preview before you accept this."
    ),
    FindingCode.BELOW_FLOOR: (
        "The tool would be {value} mm below the plane the arm stands on. Accept this only if there "
        "is nothing."
    ),
}

_PARTS: Final = Texts("ArmPart") | {
    "base": "the base",
    "upper arm": "the upper arm",
    "forearm": "the forearm",
    "hand": "the wrist",
    "gripper": "the gripper",
}

_CYCLES: Final = Texts("FindingCycle") | {"later": "From cycle {cycle} on: {text}"}

CODES: Final = frozenset(_FINDINGS)
"""The findings there is a sentence for."""
PARTS: Final = frozenset(_PARTS)
"""The parts of the arm there is a word for."""


_APPROACH: Final = Texts("Finding") | {
    Approach.HERE: (
        "Where the arm stands now, it touches itself: {other} against {one}; after a stop it may "
        "have sunk. Jog it clear, or lift it by hand, then send again: nothing of the trajectory "
        "has to be changed."
    ),
    Approach.WAY: (
        "On the way there from where the arm stands now: {text} Bringing the arm nearer to this "
        "point first helps, too."
    ),
}


def finding(found: Finding) -> str:
    """What was found in the operator's language; the row is told beside it."""
    params = {k: _text(v) for k, v in found.params.items()}
    if found.code is FindingCode.OTHER_ARM:
        params = {k: arm_kind(v) for k, v in params.items()}
    if found.approach is Approach.HERE:
        return _APPROACH.text(found.approach, params)
    text = _FINDINGS.text(found.code, params)
    if found.approach is Approach.WAY:
        return _APPROACH.text(found.approach, {"text": text})
    if found.cycle == 1:
        return text
    return _CYCLES.text("later", {"cycle": str(found.cycle), "text": text})


def _text(value: float | str) -> str:
    if isinstance(value, str):
        return _PARTS.word(value)
    return f"{round(value, 3):g}" if isinstance(value, float) else str(value)
