"""The spherical wrist: joints 4–6 from the orientation they give the hand.

The hand's orientation in the forearm is Rz(j4)·Ry(j5)·Rz(j6). All angles are arc tangents, so a
stretched wrist (joint 5 at 0) loses no solution to rounding. There joints 4 and 6 turn about one
axis and only their sum counts.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import numpy as np

from armui.kinematics.poses import Matrix, wrapped_deg

STRETCHED_DEG: Final = 2e-3
"""With joint 5 nearer to 0 than this, joint 4 may as well stay where it is.

Two of the protocol's steps: a stretched wrist, rounded to them, must not turn about.
"""


def bent_wrist(hands: Matrix) -> Matrix:
    """Both ways to bend the wrist.

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
    """How far the wrist is bent, joint 5 without its sign, in degrees; (…) for (…, 3, 3)."""
    aside = np.hypot(hands[..., 0, 2], hands[..., 1, 2])
    bend: Matrix = np.degrees(np.arctan2(aside, hands[..., 2, 2]))
    return bend


def continued(angles_deg: Sequence[float], before_deg: Sequence[float]) -> list[float]:
    """The same angles without a turn more than needed from those before."""
    return [
        before + wrapped_deg(angle - before)
        for angle, before in zip(angles_deg, before_deg, strict=True)
    ]


def stretched_wrist(hands: Matrix, joint_4_deg: float) -> Matrix:
    """Joints 4–6 of a wrist as good as stretched when joint 4 stays where it is.

    Exact when the hand's axis lies in the plane joint 4 leaves it; off by at most the bend of the
    wrist otherwise.

    Args:
        hands: (…, 3, 3) orientations of the hand in the forearm.
        joint_4_deg: Where joint 4 stays.

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
