"""The joint angles that bring the flange to a pose: one closed form for each kind of arm."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final

import numpy as np

from armui.kinematics import parallel, spherical
from armui.kinematics.forward import out_of_reach_mm, wrist_centres
from armui.kinematics.geometry import Geometry, Wrist
from armui.kinematics.poses import Joints, Matrix, wrapped_deg

FREE_DEG: Final = 2e-3
"""A wrist this near to a singular pose leaves a joint free, which then keeps its angle.

This is two of the protocol's steps: rounding a pose to them must not turn the wrist round.
"""


def solutions(
    geometry: Geometry, targets: Matrix, near_deg: Sequence[float] | None = None
) -> tuple[Matrix, Matrix]:
    """Return all solutions that bring the flange to each target, whatever the joints' limits.

    Args:
        geometry: The arm's geometry.
        targets: (…, 4, 4) transforms of the flange.
        near_deg: Six angles: a joint that a singular pose of the wrist leaves free keeps its angle
            there, and the two solutions that coincide there count once.

    Returns:
        (…, 8, 6) angles in degrees in fixed places, NaN for solutions that do not exist; a solution
        keeps its place along a continuous path. Also (…) the wrist's distance from a singular pose
        in degrees, in the solution nearest to one: below `FREE_DEG`, `near_deg` is needed.
    """
    if geometry.wrist is Wrist.PARALLEL:
        return parallel.solutions(geometry, targets, near_deg)
    return spherical.solutions(geometry, targets, None if near_deg is None else near_deg[3])


def nearest_first(geometry: Geometry, target: Matrix, near_deg: Sequence[float]) -> list[Joints]:
    """Return the solutions that bring the flange to one target, those nearest to six angles first.

    If a singular pose of the wrist leaves a joint free, the joint keeps its angle in `near_deg`.
    """
    found = solutions(geometry, target, near_deg)[0]
    ways: list[list[float]] = found[~np.isnan(found[:, 0])].tolist()
    return sorted(map(tuple, ways), key=lambda joints: math.dist(joints, near_deg))


def same_way(
    geometry: Geometry, here_deg: Matrix, joints: Joints, there_deg: Matrix
) -> Joints | None:
    """Return the joints at the end of a straight line that stays in its solution branch.

    Args:
        geometry: The arm's geometry.
        here_deg: (8, 6) the `solutions` at the start.
        joints: The joints there.
        there_deg: (8, 6) the `solutions` at the end.

    Returns:
        The six angles, without needless turns of the wrist; ``None`` if the branch ends before.
    """
    if geometry.wrist is Wrist.PARALLEL:
        ends = there_deg[_nearest(wrapped_deg(here_deg - np.array(joints)), 1)]
    else:
        way = _nearest(here_deg.reshape(spherical.WAYS, 2, 6)[:, 0, :3] - np.array(joints[:3]), 1)
        ends = there_deg[2 * way : 2 * way + 2]
    if np.isnan(ends).any():
        return None
    wrists = np.array(joints[3:])
    rows = np.atleast_2d(ends).copy()
    rows[:, 3:] = wrists + wrapped_deg(rows[:, 3:] - wrists)
    best: list[float] = min(rows.tolist(), key=lambda row: math.dist(row[3:], joints[3:]))
    return tuple(best)


def missing_mm(geometry: Geometry, target: Matrix) -> float:
    """Return by how many mm the end of the forearm misses a target; 0 within its reach."""
    if geometry.wrist is Wrist.PARALLEL:
        return parallel.missing_mm(geometry, target)
    out, height, _ = wrist_centres(geometry, target)
    return float(out_of_reach_mm(geometry, out, height))


def _nearest(gaps: Matrix, axis: int) -> int:
    worst = np.abs(gaps).max(axis=axis)
    return int(np.argmin(np.where(np.isnan(worst), math.inf, worst)))
