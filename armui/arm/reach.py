"""Checks whether the flange can reach a pose or follow a path; they return the reason if not."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final

import numpy as np

from armui.arm.limits import JointLimits, check_joints
from armui.arm.refusal import Reason, Refusal
from armui.kinematics.arm_kinematics import Kinematics
from armui.kinematics.follow import follow
from armui.kinematics.poses import Joints, Matrix, Pose, matrix_to_pose
from armui.kinematics.singularity import fine_steps, leaps
from armui.kinematics.tool_path import ToolPath

POSE_OUT_OF_REACH = Reason(
    "pose_out_of_reach",
    "The target is {missing} mm out of the arm's reach. Choose one nearer to the arm, or "
    "turn the tool.",
)
POSE_BEYOND_LIMITS = Reason(
    "pose_beyond_limits",
    "At the target joint {joint} would stand at {value}°, beyond its limits of {minimum}° to "
    "{maximum}°. Choose another position or turn the tool.",
)
PATH_OUT_OF_REACH = Reason(
    "path_out_of_reach",
    "After {gone} % of the way the arm reaches no further. Choose MOVE P, or another target.",
)
PATH_SINGULAR = Reason(
    "path_singular",
    "After {gone} % of the way the arm comes to a singular pose: joint {joint} would have to "
    "jump. Choose MOVE P, or move joint 5 away from 0° first.",
)


_FINE_STEPS: Final = 2.0
"""The fine steps between two places that are checked."""
_FEWEST_STEPS: Final = 8
_LONGEST_MM: Final = 10_000.0
"""Longer than any line or arc within the reach of an arm: its places are not worth counting."""


def check_pose(
    kinematics: Kinematics, pose: Pose, near_deg: Sequence[float], limits: Sequence[JointLimits]
) -> Joints | Refusal:
    """Return the joint angles that bring the flange to a pose, or why there are none.

    Args:
        kinematics: The arm's kinematics.
        pose: The wanted pose of the flange.
        near_deg: The present joint angles.
        limits: The limits of the six joints.

    Returns:
        The six angles nearest to ``near_deg``, or the reason why there are none.
    """
    solutions = kinematics.inverse(pose, near_deg)
    if not solutions:
        return POSE_OUT_OF_REACH(missing=round(kinematics.missing_mm(pose), 1))
    problems = [check_joints(solution, limits) for solution in solutions]
    for solution, problem in zip(solutions, problems, strict=True):
        if problem is None:
            return solution
    return POSE_BEYOND_LIMITS(**(problems[0].params if problems[0] else {}))


def led_joints(
    kinematics: Kinematics, path: ToolPath, start_deg: Sequence[float]
) -> Matrix | Refusal:
    """Return (n, 6) the joint angles along a path, or why the arm cannot follow it.

    Args:
        kinematics: The arm's kinematics.
        path: The path; it begins at the flange.
        start_deg: The present joint angles.
    """
    if not path.length_mm <= _LONGEST_MM:
        return PATH_OUT_OF_REACH(gone=0)
    joints: Matrix = follow(kinematics.geometry, places(path)[None], np.array([start_deg]))[0]
    singular = leaps(joints, _FINE_STEPS)
    for index in range(1, len(joints)):
        gone_percent = round(100.0 * index / (len(joints) - 1))
        here = joints[index]
        if np.isnan(here[0]):
            end = matrix_to_pose(path.poses(np.array([1.0]))[0])
            missing_mm = round(kinematics.missing_mm(end), 1)  # then no other way leads there
            if missing_mm > 0.0:
                return POSE_OUT_OF_REACH(missing=missing_mm)
            return PATH_OUT_OF_REACH(gone=gone_percent)
        if singular[index - 1]:
            joint = int(np.argmax(np.abs(here - joints[index - 1]))) + 1
            return PATH_SINGULAR(joint=joint, gone=gone_percent)
    return joints


def places(path: ToolPath) -> Matrix:
    """Return (n, 4, 4) transforms along a path, no further apart than 2 mm or 0.5°."""
    steps = max(fine_steps(path.length_mm, path.angle_deg) / _FINE_STEPS, _FEWEST_STEPS)
    return path.poses(np.linspace(0.0, 1.0, math.ceil(steps) + 1))
