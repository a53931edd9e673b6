"""Time limits of the picture and of the render process. No clock, no process."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from typing import Final

from armui.viewport.messages import PictureBusy, PicturePhase

_WAITS_SHARE: Final = 0.05
"""A process that uses less of a free processor is waiting for an event that does not come."""
_LATE_S: Final = 0.03
"""A process that wakes up this late shares the processor with others: it is slow, not stuck."""
_STARVED_SHARE: Final = 0.005
_STARVED_FACTOR: Final = 3.0
"""After this factor of its limit even a starved process has used more than that share of the time.
"""
_SPINS_FACTOR: Final = 2.0
_LONGEST_FACTOR: Final = 20.0
LONGEST_S: Final = 0.25
"""An older picture gets a notice."""
_CLEAR_S: Final = 0.15
"""A picture with the notice loses it when it is no older than this, which avoids flicker."""
_REMEMBERED: Final = 256


@dataclass(frozen=True, slots=True)
class Limits:
    """Time limits of a phase.

    Attributes:
        silent_s: The limit without any sign of life.
        stuck_s: The limit with signs of life, but without progress.
    """

    silent_s: float
    stuck_s: float


LIMITS: Final = {
    PicturePhase.STARTING: Limits(60.0, 120.0),  # for a cold disk or a busy computer
    PicturePhase.OPENING: Limits(10.0, 5.0),  # for a graphics card that has to wake up
    PicturePhase.LOADING: Limits(10.0, 20.0),  # for large meshes
    PicturePhase.FIRST_DRAWING: Limits(10.0, 5.0),  # for a driver that compiles its shaders
    PicturePhase.DRAWING: Limits(5.0, 1.0),
}
"""The limit of silence allows for other programs, which may delay the signs of life."""


def is_stuck(busy: PictureBusy, busy_for_s: float) -> bool:
    """Return whether a process that sends signs of life makes no progress.

    A process starved by others takes long, too, but it wants the processor and does not get it. A
    hanging one sleeps although a processor is free, or spins for far longer than the work takes.

    Args:
        busy: Its last sign of life.
        busy_for_s: The time it has worked on this so far.
    """
    limit_s = LIMITS[busy.phase].stuck_s
    # it has computed, or waited, for far longer than any work of this phase takes
    if busy.cpu_s >= _SPINS_FACTOR * limit_s or busy_for_s >= _LONGEST_FACTOR * limit_s:
        return True
    # it wakes up late, so other programs use the processor: it is given more time
    if busy.late_s >= _LATE_S:
        too_long = busy_for_s >= _STARVED_FACTOR * limit_s
        return too_long and busy.cpu_s < _STARVED_SHARE * busy_for_s
    # the processor is free, but hardly used: it waits for something that does not come
    return busy_for_s >= limit_s and busy.cpu_s < _WAITS_SHARE * busy_for_s


class Restarts:
    """Counts the losses of the process: three in a minute are too many."""

    MOST: Final = 3
    WITHIN_S: Final = 60.0

    def __init__(self) -> None:
        self._lost_s: deque[float] = deque(maxlen=self.MOST)

    def lost(self, now_s: float) -> bool:
        """Count a loss, and return whether to restart automatically."""
        self._lost_s.append(now_s)
        return len(self._lost_s) < self.MOST or now_s - self._lost_s[0] > self.WITHIN_S


class PictureAge:
    """Follows the requested and the shown states by their sequence numbers.

    A picture is as old as the first state that is newer than the one it shows.
    """

    def __init__(self) -> None:
        self._shown = 0
        self._newer: deque[tuple[int, float]] = deque(maxlen=_REMEMBERED)
        self._is_stale = False

    @property
    def is_newest_shown(self) -> bool:
        """True if the picture shows the newest state."""
        return not self._newer

    def wanted(self, sequence: int, now_s: float) -> None:
        """Note that a picture of a newer state was requested."""
        self._newer.append((sequence, now_s))

    def shown(self, sequence: int, now_s: float) -> None:
        """Note that a picture of this state has come."""
        self._shown = max(self._shown, sequence)
        while self._newer and self._newer[0][0] <= self._shown:
            self._newer.popleft()
        if self.age_s(now_s) <= _CLEAR_S:
            self._is_stale = False

    def age_s(self, now_s: float) -> float:
        """Return the time since the first state newer than the one shown; 0 if there is none."""
        return max(0.0, now_s - self._newer[0][1]) if self._newer else 0.0

    def is_stale(self, now_s: float) -> bool:
        """Return whether the picture must show the notice that it is old."""
        if self.age_s(now_s) > LONGEST_S:
            self._is_stale = True
        return self._is_stale
