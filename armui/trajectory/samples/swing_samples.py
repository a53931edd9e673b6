"""The samples of a joint inspection: each joint in turn swings to either side, and comes back."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np

from armui.kinematics import trapezoids
from armui.trajectory.samples.recording import COLUMN_COUNT, GRIPPER, Array, Recording

if TYPE_CHECKING:
    from armui.ways.swings import Swing

SPEED_DEG_S: Final = 10.0
"""The speed of each swing at the operator's speed, unless that is lower than `LEAST_SHARE`."""
LEAST_SHARE: Final = 0.2
"""Where the operator's speed is a lower share, the swings are as much slower."""
_ACCELERATION_DEG_S2: Final = 20.0
_EVERY_S: Final = 0.05
_RESTS_S: Final = 0.4
"""The rest of a joint before it turns back, in which its current settles."""


@dataclass(frozen=True, slots=True)
class SwingTimes:
    """When a joint swings, in the time of the recording.

    Attributes:
        joint: The joint (1–6).
        begin_s, end_s: From when to when.
    """

    joint: int
    begin_s: float
    end_s: float


def swing_recording(
    name: str, begin_deg: Sequence[float], swings: Sequence[Swing], share: float
) -> tuple[Recording, tuple[SwingTimes, ...], float]:
    """Return the recording of an inspection, when each joint swings in it, and its speed in °/s.

    Args:
        name: Its name.
        begin_deg: Where the arm stands.
        swings: The joints that swing, in turn.
        share: The share of its pace that it is replayed at, 0–1: it is made as much faster.
    """
    pace = max(share, LEAST_SHARE)
    times_s, offsets_deg, windows = [np.zeros(1)], [np.zeros((1, GRIPPER - 1))], []
    now_s = 0.0
    for swing in swings:
        begin_s, angle = now_s, 0.0
        for goal in (swing.above_deg, -swing.below_deg, 0.0):
            steps_s, turned_deg = _turn(goal - angle)
            offsets = np.zeros((len(steps_s), GRIPPER - 1))
            offsets[:, swing.joint - 1] = angle + turned_deg
            times_s.append(now_s + steps_s)
            offsets_deg.append(offsets)
            now_s, angle = float(times_s[-1][-1]), goal
        windows.append(SwingTimes(swing.joint, begin_s * pace, now_s * pace))
    times, offsets = np.concatenate(times_s), np.concatenate(offsets_deg)
    samples: Array = np.full((len(times), COLUMN_COUNT), np.nan)
    samples[:, 0] = times * pace
    samples[:, 1:GRIPPER] = np.array(begin_deg) + offsets
    return Recording(name, samples=samples), tuple(windows), speed_at(share)


def speed_at(share: float) -> float:
    """Return the speed of the swings at a share of the operator's speed, 0–1."""
    return SPEED_DEG_S * min(1.0, share / LEAST_SHARE)


def _turn(angle_deg: float) -> tuple[Array, Array]:
    """Return the times of a turn from rest to rest, and the angles; a rest follows it."""
    if not angle_deg:
        return np.array([_RESTS_S]), np.zeros(1)
    lasts_s = trapezoids.durations(*_limited(abs(angle_deg)))
    speed = trapezoids.even_speeds(np.array(angle_deg), lasts_s, np.array(_ACCELERATION_DEG_S2))
    steps_s = np.linspace(0.0, float(lasts_s), math.ceil(float(lasts_s) / _EVERY_S) + 1)[1:]
    turned = trapezoids.places(steps_s, lasts_s, speed, np.array(_ACCELERATION_DEG_S2))
    turned[-1] = angle_deg
    return np.append(steps_s, float(lasts_s) + _RESTS_S), np.append(turned, angle_deg)


def _limited(way_deg: float) -> tuple[Array, Array, Array]:
    return np.array(way_deg), np.array(SPEED_DEG_S), np.array(_ACCELERATION_DEG_S2)
