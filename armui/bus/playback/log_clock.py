"""The time of a log that is replayed; it stands still unless the replay moves it."""

from __future__ import annotations


class LogClock:
    """What a controller that watches a log takes for its clock.

    Args:
        at_s: Log time to begin with, in seconds.
    """

    def __init__(self, at_s: float = 0.0) -> None:
        self._at_s = at_s

    def __call__(self) -> float:
        """Log time, in seconds; any thread."""
        return self._at_s

    def set(self, at_s: float) -> None:
        """The replay has come to this place."""
        self._at_s = at_s
