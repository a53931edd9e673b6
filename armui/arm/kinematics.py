"""Forward kinematics of the flange, in the protocol's units.

The arm has two parallel axes and a spherical wrist, so the closed form of ortho-parallel
(OPW) arms fits it; the parameters below reproduce the maker's modified DH table
(firmware from S-V1.6-3 on; older firmware differs in two joint offsets).
"""

from __future__ import annotations

import enum
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import numpy.typing as npt
from py_opw_kinematics import KinematicModel, Robot
from scipy.spatial.transform import Rotation

Matrix = npt.NDArray[np.float64]


class Pose(NamedTuple):
    """Position and orientation of the flange in the base frame.

    R = Rz(rz)·Ry(ry)·Rx(rx), as the end pose feedback 0x2A2–0x2A4 has it.
    """

    x_mm: float
    y_mm: float
    z_mm: float
    rx_deg: float
    ry_deg: float
    rz_deg: float


class Geometry(enum.Enum):
    """Where joints 2 and 3 have their zero; the values are OPW offsets in degrees."""

    CURRENT = (0.0, 82.22, 192.78, 180.0, 0.0, 180.0)
    """Firmware from S-V1.6-3 on."""
    BEFORE_V1_6_3 = (0.0, 84.22, 190.78, 180.0, 0.0, 180.0)
    """Older firmware: joint 2 turned by −2°, joint 3 by +2°."""


_FLIPPED_AXES = (False, False, False, False, True, False)


def pose_to_matrix(pose: Pose) -> Matrix:
    """The 4×4 homogeneous transform of a pose, lengths in mm."""
    matrix = np.eye(4)
    matrix[:3, :3] = Rotation.from_euler(
        "xyz", (pose.rx_deg, pose.ry_deg, pose.rz_deg), degrees=True
    ).as_matrix()
    matrix[:3, 3] = pose[:3]
    return matrix


def matrix_to_pose(matrix: Matrix) -> Pose:
    """The pose of a 4×4 homogeneous transform, lengths in mm; at RY = ±90° RZ is taken as 0."""
    r = matrix[:3, :3]
    horizontal = float(np.hypot(r[0, 0], r[1, 0]))
    ry = np.arctan2(-r[2, 0], horizontal)
    if horizontal > 1e-9:
        rx, rz = np.arctan2(r[2, 1], r[2, 2]), np.arctan2(r[1, 0], r[0, 0])
    else:
        rx, rz = np.arctan2(-r[1, 2], r[1, 1]), 0.0
    x, y, z = (float(v) for v in matrix[:3, 3])
    return Pose(x, y, z, *(float(v) for v in np.degrees((rx, ry, rz))))


class Kinematics:
    """The arm's kinematics for one geometry.

    Angles are those of the protocol in degrees, joint 1 first; lengths are mm.
    """

    def __init__(self, geometry: Geometry = Geometry.CURRENT) -> None:
        self.geometry = geometry
        self._robot = Robot(
            KinematicModel(
                a1=0.0,
                a2=-21.98,
                b=0.0,
                c1=123.0,
                c2=285.03,
                c3=250.75,
                c4=91.0,
                offsets=geometry.value,
                flip_axes=_FLIPPED_AXES,
            ),
            degrees=True,
        )

    def matrix(self, joints_deg: Sequence[float]) -> Matrix:
        """The flange's 4×4 transform in the base frame, lengths in mm."""
        j1, j2, j3, j4, j5, j6 = joints_deg
        return np.asarray(self._robot.forward((j1, j2, j3, j4, j5, j6)).as_matrix())

    def forward(self, joints_deg: Sequence[float]) -> Pose:
        """The flange's pose at six joint angles."""
        return matrix_to_pose(self.matrix(joints_deg))
