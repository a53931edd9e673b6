"""The joint angles along paths of the tool."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final

import numpy as np
import numpy.typing as npt

from armui.kinematics import parallel
from armui.kinematics.geometry import Geometry, Wrist
from armui.kinematics.poses import Matrix, wrapped_deg
from armui.kinematics.spherical import (
    STRETCHED_DEG,
    arm_joints,
    bend_deg,
    bent_wrist,
    continued,
    hand_orientations,
    stretched_wrist,
)

_SURE_DEG: Final = 45.0
"""While joints 4 and 6 turn less than this in a step, the nearer solution of the wrist is the
continued one.
"""


def follow(geometry: Geometry, targets: Matrix, starts_deg: Matrix) -> Matrix:
    """Return the joint angles along paths, each in the solution branch of its start.

    Args:
        geometry: The arm's geometry.
        targets: (m, places, 4, 4) transforms of the flange, the first of them at the start.
        starts_deg: (m, 6) the joints at the start.

    Returns:
        (m, places, 6) angles in degrees, NaN from the place where the branch ends.
    """
    if geometry.wrist is Wrist.PARALLEL:
        return _follow_parallel(geometry, targets, starts_deg)
    arms = arm_joints(geometry, targets, nearest_way(geometry, targets[:, 0], starts_deg)[:, None])
    hands = hand_orientations(geometry, arms, targets)
    wrists = bent_wrist(hands)
    # Where joint 5 passes through 0, joint 4 of one bend leaps by half a turn, and the other bend
    # continues the path.
    crossed = np.abs(wrapped_deg(np.diff(wrists[:, :, 0, 0], axis=1))) > 90.0
    crossings = np.zeros(arms.shape[:2], dtype=np.int64)
    np.cumsum(crossed, axis=1, out=crossings[:, 1:])
    off = np.abs(wrapped_deg(wrists[:, 0] - starts_deg[:, None, 3:])).sum(axis=2)
    bends = (np.argmin(np.nan_to_num(off, nan=math.inf), axis=1)[:, None] + crossings) % 2
    chosen = np.take_along_axis(wrists, bends[:, :, None, None], axis=2)[:, :, 0]
    joints = np.concatenate((arms, chosen), axis=2)
    joints[:, 0] = starts_deg
    turned = wrapped_deg(np.diff(joints[:, :, 3:], axis=1))
    joints[:, 1:, 3:] = starts_deg[:, None, 3:] + np.cumsum(turned, axis=1)
    unsure = (bend_deg(hands) < STRETCHED_DEG).any(axis=1)
    unsure |= (np.abs(np.nan_to_num(turned)) > _SURE_DEG).any(axis=(1, 2))
    for index in np.flatnonzero(unsure).tolist():
        joints[index, 1:, 3:] = _step_by_step(hands[index], starts_deg[index, 3:].tolist())[1:]
    joints[np.logical_or.accumulate(np.isnan(arms[:, :, 0]), axis=1)] = math.nan
    joints[:, 0] = starts_deg
    return joints


def nearest_way(geometry: Geometry, targets: Matrix, joints_deg: Matrix) -> npt.NDArray[np.int64]:
    """Return (m,) the branch of the arm that leads to each target, nearest to (m, 6) joints."""
    gaps = np.abs(arm_joints(geometry, targets) - joints_deg[:, None, :3]).max(axis=2)
    nearest: npt.NDArray[np.int64] = np.argmin(np.nan_to_num(gaps, nan=math.inf), axis=1)
    return nearest


def _follow_parallel(geometry: Geometry, targets: Matrix, starts_deg: Matrix) -> Matrix:
    """Return what `follow` does, for a parallel wrist: the solution keeps its number.

    Joint 5 does not pass ±90°: there the joints leap, as through any singular pose.
    """
    ways = parallel.solutions(geometry, targets[:, 0])[0]
    gaps = np.abs(wrapped_deg(ways - starts_deg[:, None])).max(axis=2)
    way = np.argmin(np.nan_to_num(gaps, nan=math.inf), axis=1)
    joints = parallel.joints_of(geometry, targets, way[:, None])
    joints[:, 0] = starts_deg
    turned = wrapped_deg(np.diff(joints[:, :, 3:], axis=1))
    joints[:, 1:, 3:] = starts_deg[:, None, 3:] + np.cumsum(turned, axis=1)
    joints[np.logical_or.accumulate(np.isnan(joints[:, :, 0]), axis=1)] = math.nan
    joints[:, 0] = starts_deg
    return joints


def _step_by_step(hands: Matrix, start_deg: Sequence[float]) -> Matrix:
    """Return (n, 3) joints 4–6 for (n, 3, 3) hands in turn, each with the nearest bend."""
    last: Sequence[float] = start_deg
    followed = []
    stretched = bend_deg(hands) < STRETCHED_DEG
    for index, bends in enumerate(bent_wrist(hands).tolist()):
        if stretched[index]:
            bends = [stretched_wrist(hands[index], last[0]).tolist()]  # noqa: PLW2901 - the same
        near = [continued(wrist, last) for wrist in bends]
        last = min(near, key=lambda wrist: math.dist(wrist, last))
        followed.append(last)
    return np.array(followed)
