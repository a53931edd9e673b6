"""Whether the flange can go somewhere, and the whole way there: checks that answer in words."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final

import numpy as np

from armui.arm.limits import JointLimits, check_joints
from armui.arm.refusal import Refusal
from armui.kinematics.kinematics import Joints, Kinematics, Matrix, Pose, pose_to_matrix
from armui.kinematics.tool_path import ToolPath, follow

_STEP_MM: Final = 2.0
_STEP_DEG: Final = 0.5
_FEWEST_STEPS: Final = 8
_STEEPEST_DEG: Final = 10.0
"""A joint that turns further from one place of a path to the next is at a singular pose."""


def check_pose(
    kinematics: Kinematics, pose: Pose, near_deg: Sequence[float], limits: Sequence[JointLimits]
) -> Joints | Refusal:
    """Whether the flange can be brought to a pose.

    Args:
        kinematics: Of the arm.
        pose: Where the flange shall be.
        near_deg: Where the joints are.
        limits: Of the six joints.

    Returns:
        The six angles nearest to ``near_deg`` that do it, or why there are none.
    """
    solutions = kinematics.inverse(pose, near_deg)
    if not solutions:
        return Refusal("pose_out_of_reach", {"missing": round(kinematics.missing_mm(pose), 1)})
    troubles = [check_joints(solution, limits) for solution in solutions]
    for solution, trouble in zip(solutions, troubles, strict=True):
        if trouble is None:
            return solution
    return Refusal("pose_beyond_limits", troubles[0].params if troubles[0] else {})


def check_path(
    kinematics: Kinematics,
    path: ToolPath,
    start_deg: Sequence[float],
    limits: Sequence[JointLimits],
) -> Refusal | None:
    """Whether the arm can go along a path from where its joints stand: ``None``, or why not.

    Args:
        kinematics: Of the arm.
        path: Begins where the flange is.
        start_deg: Where the joints are.
        limits: Of the six joints.
    """
    joints = follow(kinematics, places(path), start_deg)
    for index in range(1, len(joints)):
        gone_percent = round(100.0 * index / (len(joints) - 1))
        here, before = joints[index], joints[index - 1]
        if np.isnan(here[0]):
            return Refusal("path_out_of_reach", {"gone": gone_percent})
        steps = np.abs(here - before)
        if steps.max() > _STEEPEST_DEG:
            joint = int(np.argmax(steps)) + 1
            return Refusal("path_singular", {"joint": joint, "gone": gone_percent})
        beyond = check_joints(here.tolist(), limits)
        if beyond is not None:
            return Refusal("path_beyond_limits", {**beyond.params, "gone": gone_percent})
    return None


def places(path: ToolPath) -> Matrix:
    """(n, 4, 4) transforms along a path, no further apart than 2 mm or 0.5°."""
    steps = max(path.length_mm / _STEP_MM, path.angle_deg / _STEP_DEG, _FEWEST_STEPS)
    return path.poses(np.linspace(0.0, 1.0, math.ceil(steps) + 1))


def apart(one: Pose, other: Pose) -> tuple[float, float]:
    """How far two poses are from one another, in mm, and turned against one another, in degrees."""
    first, second = pose_to_matrix(one), pose_to_matrix(other)
    cosine = (float(np.trace(first[:3, :3].T @ second[:3, :3])) - 1.0) / 2.0
    turned_deg = math.degrees(math.acos(min(1.0, max(-1.0, cosine))))
    return math.dist(one[:3], other[:3]), turned_deg
