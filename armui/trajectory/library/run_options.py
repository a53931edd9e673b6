"""The operator's choices beside 发送, kept with each trajectory."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

FIRST_RUN_FACTOR: Final = 0.2
"""The speed factor offered for a trajectory that never ran, because nobody has seen its path yet.
"""
FASTEST_FACTOR: Final = 2.0
MOST_CYCLES: Final = 9999


@dataclass(frozen=True, slots=True)
class RunOptions:
    """The options of a run.

    Attributes:
        cycles: The number of cycles; 0 runs until it is ended.
        speed_factor: The factor on each point's speed, or on the recorded speed.
        first: The index of the point to begin with.
        step_by_step: True to wait after each point.
    """

    cycles: int = 1
    speed_factor: float = 1.0
    first: int = 0
    step_by_step: bool = False

    @property
    def is_sound(self) -> bool:
        """True if every value can be chosen; values may come from a damaged file."""
        return (
            all(type(number) is int for number in (self.cycles, self.first))
            and 0 <= self.cycles <= MOST_CYCLES
            and self.first >= 0
            and isinstance(self.speed_factor, int | float)
            and 0.01 <= self.speed_factor <= FASTEST_FACTOR
            and isinstance(self.step_by_step, bool)
        )
