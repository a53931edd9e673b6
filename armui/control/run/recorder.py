"""Records the arm's path while it is led by hand, or moved by anything else."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from armui.arm.refusal import Refusal
from armui.control.context import Context, ControllerPart
from armui.control.events import Notice
from armui.control.link.link_state import why_unreachable
from armui.control.operating_state import BUSY, OperatingState
from armui.control.operations.operation import operation
from armui.control.operations.started import Ending, Started
from armui.control.run.sample_store import SampleStore
from armui.telemetry.events import Asker, EventKind, Level

if TYPE_CHECKING:
    from armui.control.run.sample_store import Recorded
    from armui.trajectory.samples.recording import Array

RECORDING_STARTED = Notice(
    "recording_started", "Recording the arm's motion", Level.INFO, EventKind.COMMAND
)
RECORDING_ENDED = Notice(
    "recording_ended",
    "Recorded: {count} samples over {seconds} s",
    Level.DONE,
    EventKind.RESULT,
    Asker.PROGRAM,
)


def why_not_record(now: OperatingState) -> Refusal | None:
    """Return why no recording may begin: there is nothing to hear, or one is under way."""
    if (refusal := why_unreachable(now.link)) is not None:
        return refusal
    return BUSY(what="recording") if now.recording else None


class Recorder(QObject, ControllerPart):
    """Keeps every joint feedback from :meth:`start` to :meth:`finish`; it sends nothing.

    When the arm is lost, what has been recorded is kept.

    Args:
        context: The context that the controller's parts share.

    Signals:
        changed: There are more samples, or recording has begun or ended.
    """

    changed = Signal()

    def __init__(self, context: Context, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._context = context
        self._samples: SampleStore | None = None
        self._recording = False
        self._started: Started | None = None
        self.dropped = 0

    @property
    def recording(self) -> bool:
        """True while it records."""
        return self._recording

    @property
    def count(self) -> int:
        """The number of samples."""
        return 0 if self._samples is None else len(self._samples)

    @property
    def duration_s(self) -> float:
        """The time from the first sample to the last."""
        return 0.0 if self._samples is None else self._samples.duration_s

    @operation("recorder.start", "Record the arm's motion", why_not_record)
    def start(self, started: Started) -> None:
        """Begin a new recording."""
        self._samples = SampleStore(self._context.operating_state().model_fit.taught_on)
        self.dropped = 0
        ring = self._context.connection.samples
        ring.take_samples()
        ring.dropped = 0
        ring.wanted = self._recording = True
        self._started = started
        self._context.emit_event(RECORDING_STARTED, started)
        self.changed.emit()

    def rows_from(self, first: int) -> Array | None:
        """Return a copy of the samples from an index on; ``None`` if there are none."""
        return None if self._samples is None else self._samples.rows_from(first)

    def finish(self, name: str) -> Recorded | None:
        """End recording.

        Args:
            name: The name of the recording.

        Returns:
            The samples since :meth:`start`, to be joined in another thread; ``None`` if there are
            none.
        """
        if self._recording:
            self._end()
        return None if self._samples is None else self._samples.recorded(name)

    def follow_arm(self) -> None:
        """Take in the new samples; the controller's tick calls it."""
        if not self._recording:
            return
        taken = self._context.connection.samples.take_samples()
        if taken and self._samples is not None:
            self._samples.extend(taken)
            self.dropped = self._context.connection.samples.dropped
            self.changed.emit()

    def forget_arm(self) -> None:
        """End the recording and keep its samples, because the arm is gone."""
        if self._recording:
            self._end()

    def _end(self) -> None:
        self.follow_arm()
        self._recording = False
        self._context.connection.samples.wanted = False
        figures = {"count": self.count, "seconds": round(self.duration_s, 1)}
        self._context.close(self._started, Ending.DONE, RECORDING_ENDED, **figures)
        self.changed.emit()
