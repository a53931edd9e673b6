"""The check before running: what is planned, and what speaks against it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from armui.control.arm_model import arm_model, start_deg
from armui.trajectory.findings import Finding, Severity
from armui.trajectory.recording import Recording
from armui.trajectory.timing import plan_path

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.trajectory.files import Content
    from armui.trajectory.library import Check
    from armui.trajectory.path import Path


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


def preflight(controller: ArmController, content: Content, speed_factor: float = 1.0) -> Preflight:
    """Plan and check a trajectory or recording from where the arm is now.

    Args:
        controller: Knows the arm.
        content: What shall be run.
        speed_factor: On the speeds of its points, or the recorded ones.
    """
    arm, start = arm_model(controller), start_deg(controller)
    path = plan_path(content, arm, start, speed_factor=speed_factor)
    expected_s = path.expected_s
    if speed_factor != 1.0 and not isinstance(content, Recording):
        # a run shortens what is planned at the points' own speeds by itself
        expected_s = plan_path(content, arm, start).expected_s
    findings = sorted(
        path.problems,
        key=lambda finding: (
            finding.severity is not Severity.ERROR,
            -1 if finding.row is None else finding.row,
        ),
    )
    return Preflight(content, path, expected_s, tuple(findings), speed_factor)
