"""Makes recordings smaller: fewer samples within a tolerance, a stretch of it, or its points.

It is Ramer–Douglas–Peucker over time: every omitted sample lies, at its own time, within the
tolerance of the straight line between the samples that are kept, in every joint. A replay
interpolates along these lines.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Final

import numpy as np
import numpy.typing as npt

from armui.arm.limits import JointLimits
from armui.protocol.codes import MoveMode
from armui.trajectory.points.program import Trajectory, Waypoint
from armui.trajectory.samples.recording import Array, Recording

GRIPPER_TOLERANCE_MM: Final = 0.5
_LEAST_S: Final = 1e-6


def thin(recording: Recording, tolerance_deg: float) -> Recording:
    """Return the recording with only as many samples as it needs.

    Args:
        recording: The whole recording.
        tolerance_deg: The allowed error of a joint at every omitted sample; for the gripper it is
            :data:`GRIPPER_TOLERANCE_MM`.

    Raises:
        ValueError: The tolerance is negative or no number.
    """
    if not tolerance_deg >= 0.0:
        raise ValueError(f"tolerance {tolerance_deg}° is none; give 0° or more")
    curves = recording.joints_deg
    scale = np.full(curves.shape[1], max(tolerance_deg, 1e-9))
    opening_mm = recording.gripper_mm
    if len(opening_mm) and not np.isnan(opening_mm).any():
        curves = np.column_stack([curves, opening_mm])
        scale = np.append(scale, GRIPPER_TOLERANCE_MM)
    kept = needed(recording.times_s, curves / scale)
    return replace(recording, samples=recording.samples[kept])


def needed(times_s: Array, curves: Array) -> npt.NDArray[np.intp]:
    """Return the samples needed for the lines between them to stay within 1 of all curves.

    All stretches are split together, level by level, so that the work is a few passes over arrays
    however many samples are kept.

    Args:
        times_s: (n,) in rising order.
        curves: (n, k) in units of its allowed error.

    Returns:
        (m,) the indices, with the first and the last.
    """
    count = len(times_s)
    if count < 3:
        return np.arange(count)
    ends = np.zeros(count, dtype=bool)
    ends[[0, -1]] = True
    open_samples = np.arange(1, count - 1)
    columns = [np.ascontiguousarray(curve) for curve in curves.T]
    while len(open_samples):
        kept = np.flatnonzero(ends)
        stretch = np.cumsum(ends)[open_samples]
        off = _off_lines(times_s, columns, kept, open_samples)
        begins = np.flatnonzero(np.diff(stretch, prepend=-1))
        worst = np.maximum.reduceat(off, begins)
        lengths = np.diff(np.append(begins, len(stretch)))
        split = np.repeat(worst > 1.0, lengths)
        peaks = np.flatnonzero(split & (off == np.repeat(worst, lengths)))
        _, firsts = np.unique(stretch[peaks], return_index=True)
        ends[open_samples[peaks[firsts]]] = True
        open_samples = open_samples[split]
        open_samples = open_samples[~ends[open_samples]]
    return np.flatnonzero(ends)


def _off_lines(
    times_s: Array, curves: Sequence[Array], kept: npt.NDArray[np.intp], here: npt.NDArray[np.intp]
) -> Array:
    """Return (n,) the deviation of samples from the lines between kept ones, in the worst curve."""
    at_s, knots_s = times_s[here], times_s[kept]
    worst = np.zeros(len(here))
    for curve in curves:
        off = np.interp(at_s, knots_s, curve[kept])
        off -= curve[here]
        np.maximum(worst, np.abs(off, out=off), out=worst)
    return worst


def cut(recording: Recording, from_s: float, to_s: float, tolerance_deg: float) -> Recording | None:
    """Return a stretch of a recording, thinned; ``None`` if no sample is left."""
    trimmed = trim(recording, from_s, to_s)
    return thin(trimmed, tolerance_deg) if len(trimmed.samples) else None


def trim(recording: Recording, from_s: float, to_s: float) -> Recording:
    """Return the stretch between two times, both included, with times from 0 again."""
    times_s = recording.times_s
    inside = (times_s >= from_s) & (times_s <= to_s)
    samples = recording.samples[inside].copy()
    if len(samples):
        samples[:, 0] -= samples[0, 0]
    return replace(recording, samples=samples)


def to_points(recording: Recording, limits: Sequence[JointLimits]) -> Trajectory:
    """Return every sample as a point of MOVE J, with the speed at which it was recorded.

    The arm comes to rest in each point, so thin the recording first.

    Args:
        recording: The recording.
        limits: The limits of the six joints; speeds are in percent of them.
    """
    angles, times_s = recording.joints_deg, recording.times_s
    highest = np.array([limit.max_speed_deg_s for limit in limits])
    spans = np.maximum(np.diff(times_s), _LEAST_S)[:, None]
    shares = np.abs(np.diff(angles, axis=0)) / spans / highest
    fastest = shares.max(axis=1) if len(shares) else np.empty(0)
    speeds = [min(100, max(1, math.ceil(100.0 * share))) for share in fastest.tolist()]
    points = tuple(
        Waypoint(MoveMode.MOVE_J, tuple(round(angle, 3) for angle in row), speed_percent=speed)
        for row, speed in zip(angles.tolist(), [100, *speeds], strict=False)
    )
    return Trajectory(
        recording.name,
        recording.note,
        points,
        recording.modified,
        taught_on=recording.taught_on,
    )
