"""Where in the picture the findings of a check stand."""

from __future__ import annotations

from typing import TYPE_CHECKING

from armui.trajectory.planning.findings import Severity
from armui.ui.words.findings import finding as finding_text
from armui.viewport.path_picture import FindingMark

if TYPE_CHECKING:
    from collections.abc import Mapping

    from armui.trajectory.planning.findings import Finding
    from armui.ui.trajectory.running.preflight import Preflight

_MOST = 200
"""More signs than anybody looks at would hide the path."""


def finding_marks(checked: Preflight) -> tuple[FindingMark, ...]:
    """The findings that happen at a place, errors first."""
    path = checked.path
    ends = path.ends()
    marks = []
    for found in checked.findings[:_MOST]:
        place_mm = _place_mm(checked, found, ends)
        if place_mm is not None:
            error = found.severity is Severity.ERROR
            marks.append(FindingMark(place_mm, error, found.row, finding_text(found)))
    return tuple(marks)


def _place_mm(
    checked: Preflight, found: Finding, ends: Mapping[int, int]
) -> tuple[float, float, float] | None:
    """Where it happens: as the check says, else where the arm would stand, else at its point."""
    if found.place_mm is not None:
        x, y, z = found.place_mm
        return x, y, z
    if found.joints_deg is not None:
        arm = checked.order.arm
        flange = arm.kinematics.matrix(found.joints_deg)
        x, y, z = (flange[:3, 3] + arm.tool_mm * flange[:3, 2]).tolist()
        return x, y, z
    if found.row is not None and found.row in ends:
        x, y, z = checked.path.places_mm[ends[found.row]].tolist()
        return x, y, z
    return None
