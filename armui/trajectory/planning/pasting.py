"""Points as text for and from the clipboard: shown for a tool, kept for the flange."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from armui.arm.limits import JointLimits
from armui.arm.refusal import Reason, Refusal
from armui.protocol.codes import MoveMode
from armui.trajectory.files.errors import TrajectoryFileError
from armui.trajectory.planning.tool_points import ToolPoints
from armui.trajectory.points.clipboard import PastedPoints, pasted, to_text
from armui.trajectory.points.program import Values, Waypoint, check_point

PASTED_OF_TOOL = Reason(
    "pasted_of_tool",
    "These poses are of a tool, and none is in force. Choose that tool under Cell, then paste "
    "again.",
)


def copied(points: Sequence[Waypoint], tool: ToolPoints) -> str:
    """Return the text of points as they are shown, for the clipboard."""
    return to_text(tool.all_shown(points), of_tool=not tool.is_flange)


def kept_from(
    text: str,
    like: MoveMode,
    shown: ToolPoints,
    told: Values | None,
    limits: Sequence[JointLimits],
) -> PastedPoints | Refusal | TrajectoryFileError:
    """Return the points in a text as they are kept, or why they are not.

    Args:
        text: The text from the clipboard.
        like: The kind of motion of rows that do not name one.
        shown: The tool whose poses the table shows.
        told: The tool that the clipboard names; ``None`` if its poses are of the one shown.
        limits: Those of the six joints, for angles that do not come from a table of points.
    """
    try:
        new = pasted(text, like, limits if told is None else ())
    except TrajectoryFileError as error:
        return error
    if new.is_file:
        return new
    if new.of_tool and told is None and shown.is_flange:
        return PASTED_OF_TOOL()
    tool = shown if told is None or told == tuple(shown.tool) else ToolPoints(told)
    points = tool.all_kept(new.points)
    refusal = next(filter(None, map(check_point, points)), None)
    return refusal or replace(new, points=tuple(points))
