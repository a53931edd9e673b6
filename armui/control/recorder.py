"""B5: records where the arm goes while it is led by hand, or moved by anything."""

from __future__ import annotations

import math
from datetime import datetime
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from armui.arm.refusal import Refusal
from armui.control.context import Context
from armui.control.situation import why_unreachable

if TYPE_CHECKING:
    from armui.bus.samples import Sample
    from armui.trajectory.recording import Recording


class Recorder(QObject):
    """Keeps every joint feedback from :meth:`start` to :meth:`finish`; it sends nothing.

    When the arm is lost, what has been recorded is kept.

    Args:
        context: What the parts of the controller share.

    Signals:
        changed: More samples, or recording has begun or ended.
    """

    changed = Signal()

    def __init__(self, context: Context, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._context = context
        self._samples: list[Sample] = []
        self._recording = False
        self.dropped = 0

    @property
    def recording(self) -> bool:
        """Whether it records now."""
        return self._recording

    @property
    def count(self) -> int:
        """How many samples there are."""
        return len(self._samples)

    @property
    def duration_s(self) -> float:
        """From the first sample to the last."""
        return self._samples[-1].at_s - self._samples[0].at_s if self._samples else 0.0

    def start(self) -> Refusal | None:
        """Begin anew: ``None``, or why not."""
        refusal = why_unreachable(self._context.connection.link)
        if refusal is None and self._recording:
            refusal = Refusal("busy", {"what": "recording"})
        if refusal is not None:
            return self._context.refuse(refusal)
        self._samples = []
        self.dropped = 0
        ring = self._context.connection.samples
        ring.take()
        ring.dropped = 0
        ring.wanted = self._recording = True
        self._context.tell("recording_started")
        self.changed.emit()
        return None

    def finish(self, name: str) -> Recording | None:
        """End recording.

        Args:
            name: What it is to be called.

        Returns:
            What was recorded since :meth:`start`, ``None`` if that is nothing.
        """
        import numpy as np  # noqa: PLC0415 - loaded when there is something to keep

        from armui.trajectory.recording import Recording  # noqa: PLC0415

        if self._recording:
            self._end()
        if not self._samples:
            return None
        start_s = self._samples[0].at_s
        rows = [
            (
                sample.at_s - start_s,
                *sample.joints_deg,
                math.nan if sample.gripper_mm is None else sample.gripper_mm,
            )
            for sample in self._samples
        ]
        return Recording(name, samples=np.array(rows), modified=datetime.now().astimezone())

    def advance(self) -> None:
        """Take in what has come; the controller's tick calls it."""
        if not self._recording:
            return
        taken = self._context.connection.samples.take()
        if taken:
            self._samples += taken
            self.dropped = self._context.connection.samples.dropped
            self.changed.emit()

    def halt(self) -> None:
        """A stopped arm may be recorded as well."""

    def forget(self) -> None:
        """The arm is gone: recording ends, what there is is kept."""
        if self._recording:
            self._end()

    def _end(self) -> None:
        self.advance()
        self._recording = False
        self._context.connection.samples.wanted = False
        self._context.tell("recording_ended", count=self.count, seconds=round(self.duration_s, 1))
        self.changed.emit()
