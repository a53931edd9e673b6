"""The points of a trajectory that has not been checked: marks without a way between them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from armui.kinematics.forward import flange_transforms
from armui.kinematics.poses import pose_to_matrix
from armui.viewport.path_picture import PathPicture

if TYPE_CHECKING:
    from collections.abc import Sequence

    from armui.arm.model import ArmModel
    from armui.trajectory.points.program import Waypoint

MOST_POINTS: Final = 3000
"""A few milliseconds in the window's thread; of longer ones a check shows the points."""


def marks_of(points: Sequence[Waypoint], arm: ArmModel) -> PathPicture | None:
    """Where the tip of the tool is at each point; None for more than `MOST_POINTS`, and none."""
    if not 0 < len(points) <= MOST_POINTS:
        return None
    targets = np.array([point.target for point in points], dtype=np.float64)
    joint = np.array([point.is_joint for point in points])
    flanges = np.empty((len(points), 4, 4))
    flanges[joint] = flange_transforms(arm.kinematics.geometry, targets[joint])
    flanges[~joint] = pose_to_matrix(targets[~joint])
    tips = flanges[:, :3, 3] + arm.tool_mm * flanges[:, :3, 2]
    nothing = np.empty((0, 3))
    return PathPicture(nothing, np.empty(0), tips, tuple(range(len(points))))
