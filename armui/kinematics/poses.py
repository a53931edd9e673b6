"""Poses put together: the tool centre point on the flange, and steps along the axes of a frame."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import numpy as np
from scipy.spatial.transform import Rotation

from armui.kinematics.axes import LINEAR_AXES, JogFrame
from armui.kinematics.kinematics import Matrix, Pose, matrix_to_pose, pose_to_matrix

NO_TOOL: Final = Pose(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
"""The tool centre point is the flange's."""


def tool_matrix(flange: Matrix, tool: Sequence[float]) -> Matrix:
    """The 4×4 transform of the tool centre point of a tool mounted on the flange."""
    result: Matrix = flange @ pose_to_matrix(Pose(*tool))
    return result


def flange_matrix(tool_point: Matrix, tool: Sequence[float]) -> Matrix:
    """Where the flange must be for a tool centre point to be somewhere."""
    result: Matrix = tool_point @ np.linalg.inv(pose_to_matrix(Pose(*tool)))
    return result


def tool_pose(flange: Sequence[float], tool: Sequence[float]) -> Pose:
    """The pose of the tool centre point, from the flange's and the tool's in it (mm, degrees)."""
    return matrix_to_pose(tool_matrix(pose_to_matrix(Pose(*flange)), tool))


def flange_pose(tool_point: Sequence[float], tool: Sequence[float]) -> Pose:
    """The flange's pose, from that of the tool centre point and the tool's in the flange."""
    return matrix_to_pose(flange_matrix(pose_to_matrix(Pose(*tool_point)), tool))


def shifted(tool_point: Matrix, axis: int, amount: float, frame: JogFrame) -> Matrix:
    """A transform moved along, or turned about, one axis of a frame.

    Args:
        tool_point: 4×4 transform, lengths in mm.
        axis: 0–2 along X, Y, Z; 3–5 about them. The point about which it turns is its own origin.
        amount: In mm or degrees.
        frame: Whose axes.
    """
    step = np.eye(4)
    if axis < LINEAR_AXES:
        step[axis, 3] = amount
    else:
        step[:3, :3] = Rotation.from_euler(
            "xyz"[axis - LINEAR_AXES], amount, degrees=True
        ).as_matrix()
    if frame is JogFrame.TOOL:
        moved: Matrix = tool_point @ step
        return moved
    moved = tool_point.copy()
    moved[:3, 3] += step[:3, 3]
    moved[:3, :3] = step[:3, :3] @ tool_point[:3, :3]
    return moved
