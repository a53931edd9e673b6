"""The operator's one speed while a run is under way: the share of its own pace."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from armui.control.context import Context, ControllerPart
from armui.control.events import Notice
from armui.control.motion.retransmission import Retransmission
from armui.control.operations.started import Ending, Started
from armui.telemetry.events import EventKind, Level

if TYPE_CHECKING:
    from collections.abc import Sequence

    from armui.arm.refusal import Refusal
    from armui.control.motion.joint_motion import Motion
    from armui.control.run.execution import Execution

RUN_SPEED_SET = Notice(
    "run_speed_set", "The run goes at {percent} %", Level.INFO, EventKind.COMMAND, streams=True
)
RUN_SPEED_LOWERED = Notice(
    "run_speed_lowered",
    "The speed at the top is lowered from {before} to {percent} % as the run begins",
    Level.INFO,
    EventKind.PROGRAM,
)

STEP_PERCENT: Final = 10
"""The change of the speed by one press of a key."""


class SpeedOverride(ControllerPart):
    """Passes the operator's speed on to the run or replay under way.

    A run begins at the operator's speed. When it is over, the speed is again what it was before,
    unless it was lowered meanwhile: it is never raised but by the operator.

    Args:
        context: The context that the controller's parts share.
        motion: Owns the speed while nothing runs.
        runs: The executions that it slows.
    """

    def __init__(self, context: Context, motion: Motion, runs: Sequence[Execution]) -> None:
        self._context = context
        self._motion = motion
        self._runs = runs
        self._lower_speed = Retransmission(context)
        self._under_way: Execution | None = None
        motion.set_speed_of_run = self._set
        for run in runs:
            run.progressed.connect(self._on_progressed)

    @property
    def percent(self) -> int:
        """The operator's speed: of the run under way, else of every other motion, 0–100."""
        run = self._running
        return self._motion.speed_percent if run is None else run.speed_percent

    @property
    def _running(self) -> Execution | None:
        return next((run for run in self._runs if run.running), None)

    def _set(self, started: Started, wanted: int) -> Refusal | None:
        """Set another speed for the run under way; a lower one is sent at once, 0 % holds it."""
        run = self._running
        if run is None:
            return None
        refusal = run.why_not_at(wanted)
        if refusal is not None:
            return refusal
        before = run.speed_percent
        self._lower_speed.drop()
        if 0 < wanted < before:
            self._lower_speed.schedule()
        started.close(Ending.SENT)
        if wanted != before:
            self._context.emit_event(RUN_SPEED_SET, started, percent=wanted)
            run.set_speed(wanted)
        self._context.refresh()
        return None

    def step(self, by_percent: int) -> Started | Refusal | None:
        """Change the operator's speed.

        Args:
            by_percent: The change; the result is limited to 0–100 %.
        """
        self._context.refresh()
        now = self.percent
        wanted = min(max(now + by_percent, 0), 100)
        return None if wanted == now else self._motion.set_speed_percent(wanted)

    def _on_progressed(self, _progress: object) -> None:
        """Keep the lower of the speeds before and in a run, as it begins and when it is over."""
        running, before = self._running, self._under_way
        run = running or before
        if run is not None and (running is None or before is None):
            now, of_run = self._motion.speed_percent, run.speed_percent
            self._motion.speed_percent = min(now, of_run)
            if before is None and of_run < now:
                self._context.emit_event(RUN_SPEED_LOWERED, before=now, percent=of_run)
        self._under_way = running

    def follow_arm(self) -> None:
        """Send a lower speed once more."""
        if self._lower_speed.take_due():
            for run in self._runs:
                run.send_speed()

    def halt(self) -> None:
        """Do not repeat a lower speed, because the runs end."""
        self._lower_speed.drop()

    def forget_arm(self) -> None:
        """Do not repeat a lower speed, because another arm may come."""
        self._lower_speed.drop()
