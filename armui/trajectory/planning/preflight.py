"""The check before a run: the whole way is planned from where the arm is, and looked at.

Nothing here knows a window or a bus, so that it can be done in a process of its own: 10,000
points take from half a second to many seconds, by how far they lie apart.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

from armui.arm.model import ArmModel
from armui.trajectory.files import Content
from armui.trajectory.planning.check import check
from armui.trajectory.planning.findings import Finding, Severity
from armui.trajectory.planning.planned_path import PlannedPath
from armui.trajectory.planning.timing import plan_path
from armui.trajectory.points.program import Trajectory
from armui.trajectory.samples.recording import Recording
from armui.trajectory.samples.replay_profile import ReplayProfile, replay_profile


@dataclass(frozen=True, slots=True)
class CheckRequest:
    """What is to be checked.

    Attributes:
        content: What shall be run.
        arm: By which arm.
        start_deg: From where.
        speed_factor: On the speed of each point, or on the recorded one.
        first: The index of the point to begin with, in the first cycle.
        cycles: How often it shall be run; 0 until it is ended.
    """

    content: Content
    arm: ArmModel
    start_deg: tuple[float, ...]
    speed_factor: float = 1.0
    first: int = 0
    cycles: int = 1


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
    plan = partial(plan_path, content, arm, start_deg, first=order.first, cycles=order.cycles)
    path = plan(speed_factor=order.speed_factor)
    found = check(content, arm, start_deg, path).findings
    expected_s = path.expected_s
    if isinstance(content, Trajectory) and order.speed_factor != 1.0:
        # a run shortens what is planned at the points' own speeds by itself
        expected_s = plan().expected_s
    profile = replay_profile(content) if isinstance(content, Recording) else None
    by_place = {(one.code, one.row, one.approach): one for one in reversed(found)}
    return CheckOutcome(path, expected_s, tuple(sorted(by_place.values(), key=_rank)), profile)


def _rank(finding: Finding) -> tuple[bool, int]:
    """Errors come first, and what concerns the whole before its rows."""
    return finding.severity is not Severity.ERROR, -1 if finding.row is None else finding.row
