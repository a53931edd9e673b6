"""Where the links of the arm are at given joint angles.

The arm's plane is turned by joint 1. In it the upper arm points along (cos s, −sin s) and the
forearm along (sin e, cos e); the hand's orientation in the forearm is Rz(j4)·Ry(j5)·Rz(j6). The
formulas are written by components, so that they serve plain numbers, at a few microseconds a pose,
and arrays alike.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from armui.kinematics.geometry import BASE_MM, ELBOW_MM, FOREARM_MM, HAND_MM, UPPER_ARM_MM, Geometry
from armui.kinematics.poses import Matrix, components

Value = Any
"""A plain number, or an array of them."""
Vector = tuple[Value, Value, Value]
"""In the arm's plane: outwards from joint 1's axis, square to the plane, upwards."""


class PlaneVectors(NamedTuple):
    """The arm in its own plane: places in mm, directions of length 1.

    Attributes:
        cos_1, sin_1: How the plane is turned.
        upper_arm: From the shoulder to the elbow.
        forearm: The axis of joint 4.
        across: Square to the forearm, in the arm's plane.
        bend_axis: Of joint 5.
        hand: From the wrist's centre to the flange, and on along the gripper.
        thumb: Square to the hand and to the axis of joint 5.
        turn_6: Cosine and sine of joint 6.
        elbow: The place of joint 3.
        centre: Of the wrist.
        flange: Its place.
    """

    cos_1: Value
    sin_1: Value
    upper_arm: Vector
    forearm: Vector
    across: Vector
    bend_axis: Vector
    hand: Vector
    thumb: Vector
    turn_6: tuple[Value, Value]
    elbow: Vector
    centre: Vector
    flange: Vector

    def turned(self, vector: Vector) -> Vector:
        """X, Y and Z in the base frame of a vector in the plane."""
        out, aside, up = vector
        c1, s1 = self.cos_1, self.sin_1
        return c1 * out - s1 * aside, s1 * out + c1 * aside, up

    def flange_axes(self) -> tuple[Vector, Vector, Vector]:
        """The flange's X, Y and Z in the base frame."""
        c6, s6 = self.turn_6
        along = _mixed(c6, self.thumb, s6, self.bend_axis)
        palm = _mixed(c6, self.bend_axis, -s6, self.thumb)
        return self.turned(along), self.turned(palm), self.turned(self.hand)


SIDE: Vector = (0.0, 1.0, 0.0)
"""The axis of joints 2 and 3, square to the plane."""


class Links(NamedTuple):
    """Where the links of the arm are in the base frame; lengths in mm, directions of length 1.

    All are (…, 3), named as in `PlaneVectors`; `side` is the axis of joints 2 and 3, `palm` the
    direction in which the gripper's fingers part.
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


def links(geometry: Geometry, joints_deg: Matrix) -> Links:
    """Where the links are at (…, 6) joint angles."""
    arm = plane_vectors(geometry, joints_deg)
    palm = stacked(arm.flange_axes()[1])
    side, upper, elbow, forearm, across, centre, hand, flange = (
        stacked(arm.turned(vector))
        for vector in (
            SIDE, arm.upper_arm, arm.elbow, arm.forearm, arm.across, arm.centre, arm.hand,
            arm.flange,
        )
    )  # fmt: skip
    return Links(side, upper, elbow, forearm, across, centre, palm, hand, flange)


def flange_transforms(geometry: Geometry, joints_deg: Matrix) -> Matrix:
    """The flange's (…, 4, 4) transforms at (…, 6) joint angles, lengths in mm."""
    arm = plane_vectors(geometry, joints_deg)
    transforms = np.zeros((*joints_deg.shape[:-1], 4, 4))
    for column, vector in enumerate((*arm.flange_axes(), arm.turned(arm.flange))):
        transforms[..., :3, column] = stacked(vector)
    transforms[..., 3, 3] = 1.0
    return transforms


def flange_rows(geometry: Geometry, joints_deg: Sequence[float]) -> list[float]:
    """The twelve figures of the upper three rows of one transform, lengths in mm."""
    arm = _plane_vectors(geometry, joints_deg, math.cos, math.sin, math.radians)
    rows = zip(*arm.flange_axes(), arm.turned(arm.flange), strict=True)
    return [figure for row in rows for figure in row]


def flange_heights(geometry: Geometry, joints_deg: Matrix) -> Matrix:
    """(…) how high the flange is, in mm, at (…, 6) joint angles; without all the rest."""
    height: Matrix = plane_vectors(geometry, joints_deg).flange[2]
    return height


def plane_vectors(geometry: Geometry, joints_deg: Matrix) -> PlaneVectors:
    """The arm in its plane at (…, 6) joint angles; each component is a number or (…)."""
    return _plane_vectors(geometry, components(joints_deg), np.cos, np.sin, np.radians)


def forearm_axes(geometry: Geometry, joints_deg: Matrix) -> Matrix:
    """(…, 3, 3) with the forearm's across, side and axis as rows, at (…, 3) joints 1–3."""
    angles = (*components(joints_deg), 0.0, 0.0, 0.0)
    arm = _plane_vectors(geometry, angles, np.cos, np.sin, np.radians)
    axes = np.empty((*joints_deg.shape, 3))
    for row, vector in enumerate((arm.across, SIDE, arm.forearm)):
        axes[..., row, 0], axes[..., row, 1], axes[..., row, 2] = arm.turned(vector)
    return axes


def stacked(vector: Vector) -> Matrix:
    """(…, 3) of three components, the first of them (…)."""
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
    """The arm in its plane, with the functions that suit the angles."""
    j1, j2, j3, j4, j5, j6 = joints_deg
    shoulder_zero, elbow_zero = geometry.value
    shoulder = j2 + shoulder_zero
    angles = [radians(each) for each in (j1, shoulder, shoulder + j3 + elbow_zero, j4, j5, j6)]
    c1, cs, ce, c4, c5, c6 = map(cos, angles)
    s1, ss, se, s4, s5, s6 = map(sin, angles)
    upper_arm, forearm, across = (cs, 0.0, -ss), (se, 0.0, ce), (ce, 0.0, -se)
    swing = (c4 * ce, s4, -c4 * se)
    bend_axis = (-s4 * ce, c4, s4 * se)
    hand = _mixed(c5, forearm, s5, swing)
    thumb = _mixed(c5, swing, -s5, forearm)
    elbow = (UPPER_ARM_MM * cs, 0.0, BASE_MM - UPPER_ARM_MM * ss)
    centre = (
        elbow[0] + ELBOW_MM * ce + FOREARM_MM * se,
        0.0,
        elbow[2] - ELBOW_MM * se + FOREARM_MM * ce,
    )
    flange = _mixed(1.0, centre, HAND_MM, hand)
    return PlaneVectors(
        c1, s1, upper_arm, forearm, across, bend_axis, hand, thumb, (c6, s6), elbow, centre, flange
    )


def _mixed(part: Value, one: Vector, other_part: Value, other: Vector) -> Vector:
    """So much of one vector and so much of another."""
    (x, y, z), (u, v, w) = one, other
    return part * x + other_part * u, part * y + other_part * v, part * z + other_part * w
