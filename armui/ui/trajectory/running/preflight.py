"""Has what is to be run checked in the background, for the arm that is connected."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QElapsedTimer

from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode
from armui.control.parameters.arm_model import arm_model, start_deg
from armui.trajectory.planning.check import CheckOutcome, CheckRequest, preflight, warm_up
from armui.trajectory.planning.findings import Finding, Severity
from armui.ui.background import Job

if TYPE_CHECKING:
    from armui.arm.models import ArmModel
    from armui.control.arm_controller import ArmController
    from armui.control.link.arm_mark import ArmMark
    from armui.trajectory.files import Content
    from armui.trajectory.library.run_options import RunOptions
    from armui.trajectory.library.store import Check
    from armui.trajectory.planning.planned_path import PlannedPath
    from armui.ui.background import Background

_SAME_PLACE_DEG: Final = 0.5
"""An arm at rest is heard to tremble by some hundredths."""


@dataclass(frozen=True, slots=True)
class CheckBasis:
    """What a check belongs to, beside what is run and where the arm stands: compared whole.

    Attributes:
        mark: The arm and the connection.
        arm: The arm as a plan sees it: limits, geometry and zeros, tool, gripper.
        alterations: How often this program had set something of the arm by then, a load also.
        options: How the operator wants it run.
    """

    mark: ArmMark
    arm: ArmModel
    alterations: int
    options: RunOptions

    @classmethod
    def of(cls, controller: ArmController, options: RunOptions) -> CheckBasis:
        """Return what a check would belong to now."""
        arm, altered = arm_model(controller), controller.transactions.alterations
        return cls(controller.mark, arm, altered, options)

    def why_other(self, now: CheckBasis) -> Refusal | None:
        """Return the reason why a check for this says nothing of a run under ``now``."""
        if not self.mark.is_still(now.mark):
            return Refusal(RefusalCode.ARM_CHANGED)
        if self.arm.limits != now.arm.limits:
            return Refusal(RefusalCode.LIMITS_CHANGED_SINCE_CHECK)
        if self.arm.kinematics != now.arm.kinematics:
            return Refusal(RefusalCode.MODEL_CHANGED_SINCE_CHECK)
        if replace(self, mark=now.mark) != now:
            return Refusal(RefusalCode.CHANGED_SINCE_CHECK)
        return None


@dataclass(frozen=True, slots=True)
class Preflight:
    """A check that has ended.

    Attributes:
        order: What was checked.
        outcome: How it ended.
        basis: What it belongs to.
        took_s: How long the operator has waited for it.
    """

    order: CheckRequest
    outcome: CheckOutcome
    basis: CheckBasis
    took_s: float = 0.0

    @property
    def content(self) -> Content:
        """What was checked."""
        return self.order.content

    @property
    def path(self) -> PlannedPath:
        """Where the arm would go."""
        return self.outcome.path

    @property
    def findings(self) -> tuple[Finding, ...]:
        """What was found, errors first, then by row."""
        return self.outcome.findings

    @property
    def errors(self) -> int:
        """How many findings forbid it to be run."""
        return sum(finding.severity is Severity.ERROR for finding in self.findings)

    @property
    def whole(self) -> bool:
        """Whether all rows were looked at: a run from a later row, once, leaves some out."""
        return not self.order.first or self.order.cycles != 1

    @property
    def mark(self) -> Check:
        """The check mark it gives what was checked, wherever the arm is."""
        of_content = [one.severity for one in self.findings if not one.is_of_approach]
        return "errors" if Severity.ERROR in of_content else "warnings" if of_content else "ok"

    def why_outdated(self, controller: ArmController, options: RunOptions) -> Refusal | None:
        """Why it says nothing of a run that begins now with these options, or ``None``: it does."""
        pairs = zip(self.order.start_deg, start_deg(controller), strict=True)
        moved_deg = max(abs(there - here) for there, here in pairs)
        if moved_deg > _SAME_PLACE_DEG:
            return Refusal(RefusalCode.MOVED_SINCE_CHECK, {"value": f"{moved_deg:.1f}"})
        return self.basis.why_other(CheckBasis.of(controller, options))


@dataclass(slots=True, eq=False)
class CheckJob:
    """A check that somebody waits for.

    Attributes:
        order: What is checked.
        job: The work.
    """

    order: CheckRequest
    job: Job[CheckOutcome]

    def drop(self) -> None:
        """Nobody waits for it any more."""
        self.job.wanted = False


class Checks:
    """Has checks done one after another, out of the window's way.

    Args:
        controller: Knows the arm.
        background: Where they are done.
    """

    def __init__(self, controller: ArmController, background: Background) -> None:
        self._controller = controller
        self._background = background

    def get_ready(self) -> None:
        """Begin to load what checks need: one will be asked for soon."""
        self._background.warm_up(warm_up)

    def prepare(
        self, content: Content, options: RunOptions, then: Callable[[Preflight | Refusal], object]
    ) -> CheckJob:
        """A check of something that shall be run from where the arm is now.

        Args:
            content: What shall be run.
            options: How.
            then: Gets the :class:`Preflight`, or why there is none.
        """
        basis = CheckBasis.of(self._controller, options)
        order = CheckRequest(
            content,
            basis.arm,
            start_deg(self._controller),
            options.speed_factor,
            options.first,
            options.cycles,
        )
        clock = QElapsedTimer()
        clock.start()

        def take(outcome: CheckOutcome | Refusal) -> None:
            if isinstance(outcome, Refusal):
                then(outcome)
            else:
                then(Preflight(order, outcome, basis, clock.elapsed() / 1e3))

        return CheckJob(order, Job(take))

    def begin(self, check: CheckJob) -> None:
        """Begin a check; what it was prepared for is called in this thread."""
        self._background.begin(check.job, preflight, check.order)
