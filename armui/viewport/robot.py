"""A six-joint arm as a URDF file describes it, and where its links are.

Pure data and numpy: nothing is drawn here, and nothing is imported that would slow the program's
start. Lengths are metres and angles radians as in URDF; the joint angles handed in are the arm's
own, in degrees, and the gripper opening in millimetres.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

Matrix = NDArray[np.float64]
Rgb = tuple[float, float, float]

ARM_JOINT_COUNT = 6
HINGES = frozenset({"revolute", "continuous"})


@dataclass(frozen=True)
class Visual:
    """One picture of a link: a mesh file or a simple solid.

    Attributes:
        kind: "mesh", "box", "cylinder" or "sphere".
        size: scale factors of a mesh; edges of a box, (radius, length) or (radius,) in metres.
        mesh: the file of a mesh, else None.
        pose: 4×4 in the frame of the link, metres.
        color: red, green, blue in 0–1, or None when the file names none.
    """

    kind: str
    size: tuple[float, ...]
    mesh: Path | None
    pose: Matrix
    color: Rgb | None


@dataclass(frozen=True)
class Mimic:
    """A joint that follows another one: value = multiplier · leader + offset."""

    leader: str
    multiplier: float
    offset: float


@dataclass(frozen=True)
class Joint:
    """One joint; `lower` and `upper` are radians (hinges) or metres (sliders)."""

    name: str
    kind: str
    parent: str
    child: str
    origin: Matrix
    axis: NDArray[np.float64]
    lower: float
    upper: float
    mimic: Mimic | None

    def pose(self, value: float) -> Matrix:
        """4×4 pose of the child in the parent's frame at a joint value (rad or m)."""
        if self.kind in HINGES:
            return self.origin @ rotation_about(self.axis, value)
        if self.kind == "prismatic":
            shift = np.eye(4)
            shift[:3, 3] = self.axis * value
            return self.origin @ shift
        return self.origin

    def opened(self, travel_m: float) -> float:
        """Value of a slider this far from its closed end (zero), but within its limit."""
        if abs(self.lower) > abs(self.upper):
            return -min(travel_m, -self.lower)
        return min(travel_m, self.upper)


@dataclass(frozen=True)
class Robot:
    """Links and joints of one arm.

    Attributes:
        path: the file it came from.
        root: name of the link everything stands on.
        visuals: the pictures of each link.
        joints: every joint, parents before children, leaders before those that mimic them.
        arm_joints: names of the six hinges of the arm, base first.
        joint_number_of_link: by link name, the number (1–6) of the arm joint that moves it last;
            the links before joint 1 are absent.
    """

    path: Path
    root: str
    visuals: dict[str, tuple[Visual, ...]]
    joints: tuple[Joint, ...]
    arm_joints: tuple[str, ...]
    joint_number_of_link: dict[str, int]

    def link_poses(self, angles_deg: Sequence[float], opening_mm: float) -> dict[str, Matrix]:
        """Poses of all links in the root's frame.

        Args:
            angles_deg: six joint angles as on the bus, joint 1 first.
            opening_mm: distance between the fingers; each finger travels half of it.

        Returns:
            4×4 matrices in metres, by link name.
        """
        values = {
            name: math.radians(angle_deg)
            for name, angle_deg in zip(self.arm_joints, angles_deg, strict=True)
        }
        poses = {self.root: np.eye(4)}
        for joint in self.joints:
            if joint.name not in values:
                values[joint.name] = _follower_value(joint, values, opening_mm)
            poses[joint.child] = poses[joint.parent] @ joint.pose(values[joint.name])
        return poses


def _follower_value(joint: Joint, values: dict[str, float], opening_mm: float) -> float:
    """Value of a joint that is none of the arm's six."""
    if joint.mimic is not None:
        return joint.mimic.multiplier * values[joint.mimic.leader] + joint.mimic.offset
    if joint.kind == "prismatic":
        return joint.opened(opening_mm / 2000.0)
    return 0.0


def rotation_about(axis: NDArray[np.float64], angle_rad: float) -> Matrix:
    """4×4 rotation about a unit axis (Rodrigues)."""
    x, y, z = axis
    c, s = math.cos(angle_rad), math.sin(angle_rad)
    t = 1.0 - c
    return np.array(
        [
            [t * x * x + c, t * x * y - s * z, t * x * z + s * y, 0.0],
            [t * x * y + s * z, t * y * y + c, t * y * z - s * x, 0.0],
            [t * x * z - s * y, t * y * z + s * x, t * z * z + c, 0.0],
            [0.0, 0.0, 0.0, 1.0],
        ]
    )


def pose_from_xyz_rpy(xyz_m: Sequence[float], rpy_rad: Sequence[float]) -> Matrix:
    """4×4 pose of a URDF <origin>: Rz(yaw)·Ry(pitch)·Rx(roll), then the shift."""
    roll, pitch, yaw = rpy_rad
    x_axis, y_axis, z_axis = np.eye(3)
    pose = (
        rotation_about(z_axis, yaw) @ rotation_about(y_axis, pitch) @ rotation_about(x_axis, roll)
    )
    pose[:3, 3] = xyz_m
    return pose
