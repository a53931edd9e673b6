"""The check before a run: the whole way is planned from where the arm is, and looked at.

Nothing here knows a window or a bus, so that it can be done in a process of its own: 10,000
points take from half a second to many seconds, by how far they lie apart.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Final

from armui.arm.model import ArmModel
from armui.protocol.codes import MoveMode
from armui.trajectory.files import Content
from armui.trajectory.planning.check import check
from armui.trajectory.planning.findings import Finding, FindingCode, Severity
from armui.trajectory.planning.planned_path import PlannedPath
from armui.trajectory.planning.timing import APPROACH_PERCENT, plan_path
from armui.trajectory.points.program import Trajectory, Waypoint
from armui.trajectory.samples.recording import Recording
from armui.trajectory.samples.replay_profile import ReplayProfile, replay_profile

_FAR: Final = FindingCode.FAR_FROM_START
"""Said of the way to the first point; other ways are as long as they were written."""


@dataclass(frozen=True, slots=True)
class CheckRequest:
    """What is to be checked.

    Attributes:
        content: What shall be run.
        arm: By which arm.
        start_deg: From where.
        speed_factor: On the speed of each point, or on the recorded one.
        first: The index of the point to begin with: it is come to from elsewhere.
        again: Whether the first point, or sample, is come to from the last, in another cycle.
    """

    content: Content
    arm: ArmModel
    start_deg: tuple[float, ...]
    speed_factor: float = 1.0
    first: int = 0
    again: bool = False


@dataclass(frozen=True, slots=True)
class CheckOutcome:
    """How a check has ended.

    Attributes:
        path: Where the arm would go.
        expected_s: How long each point takes at its own speed; of a recording empty.
        findings: What was found, errors first, then by row.
        profile: What a replay must know of a recording; ``None`` for points.
    """

    path: PlannedPath
    expected_s: tuple[float, ...]
    findings: tuple[Finding, ...]
    profile: ReplayProfile | None = None


def warm_up() -> None:
    """Nothing: but where it has run, this module and its libraries are loaded."""


def preflight(order: CheckRequest) -> CheckOutcome:
    """Plan and check a trajectory or recording."""
    content, arm, start_deg = order.content, order.arm, order.start_deg
    path = plan_path(content, arm, start_deg, speed_factor=order.speed_factor)
    found = list(check(content, arm, start_deg, path).findings)
    expected_s = path.expected_s
    if isinstance(content, Trajectory) and content.points:
        if order.speed_factor != 1.0:
            # a run shortens what is planned at the points' own speeds by itself
            expected_s = plan_path(content, arm, start_deg).expected_s
        if order.first:
            found = [one for one in found if one.code != _FAR]
            found += _coming_to(content, order.first, arm, start_deg)
        if order.again and len(path.joints_deg):
            last_deg = path.joints_deg[-1].tolist()
            back = (one for one in _coming_to(content, 0, arm, last_deg) if one.code != _FAR)
            found += [replace(one, approach=None) for one in back]
    profile = None
    if isinstance(content, Recording):
        profile = replay_profile(content)
        if order.again and len(content.samples) > 1:
            found += _way_back(content, arm)
    by_place = {(one.code, one.row, one.approach): one for one in reversed(found)}
    return CheckOutcome(path, expected_s, tuple(sorted(by_place.values(), key=_rank)), profile)


def _way_back(recording: Recording, arm: ArmModel) -> list[Finding]:
    """What the check finds of the way from the last sample back to the first, for another cycle."""
    first_deg = tuple(recording.joints_deg[0].tolist())
    point = Waypoint(MoveMode.MOVE_J, first_deg, speed_percent=APPROACH_PERCENT)
    way = Trajectory(recording.name, points=(point,))
    last_deg = recording.joints_deg[-1].tolist()
    back = (one for one in _coming_to(way, 0, arm, last_deg) if one.code != _FAR)
    return [replace(one, approach=None) for one in back]


def _coming_to(
    content: Trajectory, row: int, arm: ArmModel, from_deg: Sequence[float]
) -> Iterator[Finding]:
    """What the check finds of one row when the arm comes to it from elsewhere."""
    alone = replace(content, points=content.points[row : row + 1])
    for finding in check(alone, arm, from_deg).findings:
        yield replace(finding, row=row)


def _rank(finding: Finding) -> tuple[bool, int]:
    """Errors come first, and what concerns the whole before its rows."""
    return finding.severity is not Severity.ERROR, -1 if finding.row is None else finding.row
