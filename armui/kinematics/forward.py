"""The places of the arm's links at given joint angles, and the two-bar geometry behind them.

The arm's plane is turned by joint 1. In it the upper arm points along (cos s, −sin s). With a
spherical wrist the forearm points along (sin e, cos e), and the hand's orientation in it is
Rz(j4)·Ry(j5)·Rz(j6). With a parallel wrist forearm and wrist point along (cos, −sin) of the sums of
the angles so far, and only joints 5 and 6 lead out of the plane. The formulas are written by
components, so that they serve plain numbers, at a few microseconds a pose, and arrays alike.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any, Final, NamedTuple

import numpy as np
import numpy.typing as npt

from armui.kinematics.geometry import JOINT_COUNT, Geometry, Wrist
from armui.kinematics.poses import Matrix, components

_ROUNDING: Final = 1e-9

Value = Any
"""A plain number, or an array of them."""
Vector = tuple[Value, Value, Value]
"""Components in the arm's plane: outwards from joint 1's axis, square to the plane, upwards."""

SIDE: Vector = (0.0, 1.0, 0.0)
"""The axis of joints 2 and 3, square to the plane."""


class PlaneVectors(NamedTuple):
    """The arm in its own plane: places in mm, directions of length 1.

    Attributes:
        cos_1, sin_1: Cosine and sine of joint 1, which turns the plane.
        upper_arm: From the shoulder to the elbow.
        forearm: Along the forearm; the axis of joint 4 of a spherical wrist.
        across: Square to the forearm, in the arm's plane.
        axis_4: The axis of joint 4.
        bend_axis: The axis of joint 5.
        hand: From the wrist's centre to the flange, and on along the gripper.
        thumb: Square to the hand and to the axis of joint 5.
        turn_6: Cosine and sine of joint 6.
        elbow: The place of joint 3.
        wrist: The end of the forearm, the place of joint 4.
        centre: The wrist's centre, where the axes of joints 5 and 6 meet.
        flange: The flange's place.
    """

    cos_1: Value
    sin_1: Value
    upper_arm: Vector
    forearm: Vector
    across: Vector
    axis_4: Vector
    bend_axis: Vector
    hand: Vector
    thumb: Vector
    turn_6: tuple[Value, Value]
    elbow: Vector
    wrist: Vector
    centre: Vector
    flange: Vector

    def turned(self, vector: Vector) -> Vector:
        """Return X, Y and Z in the base frame of a vector in the plane."""
        out, aside, up = vector
        c1, s1 = self.cos_1, self.sin_1
        return c1 * out - s1 * aside, s1 * out + c1 * aside, up

    def flange_axes(self) -> tuple[Vector, Vector, Vector]:
        """Return the directions of the flange's X, Y and Z axes in the base frame."""
        c6, s6 = self.turn_6
        along = _mixed(c6, self.thumb, s6, self.bend_axis)
        palm = _mixed(c6, self.bend_axis, -s6, self.thumb)
        return self.turned(along), self.turned(palm), self.turned(self.hand)


class Links(NamedTuple):
    """The arm's links in the base frame; lengths in mm, directions of length 1.

    All are (…, 3), named as in `PlaneVectors`; `side` is the axis of joints 2 and 3, `along` and
    `palm` are the flange's X and Y.
    """

    side: Matrix
    upper_arm: Matrix
    elbow: Matrix
    forearm: Matrix
    across: Matrix
    wrist: Matrix
    centre: Matrix
    along: Matrix
    palm: Matrix
    hand: Matrix
    flange: Matrix


def links(geometry: Geometry, joints_deg: Matrix) -> Links:
    """Return the places of the links at (…, 6) joint angles."""
    arm = plane_vectors(geometry, joints_deg)
    along, palm, hand = map(stacked, arm.flange_axes())
    side, upper, elbow, forearm, across, wrist, centre, flange = (
        stacked(arm.turned(vector))
        for vector in (
            SIDE, arm.upper_arm, arm.elbow, arm.forearm, arm.across, arm.wrist, arm.centre,
            arm.flange,
        )
    )  # fmt: skip
    return Links(side, upper, elbow, forearm, across, wrist, centre, along, palm, hand, flange)


def flange_transforms(geometry: Geometry, joints_deg: Matrix) -> Matrix:
    """Return the flange's (…, 4, 4) transforms at (…, 6) joint angles, lengths in mm."""
    arm = plane_vectors(geometry, joints_deg)
    transforms = np.zeros((*joints_deg.shape[:-1], 4, 4))
    for column, vector in enumerate((*arm.flange_axes(), arm.turned(arm.flange))):
        transforms[..., :3, column] = stacked(vector)
    transforms[..., 3, 3] = 1.0
    return transforms


