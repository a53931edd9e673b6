"""Decides when the ring is saved after a fault or a stop, and not too often: pure."""

from __future__ import annotations

from typing import Final

from armui.session.session import MarkKind

AFTER_S: Final = 5.0
"""The time after a fault that is saved with it."""


class SaveAtFaults:
    """Decides when the ring is to be saved.

    It is saved a few seconds after a fault or a stop. Faults that come one after another are saved
    together: the next save comes when the frames after the last one are about to leave the ring, so
    that nothing is lost and hardly anything is saved twice.

    Args:
        keep_s: The time that the ring reaches back.
    """

    def __init__(self, keep_s: float) -> None:
        self._keep_s = keep_s
        self._due_s: float | None = None
        self._saved_s: float | None = None
        self._kind = MarkKind.FAULT

    def happened(self, mark: MarkKind, at_s: float) -> None:
        """Note an event; only faults and stops count."""
        if mark not in {MarkKind.FAULT, MarkKind.STOP} or self._due_s is not None:
            return
        self._kind = mark
        self._due_s = at_s + AFTER_S
        if self._saved_s is not None:
            self._due_s = max(self._due_s, self._saved_s + self._keep_s - 2 * AFTER_S)

    def take_due(self, now_s: float) -> MarkKind | None:
        """Return the event for which the ring is to be saved now, or ``None``."""
        if self._due_s is None or now_s < self._due_s:
            return None
        self._due_s, self._saved_s = None, now_s
        return self._kind

    def reset(self) -> None:
        """Forget the events: the operator no longer wants automatic saving."""
        self._due_s = None
