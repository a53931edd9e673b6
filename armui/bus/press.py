"""A press of the operator: what it sends begins within a second, or never (safety S14)."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(eq=False, slots=True)
class Press:
    """A press whose frames may be sent several times, as batches of an outbox.

    Attributes:
        until_s: No batch of it begins after this monotonic time, unless one has begun before.
        begun: True once a frame of it has left; the outbox sets it.
    """

    until_s: float
    begun: bool = False

    def is_over(self, now_s: float) -> bool:
        """Return whether nothing of it has left in time, so that nothing may any more."""
        return not self.begun and self.until_s < now_s
