"""The data of a trajectory's run and of its progress."""

from __future__ import annotations

import enum
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import accumulate

from armui.arm.refusal import Refusal
from armui.trajectory.points.program import Waypoint

ENDLESS = 0
"""The number of cycles that stands for «until the operator ends it»."""


class RunPhase(enum.Enum):
    """The phases of a run."""

    IDLE = enum.auto()
    MOVING = enum.auto()
    """A point has been sent, and the arm has not reported its arrival."""
    DWELLING = enum.auto()
    WAITING = enum.auto()
    """A run step by step waits for the operator."""
    PAUSED = enum.auto()
    STOPPING = enum.auto()
    """The operator has ended the run, and the arm has not come to rest."""
    DONE = enum.auto()
    STOPPED = enum.auto()
    """The operator has ended the run, and the arm is at rest."""
    FAILED = enum.auto()
    """Something else has ended the run; the reason tells what."""


OVER = frozenset({RunPhase.IDLE, RunPhase.DONE, RunPhase.STOPPED, RunPhase.FAILED})
"""The phases in which the run does not control the arm."""


def sent_percent(own_percent: int, speed_factor: float) -> int:
    """Return the speed percentage of a point: its own times the run's factor, 1–100."""
    return min(100, max(1, round(own_percent * speed_factor)))


@dataclass(frozen=True, slots=True)
class Run:
    """A run as the operator wants it.

    Attributes:
        name: The name of the trajectory.
        points: All points.
        expected_s: The time of each from the one before at the factor below, dwell included.
        cycles: The number of cycles, or :data:`ENDLESS`.
        first: The index of the point to begin with, in the first cycle.
        speed_factor: The factor on each point's own speed.
        step_by_step: True to wait for the operator after each point.
    """

    name: str
    points: Sequence[Waypoint]
    expected_s: Sequence[float]
    cycles: int = 1
    first: int = 0
    speed_factor: float = 1.0
    step_by_step: bool = False


@dataclass(frozen=True, slots=True)
class Progress:
    """The progress of a run.

    Attributes:
        phase: The phase.
        name: The name of the trajectory.
        index: The point under way, from 0; the one it ended at, once it has ended.
        count: The number of points in a cycle.
        cycle, cycles: The cycle, from 1, and the number of cycles, 0 for endless.
        done: The share of the cycle that is done, 0–1.
        remaining_s: The time left of the whole run at the present override; ``None`` if it has no
            end, or is held back at 0 %.
        refusal: The reason of its failure.
    """

    phase: RunPhase = RunPhase.IDLE
    name: str = ""
    index: int = 0
    count: int = 0
    cycle: int = 1
    cycles: int = 1
    done: float = 0.0
    remaining_s: float | None = None
    refusal: Refusal | None = None


class RunSchedule:
    """The planned times of a run."""

    def __init__(self, run: Run) -> None:
        self._run = run
        lengths_s = [
            max(point.dwell_s, expected_s)
            for point, expected_s in zip(run.points, run.expected_s, strict=True)
        ]
        self._ends_s = list(accumulate(lengths_s))
        self._lengths_s = lengths_s
        self._dwells_end_s = list(accumulate(point.dwell_s for point in run.points))

    @property
    def cycle_s(self) -> float:
        """The duration of a cycle."""
        return self._ends_s[-1] if self._ends_s else 0.0

    def time_limit_s(self, index: int) -> float:
        """Return the time after which a point counts as not reached; generous, as arms differ."""
        return 5.0 + 3.0 * self._lengths_s[index]

    def in_cycle_s(self, index: int, elapsed_s: float) -> float:
        """Return the planned time in the cycle, this long after a point was sent."""
        length_s = self._lengths_s[index]
        return self._ends_s[index] - length_s + min(elapsed_s, length_s)

    def remaining_s(
        self, index: int, cycle: int, elapsed_s: float, share: float = 1.0
    ) -> float | None:
        """Return the time that the rest of the run takes; ``None`` if it has no end.

        Args:
            index: The point under way.
            cycle: The cycle, from 1.
            elapsed_s: The planned time since that point was sent.
            share: The arm's speed as a share of the planned one; dwells keep their time.
        """
        if self._run.cycles == ENDLESS or share <= 0.0:
            return None
        cycles_left = self._run.cycles - cycle
        rest_s = self.cycle_s * (cycles_left + 1) - self.in_cycle_s(index, elapsed_s)
        dwell_s = self._run.points[index].dwell_s
        here_s = max(0.0, min(dwell_s, self._lengths_s[index] - elapsed_s))
        per_cycle_s = self._dwells_end_s[-1]
        dwells_s = here_s + per_cycle_s * (cycles_left + 1) - self._dwells_end_s[index]
        return dwells_s + (rest_s - dwells_s) / share
