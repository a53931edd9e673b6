"""The check before running: what is planned, and what speaks against it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Final

from armui.control.arm_model import arm_model, start_deg
from armui.trajectory.check import check
from armui.trajectory.findings import Finding, Severity
from armui.trajectory.program import Trajectory
from armui.trajectory.timing import plan_path

if TYPE_CHECKING:
    from armui.arm.model import ArmModel
    from armui.control.arm_controller import ArmController
    from armui.trajectory.files import Content
    from armui.trajectory.library import Check
    from armui.trajectory.path import Path
    from armui.ui.trajectory.runner import RunOptions

_FAR: Final = "far_from_start"
"""Said of the way to the first point; other ways are as long as they were written."""


@dataclass(frozen=True, slots=True)
class Preflight:
    """How a check has ended.

    Attributes:
        content: What was checked.
        path: Where the arm would go.
        expected_s: How long each point takes at its own speed; of a recording empty.
        findings: What was found, errors first, then by row.
        speed_factor: What it was planned with.
    """

    content: Content
    path: Path
    expected_s: tuple[float, ...]
    findings: tuple[Finding, ...]
    speed_factor: float

    @property
    def errors(self) -> int:
        """How many findings forbid it to be run."""
        return sum(finding.severity is Severity.ERROR for finding in self.findings)

    @property
    def mark(self) -> Check:
        """The check mark it gives."""
        return "errors" if self.errors else "warnings" if self.findings else "ok"


def preflight(controller: ArmController, content: Content, options: RunOptions) -> Preflight:
    """Plan and check a trajectory or recording from where the arm is now.

    Args:
        controller: Knows the arm.
        content: What shall be run.
        options: How: another first row is come to from elsewhere, and so is the first of a lap.
    """
    arm, start = arm_model(controller), start_deg(controller)
    path = plan_path(content, arm, start, speed_factor=options.speed_factor)
    found = list(check(content, arm, start, path).findings)
    expected_s = path.expected_s
    if isinstance(content, Trajectory) and content.points:
        if options.speed_factor != 1.0:
            # a run shortens what is planned at the points' own speeds by itself
            expected_s = plan_path(content, arm, start).expected_s
        if options.first:
            found = [one for one in found if one.code != _FAR]
            found += _coming_to(content, options.first, arm, start)
        if options.laps != 1 and len(path.joints_deg):
            last_deg = path.joints_deg[-1].tolist()
            found += [one for one in _coming_to(content, 0, arm, last_deg) if one.code != _FAR]
    by_place = {(one.code, one.row): one for one in reversed(found)}
    findings = sorted(by_place.values(), key=_rank)
    return Preflight(content, path, expected_s, tuple(findings), options.speed_factor)


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
