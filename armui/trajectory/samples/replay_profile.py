"""What a replay must know of a whole recording, worked out once, before it begins.

Half an hour of samples takes a tenth of a second: the check before a run does it, in its own
process. Nothing here knows Qt or a bus.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
import numpy.typing as npt

from armui.arm.limits import JOINTS
from armui.trajectory.samples.recording import Recording

_SPEED_OVER_S: Final = 0.1
"""Speeds are taken over so long: samples carry the bus's jitter."""


@dataclass(frozen=True, slots=True, eq=False)
class ReplayProfile:
    """Extremes and speeds of a recording at its recorded speed.

    Attributes:
        speeds_deg_s: (n, 6) how fast each joint turns at each sample.
        low_deg: The smallest angle of each joint.
        high_deg: The largest.
        fastest_deg_s: The highest speed of each joint.
    """

    speeds_deg_s: npt.NDArray[np.float32]
    low_deg: tuple[float, ...]
    high_deg: tuple[float, ...]
    fastest_deg_s: tuple[float, ...]


def replay_profile(recording: Recording) -> ReplayProfile:
    """Work it out; a recording without samples has an empty one."""
    speeds = np.zeros((len(recording.samples), len(JOINTS)), dtype=np.float32)
    if not len(speeds):
        return ReplayProfile(speeds, (0.0,) * 6, (0.0,) * 6, (0.0,) * 6)
    times_s = np.ascontiguousarray(recording.times_s - recording.times_s[0])
    before_s = np.maximum(times_s - _SPEED_OVER_S / 2, 0.0)
    after_s = np.minimum(times_s + _SPEED_OVER_S / 2, times_s[-1])
    spans_s = np.maximum(after_s - before_s, 1e-9)
    for index, column in enumerate(recording.joints_deg.T):
        angles = np.ascontiguousarray(column)
        turned = np.interp(after_s, times_s, angles) - np.interp(before_s, times_s, angles)
        speeds[:, index] = np.abs(turned) / spans_s
    return ReplayProfile(
        speeds,
        tuple(recording.joints_deg.min(axis=0).tolist()),
        tuple(recording.joints_deg.max(axis=0).tolist()),
        tuple(speeds.max(axis=0).tolist()),
    )
