"""The kinematics for many poses at once: what a check of ten thousand points needs.

The same geometry as `armui.kinematics.kinematics`, written for arrays. There py-opw-kinematics
gives the ways of the arm, some 50 µs a pose; joints 1–3 are two bars in a plane that joint 1
turns, which numpy solves in a fraction of a microsecond.
"""

from __future__ import annotations

import math
from typing import Final, NamedTuple

import numpy as np
import numpy.typing as npt

from armui.kinematics.kinematics import (
    BASE_MM,
    ELBOW_MM,
    FOREARM_MM,
    HAND_MM,
    MIDDLES_DEG,
    UPPER_ARM_MM,
    Kinematics,
    Matrix,
)
from armui.kinematics.wrist import bend_deg, bent_wrist

WAYS: Final = 4
"""Ways to bring the wrist's centre to a place: reaching ahead or back, the elbow up or down."""

_FORE_BAR_MM: Final = math.hypot(ELBOW_MM, FOREARM_MM)
_FORE_BAR_RAD: Final = math.atan2(FOREARM_MM, ELBOW_MM)
"""The straight line from the elbow to the wrist's centre: its length, its angle in the forearm."""
_ROUNDING: Final = 1e-9


class Skeleton(NamedTuple):
    """Where the parts of the arm are; lengths in mm, directions of length 1, all (n, 3).

    Attributes:
        side: The axis of joints 2 and 3.
        upper_arm: From the shoulder to the elbow.
        elbow: The place of joint 3.
        forearm: The axis of joint 4.
        across: Square to the forearm, in the arm's plane.
        centre: Of the wrist.
        palm: The direction in which the gripper's fingers part.
        hand: From the wrist's centre to the flange, and on along the gripper.
        flange: Its place.
    """

    side: Matrix
    upper_arm: Matrix
    elbow: Matrix
    forearm: Matrix
    across: Matrix
    centre: Matrix
    palm: Matrix
    hand: Matrix
    flange: Matrix


def skeletons(kinematics: Kinematics, joints_deg: Matrix) -> Skeleton:
    """Where the parts of the arm are at (n, 6) joint angles."""
    j1, j2, j3, j4, j5, j6 = np.radians(joints_deg).T[..., None]
    s = j2 + math.radians(kinematics.shoulder_zero_deg)
    e = j2 + j3 + math.radians(kinematics.forearm_zero_deg)
    zero = np.zeros_like(j1)
    up = np.array((0.0, 0.0, 1.0))
    ahead = np.hstack((np.cos(j1), np.sin(j1), zero))
    side = np.hstack((-np.sin(j1), np.cos(j1), zero))
    upper_arm = np.cos(s) * ahead - np.sin(s) * up
    forearm = np.sin(e) * ahead + np.cos(e) * up
    across = np.cos(e) * ahead - np.sin(e) * up
    elbow = BASE_MM * up + UPPER_ARM_MM * upper_arm
    centre = elbow + ELBOW_MM * across + FOREARM_MM * forearm
    swing = np.cos(j4) * across + np.sin(j4) * side
    bend_axis = np.cos(j4) * side - np.sin(j4) * across
    hand = np.cos(j5) * forearm + np.sin(j5) * swing
    thumb = np.cos(j5) * swing - np.sin(j5) * forearm
    palm = np.cos(j6) * bend_axis - np.sin(j6) * thumb
    flange = centre + HAND_MM * hand
    return Skeleton(side, upper_arm, elbow, forearm, across, centre, palm, hand, flange)


def flanges(kinematics: Kinematics, joints_deg: Matrix) -> Matrix:
    """The flange's (n, 4, 4) transforms at (n, 6) joint angles, lengths in mm."""
    bones = skeletons(kinematics, joints_deg)
    transforms = np.zeros((len(joints_deg), 4, 4))
    transforms[:, :3, 0] = np.cross(bones.palm, bones.hand)
    transforms[:, :3, 1] = bones.palm
    transforms[:, :3, 2] = bones.hand
    transforms[:, :3, 3] = bones.flange
    transforms[:, 3, 3] = 1.0
    return transforms


def flange_heights(kinematics: Kinematics, joints_deg: Matrix) -> Matrix:
    """(n,) how high the flange is, in mm, at (n, 6) joint angles; without all the rest."""
    _, j2, j3, j4, j5, _ = np.radians(joints_deg).T
    s = j2 + math.radians(kinematics.shoulder_zero_deg)
    e = j2 + j3 + math.radians(kinematics.forearm_zero_deg)
    sin_e, cos_e = np.sin(e), np.cos(e)
    centre = BASE_MM - UPPER_ARM_MM * np.sin(s) - ELBOW_MM * sin_e + FOREARM_MM * cos_e
    heights: Matrix = centre + HAND_MM * (cos_e * np.cos(j5) - sin_e * np.cos(j4) * np.sin(j5))
    return heights


