"""Starts trajectories and recordings, and follows whichever of them moves the arm."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from armui.arm.refusal import Refusal
from armui.control.operations.started import refusal_of
from armui.control.run.progress import OVER, Progress, Run, RunPhase
from armui.control.run.replay import Replay
from armui.trajectory.samples.recording import Recording

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.control.operations.started import Started
    from armui.control.run.preflight import Preflight
    from armui.trajectory.points.program import Waypoint


class Runner(QObject):
    """A common interface to the controller's two parts that run something.

    Args:
        controller: Its player runs points, its replayer recordings.

    Signals:
        progressed: A :class:`Progress` of the one that was started last.
    """

    progressed = Signal(object)

    def __init__(self, controller: ArmController, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._controller = controller
        self._compared: tuple[object, object, bool] = (None, None, False)
        controller.player.progressed.connect(self.progressed)
        controller.replayer.progressed.connect(self.progressed)

    @property
    def running(self) -> bool:
        """True if a run moves the arm, or will."""
        return self._controller.last_run.running

    @property
    def progress(self) -> Progress:
        """The progress of the present run, or of the last one."""
        return self._controller.last_run.progress

    def goes_by(self, points: Sequence[Waypoint]) -> bool:
        """Return whether the present run of points, or the last one, goes by these."""
        rows = self._controller.player.rows
        if self._compared[0] is not rows or self._compared[1] is not points:
            self._compared = rows, points, rows == points  # kept: slow with 10,000 points
        return self._compared[2]

    def start(self, checked: Preflight, speed_percent: int) -> Refusal | None:
        """Run a checked content; return ``None`` if the run has begun, or why not."""
        return refusal_of(self.begin(checked, speed_percent))

    def begin(self, checked: Preflight, speed_percent: int) -> Started | Refusal:
        """Run a checked content; return the record of the run, or why it has not begun.

        Args:
            checked: The checked content.
            speed_percent: The operator's speed as it begins.
        """
        content, asked, options = checked.content, checked.order.content, checked.basis.options
        if isinstance(content, Recording):
            replay = Replay(content, speed_percent, options.cycles, checked.outcome.profile)
            return self._controller.replayer.start(replay)
        run = Run(
            content.name,
            content.points,
            checked.outcome.expected_s,
            options.cycles,
            options.first,
            speed_percent,
            options.step_by_step,
            checked.outcome.path.even_s,
            () if isinstance(asked, Recording) else asked.points,
        )
        return self._controller.player.start(run)

    def pause(self) -> Refusal | None:
        """Have the arm hold where it is."""
        return refusal_of(self._controller.last_run.pause())

    def go_on(self) -> Refusal | None:
        """End a pause, or begin the next step."""
        return refusal_of(self._controller.last_run.go_on())

    def stop(self) -> None:
        """End the run; the arm stays powered."""
        self._controller.last_run.stop()


def can_pause(progress: Progress) -> bool:
    """Return whether there is a motion or a dwell that can be paused."""
    return progress.phase in {RunPhase.MOVING, RunPhase.DWELLING}


def ended_early(progress: Progress) -> bool:
    """Return whether a run ended before its end; one of points can be continued."""
    return progress.phase in OVER - {RunPhase.IDLE, RunPhase.DONE}