def link_frames(geometry: Geometry, joints_deg: Matrix) -> Matrix:
    """Return (n, 7, 4, 4) the frames of base and links at (n, 6) joint angles, lengths in mm.

    Frame 0 is the base; the Z axis of frame i is the axis of joint i, as in the DH table and in the
    robot descriptions. Frame 6 is the flange.
    """
    frames = np.zeros((len(joints_deg), JOINT_COUNT + 1, 4, 4))
    frames[:, :, 3, 3] = 1.0
    frames[:, 0, :3, :3] = np.eye(3)
    for index, row in enumerate(geometry.rows):
        alpha, theta = math.radians(row.alpha_deg), np.radians(joints_deg[:, index] + row.theta_deg)
        ca, sa, ct, st = math.cos(alpha), math.sin(alpha), np.cos(theta), np.sin(theta)
        step = np.zeros((len(joints_deg), 3, 3))
        step[:, 0, 0], step[:, 0, 1] = ct, -st
        step[:, 1, 0], step[:, 1, 1], step[:, 1, 2] = ca * st, ca * ct, -sa
        step[:, 2, 0], step[:, 2, 1], step[:, 2, 2] = sa * st, sa * ct, ca
        way = np.array((row.a_mm, -sa * row.d_mm, ca * row.d_mm))
        before = frames[:, index]
        frames[:, index + 1, :3, :3] = before[:, :3, :3] @ step
        frames[:, index + 1, :3, 3] = before[:, :3, 3] + before[:, :3, :3] @ way
    return frames


def flange_rows(geometry: Geometry, joints_deg: Sequence[float]) -> list[float]:
    """Return the twelve values of the upper three rows of one transform, lengths in mm."""
    arm = _plane_vectors(geometry, joints_deg, math.cos, math.sin, math.radians)
    rows = zip(*arm.flange_axes(), arm.turned(arm.flange), strict=True)
    return [figure for row in rows for figure in row]


def joint_places(geometry: Geometry, joints_deg: Sequence[float]) -> tuple[Vector, Vector, Vector]:
    """Return the places of elbow, wrist and flange in the base in mm, at six joint angles."""
    arm = _plane_vectors(geometry, joints_deg, math.cos, math.sin, math.radians)
    return arm.turned(arm.elbow), arm.turned(arm.wrist), arm.turned(arm.flange)


def plane_vectors(geometry: Geometry, joints_deg: Matrix) -> PlaneVectors:
    """Return the arm in its plane at (…, 6) joint angles; each component is a number or (…)."""
    return _plane_vectors(geometry, components(joints_deg), np.cos, np.sin, np.radians)


def forearm_axes(geometry: Geometry, joints_deg: Matrix) -> Matrix:
    """Return (…, 3, 3) the forearm's across, side and axis as rows, at (…, 3) joints 1–3.

    Only for arms with a spherical wrist.
    """
    angles = (*components(joints_deg), 0.0, 0.0, 0.0)
    arm = _plane_vectors(geometry, angles, np.cos, np.sin, np.radians)
    axes = np.empty((*joints_deg.shape, 3))
    for row, vector in enumerate((arm.across, SIDE, arm.forearm)):
        axes[..., row, 0], axes[..., row, 1], axes[..., row, 2] = arm.turned(vector)
    return axes


def stacked(vector: Vector) -> Matrix:
    """Return (…, 3) of a vector's three components, the first of them (…)."""
    figures = np.empty((*np.shape(vector[0]), 3))
    figures[..., 0], figures[..., 1], figures[..., 2] = vector
    return figures


