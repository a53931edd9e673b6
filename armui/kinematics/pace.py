"""The speeds at which paths may be followed when joints and tool have limits.

Many paths are planned at once, each over its own parameter. The simulated arm moves at this pace,
and the host computes with it how long a line or an arc will take.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
import numpy.typing as npt
from scipy.interpolate import CubicSpline
from scipy.spatial.transform import Rotation

Values = npt.NDArray[np.float64]

FINER: Final = 4
"""The number of places in each step of the path at which limits are checked."""
_BEND_SHARE: Final = 0.5
"""The part of an acceleration limit that the path's bends may use up at full speed."""
_LEAST_RATE: Final = 1e-9
"""A lower rate is rounding, and limits nothing."""
_LEAST_BEND: Final = 1e-60
"""The same for bends: small even where it is multiplied by the square of the highest speed."""


@dataclass(frozen=True, slots=True)
class Demand:
    """The speeds and accelerations of limited quantities along the paths.

    Attributes:
        rates: The quantities' speeds at a speed of 1 along the path, (places, paths, quantities).
        bends: Their accelerations at that steady speed, of the same shape.
        speeds: The highest speeds, (quantities,).
        accelerations: The highest accelerations, (quantities,).
    """

    rates: Values
    bends: Values
    speeds: Values
    accelerations: Values


def joint_demand(
    way: CubicSpline, places: Values, speeds: Sequence[float], accelerations: Sequence[float]
) -> Demand:
    """Return the demand of the joints.

    Args:
        way: The joint angles in degrees over the path's parameter: (paths, 6) or (6,) at a place.
        places: (n,) values of the parameter.
        speeds: The highest speeds in °/s.
        accelerations: The highest accelerations in °/s².
    """
    shape = (len(places), -1, len(speeds))
    return Demand(
        np.abs(way(places, 1)).reshape(shape),
        np.abs(way(places, 2)).reshape(shape),
        np.array(speeds),
        np.array(accelerations),
    )


def tool_demand(poses: Values, places: Values, end_limits: Sequence[float]) -> Demand:
    """Return the demand of the tool on one path.

    Args:
        poses: (n, 4, 4) transforms of the flange, lengths in mm.
        places: (n,) values of the parameter, evenly spaced.
        end_limits: Linear speed in m/s, angular speed in rad/s, and their accelerations.
    """
    spacing = float(places[1] - places[0])
    velocity = np.gradient(poses[:, :3, 3], spacing, axis=0) / 1e3
    turns = Rotation.from_matrix(poses[:, :3, :3])
    spin = (turns[1:] * turns[:-1].inv()).as_rotvec() / spacing
    spin = np.vstack((spin, spin[-1:]))
    motions = (velocity, spin)
    rates = [np.linalg.norm(motion, axis=1) for motion in motions]
    bends = [np.linalg.norm(np.gradient(each, spacing, axis=0), axis=1) for each in motions]
    linear, angular, linear_acceleration, angular_acceleration = end_limits
    return Demand(
        np.stack(rates, axis=1)[:, None],
        np.stack(bends, axis=1)[:, None],
        np.array((linear, angular)),
        np.array((linear_acceleration, angular_acceleration)),
    )


def pace(demands: Sequence[Demand]) -> tuple[Values, Values]:
    """Return the highest speed and acceleration along each path that keep every limit everywhere.

    Returns:
        Two arrays, (paths,), in units of the paths' parameters per second and per second². Infinite
        where nothing moves.
    """
    paths = demands[0].rates.shape[1]
    top_speed = np.full(paths, math.inf)
    acceleration = np.full(paths, math.inf)
    for each in demands:
        steepest, sharpest = each.rates.max(axis=0), each.bends.max(axis=0)
        by_bend = np.sqrt(_quotient(_BEND_SHARE * each.accelerations, sharpest, _LEAST_BEND))
        fastest = np.minimum(_quotient(each.speeds, steepest), by_bend)
        top_speed = np.minimum(top_speed, fastest.min(axis=1))
    squared = np.where(np.isfinite(top_speed), top_speed, 0.0)[:, None] ** 2
    for each in demands:
        left = _quotient(each.accelerations - each.bends * squared, each.rates)
        acceleration = np.minimum(acceleration, left.min(axis=(0, 2)))
    return top_speed, acceleration


def _quotient(limits: Values, wanted: Values, least: float = _LEAST_RATE) -> Values:
    """Return the allowed amount per unit of demand; infinite where the demand is 0."""
    some = wanted > least
    return np.where(some, limits / np.where(some, wanted, 1.0), math.inf)
