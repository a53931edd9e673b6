"""The data of a trajectory's run and of its progress."""

from __future__ import annotations

import enum
import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import accumulate
from operator import add

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


def sent_percent(own_percent: int, speed_percent: int) -> int:
    """Return the speed percentage of a point: its own times the operator's, 1–100."""
    return min(100, max(1, round(own_percent * speed_percent / 100.0)))


def capped_percent(cap_percent: int, speed_percent: int) -> int:
    """Return the speed percentage of a way with a cap of its own: the lesser, from 1 on."""
    return max(1, min(cap_percent, speed_percent))


@dataclass(frozen=True, slots=True)
class Run:
    """A run as the operator wants it.

    Attributes:
        name: The name of the trajectory.
        points: All points.
        expected_s: The time of each from the one before at its own speed, dwell included.
        even_s: The same without dwells and without ramps; empty if it is not known.
        rows: The points as their table had them, in their user frames; empty if as `points`.
        cycles: The number of cycles, or :data:`ENDLESS`.
        first: The index of the point to begin with, in the first cycle.
        speed_percent: The operator's speed as it begins: the share of each point's own.
        step_by_step: True to wait for the operator after each point.
    """

    name: str
    points: Sequence[Waypoint]
    expected_s: Sequence[float]
    cycles: int = 1
    first: int = 0
    speed_percent: int = 100
    step_by_step: bool = False
    even_s: Sequence[float] = ()
    rows: Sequence[Waypoint] = ()


@dataclass(frozen=True, slots=True)
class Progress:
    """The progress of a run.

    Attributes:
        phase: The phase.
        name: The name of the trajectory.
        index: The point under way, from 0; the one it ended at, once it has ended.
        count: The number of points in a cycle; 0 for a recording, which is no run of points.
        cycle, cycles: The cycle, from 1, and the number of cycles, 0 for endless.
        done: The share of the cycle that is done, 0–1.
        remaining_s: The time left of the whole run at the present speed; ``None`` if it has no
            end, is held back at 0 %, or is on its way to a recording's first angles.
        refusal: The reason of its failure.
        percent: The speed that the arm was told for the point under way; ``None``: none.
        tool_mm_s: The highest speed of the tool at that percentage, along a line or an arc.
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
    percent: int | None = None
    tool_mm_s: float = math.inf


class RunSchedule:
    """The planned times of a run, at any share of its own speed."""

    def __init__(self, run: Run) -> None:
        self._run = run
        self._dwells_s = [point.dwell_s for point in run.points]
        self._moves_s = [
            max(0.0, expected_s - dwell_s)
            for expected_s, dwell_s in zip(run.expected_s, self._dwells_s, strict=True)
        ]
        self._lengths_s: list[float] = list(map(add, self._moves_s, self._dwells_s))
        self._ends_s = list(accumulate(self._lengths_s))
        self._slowed = (1.0, self._ends_s)

    @property
    def cycle_s(self) -> float:
        """The duration of a cycle at the run's own speed, its dwells included."""
        return self._ends_s[-1] if self._ends_s else 0.0

    def time_limit_s(self, index: int) -> float:
        """Return the time after which a point counts as not reached; generous, as arms differ."""
        return 5.0 + 3.0 * self._lengths_s[index]

    def in_cycle_s(self, index: int, elapsed_s: float) -> float:
        """Return the planned time in the cycle, this long after a point was sent."""
        length_s = self._lengths_s[index]
        return self._ends_s[index] - length_s + min(elapsed_s, length_s)

    def move_s(self, index: int, share: float) -> float:
        """Return how long the way to a point takes at a share of its speed, above 0.

        A motion that goes evenly for D at its own speed, with ramps that add R, takes
        D / share + R · share; one too short to go evenly takes as long as before.
        """
        move_s = self._moves_s[index]
        even_s = min(move_s, self._run.even_s[index]) if self._run.even_s else move_s
        ramps_s = move_s - even_s
        # The motion is too short to reach its even speed: it only speeds up and slows down, which
        # takes 2·√(D·R); R follows from that.
        if ramps_s > even_s:
            ramps_s = move_s * move_s / (4.0 * even_s or 1.0)
        return max(move_s, even_s / share + min(ramps_s * share, even_s / share))

    def pace(self, index: int, share: float) -> float:
        """Return how fast the planned time of a motion goes by at a share of its speed, 0–1."""
        if share <= 0.0:
            return 0.0
        return self._moves_s[index] / (self.move_s(index, share) or 1.0)

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
        ends_s = self._ends_at(share)
        cycles_left = self._run.cycles - cycle
        move_s, dwell_s = self._moves_s[index], self._dwells_s[index]
        move_left_s = max(0.0, move_s - elapsed_s) / (self.pace(index, share) or 1.0)
        dwell_left_s = max(0.0, min(dwell_s, move_s + dwell_s - elapsed_s))
        return ends_s[-1] * (cycles_left + 1) - ends_s[index] + move_left_s + dwell_left_s

    def _ends_at(self, share: float) -> list[float]:
        """Return when each point of a cycle is done; planned anew where the share has changed."""
        if self._slowed[0] != share:
            moves_s = (self.move_s(index, share) for index in range(len(self._moves_s)))
            self._slowed = share, list(accumulate(map(add, moves_s, self._dwells_s)))
        return self._slowed[1]
