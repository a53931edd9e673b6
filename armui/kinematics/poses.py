"""Poses as six values and as transforms: conversion, motion and comparison."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple, TypeVar

import numpy as np
import numpy.typing as npt

from armui.kinematics.axes import JogFrame

Matrix = npt.NDArray[np.float64]
JogAxes = JogFrame | Matrix
"""The frame whose axes count in a jog, or the 3×3 rotation of another one in the base."""
Joints = tuple[float, ...]
"""Six angles in degrees, joint 1 first."""
_Angle = TypeVar("_Angle", float, Matrix)


class Pose(NamedTuple):
    """The position and orientation of the flange in the base frame.

    R = Rz(rz)·Ry(ry)·Rx(rx), as in the end pose feedback 0x2A2–0x2A4.
    """

    x_mm: float
    y_mm: float
    z_mm: float
    rx_deg: float
    ry_deg: float
    rz_deg: float


def pose_to_matrix(pose: Sequence[float] | Matrix) -> Matrix:
    """Return the homogeneous transforms of poses, lengths in mm: (…, 6) becomes (…, 4, 4)."""
    figures = np.asarray(pose, dtype=np.float64)
    angles = np.radians(figures[..., 3:])
    cx, cy, cz = components(np.cos(angles))
    sx, sy, sz = components(np.sin(angles))
    rows = (
        (cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx, figures[..., 0]),
        (sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx, figures[..., 1]),
        (-sy, cy * sx, cy * cx, figures[..., 2]),
    )
    matrix = np.zeros((*figures.shape[:-1], 4, 4))
    for index, row in enumerate(rows):
        for column, values in enumerate(row):
            matrix[..., index, column] = values
    matrix[..., 3, 3] = 1.0
    return matrix


def components(vectors: Matrix) -> list[Matrix]:
    """Return the columns of (…, n) as n arrays (…)."""
    return [vectors[..., index] for index in range(vectors.shape[-1])]


def matrix_to_pose(matrix: Matrix) -> Pose:
    """Return the pose of a 4×4 transform, lengths in mm; at RY = ±90° RZ is taken as 0."""
    return rows_to_pose(matrix[:3].ravel().tolist())


def rows_to_pose(rows: Sequence[float]) -> Pose:
    """Return the pose of the twelve values in a transform's upper three rows."""
    xx, _, _, x, yx, yy, yz, y, zx, zy, zz, z = rows
    horizontal = math.hypot(xx, yx)
    ry = math.atan2(-zx, horizontal)
    if horizontal > 1e-9:
        rx, rz = math.atan2(zy, zz), math.atan2(yx, xx)
    else:
        rx, rz = math.atan2(-yz, yy), 0.0
    return Pose(x, y, z, math.degrees(rx), math.degrees(ry), math.degrees(rz))


def wrapped_deg(angle_deg: _Angle) -> _Angle:
    """Return the same angles within −180° to 180°."""
    return (angle_deg + 180.0) % 360.0 - 180.0


def apart(one: Pose, other: Pose) -> tuple[float, float]:
    """Return the distance of two poses in mm, and the angle between them in degrees."""
    first, second = pose_to_matrix(np.array((one, other)))
    cosine = (float(np.trace(first[:3, :3].T @ second[:3, :3])) - 1.0) / 2.0
    turned_deg = math.degrees(math.acos(min(1.0, max(-1.0, cosine))))
    return math.dist(one[:3], other[:3]), turned_deg


def tool_matrix(flange: Matrix, tool: Sequence[float]) -> Matrix:
    """Return the 4×4 transform of the tool centre point of a tool mounted on the flange."""
    result: Matrix = flange @ pose_to_matrix(tool)
    return result


def flange_matrix(tool_point: Matrix, tool: Sequence[float]) -> Matrix:
    """Return the flange's transform that brings the tool centre point to a transform."""
    result: Matrix = tool_point @ np.linalg.inv(pose_to_matrix(tool))
    return result


def tool_pose(flange: Sequence[float], tool: Sequence[float]) -> Pose:
    """Return the tool centre point's pose, from the flange's and the tool's on it (mm, °)."""
    return matrix_to_pose(tool_matrix(pose_to_matrix(flange), tool))


def flange_pose(tool_point: Sequence[float], tool: Sequence[float]) -> Pose:
    """Return the flange's pose, from the tool centre point's and the tool's on the flange."""
    return matrix_to_pose(flange_matrix(pose_to_matrix(tool_point), tool))


def to_base(pose: Sequence[float], frame: Sequence[float]) -> Pose:
    """Return a pose of a frame as one of the base.

    Args:
        pose: X, Y, Z in mm, RX, RY, RZ in degrees, in the frame.
        frame: The frame's own pose in the base, likewise.
    """
    return tool_pose(frame, pose)


def from_base(pose: Sequence[float], frame: Sequence[float]) -> Pose:
    """Return a pose of the base as one of a frame; see :func:`to_base`."""
    return matrix_to_pose(np.linalg.inv(pose_to_matrix(frame)) @ pose_to_matrix(pose))


def shifted(tool_point: Matrix, axis: int, amount: float, frame: JogAxes) -> Matrix:
    """Return a transform moved along, or turned about, one axis of a frame.

    Args:
        tool_point: 4×4 transform, lengths in mm.
        axis: 0–2 along X, Y, Z; 3–5 about them. It turns about its own origin.
        amount: In mm or degrees.
        frame: The frame whose axes count.
    """
    way = [amount if each == axis else 0.0 for each in range(6)]
    return moved(tool_point, way[:3], way[3:], frame)


def moved(
    tool_point: Matrix, way_mm: Sequence[float], turn_deg: Sequence[float], frame: JogAxes
) -> Matrix:
    """Return a transform moved along three axes of a frame, and turned about all three at once.

    Args:
        tool_point: 4×4 transform, lengths in mm.
        way_mm: The way along X, Y, Z.
        turn_deg: A rotation vector: its direction is the axis, its length the angle. It turns about
            its own origin.
        frame: The frame whose axes count.
    """
    own = tool_point[:3, :3]
    axes = frame
    if isinstance(axes, JogFrame):
        axes = own if axes is JogFrame.TOOL else np.eye(3)
    result: Matrix = tool_point.copy()
    result[:3, 3] += axes @ np.asarray(way_mm, dtype=np.float64)
    result[:3, :3] = axes @ rotation(turn_deg) @ axes.T @ own
    return result


def rotation(turn_deg: Sequence[float]) -> Matrix:
    """Return the 3×3 matrix of a rotation vector in degrees."""
    vector = np.radians(np.asarray(turn_deg, dtype=np.float64))
    angle = float(np.linalg.norm(vector))
    if angle < 1e-12:
        return np.eye(3)
    x, y, z = vector / angle
    cross = np.array(((0.0, -z, y), (z, 0.0, -x), (-y, x, 0.0)))
    result: Matrix = np.eye(3) + math.sin(angle) * cross + (1 - math.cos(angle)) * cross @ cross
    return result
