"""Samples over time, read forward: each look continues where the last one ended."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from armui.trajectory.samples.recording import GRIPPER, Array, Recording

_STRIDE = 64
"""A look this many samples ahead, or one back in time, searches all of them by halves."""


class SampleCursor:
    """Looks up where a recording is at a time, in a few microseconds whatever its length.

    Args:
        recording: At least one sample; its array may be mapped from a file.
    """

    def __init__(self, recording: Recording) -> None:
        # a mapped array answers each look in Python; the plain one over the same bytes does not
        self._samples: Array = np.asarray(recording.samples)
        self._count = len(self._samples)
        self._start_s = float(self._samples[0, 0])
        self._index = 0

    def index_at(self, recorded_s: float) -> int:
        """The last sample not later than a time after the first one; 0 before the first."""
        index = self._index
        if self._time_s(index) > recorded_s:
            index = self._search(0, index, recorded_s)
        else:
            last = min(index + _STRIDE, self._count - 1)
            if self._time_s(last) <= recorded_s:
                index = self._search(last, self._count, recorded_s)
            else:
                while self._time_s(index + 1) <= recorded_s:
                    index += 1
        self._index = index
        return index

    def joints_deg_at(self, recorded_s: float) -> tuple[float, ...]:
        """Six angles at a time after the first sample, on straight lines between samples."""
        index = self.index_at(recorded_s)
        here: npt.NDArray[np.float64] = self._samples[index, 1:GRIPPER]
        begin_s = self._time_s(index)
        if index + 1 < self._count and recorded_s > begin_s:
            share = (recorded_s - begin_s) / (self._time_s(index + 1) - begin_s)
            here = here + share * (self._samples[index + 1, 1:GRIPPER] - here)
        return tuple(here.tolist())

    def gripper_mm_at(self, recorded_s: float) -> float:
        """The opening of the last sample not later than a time; NaN where it was not recorded."""
        return float(self._samples[self.index_at(recorded_s), GRIPPER])

    def _time_s(self, index: int) -> float:
        return float(self._samples[index, 0]) - self._start_s

    def _search(self, low: int, high: int, recorded_s: float) -> int:
        """By halves: the last of the samples ``low`` to ``high`` that is not later."""
        while high - low > 1:
            middle = (low + high) // 2
            if self._time_s(middle) <= recorded_s:
                low = middle
            else:
                high = middle
        return low
