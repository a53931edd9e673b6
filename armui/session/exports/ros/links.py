"""Where each link of the arm is in the one before it, as ROS has it: metres and quaternions.

The frames are those of the robot descriptions in `urdf/`, from the maker's modified DH tables:
joint n turns about the Z axis of link n.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from armui.kinematics.geometry import Geometry

BASE: Final = "base_link"
FLANGE: Final = "flange"
LINKS: Final = tuple(f"link{joint}" for joint in range(1, 7))
"""What each joint turns."""
JOINT_NAMES: Final = tuple(f"joint{joint}" for joint in range(1, 7))
FINGERS: Final = ("finger_left", "finger_right")
FINGER_JOINTS: Final = ("gripper_left", "gripper_right")
GRIPPER_BASE: Final = "gripper_base"
_MM_PER_M: Final = 1000.0


def link_transforms(geometry: Geometry, joints_deg: NDArray[np.float64]) -> NDArray[np.float64]:
    """(n, 6, 7): for each link x, y, z in m and the quaternion x, y, z, w in the link before.

    Args:
        geometry: Of the arm.
        joints_deg: (n, 6) joint angles.
    """
    along_x, turns_deg, along_z, zeros_deg = np.array(geometry.rows).T
    half = np.radians(joints_deg + zeros_deg) / 2.0
    turned = np.radians(turns_deg) / 2.0
    cos_x, sin_x = np.cos(turned), np.sin(turned)
    cos_z, sin_z = np.cos(half), np.sin(half)
    along_z = along_z / _MM_PER_M
    result = np.empty((*joints_deg.shape, 7))
    result[..., 0] = along_x / _MM_PER_M
    result[..., 1] = -along_z * np.sin(2.0 * turned)
    result[..., 2] = along_z * np.cos(2.0 * turned)
    result[..., 3] = sin_x * cos_z
    result[..., 4] = -sin_x * sin_z
    result[..., 5] = cos_x * sin_z
    result[..., 6] = cos_x * cos_z
    return result


def mounted_transforms(gripper_turned_deg: float) -> NDArray[np.float64]:
    """(1, 2, 7): the flange in link 6, and the gripper in the flange, turned about its Z axis."""
    result = np.zeros((1, 2, 7))
    result[..., 6] = 1.0
    half_rad = np.radians(gripper_turned_deg) / 2.0
    result[0, 1, 5:] = np.sin(half_rad), np.cos(half_rad)
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
