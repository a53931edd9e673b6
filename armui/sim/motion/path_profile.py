"""The distance along a path over time, with a trapezoidal speed profile."""

from __future__ import annotations

import math
from typing import Final

_ROUNDING: Final = 1e-9


class PathProfile:
    """Runs from 0 to an end, never backwards, with one acceleration up and down.

    It can be slowed, halted and sent on at any time, and still stops at its end.

    Attributes:
        position: How far it is.
        speed: How fast it goes.
        acceleration: How its speed changes.
    """

    def __init__(self, end: float, acceleration: float) -> None:
        """At its start, halted.

        Args:
            end: Where it ends, in any unit.
            acceleration: The most its speed changes a second, above 0.
        """
        self._end = end
        self._most = acceleration
        self._grain = _ROUNDING * end
        self._top_speed = 0.0
        self.position = 0.0
        self.speed = 0.0
        self.acceleration = 0.0

    @property
    def at_end(self) -> bool:
        """Whether the end is reached."""
        return self.position == self._end

    @property
    def moving(self) -> bool:
        """Whether it runs, or is about to."""
        return self.speed > 0.0 or (self._top_speed > 0.0 and not self.at_end)

    def run(self, top_speed: float) -> None:
        """Goes on with this speed; 0 halts."""
        self._top_speed = top_speed

    def advance(self, dt_s: float) -> None:
        """Lets time pass."""
        while dt_s > 0.0 and not self.at_end:
            acceleration, lasts_s = self._phase()
            part_s = min(dt_s, lasts_s)
            self.position += (self.speed + 0.5 * acceleration * part_s) * part_s
            self.speed = max(self.speed + acceleration * part_s, 0.0)
            self.acceleration = acceleration
            dt_s -= part_s
            if self.speed <= _ROUNDING * self._most and not acceleration > 0.0:
                self._stand()
                if not self._top_speed:
                    return

    def _phase(self) -> tuple[float, float]:
        """The acceleration of now, and how long it lasts."""
        most, speed, top = self._most, self.speed, self._top_speed
        left = self._end - self.position
        if speed > top * (1.0 + _ROUNDING):
            return -most, (speed - top) / most
        spare = left - 0.5 * speed**2 / most
        if spare <= self._grain:
            return -most, speed / most
        peak = min(top, math.sqrt(most * left + 0.5 * speed**2))
        if speed < peak * (1.0 - _ROUNDING):
            return most, (peak - speed) / most
        if not top:
            return 0.0, math.inf
        return 0.0, spare / speed

    def _stand(self) -> None:
        """Stops; as good as at the end is at the end."""
        self.speed = self.acceleration = 0.0
        if self._end - self.position <= 2.0 * self._grain:
            self.position = self._end
