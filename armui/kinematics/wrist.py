"""The spherical wrist: joints 4–6 from the orientation they give the hand.

The hand's orientation in the forearm is Rz(j4)·Ry(j5)·Rz(j6). All angles are arc tangents, so a
stretched wrist (joint 5 at 0) loses no solution to rounding. There joints 4 and 6 turn about one
axis and only their sum counts.
"""

from __future__ import annotations

import math
from typing import Final

import numpy as np
import numpy.typing as npt

Matrix = npt.NDArray[np.float64]

STRETCHED_DEG: Final = 2e-3
"""With joint 5 nearer to 0 than this, joint 4 may as well stay where it is.

Two of the protocol's steps: a stretched wrist, rounded to them, must not turn about.
"""


def bent_wrist(hands: Matrix) -> Matrix:
    """Both ways to bend the wrist.

    Args:
        hands: (n, 3, 3) orientations of the hand in the forearm.

    Returns:
        (n, 2, 3) joints 4–6 in degrees: joint 5 from 0 up, then from 0 down.
    """
    bend = bend_deg(hands)
    j4 = np.degrees(np.arctan2(hands[:, 1, 2], hands[:, 0, 2]))
    j6 = np.degrees(np.arctan2(hands[:, 2, 1], -hands[:, 2, 0]))
    up = np.stack((j4, bend, j6), axis=1)
    down = np.stack((j4 + 180.0, -bend, j6 + 180.0), axis=1)
    return np.stack((up, down), axis=1)


def bend_deg(hands: Matrix) -> Matrix:
    """How far the wrist is bent, joint 5 without its sign, in degrees; (n,) for (n, 3, 3)."""
    bend: Matrix = np.degrees(np.arctan2(np.hypot(hands[:, 0, 2], hands[:, 1, 2]), hands[:, 2, 2]))
    return bend


def stretched_wrist(hand: Matrix, joint_4_deg: float) -> tuple[float, float, float]:
    """Joints 4–6 of a wrist as good as stretched when joint 4 stays where it is.

    Exact when the hand's axis lies in the plane joint 4 leaves it; off by at most the bend of the
    wrist otherwise.

    Args:
        hand: (3, 3) orientation of the hand in the forearm.
        joint_4_deg: Where joint 4 stays.
    """
    c4, s4 = math.cos(math.radians(joint_4_deg)), math.sin(math.radians(joint_4_deg))
    (xx, xy, xz), (yx, yy, yz), (_, _, zz) = hand.tolist()
    bend = math.atan2(c4 * xz + s4 * yz, zz)
    roll = math.atan2(c4 * yx - s4 * xx, c4 * yy - s4 * xy)
    return joint_4_deg, math.degrees(bend), math.degrees(roll)
