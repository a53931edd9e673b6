"""Where each link of the arm is in the one before it, as ROS has it: metres and quaternions.

The frames are those of `urdf/piper.urdf`, from the maker's modified DH table: joint n turns about
the Z axis of link n.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from armui.kinematics.geometry import (
    BASE_MM,
    ELBOW_MM,
    FOREARM_MM,
    HAND_MM,
    UPPER_ARM_MM,
    Geometry,
)

if TYPE_CHECKING:
    from numpy.typing import NDArray

BASE: Final = "base_link"
FLANGE: Final = "flange"
LINKS: Final = tuple(f"link{joint}" for joint in range(1, 7))
"""What each joint turns."""
JOINT_NAMES: Final = tuple(f"joint{joint}" for joint in range(1, 7))
FINGERS: Final = ("finger_left", "finger_right")
FINGER_JOINTS: Final = ("gripper_left", "gripper_right")
GRIPPER_BASE: Final = "gripper_base"
_MM_PER_M: Final = 1000.0

_TURNS_DEG: Final = (0.0, -90.0, 0.0, 90.0, -90.0, 90.0)
"""About the X axis of the link before, from it to the joint's axis."""
_ALONG_X_MM: Final = (0.0, 0.0, UPPER_ARM_MM, ELBOW_MM, 0.0, 0.0)
_ALONG_Z_MM: Final = (BASE_MM, 0.0, 0.0, FOREARM_MM, 0.0, HAND_MM)


def link_transforms(geometry: Geometry, joints_deg: NDArray[np.float64]) -> NDArray[np.float64]:
    """(n, 6, 7): for each link x, y, z in m and the quaternion x, y, z, w in the link before.

    Args:
        geometry: Where the joints have their zeros.
        joints_deg: (n, 6) joint angles.
    """
    zeros = np.array((0.0, *geometry.value, 0.0, 0.0, 0.0))
    half = np.radians(joints_deg + zeros) / 2.0
    turned = np.radians(_TURNS_DEG) / 2.0
    cos_x, sin_x = np.cos(turned), np.sin(turned)
    cos_z, sin_z = np.cos(half), np.sin(half)
    along_z = np.array(_ALONG_Z_MM) / _MM_PER_M
    result = np.empty((*joints_deg.shape, 7))
    result[..., 0] = np.array(_ALONG_X_MM) / _MM_PER_M
    result[..., 1] = -along_z * np.sin(2.0 * turned)
    result[..., 2] = along_z * np.cos(2.0 * turned)
    result[..., 3] = sin_x * cos_z
    result[..., 4] = -sin_x * sin_z
    result[..., 5] = cos_x * sin_z
    result[..., 6] = cos_x * cos_z
    return result


def finger_transforms(openings_mm: NDArray[np.float64]) -> NDArray[np.float64]:
    """(n, 2, 7): the fingers in the gripper's base, each half of the opening from its middle."""
    result = np.zeros((len(openings_mm), 2, 7))
    result[:, 0, 1] = openings_mm / 2.0 / _MM_PER_M
    result[:, 1, 1] = -result[:, 0, 1]
    result[..., 6] = 1.0
    return result


def pose_figures(poses: NDArray[np.float64]) -> NDArray[np.float64]:
    """(n, 7): x, y, z in m and the quaternion of (n, 6) poses in mm and degrees, R = Rz·Ry·Rx."""
    half = np.radians(poses[:, 3:]) / 2.0
    (cx, cy, cz), (sx, sy, sz) = np.cos(half).T, np.sin(half).T
    result = np.empty((len(poses), 7))
    result[:, :3] = poses[:, :3] / _MM_PER_M
    result[:, 3] = sx * cy * cz - cx * sy * sz
    result[:, 4] = cx * sy * cz + sx * cy * sz
    result[:, 5] = cx * cy * sz - sx * sy * cz
    result[:, 6] = cx * cy * cz + sx * sy * sz
    return result
