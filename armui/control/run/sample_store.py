"""Stores samples in arrays of a fixed size, which are never copied during recording."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import datetime
from typing import TYPE_CHECKING, Final

import numpy as np

from armui.trajectory.samples.recording import COLUMN_COUNT, Array, Recording

if TYPE_CHECKING:
    from armui.bus.samples import Sample

_CHUNK: Final = 12_000
"""The samples in an array: a minute at 200 Hz, 0.8 MB."""


@dataclass(frozen=True, slots=True, eq=False)
class Recorded:
    """The samples that a recorder has kept, not joined yet.

    Attributes:
        name: The name of the recording.
        chunks: The arrays in their order, in the form of a `Recording`'s samples.
        ended: The time at which it ended.
        taught_on: The arm of the recording, or "" if unknown.
    """

    name: str
    chunks: tuple[Array, ...]
    ended: datetime
    taught_on: str = ""

    @property
    def count(self) -> int:
        """The number of samples."""
        return sum(len(chunk) for chunk in self.chunks)

    def joined(self, name: str | None = None) -> Recording:
        """Return the recording: two hours at 200 Hz are 92 MB, so this belongs in another thread.

        Args:
            name: Another name; by default its own.
        """
        return Recording(
            name or self.name,
            samples=np.concatenate(self.chunks),
            modified=self.ended,
            taught_on=self.taught_on,
        )


class SampleStore:
    """Stores samples; the time of the first one is 0.

    Args:
        taught_on: The arm of the samples, as in `ModelFit.taught_on`.
    """

    def __init__(self, taught_on: str = "") -> None:
        self._taught_on = taught_on
        self._full: list[Array] = []
        self._chunk: Array = np.empty((_CHUNK, COLUMN_COUNT))
        self._used = 0
        self._start_s = 0.0
        self.duration_s = 0.0

    def __len__(self) -> int:
        return len(self._full) * _CHUNK + self._used

    def extend(self, samples: Sequence[Sample]) -> None:
        """Append samples; the time of the first one becomes 0.

        A sample that is dated before the last one is left out, so that all that is kept can be
        saved.
        """
        for sample in samples:
            if len(self) and sample.at_s - self._start_s < self.duration_s:
                continue
            if not len(self):
                self._start_s = sample.at_s
            elif self._used == _CHUNK:
                self._full.append(self._chunk)
                self._chunk, self._used = np.empty((_CHUNK, COLUMN_COUNT)), 0
            self.duration_s = sample.at_s - self._start_s
            opening_mm = math.nan if sample.gripper_mm is None else sample.gripper_mm
            self._chunk[self._used] = (self.duration_s, *sample.joints_deg, opening_mm)
            self._used += 1

    def rows_from(self, first: int) -> Array:
        """Return a copy of the samples from an index on."""
        skipped, rest = divmod(first, _CHUNK)
        chunks = (*self._full, self._chunk[: self._used])[skipped:]
        return np.concatenate((chunks[0][rest:], *chunks[1:]))

    def recorded(self, name: str) -> Recorded | None:
        """Return the samples so far, or ``None`` if there are none."""
        if not len(self):
            return None
        chunks = (*self._full, self._chunk[: self._used])
        return Recorded(name, chunks, datetime.now().astimezone(), self._taught_on)
