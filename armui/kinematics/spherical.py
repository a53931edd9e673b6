"""The inverse kinematics of an arm with a spherical wrist.

Joints 1–3 are two bars in a plane that joint 1 turns; they bring the wrist's centre to its place
with up to four solutions. Joints 4–6 then turn the hand, with two solutions each: its orientation
in the forearm is Rz(j4)·Ry(j5)·Rz(j6). All angles are arc tangents, so a stretched wrist (joint 5
at 0) loses no solution to rounding. There joints 4 and 6 turn about one axis, and only their sum
counts.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final

import numpy as np
import numpy.typing as npt

from armui.kinematics.forward import bar_angles, forearm_axes, wrist_centres
from armui.kinematics.geometry import MIDDLES_DEG, Geometry
from armui.kinematics.poses import Matrix, wrapped_deg

STRETCHED_DEG: Final = 2e-3
"""With joint 5 nearer to 0 than this, joint 4 may keep its angle.

This is two of the protocol's steps: rounding to them must not turn a stretched wrist round.
"""

WAYS: Final = 4
"""The number of solutions for the wrist's centre: reaching ahead or back, the elbow up or down."""

_ARM: Final = np.array(MIDDLES_DEG[:3])


def bent_wrist(hands: Matrix) -> Matrix:
    """Return both solutions of the wrist.

    Args:
        hands: (…, 3, 3) orientations of the hand in the forearm.

    Returns:
        (…, 2, 3) joints 4–6 in degrees: joint 5 from 0 up, then from 0 down.
    """
    wrists = np.empty((*hands.shape[:-2], 2, 3))
    wrists[..., 0, 0] = np.degrees(np.arctan2(hands[..., 1, 2], hands[..., 0, 2]))
    wrists[..., 0, 1] = bend_deg(hands)
    wrists[..., 0, 2] = np.degrees(np.arctan2(hands[..., 2, 1], -hands[..., 2, 0]))
    wrists[..., 1, :] = wrists[..., 0, :] * (1.0, -1.0, 1.0) + (180.0, 0.0, 180.0)
    return wrists


def bend_deg(hands: Matrix) -> Matrix:
    """Return the wrist's bend in degrees, joint 5 without its sign; (…) for (…, 3, 3)."""
    aside = np.hypot(hands[..., 0, 2], hands[..., 1, 2])
    bend: Matrix = np.degrees(np.arctan2(aside, hands[..., 2, 2]))
    return bend


def continued(angles_deg: Sequence[float], before_deg: Sequence[float]) -> list[float]:
    """Return the same angles, each within half a turn of the one before."""
    return [
        before + wrapped_deg(angle - before)
        for angle, before in zip(angles_deg, before_deg, strict=True)
    ]


def stretched_wrist(hands: Matrix, joint_4_deg: float) -> Matrix:
    """Return joints 4–6 of a practically stretched wrist when joint 4 keeps its angle.

    The result is exact if the hand's axis lies in the plane that joint 4 allows; otherwise it is
    off by at most the bend of the wrist.

    Args:
        hands: (…, 3, 3) orientations of the hand in the forearm.
        joint_4_deg: The angle joint 4 keeps.

    Returns:
        (…, 3) in degrees.
    """
    angle = np.radians(joint_4_deg)
    along = np.cos(angle) * hands[..., 0, :] + np.sin(angle) * hands[..., 1, :]
    across = np.cos(angle) * hands[..., 1, :] - np.sin(angle) * hands[..., 0, :]
    bend = np.arctan2(along[..., 2], hands[..., 2, 2])
    roll = np.arctan2(across[..., 0], across[..., 1])
    j4 = np.broadcast_to(joint_4_deg, bend.shape)
    return np.stack((j4, np.degrees(bend), np.degrees(roll)), axis=-1)


def arm_joints(
    geometry: Geometry, targets: Matrix, way: npt.NDArray[np.int64] | int | None = None
) -> Matrix:
    """Return joints 1–3 that bring the wrist's centre to where each target needs it.

    Args:
        geometry: The arm's geometry.
        targets: (…, 4, 4) transforms of the flange.
        way: The solution's number, 0–3: 2·(reaching back) + (elbow the other way round); (…), or
            one for all.

    Returns:
        (…, 3) angles in degrees within half a turn of the middles of the joints' ranges, NaN for a
        solution that does not exist; (…, 4, 3) of all solutions if no number is given. A solution
        keeps its number along a continuous path.
    """
    if way is None:
        targets, way = targets[..., None, :, :], np.arange(WAYS)
    back, elbow = np.divmod(way, 2)
    out, height, turn = wrist_centres(geometry, targets)
    out = out * np.where(back, -1.0, 1.0)
    upper, fore = bar_angles(geometry, out, height, elbow == back)
    shoulder_zero, elbow_zero, _ = geometry.plane_zeros_deg
    lean = math.atan2(geometry.forearm_mm, geometry.elbow_mm)
    angles = np.empty((*upper.shape, 3))
    angles[..., 0] = np.degrees(turn) + 180.0 * back
    angles[..., 1] = np.degrees(-upper) - shoulder_zero
    angles[..., 2] = np.degrees(lean - fore + upper) - elbow_zero
    angles[np.isnan(upper)] = math.nan
    wrapped: Matrix = wrapped_deg(angles - _ARM) + _ARM
    return wrapped


def hand_orientations(geometry: Geometry, arms_deg: Matrix, targets: Matrix) -> Matrix:
    """Return (…, 3, 3) the hand's orientation in the forearm that each target needs.

    Args:
        geometry: The arm's geometry.
        arms_deg: (…, 3) joints 1–3.
        targets: (…, 4, 4) transforms of the flange.
    """
    hands: Matrix = forearm_axes(geometry, arms_deg) @ targets[..., :3, :3]
    return hands


def solutions(
    geometry: Geometry, targets: Matrix, joint_4_deg: float | None = None
) -> tuple[Matrix, Matrix]:
    """See `inverse.solutions`; places are 2·way + (wrist bent down)."""
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
