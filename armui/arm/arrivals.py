"""Distinguishes reports that arrive in time from those delayed on their way: pure.

What is measured between two reports is the arm's doing only if both arrived as they were sent. A
busy computer or adapter holds reports up, and hands them over together: then joints seem to stand,
and to jump.
"""

from __future__ import annotations

import math
from typing import Final

LATE_S: Final = 0.06
"""A longer time without a report is a gap: twelve periods of an arm that reports at 200 Hz."""
_CAUGHT_UP_S: Final = 0.03
"""Reports that have come this much faster than the arm sends them were held up before."""
_PERIOD_SHARE: Final = 0.01
"""The weight of each new interval in the mean period: so small that delays hardly change it."""
_CERTAIN: Final = 0.9
"""The share of the mean period that is used: frames lost now and then make the mean longer."""


class Arrivals:
    """Follows the times at which the reports of one kind arrive.

    Attributes:
        since_s: Since when they have arrived in time; the first of them tells nothing of what was
            before it.
        gap_s: The length of the last gap; 0 if there was none.
        gap_ended_s: The time at which it ended.
    """

    def __init__(self) -> None:
        self.gap_ended_s = -math.inf
        self._period_s = 0.0
        self._ahead_s = 0.0
        self.since_s = math.inf
        self.gap_s = 0.0
        self._last_s: float | None = None

    def note(self, at_s: float) -> bool:
        """Note a report; return whether it and the one before it have both arrived in time."""
        last_s, self._last_s = self._last_s, at_s
        if last_s is None:
            self.since_s = at_s
            return False
        spacing_s = max(0.0, at_s - last_s)
        self._period_s += _PERIOD_SHARE * (min(spacing_s, LATE_S) - self._period_s)
        if spacing_s > LATE_S:
            self.gap_s, self.gap_ended_s = spacing_s, at_s
            self._begin(at_s)
            return False
        self._ahead_s = max(0.0, self._ahead_s + _CERTAIN * self._period_s - spacing_s)
        if self._ahead_s > _CAUGHT_UP_S:
            self._begin(at_s)
            return False
        return True

    def forget(self) -> None:
        """Forget what arrived before: time has jumped, as where a log is opened in its middle."""
        self.since_s, self.gap_s, self._last_s = math.inf, 0.0, None

    def _begin(self, at_s: float) -> None:
        self.since_s, self._ahead_s = at_s, 0.0
