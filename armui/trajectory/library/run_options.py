"""What the operator has chosen beside 发送, kept with each trajectory."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

FIRST_RUN_FACTOR: Final = 0.2
"""A trajectory that never ran begins with this: nobody has seen yet where it goes."""
FASTEST_FACTOR: Final = 2.0
MOST_CYCLES: Final = 9999


@dataclass(frozen=True, slots=True)
class RunOptions:
    """How the operator wants it run.

    Attributes:
        cycles: How often; 0 until it is ended.
        speed_factor: On the speed of each point, or on the recorded one.
        first: The index of the point to begin with.
        step_by_step: Whether to wait after each point.
    """

    cycles: int = 1
    speed_factor: float = 1.0
    first: int = 0
    step_by_step: bool = False

    @property
    def is_sound(self) -> bool:
        """Return whether every value is one that can be chosen: it may come from a damaged file."""
        return (
            all(type(number) is int for number in (self.cycles, self.first))
            and 0 <= self.cycles <= MOST_CYCLES
            and self.first >= 0
            and isinstance(self.speed_factor, int | float)
            and 0.01 <= self.speed_factor <= FASTEST_FACTOR
            and isinstance(self.step_by_step, bool)
        )