def _plane_vectors(
    geometry: Geometry,
    joints_deg: Sequence[Value] | Matrix,
    cos: Callable[[Value], Value],
    sin: Callable[[Value], Value],
    radians: Callable[[Value], Value],
) -> PlaneVectors:
    """Return the arm in its plane, with the functions that suit the angles."""
    j1, j2, j3, j4, j5, j6 = joints_deg
    shoulder_zero, elbow_zero, wrist_zero = geometry.plane_zeros_deg
    shoulder = j2 + shoulder_zero
    fore, turn = shoulder + j3 + elbow_zero, j4 + wrist_zero
    parallel = geometry.wrist is Wrist.PARALLEL
    if parallel:
        turn = fore + turn
    angles = [radians(each) for each in (j1, shoulder, fore, turn, j5, j6)]
    c1, cs, ce, c4, c5, c6 = map(cos, angles)
    s1, ss, se, s4, s5, s6 = map(sin, angles)
    upper_arm = (cs, 0.0, -ss)
    forearm, across, axis_4, swing, bend_axis = (
        _parallel_wrist(ce, se, c4, s4) if parallel else _spherical_wrist(ce, se, c4, s4)
    )
    elbow = (geometry.upper_arm_mm * cs, 0.0, geometry.base_mm - geometry.upper_arm_mm * ss)
    wrist = _mixed(geometry.elbow_mm, across, geometry.forearm_mm, forearm)
    wrist = _mixed(1.0, elbow, 1.0, wrist)
    if parallel:
        centre = _mixed(1.0, wrist, geometry.wrist_mm, swing)
        hand, thumb = _mixed(c5, swing, -s5, SIDE), _mixed(-s5, swing, -c5, SIDE)
    else:
        centre = wrist
        hand, thumb = _mixed(c5, forearm, s5, swing), _mixed(c5, swing, -s5, forearm)
    flange = _mixed(1.0, centre, geometry.hand_mm, hand)
    return PlaneVectors(
        c1, s1, upper_arm, forearm, across, axis_4, bend_axis, hand, thumb, (c6, s6), elbow, wrist,
        centre, flange,
    )  # fmt: skip


def _spherical_wrist(ce: Value, se: Value, c4: Value, s4: Value) -> tuple[Vector, ...]:
    """Return forearm, across, axis of joint 4, direction of joint 5's swing, axis of joint 5."""
    forearm, across = (se, 0.0, ce), (ce, 0.0, -se)
    return forearm, across, forearm, (c4 * ce, s4, -c4 * se), (-s4 * ce, c4, s4 * se)


def _parallel_wrist(ce: Value, se: Value, c4: Value, s4: Value) -> tuple[Vector, ...]:
    """Return the same vectors; joint 5 swings the hand out of the wrist's direction."""
    return (ce, 0.0, -se), (-se, 0.0, -ce), SIDE, (c4, 0.0, -s4), (-s4, 0.0, -c4)


def _mixed(part: Value, one: Vector, other_part: Value, other: Vector) -> Vector:
    """Return a weighted sum of two vectors."""
    (x, y, z), (u, v, w) = one, other
    return part * x + other_part * u, part * y + other_part * v, part * z + other_part * w


def wrist_centres(geometry: Geometry, targets: Matrix) -> tuple[Matrix, Matrix, Matrix]:
    """Return each wrist centre: distance from joint 1's axis, height above the shoulder, turn.

    Args:
        geometry: The arm's geometry.
        targets: (…, 4, 4) transforms of the flange.
    """
    centres = targets[..., :3, 3] - geometry.hand_mm * targets[..., :3, 2]
    x, y, z = components(centres)
    return np.hypot(x, y), z - geometry.base_mm, np.arctan2(y, x)


def bar_angles(
    geometry: Geometry, out: Matrix, height: Matrix, elbow_above: npt.NDArray[np.bool_] | Any
) -> tuple[Matrix, Matrix]:
    """Return the angles in radians by which both bars rise to end in a place; NaN out of reach.

    Args:
        geometry: The arm's geometry; its second bar is the straight line from elbow to wrist.
        out: (…) outwards from the shoulder, in mm.
        height: (…) above it, in mm.
        elbow_above: True if the first bar rises more than the straight line to the place.
    """
    upper_mm, fore_mm = geometry.upper_arm_mm, geometry.elbow_to_wrist_mm
    straight = np.hypot(out, height)
    with np.errstate(divide="ignore", invalid="ignore"):
        cosine = (upper_mm**2 - fore_mm**2 + straight**2) / (2 * upper_mm * straight)
        # a pose the arm itself has reported may be out of reach by rounding
        cosine = np.where(np.abs(cosine) <= 1.0 + _ROUNDING, np.clip(cosine, -1.0, 1.0), math.nan)
    upper = np.arctan2(height, out) + np.arccos(cosine) * np.where(elbow_above, 1.0, -1.0)
    fore = np.arctan2(height - upper_mm * np.sin(upper), out - upper_mm * np.cos(upper))
    return upper, fore


def out_of_reach_mm(geometry: Geometry, out: Matrix, height: Matrix) -> Matrix:
    """Return (…) by how many mm a place of the plane is out of both bars' reach; 0 within."""
    straight = np.hypot(out, height)
    upper_mm, fore_mm = geometry.upper_arm_mm, geometry.elbow_to_wrist_mm
    beyond = np.maximum(straight - upper_mm - fore_mm, abs(upper_mm - fore_mm) - straight)
    missing: Matrix = np.maximum(beyond, 0.0)
    return missing
