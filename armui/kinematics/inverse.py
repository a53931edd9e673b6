"""The joint angles that bring the flange to a pose.

Joints 1–3 are two bars in a plane that joint 1 turns; they bring the wrist's centre to its place in
up to four ways. Joints 4–6 then turn the hand, in two ways each.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final

import numpy as np
import numpy.typing as npt

from armui.kinematics.forward import forearm_axes
from armui.kinematics.geometry import (
    BASE_MM,
    ELBOW_TO_WRIST_MM,
    ELBOW_TO_WRIST_RAD,
    HAND_MM,
    MIDDLES_DEG,
    UPPER_ARM_MM,
    Geometry,
)
from armui.kinematics.poses import Joints, Matrix, components, wrapped_deg
from armui.kinematics.wrist import STRETCHED_DEG, bend_deg, bent_wrist, stretched_wrist

WAYS: Final = 4
"""Ways to bring the wrist's centre to a place: reaching ahead or back, the elbow up or down."""

_ROUNDING: Final = 1e-9


def arm_joints(
    geometry: Geometry, targets: Matrix, way: npt.NDArray[np.int64] | int | None = None
) -> Matrix:
    """Joints 1–3 of ways to bring the wrist's centre where each target wants it.

    Args:
        geometry: Of the arm.
        targets: (…, 4, 4) transforms of the flange.
        way: Which, 0–3: 2·(reaching back) + (elbow the other way round); (…), or one for all.

    Returns:
        (…, 3) angles in degrees within half a turn of the middles of the joints' ranges, NaN
        where the way does not exist; (…, 4, 3) of all ways if none is named. A way keeps its
        number along a continuous path.
    """
    if way is None:
        targets, way = targets[..., None, :, :], np.arange(WAYS)
    back, elbow = np.divmod(way, 2)
    out, height, turn = _wrist_centres(targets)
    out = out * np.where(back, -1.0, 1.0)
    straight = np.hypot(out, height)
    with np.errstate(divide="ignore", invalid="ignore"):
        sides = UPPER_ARM_MM**2 - ELBOW_TO_WRIST_MM**2 + straight**2
        cosine = sides / (2 * UPPER_ARM_MM * straight)
        # a pose the arm itself has reported may be out of reach by rounding
        cosine = np.where(np.abs(cosine) <= 1.0 + _ROUNDING, np.clip(cosine, -1.0, 1.0), math.nan)
    upper = np.arctan2(height, out) + np.arccos(cosine) * np.where(elbow == back, 1.0, -1.0)
    fore = np.arctan2(height - UPPER_ARM_MM * np.sin(upper), out - UPPER_ARM_MM * np.cos(upper))
    shoulder_zero, elbow_zero = geometry.value
    angles = np.empty((*upper.shape, 3))
    angles[..., 0] = np.degrees(turn) + 180.0 * back
    angles[..., 1] = np.degrees(-upper) - shoulder_zero
    angles[..., 2] = np.degrees(ELBOW_TO_WRIST_RAD - fore + upper) - elbow_zero
    angles[np.isnan(cosine)] = math.nan
    return wrapped_deg(angles - MIDDLES_DEG) + MIDDLES_DEG


def hand_orientations(geometry: Geometry, arms_deg: Matrix, targets: Matrix) -> Matrix:
    """(…, 3, 3) how the hand must lie in the forearm, for the wrist's joints.

    Args:
        geometry: Of the arm.
        arms_deg: (…, 3) joints 1–3.
        targets: (…, 4, 4) transforms of the flange.
    """
    hands: Matrix = forearm_axes(geometry, arms_deg) @ targets[..., :3, :3]
    return hands


def solutions(
    geometry: Geometry, targets: Matrix, joint_4_deg: float | None = None
) -> tuple[Matrix, Matrix]:
    """All ways to bring the flange to each target, whatever the joints' limits.

    Args:
        geometry: Of the arm.
        targets: (…, 4, 4) transforms of the flange.
        joint_4_deg: Where joint 4 stays with a stretched wrist, which then has one solution.

    Returns:
        (…, 8, 6) angles in degrees in fixed places, 2·way + (wrist bent down); NaN where there is
        none. And (…) how far the wrist is bent, in the way in which it is least: one as good as
        stretched asks where joint 4 is.
    """
    arms = arm_joints(geometry, targets)
    hands = hand_orientations(geometry, arms, targets[..., None, :, :])
    bends = bend_deg(hands)
    wrists = wrapped_deg(bent_wrist(hands))
    if joint_4_deg is not None:
        stretched = bends < STRETCHED_DEG
    if joint_4_deg is not None and stretched.any():
        wrists[stretched, 0] = stretched_wrist(hands[stretched], joint_4_deg)
        wrists[stretched, 0, 2] = wrapped_deg(wrists[stretched, 0, 2])
        wrists[stretched, 1] = math.nan
    joints = np.empty((*wrists.shape[:-1], 6))
    joints[..., :3] = np.where(np.isnan(wrists[..., :1]), math.nan, arms[..., None, :])
    joints[..., 3:] = wrists
    least = np.nan_to_num(bends, nan=180.0).min(axis=-1)
    return joints.reshape(*targets.shape[:-2], 2 * WAYS, 6), least


def nearest_first(geometry: Geometry, target: Matrix, near_deg: Sequence[float]) -> list[Joints]:
    """The ways to bring the flange to one target, those nearest to six angles first.

    With a wrist stretched to 0.002° joint 4 stays where it is in `near_deg`: a pose rounded to the
    protocol's steps must not turn the wrist about.
    """
    found = solutions(geometry, target, near_deg[3])[0]
    ways: list[list[float]] = found[~np.isnan(found[:, 0])].tolist()
    return sorted(map(tuple, ways), key=lambda joints: math.dist(joints, near_deg))


def missing_mm(target: Matrix) -> float:
    """How far the wrist's centre is out of the arm's reach for one target; 0 within it."""
    out, height, _ = _wrist_centres(target)
    straight = math.hypot(out, height)
    return max(
        0.0,
        straight - UPPER_ARM_MM - ELBOW_TO_WRIST_MM,
        UPPER_ARM_MM - ELBOW_TO_WRIST_MM - straight,
    )


def _wrist_centres(targets: Matrix) -> tuple[Matrix, Matrix, Matrix]:
    """Of each target: how far from joint 1's axis, how high above the shoulder, in which turn."""
    centres = targets[..., :3, 3] - HAND_MM * targets[..., :3, 2]
    x, y, z = components(centres)
    return np.hypot(x, y), z - BASE_MM, np.arctan2(y, x)
