"""The checks and estimates of a page's content, worked out in the background."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from armui.control.parameters.arm_model import arm_model
from armui.control.run.preflight import RunChecks
from armui.trajectory.planning.check import warm_up
from armui.trajectory.planning.estimate import estimates_s
from armui.ui.background import Job

if TYPE_CHECKING:
    from armui.arm.models import ArmModel
    from armui.arm.refusal import Refusal
    from armui.control.arm_controller import ArmController
    from armui.trajectory.files import Content
    from armui.trajectory.library.run_options import RunOptions
    from armui.ui.background import Background


class Checks(RunChecks):
    """Runs checks and estimates one after another in the background.

    Args:
        controller: Gives the arm's state.
        background: Runs them.

    Attributes:
        background: Runs them, and other long work on points.
    """

    def __init__(self, controller: ArmController, background: Background) -> None:
        super().__init__(controller, background)
        self.background = background

    def get_ready(self) -> None:
        """Load the modules of checks in advance."""
        self.background.warm_up(warm_up)

    @property
    def arm(self) -> ArmModel:
        """The arm as a plan sees it now."""
        return arm_model(self._controller)

    @property
    def stands_at_deg(self) -> tuple[float, ...] | None:
        """The joint angles of an arm at rest, to a degree; ``None`` if they are not known."""
        now, state = self._controller.operating_state, self._controller.state
        angles_deg = None if now.moving or now.unreachable else state.angles_deg()
        return None if angles_deg is None else tuple(float(round(each)) for each in angles_deg)

    def estimate(
        self,
        content: Content,
        options: RunOptions,
        percents: Sequence[int],
        then: Callable[[tuple[float | None, ...] | Refusal], object],
    ) -> Job[tuple[float | None, ...]]:
        """Work out how long something takes at some speeds, see `estimates_s`.

        It is told in this thread.

        Returns:
            What is waited for; it may not be wanted any more.
        """
        job: Job[tuple[float | None, ...]] = Job(then)
        arm, here = self.arm, self.stands_at_deg
        self.background.begin(job, estimates_s, content, arm, options, percents, here)
        return job
