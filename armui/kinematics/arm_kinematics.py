"""The kinematics of one arm for single poses, in the protocol's units."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from armui.kinematics.forward import flange_rows
from armui.kinematics.geometry import Geometry
from armui.kinematics.inverse import missing_mm, nearest_first
from armui.kinematics.poses import Joints, Matrix, Pose, pose_to_matrix, rows_to_pose


@dataclass(frozen=True, slots=True)
class Kinematics:
    """An arm's kinematics: angles in degrees, joint 1 first; lengths in mm.

    Attributes:
        geometry: Its dimensions.
    """

    geometry: Geometry

    def matrix(self, joints_deg: Sequence[float]) -> Matrix:
        """Return the flange's 4×4 transform in the base frame."""
        return np.array((*flange_rows(self.geometry, joints_deg), 0.0, 0.0, 0.0, 1.0)).reshape(4, 4)

    def forward(self, joints_deg: Sequence[float]) -> Pose:
        """Return the flange's pose at six joint angles."""
        return rows_to_pose(flange_rows(self.geometry, joints_deg))

    def inverse(self, pose: Pose, near_deg: Sequence[float]) -> list[Joints]:
        """Return all solutions that bring the flange to a pose, whatever the joints' limits.

        Angles lie within half a turn of the middle of their joint's range. If a singular pose of
        the wrist leaves a joint free, the joint keeps its angle in `near_deg`.

        Args:
            pose: The wanted pose of the flange.
            near_deg: Six angles; the solutions nearest to them come first.

        Returns:
            Up to eight solutions; none when the pose is out of reach.
        """
        if not all(map(math.isfinite, pose)):
            return []
        return nearest_first(self.geometry, pose_to_matrix(pose), near_deg)

    def missing_mm(self, pose: Pose) -> float:
        """Return by how many mm the end of the forearm misses a pose; 0 within its reach."""
        return missing_mm(self.geometry, pose_to_matrix(pose))
