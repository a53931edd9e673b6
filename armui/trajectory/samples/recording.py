"""Recordings of a moving arm: samples of its joints and its gripper over time."""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import dataclass, field
from datetime import UTC, datetime
from typing import Final

import numpy as np
import numpy.typing as npt

from armui.arm.limits import JOINTS
from armui.arm.refusal import Reason, Refusal
from armui.trajectory.points.program import (
    ANGLE,
    POINT_NOT_A_NUMBER,
    POINT_OUT_OF_RANGE,
    RANGES,
    check_name,
    check_text,
)

SAMPLE_BACK_IN_TIME = Reason(
    "sample_back_in_time", "The time {value} s is before the one above, {minimum} s."
)


Array = npt.NDArray[np.float64]

COLUMN_NAMES: Final = ("t", "J1", "J2", "J3", "J4", "J5", "J6", "gripper")
COLUMN_COUNT: Final = len(COLUMN_NAMES)
GRIPPER: Final = 7
"""The column of the gripper's opening."""

LONGEST_S: Final = 24 * 3600.0

_STRIDE = 64
"""Going this many samples forward, or one back in time, searches all of them by bisection."""

_SPEED_OVER_S: Final = 0.1
"""Speeds are averaged over this time, because samples carry the bus's jitter."""
_COMES_AFTER_S: Final = 0.13
"""In the simulated arm a corner is cut by half the acceleration times the square of this."""
_WITH_THE_WORST: Final = 0.3
_LASTS_S: Final = 0.3
"""The time before and after a change of speed in which the arm may be off the way."""


@dataclass(frozen=True, slots=True, eq=False)
class Recording:
    """Named samples over time.

    Attributes:
        name: The name the operator gave it.
        note: The operator's note.
        samples: (n, 8): time in s, from 0 and never decreasing; six joint angles in degrees; the
            gripper's opening in mm, NaN if it was not recorded.
        modified: The time of the last change, with its time zone.
        taught_on: The arm it was taught on, as in `ModelFit.kind`; "" if not known.
    """

    name: str
    note: str = ""
    samples: Array = field(default_factory=lambda: np.empty((0, COLUMN_COUNT)))
    modified: datetime = datetime(1970, 1, 1, tzinfo=UTC)
    taught_on: str = ""

    @property
    def times_s(self) -> Array:
        """(n,) the samples' times in s, from 0."""
        return self.samples[:, 0]

    @property
    def joints_deg(self) -> Array:
        """(n, 6) joint angles."""
        return self.samples[:, 1:GRIPPER]

    @property
    def gripper_mm(self) -> Array:
        """(n,) the gripper's openings, NaN if not recorded."""
        return self.samples[:, GRIPPER]

    @property
    def duration_s(self) -> float:
        """The time from the first sample to the last."""
        return float(self.samples[-1, 0] - self.samples[0, 0]) if len(self.samples) else 0.0

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Recording):
            return NotImplemented
        return (self.name, self.note, self.modified) == (
            other.name,
            other.note,
            other.modified,
        ) and np.array_equal(self.samples, other.samples, equal_nan=True)

    __hash__ = None  # type: ignore[assignment]  # holds an array


def check_samples(samples: Array) -> tuple[int, Refusal] | None:
    """Return the first invalid sample: its row, from 1, and the reason; ``None`` if all are valid.

    Args:
        samples: (n, 8), as in `Recording`.
    """
    opening = RANGES["opening"]
    low = np.array([0.0, *[ANGLE.minimum] * 6, opening.minimum])
    high = np.array([LONGEST_S, *[ANGLE.maximum] * 6, opening.maximum])
    inside = (samples >= low) & (samples <= high)
    inside[:, GRIPPER] |= np.isnan(samples[:, GRIPPER])
    forward = np.ones(len(samples), dtype=bool)
    forward[1:] = np.diff(samples[:, 0]) >= 0.0
    good = inside.all(axis=1) & forward
    if good.all():
        return None
    row = int(np.argmin(good))
    if inside[row].all():
        params = {"value": float(samples[row, 0]), "minimum": float(samples[row - 1, 0])}
        return row + 1, SAMPLE_BACK_IN_TIME(**params)
    column = int(np.argmin(inside[row]))
    name, value = COLUMN_NAMES[column], float(samples[row, column])
    if not np.isfinite(value):
        return row + 1, POINT_NOT_A_NUMBER(field=name, value=value)
    unit = ("s", *["°"] * 6, "mm")[column]
    limits: dict[str, float | str] = {
        "minimum": float(low[column]),
        "maximum": float(high[column]),
        "unit": unit,
    }
    return row + 1, POINT_OUT_OF_RANGE(**limits, field=name, value=value)


def check_recording(recording: Recording) -> tuple[int, Refusal] | None:
    """Return the first reason why a recording cannot be saved, with its row (0: the whole)."""
    refusal = check_name(recording.name) or check_text("note", recording.note)
    return (0, refusal) if refusal is not None else check_samples(recording.samples)