def margins(kinematics: Kinematics, joints_deg: Matrix) -> Matrix:
    """(n,) how far poses are from a singular one, 0 to 1, by a product quick to work out.

    It is 0 where the wrist or the elbow is straight or the wrist's centre is above joint 1, and
    tells which of the poses of one path is nearest to a singular one; how near, the smallest
    singular value of the Jacobian tells.
    """
    _, j2, j3, _, j5, _ = np.radians(joints_deg).T
    s = j2 + math.radians(kinematics.shoulder_zero_deg)
    e = j2 + j3 + math.radians(kinematics.forearm_zero_deg)
    ahead = UPPER_ARM_MM * np.cos(s) + ELBOW_MM * np.cos(e) + FOREARM_MM * np.sin(e)
    elbow = np.sin(_FORE_BAR_RAD - e + s)
    share = ahead / (UPPER_ARM_MM + _FORE_BAR_MM)
    margin: Matrix = np.abs(np.sin(j5) * elbow * share)
    return margin


def jacobians(kinematics: Kinematics, joints_deg: Matrix) -> Matrix:
    """(n, 6, 6) as `Kinematics.jacobian` gives it for one pose."""
    bones = skeletons(kinematics, joints_deg)
    j4 = np.radians(joints_deg[:, 3, None])
    up = np.broadcast_to((0.0, 0.0, 1.0), bones.side.shape)
    bend_axis = np.cos(j4) * bones.side - np.sin(j4) * bones.across
    axes = np.stack((up, bones.side, bones.side, bones.forearm, bend_axis, bones.hand), axis=2)
    shoulder = BASE_MM * up
    arms = [bones.flange - origin for origin in (shoulder, shoulder, bones.elbow)]
    arms += [bones.flange - bones.centre] * 3
    return np.concatenate((np.cross(axes, np.stack(arms, axis=2), axis=1) / 1e3, axes), axis=1)


def arm_ways(kinematics: Kinematics, targets: Matrix) -> Matrix:
    """Joints 1–3 of all ways to bring the wrist's centre where the targets want it.

    Args:
        kinematics: Of the arm.
        targets: (n, 4, 4) transforms of the flange.

    Returns:
        (n, 4, 3) angles, as `arm_way` gives each.
    """
    return np.stack([arm_way(kinematics, targets, way) for way in range(WAYS)], axis=1)


def arm_way(kinematics: Kinematics, targets: Matrix, way: npt.NDArray[np.int64] | int) -> Matrix:
    """Joints 1–3 of one way to bring the wrist's centre where each target wants it.

    Args:
        kinematics: Of the arm.
        targets: (n, 4, 4) transforms of the flange.
        way: Which, 0–3: 2·(reaching back) + (elbow the other way round); (n,), or one for all.

    Returns:
        (n, 3) angles in degrees within half a turn of the middles of the joints' ranges, NaN
        where the way does not exist. A way keeps its number along a continuous path.
    """
    back, elbow = np.divmod(way, 2)
    centre = targets[:, :3, 3] - HAND_MM * targets[:, :3, 2]
    ahead = np.hypot(centre[:, 0], centre[:, 1]) * np.where(back, -1.0, 1.0)
    height = centre[:, 2] - BASE_MM
    straight = np.hypot(ahead, height)
    with np.errstate(divide="ignore", invalid="ignore"):
        cosine = (UPPER_ARM_MM**2 - _FORE_BAR_MM**2 + straight**2) / (2 * UPPER_ARM_MM * straight)
        # a pose the arm itself has reported may be out of reach by rounding
        cosine = np.where(np.abs(cosine) <= 1.0 + _ROUNDING, np.clip(cosine, -1.0, 1.0), math.nan)
    opening = np.arccos(cosine) * np.where(elbow == back, 1.0, -1.0)
    bar = np.arctan2(height, ahead) + opening
    fore = np.arctan2(height - UPPER_ARM_MM * np.sin(bar), ahead - UPPER_ARM_MM * np.cos(bar))
    angles = np.empty((len(targets), 3))
    angles[:, 0] = np.degrees(np.arctan2(centre[:, 1], centre[:, 0])) + 180.0 * back
    angles[:, 1] = np.degrees(-bar) - kinematics.shoulder_zero_deg
    angles[:, 2] = np.degrees(_FORE_BAR_RAD - fore) - kinematics.forearm_zero_deg - angles[:, 1]
    angles[np.isnan(cosine)] = math.nan
    offset = 180.0 - np.array(MIDDLES_DEG)
    near: Matrix = (angles + offset) % 360.0 - offset
    return near


def solutions(kinematics: Kinematics, targets: Matrix) -> tuple[Matrix, Matrix]:
    """All ways to bring the flange to each target, whatever the joints' limits.

    Args:
        kinematics: Of the arm.
        targets: (n, 4, 4) transforms of the flange.

    Returns:
        (n, 8, 6) angles in degrees, as `Kinematics.inverse` has them but in fixed places: 2·way +
        (wrist bent down); NaN where there is none. And (n,) how far the wrist is bent, in the way
        in which it is least: one as good as stretched asks where joint 4 is.
    """
    arms = arm_ways(kinematics, targets)
    joints = np.empty((len(targets), WAYS, 2, 6))
    joints[..., :3] = arms[:, :, None]
    hands = kinematics.hands(arms.reshape(-1, 3), np.repeat(targets, WAYS, axis=0))
    wrists = (bent_wrist(hands) + 180.0) % 360.0 - 180.0
    joints[..., 3:] = wrists.reshape(-1, WAYS, 2, 3)
    bends = np.nan_to_num(bend_deg(hands), nan=180.0).reshape(-1, WAYS)
    return joints.reshape(-1, 2 * WAYS, 6), bends.min(axis=1)
