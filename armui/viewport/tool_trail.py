"""Collects the measured and the commanded way of the tool. Pure."""

from __future__ import annotations

import math
from array import array
from collections import deque
from typing import Final

from armui.viewport.path_picture import Trail
from armui.viewport.vectors import Vector

_STEP_MM: Final = 0.5
"""A place this near to the last one is the same: an arm at rest wavers by some hundredths."""
_LONGEST_STEP_S: Final = 0.25
"""The most that a pause between two places counts: the trail shows motion, not rest."""
_LOST_S: Final = 1.0
_LEAP_MM: Final = 25.0
"""A setpoint further than this from the one before is a target, not a part of the way."""
_MOST: Final = 1200
"""The most places of each line: more than a screen can show, and few enough to be sent each time.
"""


class ToolTrail:
    """Collects places; the oldest are dropped first.

    Args:
        length_s: The seconds of motion that are kept; 0 for none.
    """

    def __init__(self, length_s: float) -> None:
        self.length_s = length_s
        self._driven: deque[tuple[float, Vector]] = deque(maxlen=_MOST)
        self._commanded: deque[tuple[float, Vector]] = deque(maxlen=_MOST)
        self._moved_s = 0.0
        self._last_s: float | None = None

    @property
    def trail(self) -> Trail | None:
        """The trail to be shown; None while there is none."""
        if len(self._driven) < 2 and len(self._commanded) < 2:
            return None
        return Trail(_packed(self._driven), _packed(self._commanded))

    def clear(self) -> None:
        """Start again, for another arm, or one that was out of sight."""
        self._driven.clear()
        self._commanded.clear()
        self._last_s = None

    def set_length(self, length_s: float) -> bool:
        """Set the seconds of motion to keep, and return whether the trail has changed."""
        self.length_s = length_s
        return self._trim()

    def add(self, now_s: float, driven_mm: Vector, commanded_mm: Vector | None) -> bool:
        """Add the tool's measured place, and its last setpoint.

        Args:
            now_s: The time by a clock that never goes back.
            driven_mm: The measured place in the base frame.
            commanded_mm: The setpoint sent last; None if this program sends none.

        Returns:
            True if the trail has changed.
        """
        if self.length_s <= 0.0:
            return False
        if self._last_s is not None and now_s - self._last_s > _LOST_S and self._far(driven_mm):
            self.clear()  # the way since the last place is unknown: no line may pretend one
        passed_s = 0.0 if self._last_s is None else min(_LONGEST_STEP_S, now_s - self._last_s)
        self._last_s = now_s
        is_new = not self._driven or math.dist(driven_mm, self._driven[-1][1]) >= _STEP_MM
        if is_new:
            self._moved_s += passed_s
            self._driven.append((self._moved_s, driven_mm))
        is_new |= self._add_commanded(commanded_mm)
        return (is_new and self._trim()) or is_new

    def _add_commanded(self, place_mm: Vector | None) -> bool:
        line = self._commanded
        if place_mm is None:
            return False
        if not line:
            line.append((self._moved_s, place_mm))
            return False
        away_mm = math.dist(place_mm, line[-1][1])
        if away_mm < _STEP_MM:
            return False
        if away_mm > _LEAP_MM:
            had_line = len(line) > 1
            line.clear()
            line.append((self._moved_s, place_mm))
            return had_line
        line.append((self._moved_s, place_mm))
        return True

    def _far(self, place_mm: Vector) -> bool:
        return bool(self._driven) and math.dist(place_mm, self._driven[-1][1]) > _LEAP_MM

    def _trim(self) -> bool:
        gone = False
        for line in (self._driven, self._commanded):
            while line and line[0][0] < self._moved_s - self.length_s:
                line.popleft()
                gone = True
        return gone


def _packed(line: deque[tuple[float, Vector]]) -> bytes:
    if len(line) < 2:
        return b""
    return array("f", [figure for _, place in line for figure in place]).tobytes()
