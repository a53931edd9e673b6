"""Motions from rest to rest, limited in speed and acceleration: many at once, in closed form.

They equal ruckig's plan for such a motion without a limit of jerk: each joint accelerates, moves
evenly and brakes; joints with time to spare move slower, so that all of them arrive together.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]


def durations(ways: Array, speeds: Array, accelerations: Array) -> Array:
    """Return the shortest time for each motion.

    Args:
        ways: The distances, in any unit; the sign does not matter.
        speeds: The highest speed, above 0.
        accelerations: The highest acceleration, above 0.

    Returns:
        Times in s, in the common (broadcast) shape of the three.
    """
    ways = np.abs(ways)
    short = ways < speeds**2 / accelerations
    longer: Array = ways / speeds + speeds / accelerations
    return np.where(short, 2.0 * np.sqrt(ways / accelerations), longer)


def even_speeds(ways: Array, lasting_s: Array | float, accelerations: Array) -> Array:
    """Return the speed of the even part with which a motion takes exactly a given time.

    Args:
        ways: The distances, in any unit; the speed has their sign.
        lasting_s: The durations, not less than the shortest.
        accelerations: The accelerations of both ramps.
    """
    reserve = (accelerations * lasting_s) ** 2 - 4.0 * accelerations * np.abs(ways)
    # the smaller root, written so that nothing cancels when it is small
    speeds = (
        2.0
        * np.abs(ways)
        / _above_zero(lasting_s + np.sqrt(np.maximum(reserve, 0.0)) / accelerations)
    )
    signed: Array = np.copysign(speeds, ways)
    return signed


def places(times_s: Array, lasting_s: Array | float, speeds: Array, accelerations: Array) -> Array:
    """Return the distance covered by a motion at a time.

    Args:
        times_s: The times since its start.
        lasting_s: Its duration.
        speeds: The speed of its even part, with a sign.
        accelerations: The accelerations of both ramps.
    """
    ramp_s = np.abs(speeds) / accelerations
    into = np.minimum(times_s, ramp_s)
    left = np.minimum(np.maximum(lasting_s - times_s, 0.0), ramp_s)
    even = np.maximum(np.minimum(times_s, lasting_s - ramp_s) - ramp_s, 0.0)
    push = np.copysign(accelerations, speeds) / 2.0
    braked: Array = push * into**2 + speeds * even + push * (ramp_s**2 - left**2)
    return braked


def times(gone: Array, ways: Array, speeds: Array, accelerations: Array) -> Array:
    """Return when a motion has covered a distance: the inverse of `places`, for ways ≥ 0.

    Args:
        gone: The distance covered, 0 to `ways`.
        ways: The whole distance.
        speeds: The speed of the even part, above 0.
        accelerations: The accelerations of both ramps.
    """
    ramp = np.minimum(speeds**2 / (2.0 * accelerations), ways / 2.0)
    lasting_s = durations(ways, speeds, accelerations)
    ramp_s = np.sqrt(2.0 * ramp / accelerations)
    into = np.sqrt(2.0 * np.minimum(gone, ramp) / accelerations)
    even = np.clip(gone - ramp, 0.0, np.maximum(ways - 2.0 * ramp, 0.0)) / speeds
    braking = np.sqrt(2.0 * np.clip(ways - gone, 0.0, ramp) / accelerations)
    since: Array = np.where(gone > ways - ramp, lasting_s - braking, into + even)
    return np.where(gone <= ramp, np.minimum(into, ramp_s), since)


def _above_zero(values: Array) -> Array:
    return np.maximum(values, np.finfo(float).tiny)
