"""The speed override: the share of their own speed at which runs and replays go."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from armui.arm.figures import PERCENT, Percent, check_figure
from armui.arm.refusal import Refusal
from armui.control.context import Context, ControllerPart
from armui.control.events import Notice
from armui.control.motion.retransmission import Retransmission
from armui.control.operations.operation import declare, record_start
from armui.control.operations.started import Ending, Started
from armui.control.run.player import NOT_RUNNING
from armui.telemetry.events import EventKind, Level

if TYPE_CHECKING:
    from collections.abc import Sequence

    from armui.control.motion.joint_motion import Motion
    from armui.control.operating_state import OperatingState
    from armui.control.run.execution import Execution

OVERRIDE_SET = Notice(
    "override_set", "Speed override {percent} %", Level.INFO, EventKind.COMMAND, streams=True
)

FULL_PERCENT: Final = 100
"""The override at which everything goes at its own speed."""
STEP_PERCENT: Final = 10
"""The change of a speed by one press of a key."""


def why_no_override(now: OperatingState, percent: float) -> Refusal | None:
    """Return why the override may not be set: 0 % is a pause, so there must be a run to pause."""
    if (refusal := check_figure("percent", percent, PERCENT)) is not None:
        return refusal
    if percent < 1 and not now.running:
        return NOT_RUNNING()
    return None


class SpeedOverride(ControllerPart):
    """Keeps the override and passes it on to runs and replays.

    It keeps the operator's choice from one run to the next. After a run held back at 0 % the choice
    before that holds again.

    Args:
        context: The context that the controller's parts share.
        motion: Owns the speed of every other motion.
        runs: The executions that it slows.

    Attributes:
        percent: The share of a run's or replay's own speed, 0–100.
    """

    def __init__(self, context: Context, motion: Motion, runs: Sequence[Execution]) -> None:
        self._context = context
        self._motion = motion
        self._runs = runs
        self._lower_speed = Retransmission(context)
        self._before_zero = self.percent = FULL_PERCENT

    @declare("run.override", "Set the speed override of runs", why_no_override)
    def set_percent(self, percent: Percent) -> Started | Refusal | None:
        """Set the share of their own speed for runs and replays, from this moment on.

        It may be lowered at once. At 0 % a run is held back until a held press on 继续.

        Args:
            percent: The share.

        Returns:
            The record of the command, or why nothing was sent; ``None`` where it is so already.
        """
        context = self._context
        refusal = why_no_override(context.refresh(), percent)
        if refusal is not None:
            return context.refuse(refusal)
        wanted, before = round(percent), self.percent
        if wanted == before:
            return None
        if wanted > 0:
            self._before_zero = wanted
        self.percent = wanted
        self._lower_speed.drop()
        if 0 < wanted < before:
            self._lower_speed.schedule()
        started = record_start(self.set_percent)
        started.close(Ending.SENT)
        context.tell(OVERRIDE_SET, started, percent=wanted)
        for run in self._runs:
            run.set_override(wanted)
        context.refresh()
        return started

    def step(self, by_percent: int) -> Started | Refusal | None:
        """Change the present speed: of the run under way, else of every other motion.

        Args:
            by_percent: The change; the result is limited to 0–100 %.
        """
        running = self._context.refresh().running
        now = self.percent if running else self._motion.speed_percent
        wanted = min(max(now + by_percent, 0), 100)
        if wanted == now:
            return None
        return self.set_percent(wanted) if running else self._motion.set_speed_percent(wanted)

    def follow_arm(self) -> None:
        """Send a lower speed once more; forget 0 % when nothing is left to hold back."""
        running = any(run.running for run in self._runs)
        if self.percent == 0 and not running:
            self.percent = self._before_zero
            for run in self._runs:
                run.set_override(self.percent)
        if self._lower_speed.take_due():
            for run in self._runs:
                run.tell_speed()

    def halt(self) -> None:
        """Do not repeat a lower speed, because the runs end."""
        self._lower_speed.drop()

    def forget_arm(self) -> None:
        """Do not repeat a lower speed, because another arm may come."""
        self._lower_speed.drop()
