"""The columns of a table of points, and the edit of a point through one of its cells."""

from __future__ import annotations

import enum
import re
from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from armui.arm.limits import JointLimits, check_joint
from armui.arm.refusal import Refusal
from armui.protocol.codes import MoveMode
from armui.trajectory.files.errors import TrajectoryFileError
from armui.trajectory.files.log_points import gripper_text, light_text, read_gripper, read_light
from armui.trajectory.files.text import number
from armui.trajectory.points.program import (
    POINT_INCOMPLETE,
    POINT_NOT_A_NUMBER,
    POINT_NOT_WHOLE,
    POSE_NAMES,
    VALUE_COUNT,
    WHOLE,
    Values,
    Waypoint,
    check_figure,
    check_point,
)

IN_FRAME: Final = "@"
"""The separator between the kind of motion and the user frame, as in ``MOVE L@Table``."""
HOLDS: Final = "holds="
"""The prefix of the held object's name from a point on; without a name nothing is held."""

_PARTING: Final = re.compile(r"[\s;,，；/]+")
_UNIT: Final = re.compile(r"\s*(?:°|deg|mm|%|s)$")


class PointColumn(enum.IntEnum):
    """The columns from left to right."""

    MOVE = 0
    VALUE_1 = 1
    VALUE_2 = 2
    VALUE_3 = 3
    VALUE_4 = 4
    VALUE_5 = 5
    VALUE_6 = 6
    MIDDLE = 7
    SPEED = 8
    DWELL = 9
    GRIPPER = 10
    LIGHT = 11
    NOTE = 12


VALUES: Final = range(PointColumn.VALUE_1, PointColumn.VALUE_6 + 1)
"""The columns of the six values of the target."""


def text_of(point: Waypoint, column: PointColumn) -> str:
    """Return the exact text of a cell for editing; :func:`edited` reads it."""
    if column in VALUES:
        return number(point.target[column - PointColumn.VALUE_1])
    if column is PointColumn.MIDDLE:
        return " ".join(map(number, point.middle or ()))
    if column is PointColumn.SPEED:
        return str(point.speed_percent)
    if column is PointColumn.DWELL:
        return number(point.dwell_s)
    if column is PointColumn.GRIPPER:
        gripper = "" if point.gripper is None else gripper_text(point.gripper)
        return gripper if point.holds is None else f"{gripper} {HOLDS}{point.holds}".lstrip()
    if column is PointColumn.LIGHT:
        return "" if point.light is None else light_text(point.light)
    if column is PointColumn.MOVE:
        return f"MOVE {point.move.name[-1]}" + (point.frame and f"{IN_FRAME}{point.frame}")
    return point.note


def edited(
    point: Waypoint, column: PointColumn, text: str, limits: Sequence[JointLimits] = ()
) -> Waypoint | Refusal:
    """Return a point after a text was entered in one of its cells, or why it is refused.

    Args:
        point: The point before.
        column: The cell's column; not that of the kind of motion, see
            :func:`armui.trajectory.planning.convert.to_move`.
        text: The text entered. A figure may have its unit behind it, and a decimal comma.
        limits: The limits of the six joints, within which an angle entered has to be; empty for
            any that some arm could have.

    Returns:
        The new point, or the reason against it.
    """
    try:
        changed = _edited(point, column, text.strip(), limits)
    except TrajectoryFileError as error:
        return error.refusal
    return changed if isinstance(changed, Refusal) else check_point(changed) or changed


def _edited(
    point: Waypoint, column: PointColumn, text: str, limits: Sequence[JointLimits]
) -> Waypoint | Refusal:
    if column in VALUES:
        place = column - PointColumn.VALUE_1
        joint = limits[place] if limits and point.is_joint else None
        value = figure(point.names[place], text, far=bool(point.frame), limits=joint)
        if isinstance(value, Refusal):
            return value
        target = (*point.target[:place], value, *point.target[place + 1 :])
        return replace(point, target=target)
    if column is PointColumn.MIDDLE:
        middle = _six(text, far=bool(point.frame))
        return middle if isinstance(middle, Refusal) else replace(point, middle=middle)
    if column is PointColumn.SPEED:
        value = figure("speed", text)
        return value if isinstance(value, Refusal) else replace(point, speed_percent=int(value))
    if column is PointColumn.DWELL:
        value = figure("dwell", text or "0")
        return value if isinstance(value, Refusal) else replace(point, dwell_s=value)
    if column is PointColumn.GRIPPER:
        action, sign, held = (part.strip() for part in text.partition(HOLDS))
        gripper = read_gripper(action, 0, 0) if action else None
        return replace(point, gripper=gripper, holds=held if sign else None)
    if column is PointColumn.LIGHT:
        return replace(point, light=read_light(text, 0, 0) if text else None)
    return replace(point, note=text)


def figure(
    field: str, text: str, *, far: bool = False, limits: JointLimits | None = None
) -> float | Refusal:
    """Return the figure in a text, or why a point cannot have it.

    Args:
        field: A key of `program.RANGES`.
        text: The text as typed: a unit behind the figure, a decimal comma and the typographic minus
            are understood.
        far: True for a point in a user frame.
        limits: Those of the joint, if the figure is the angle of one.
    """
    plain = _UNIT.sub("", text.strip()).replace("−", "-").replace(",", ".")
    try:
        value = float(plain)
    except ValueError:
        code = POINT_NOT_WHOLE if field in WHOLE else POINT_NOT_A_NUMBER
        return Refusal(code, {"field": field, "value": text.strip(), "unit": ""})
    beyond = None if limits is None else check_joint(int(field[1:]), value, limits)
    return beyond or check_figure(field, value, far=far) or value


def _six(text: str, *, far: bool) -> Values | Refusal:
    words = [word for word in _PARTING.split(text) if word]
    if len(words) != VALUE_COUNT:
        return POINT_INCOMPLETE(field="middle", value=len(words))
    values = [figure(name, word, far=far) for name, word in zip(POSE_NAMES, words, strict=True)]
    wrong = next((value for value in values if isinstance(value, Refusal)), None)
    return wrong or tuple(value for value in values if not isinstance(value, Refusal))


def editable(point: Waypoint, column: PointColumn) -> bool:
    """Return whether a cell can be edited: only arcs have a middle pose."""
    return column is not PointColumn.MIDDLE or point.move is MoveMode.MOVE_C
