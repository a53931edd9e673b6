"""Reads every parameter of the arm, one question after the other, until stopped."""

from __future__ import annotations

from collections import deque

from PySide6.QtCore import QObject, Signal

from armui.arm.parameters import Batch
from armui.arm.refusal import Refusal
from armui.control.parameters.arm_settings import ArmSettings


class ParameterReader(QObject):
    """Asks each question after the one before was answered or given up.

    Args:
        settings: Asks the arm.

    Signals:
        progressed: The number of questions done, and their total.
        finished: ``None``, or the reason of an early end.
    """

    progressed = Signal(int, int)
    finished = Signal(object)

    def __init__(self, settings: ArmSettings, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._settings = settings
        self._waiting: deque[Batch] = deque()
        self._total = 0
        self._running = False
        settings.finished.connect(self._ask_next)

    @property
    def running(self) -> bool:
        """True if questions are under way."""
        return self._running

    def start(self) -> Refusal | None:
        """Ask the first question; return ``None``, or why the arm cannot be asked."""
        batches = self._settings.everything()
        if isinstance(batches, Refusal):
            return batches
        self._waiting = deque(batches)
        self._total = len(self._waiting)
        self._running = True
        if not self._settings.busy:
            self._ask_next()
        return None

    def stop(self) -> None:
        """Ask no more; the values read so far stay."""
        if self._running:
            self._end(None)

    def _ask_next(self) -> None:
        if not self._running:
            return
        self.progressed.emit(self._total - len(self._waiting), self._total)
        if not self._waiting:
            self._end(None)
            return
        refusal = self._settings.read([self._waiting.popleft()])
        if refusal is not None and self._running:
            self._end(refusal)

    def _end(self, refusal: Refusal | None) -> None:
        self._running = False
        self._waiting.clear()
        self.finished.emit(refusal)