class SampleCursor:
    """Finds the sample of a recording at a time, in a few microseconds whatever its length.

    Args:
        recording: At least one sample; its array may be mapped from a file.
    """

    def __init__(self, recording: Recording) -> None:
        # numpy.memmap handles each access in Python; a plain array over the same bytes does not.
        self._samples: Array = np.asarray(recording.samples)
        self._count = len(self._samples)
        self._start_s = float(self._samples[0, 0])
        self._index = 0

    def index_at(self, recorded_s: float) -> int:
        """Return the last sample not later than a time after the first one; 0 before the first."""
        index = self._index
        if self._time_s(index) > recorded_s:
            index = max(bisect_right(range(index), recorded_s, key=self._time_s) - 1, 0)
        else:
            last = min(index + _STRIDE, self._count - 1)
            if self._time_s(last) <= recorded_s:
                index = bisect_right(range(self._count), recorded_s, last, key=self._time_s) - 1
            else:
                while self._time_s(index + 1) <= recorded_s:
                    index += 1
        self._index = index
        return index

    def joints_deg_at(self, recorded_s: float) -> tuple[float, ...]:
        """Return the joint angles at a time after the first sample, interpolated linearly."""
        index = self.index_at(recorded_s)
        here: npt.NDArray[np.float64] = self._samples[index, 1:GRIPPER]
        begin_s = self._time_s(index)
        if index + 1 < self._count and recorded_s > begin_s:
            share = (recorded_s - begin_s) / (self._time_s(index + 1) - begin_s)
            here = here + share * (self._samples[index + 1, 1:GRIPPER] - here)
        return tuple(here.tolist())

    def gripper_mm_at(self, recorded_s: float) -> float:
        """Return the opening of the last sample up to a time; NaN if it was not recorded."""
        return float(self._samples[self.index_at(recorded_s), GRIPPER])

    def _time_s(self, index: int) -> float:
        return float(self._samples[index, 0]) - self._start_s


@dataclass(frozen=True, slots=True, eq=False)
class ReplayProfile:
    """The speeds of a recording at its recorded speed.

    Attributes:
        speeds_deg_s: (n, 6) the speed of each joint at each sample.
        fastest_deg_s: The highest speed of each joint.
        astray_deg: (n, 6) how far the arm may be off the way there, as :func:`astray_deg` has it.
    """

    speeds_deg_s: npt.NDArray[np.float32]
    fastest_deg_s: tuple[float, ...]
    astray_deg: npt.NDArray[np.float32]


def turning_speeds(times_s: Array, angles_deg: Array) -> Array:
    """Return (n,) the speeds of a joint around each sample, in °/s."""
    before_s = np.maximum(times_s - _SPEED_OVER_S / 2, times_s[0])
    after_s = np.minimum(times_s + _SPEED_OVER_S / 2, times_s[-1])
    angles_deg = np.ascontiguousarray(angles_deg)
    turned = np.interp(after_s, times_s, angles_deg) - np.interp(before_s, times_s, angles_deg)
    speeds: Array = np.abs(turned) / np.maximum(after_s - before_s, 1e-9)
    return speeds


def astray_deg(times_s: Array, angles_deg: Array) -> Array:
    """Return (n,) how far a joint may be off the recorded way around each sample, in degrees.

    The arm is told where to be fifty times a second, and comes after. As long as the joints turn
    evenly it comes after on the way; where one of them has to change its speed, it is ahead of the
    others or behind them for a while: a corner is cut. In the simulated arm that is half the
    acceleration times the square of 0.13 s, or less.
    """
    from scipy.ndimage import maximum_filter1d  # noqa: PLC0415 - scipy

    angles_deg = np.ascontiguousarray(angles_deg)
    before_s = np.maximum(times_s - _SPEED_OVER_S, times_s[0])
    after_s = np.minimum(times_s + _SPEED_OVER_S, times_s[-1])
    before, after = (np.interp(each, times_s, angles_deg) for each in (before_s, after_s))
    changes = (
        np.abs(before - 2.0 * angles_deg + after) * (_COMES_AFTER_S / _SPEED_OVER_S) ** 2 / 2.0
    )
    first = np.searchsorted(times_s, times_s - _LASTS_S)
    last = np.searchsorted(times_s, times_s + _LASTS_S, side="right")
    size = int((last - first).max(initial=1))
    astray: Array = maximum_filter1d(changes, min(size, len(changes)), mode="nearest")
    return astray


def replay_profile(recording: Recording) -> ReplayProfile:
    """Compute the replay profile; it is empty for a recording without samples."""
    speeds = np.zeros((len(recording.samples), len(JOINTS)), dtype=np.float32)
    astray = np.zeros_like(speeds)
    if not len(speeds):
        return ReplayProfile(speeds, (0.0,) * 6, astray)
    times_s = np.ascontiguousarray(recording.times_s - recording.times_s[0])
    for index, angles_deg in enumerate(recording.joints_deg.T):
        speeds[:, index] = turning_speeds(times_s, angles_deg)
        astray[:, index] = astray_deg(times_s, angles_deg)
    # The joints arrive together, so that a lag of one delays the others by a part of it.
    astray += _WITH_THE_WORST * astray.max(axis=1, keepdims=True)
    return ReplayProfile(speeds, tuple(speeds.max(axis=0).tolist()), astray)
