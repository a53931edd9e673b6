"""The operator's choices beside 发送, kept with each trajectory."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

FIRST_RUN_PERCENT: Final = 20
"""The highest speed, in %, at which a trajectory that never ran begins: its path is unseen."""
MOST_CYCLES: Final = 9999


@dataclass(frozen=True, slots=True)
class RunOptions:
    """The options of a run.

    Attributes:
        cycles: The number of cycles; 0 runs until it is ended.
        first: The index of the point to begin with.
        step_by_step: True to wait after each point.
    """

    cycles: int = 1
    first: int = 0
    step_by_step: bool = False

    @property
    def is_sound(self) -> bool:
        """True if every value can be chosen; values may come from a damaged file."""
        return (
            all(type(number) is int for number in (self.cycles, self.first))
            and 0 <= self.cycles <= MOST_CYCLES
            and self.first >= 0
            and isinstance(self.step_by_step, bool)
        )


def begin_percent(percent: int, *, seen: bool) -> int:
    """Return the speed at which a run begins: lowered if it has never run.

    Args:
        percent: The operator's speed.
        seen: True if it has run before.
    """
    return percent if seen else min(percent, FIRST_RUN_PERCENT)
