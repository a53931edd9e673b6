"""The inverse kinematics of an arm with a parallel wrist.

The centre of the wrist lies in the arm's plane, so it gives two solutions for joint 1. The hand's
orientation in that plane gives two solutions for joint 5 and the wrist's direction; joint 6
follows. The rest are two bars from the shoulder to the axis of joint 4, again with two solutions.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final

import numpy as np
import numpy.typing as npt

from armui.kinematics.forward import bar_angles, out_of_reach_mm, wrist_centres
from armui.kinematics.geometry import MIDDLES_DEG, Geometry
from armui.kinematics.poses import Matrix, components, wrapped_deg

WAYS: Final = 8
SQUARE_DEG: Final = 2e-3
"""With joint 5 nearer to ±90° than this, the wrist may keep its direction in the plane."""

_MIDDLES: Final = np.array(MIDDLES_DEG)


def solutions(
    geometry: Geometry, targets: Matrix, near_deg: Sequence[float] | None = None
) -> tuple[Matrix, Matrix]:
    """See `inverse.solutions`; places are those of `joints_of`."""
    every = np.arange(WAYS)
    joints = joints_of(geometry, targets[..., None, :, :], every, near_deg)
    return joints, square_deg(geometry, targets)


def joints_of(
    geometry: Geometry,
    targets: Matrix,
    way: npt.NDArray[np.int64],
    near_deg: Sequence[float] | None = None,
) -> Matrix:
    """Return the joints of one of the eight solutions for each target.

    Args:
        geometry: The arm's geometry.
        targets: (…, 4, 4) transforms of the flange.
        way: (…) the solution's number, 0–7: 4·(reaching back) + 2·(joint 5 beyond a right angle) +
            (elbow the other way round). A solution keeps its number along a continuous path.
        near_deg: Six angles: if joint 5 is practically ±90°, the wrist keeps its direction at these
            angles, and the two solutions coincide.

    Returns:
        (…, 6) angles in degrees within half a turn of the middles of the joints' ranges, NaN for
        solutions that do not exist.
    """
    back, rest = np.divmod(way, 4)
    beyond, elbow = np.divmod(rest, 2)
    out, height, turn = wrist_centres(geometry, targets)
    out, turn = out * np.where(back, -1.0, 1.0), turn + math.pi * back
    hand, along = (_in_plane(turn, targets[..., :3, column]) for column in (2, 0))
    bend_rad, wrist_rad = _hand_angles(hand, beyond)
    lost = np.zeros(bend_rad.shape, dtype=bool)
    if near_deg is not None:
        square = np.broadcast_to(np.hypot(hand[0], hand[2]), lost.shape) < math.radians(SQUARE_DEG)
        kept = math.radians(sum(near_deg[1:4]) + sum(geometry.plane_zeros_deg))
        kept_bend = np.arctan2(-hand[1], hand[0] * math.cos(kept) - hand[2] * math.sin(kept))
        wrist_rad = np.where(square, kept, wrist_rad)
        bend_rad = np.where(square, kept_bend, bend_rad)
        lost = np.asarray(square & (beyond == 1))
    cw, sw, cb, sb = np.cos(wrist_rad), np.sin(wrist_rad), np.cos(bend_rad), np.sin(bend_rad)
    roll_rad = np.arctan2(
        -along[0] * sw - along[2] * cw, -sb * (along[0] * cw - along[2] * sw) - cb * along[1]
    )
    upper, fore = bar_angles(
        geometry, out - geometry.wrist_mm * cw, height + geometry.wrist_mm * sw, elbow == back
    )
    shoulder_zero, elbow_zero, wrist_zero = geometry.plane_zeros_deg
    joints = np.empty((*upper.shape, 6))
    joints[..., 0] = np.degrees(turn)
    joints[..., 1] = np.degrees(-upper) - shoulder_zero
    joints[..., 2] = np.degrees(upper - fore) - elbow_zero
    joints[..., 3] = np.degrees(wrist_rad + fore) - wrist_zero
    joints[..., 4] = np.degrees(bend_rad)
    joints[..., 5] = np.degrees(roll_rad)
    joints[np.isnan(upper) | lost] = math.nan
    wrapped: Matrix = wrapped_deg(joints - _MIDDLES) + _MIDDLES
    return wrapped


def square_deg(geometry: Geometry, targets: Matrix) -> Matrix:
    """Return (…) the distance of joint 5 from ±90° at each target, in degrees."""
    turn = wrist_centres(geometry, targets)[2]
    out, aside, up = _in_plane(turn, targets[..., :3, 2])
    off: Matrix = np.degrees(np.arctan2(np.hypot(out, up), np.abs(aside)))
    return off


def missing_mm(geometry: Geometry, target: Matrix) -> float:
    """See `inverse.missing_mm`."""
    back, beyond = np.divmod(np.arange(4), 2)
    out, height, turn = wrist_centres(geometry, target)
    out, turn = out * np.where(back, -1.0, 1.0), turn + math.pi * back
    _, wrist_rad = _hand_angles(_in_plane(turn, target[:3, 2]), beyond)
    missing = out_of_reach_mm(
        geometry,
        out - geometry.wrist_mm * np.cos(wrist_rad),
        height + geometry.wrist_mm * np.sin(wrist_rad),
    )
    return float(missing.min())


def _hand_angles(
    hand: tuple[Matrix, Matrix, Matrix], beyond: npt.NDArray[np.int64]
) -> tuple[Matrix, Matrix]:
    """Return joint 5, and the angle of the wrist's direction downwards in the plane, in radians."""
    out, aside, up = hand
    sign = np.where(beyond, -1.0, 1.0)
    return np.arctan2(-aside, sign * np.hypot(out, up)), np.arctan2(-sign * up, sign * out)


def _in_plane(turn_rad: Matrix, vectors: Matrix) -> tuple[Matrix, Matrix, Matrix]:
    """Return vectors (…, 3) of the base, by the arm's plane: outwards, aside of it, and upwards."""
    x, y, z = components(vectors)
    c, s = np.cos(turn_rad), np.sin(turn_rad)
    return c * x + s * y, c * y - s * x, z
