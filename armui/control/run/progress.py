"""What a run of a trajectory is, and how far it has come: plain data."""

from __future__ import annotations

import enum
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import accumulate

from armui.arm.refusal import Refusal
from armui.trajectory.points.program import Waypoint

ENDLESS = 0
"""As a number of cycles: until the operator ends it."""


class RunPhase(enum.Enum):
    """What the run is doing."""

    IDLE = enum.auto()
    MOVING = enum.auto()
    """A point has been sent; the arm has not said that it is there."""
    DWELLING = enum.auto()
    WAITING = enum.auto()
    """Step by step: for the operator's word."""
    PAUSED = enum.auto()
    STOPPING = enum.auto()
    """Ended by the operator; the arm has not come to rest."""
    DONE = enum.auto()
    STOPPED = enum.auto()
    """Ended by the operator, the arm is at rest."""
    FAILED = enum.auto()
    """Ended by something else; the reason says what."""


OVER = frozenset({RunPhase.IDLE, RunPhase.DONE, RunPhase.STOPPED, RunPhase.FAILED})
"""The arm is not under the run's control."""


def sent_percent(own_percent: int, speed_factor: float) -> int:
    """Return the speed percentage a point is sent with: its own times that of the run, 1–100."""
    return min(100, max(1, round(own_percent * speed_factor)))


@dataclass(frozen=True, slots=True)
class Run:
    """What the operator wants to have run.

    Attributes:
        name: The trajectory's.
        points: All of them.
        expected_s: How long each takes, dwell included, from the one before.
        cycles: How often; :data:`ENDLESS` until it is ended.
        first: The index of the point to begin with, in the first cycle.
        speed_factor: On each point's own speed.
        step_by_step: Whether to wait for the operator after each point.
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
    """How far a run has come.

    Attributes:
        phase: What it is doing.
        name: The trajectory's.
        index: The point under way, from 0; the one it ended at, once it has ended.
        count: How many points a cycle has.
        cycle, cycles: Which cycle, from 1, of how many; 0 endless.
        done: Share of the cycle that is done, 0–1.
        remaining_s: Of the whole run at the override of now; ``None`` if it has no end, or is held
            back at 0 %.
        refusal: Why it failed.
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
    """When a run as planned is where."""

    def __init__(self, run: Run) -> None:
        self._run = run
        factor = run.speed_factor
        # dwells do not shorten when the arm moves faster
        lengths_s = [
            point.dwell_s + max(0.0, expected_s - point.dwell_s) / factor
            for point, expected_s in zip(run.points, run.expected_s, strict=True)
        ]
        self._ends_s = list(accumulate(lengths_s))
        self._lengths_s = lengths_s
        self._dwells_end_s = list(accumulate(point.dwell_s for point in run.points))

    @property
    def cycle_s(self) -> float:
        """How long a cycle takes."""
        return self._ends_s[-1] if self._ends_s else 0.0

    def time_limit_s(self, index: int) -> float:
        """After this long a point has not been reached; generous, for an arm may be slower."""
        return 5.0 + 3.0 * self._lengths_s[index]

    def in_cycle_s(self, index: int, elapsed_s: float) -> float:
        """Return how far a cycle is, so long after a point was sent."""
        length_s = self._lengths_s[index]
        return self._ends_s[index] - length_s + min(elapsed_s, length_s)

    def remaining_s(
        self, index: int, cycle: int, elapsed_s: float, share: float = 1.0
    ) -> float | None:
        """Return how long the rest of the run takes; ``None`` if it has no end.

        Args:
            index: The point under way.
            cycle: Which cycle, from 1.
            elapsed_s: Since that point was sent, as planned.
            share: How fast the arm moves, of what was planned; dwells stay as long as they are.
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
