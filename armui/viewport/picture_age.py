"""How old the picture is beside what it should show (safety promise S24). No Qt, no clock."""

from __future__ import annotations

from collections import deque
from typing import Final

LONGEST_S: Final = 0.25
"""An older picture looks old."""

_CLEAR_S: Final = 0.15
"""A picture that looked old looks new again when it comes no later than this: no flicker."""

_REMEMBERED: Final = 256


class PictureAge:
    """Follows the states that were wanted and shown, each by its sequence number.

    A picture is as old as the first state that is newer than the one it shows.
    """

    def __init__(self) -> None:
        self._shown = 0
        self._newer: deque[tuple[int, float]] = deque(maxlen=_REMEMBERED)
        self._looks_old = False

    @property
    def is_newest_shown(self) -> bool:
        """Whether the picture shows the newest state."""
        return not self._newer

    def wanted(self, sequence: int, now_s: float) -> None:
        """There is a newer state."""
        self._newer.append((sequence, now_s))

    def shown(self, sequence: int, now_s: float) -> None:
        """A picture of this state has come."""
        self._shown = max(self._shown, sequence)
        while self._newer and self._newer[0][0] <= self._shown:
            self._newer.popleft()
        if self.age_s(now_s) <= _CLEAR_S:
            self._looks_old = False

    def age_s(self, now_s: float) -> float:
        """For how long there has been a newer state than the one shown; 0: there is none."""
        return max(0.0, now_s - self._newer[0][1]) if self._newer else 0.0

    def looks_old(self, now_s: float) -> bool:
        """Whether the picture must say that it is old."""
        if self.age_s(now_s) > LONGEST_S:
            self._looks_old = True
        return self._looks_old
