"""Has what is to be run checked in the background, for the arm that is connected."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QElapsedTimer, QObject, Signal

from armui.arm.refusal import Refusal
from armui.control.arm_model import arm_model, start_deg
from armui.trajectory.findings import Finding, Severity
from armui.trajectory.preflight import Order, Outcome, preflight, warm_up

if TYPE_CHECKING:
    from concurrent.futures import Executor, Future

    from armui.control.arm_controller import ArmController
    from armui.trajectory.files import Content
    from armui.trajectory.library import Check
    from armui.trajectory.path import Path
    from armui.ui.trajectory.runner import RunOptions

_SAME_PLACE_DEG: Final = 0.5
"""An arm at rest is heard to tremble by some hundredths."""


@dataclass(frozen=True, slots=True)
class Preflight:
    """A check that has ended.

    Attributes:
        order: What was checked.
        outcome: How it ended.
        took_s: How long the operator has waited for it.
    """

    order: Order
    outcome: Outcome
    took_s: float = 0.0

    @property
    def content(self) -> Content:
        """What was checked."""
        return self.order.content

    @property
    def path(self) -> Path:
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
    def mark(self) -> Check:
        """The check mark it gives."""
        return "errors" if self.errors else "warnings" if self.findings else "ok"

    def why_outdated(self, controller: ArmController) -> Refusal | None:
        """Why it says nothing of a run that begins now, or ``None``: it does."""
        pairs = zip(self.order.start_deg, start_deg(controller), strict=True)
        moved_deg = max(abs(there - here) for there, here in pairs)
        if moved_deg > _SAME_PLACE_DEG:
            return Refusal("moved_since_check", {"value": f"{moved_deg:.1f}"})
        if self.order.arm.limits != controller.situation.limits:
            return Refusal("limits_changed_since_check")
        return None


@dataclass(slots=True, eq=False)
class CheckJob:
    """A check that somebody waits for.

    Attributes:
        order: What is checked.
        then: Gets the :class:`Preflight`, or the :class:`Refusal` that says why there is none.
        wanted: Whether anybody waits for it still.
        clock: Tells how long.
    """

    order: Order
    then: Callable[[Preflight | Refusal], object]
    wanted: bool = True
    clock: QElapsedTimer = field(default_factory=QElapsedTimer)


class Checks(QObject):
    """Has checks done one after another, out of the window's way.

    Args:
        controller: Knows the arm.
        workers: Who does them.
    """

    _arrived = Signal(object, object)

    def __init__(
        self, controller: ArmController, workers: Executor, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._controller = controller
        self._workers = workers
        self._arrived.connect(self._on_arrived)

    def get_ready(self) -> None:
        """Begin to load what checks need: one will be asked for soon."""
        self._workers.submit(warm_up)

    def job(
        self,
        content: Content,
        options: RunOptions,
        then: Callable[[Preflight | Refusal], object],
    ) -> CheckJob:
        """A check of something that shall be run from where the arm is now."""
        order = Order(
            content,
            arm_model(self._controller),
            start_deg(self._controller),
            options.speed_factor,
            options.first,
            options.laps != 1,
        )
        return CheckJob(order, then)

    def start(self, job: CheckJob) -> None:
        """Begin a check; its :attr:`CheckJob.then` is called in this thread."""
        job.clock.start()
        future = self._workers.submit(preflight, job.order)
        # the signal brings it here from whichever thread
        future.add_done_callback(lambda done: self._arrived.emit(job, done))

    def _on_arrived(self, job: CheckJob, done: Future[Outcome]) -> None:
        if not job.wanted or done.cancelled():
            return
        error = done.exception()
        if error is None:
            job.then(Preflight(job.order, done.result(), job.clock.elapsed() / 1e3))
        else:
            job.then(Refusal("check_failed", {"text": str(error) or type(error).__name__}))
