"""Forward and inverse kinematics of the flange, in the protocol's units.

The arm has two parallel axes and a spherical wrist, so the closed form of ortho-parallel
(OPW) arms fits it; the parameters below reproduce the maker's modified DH table
(firmware from S-V1.6-3 on; older firmware differs in two joint offsets).

Of py-opw-kinematics only the four ways to bring the wrist's centre to its place are used. Its
wrist angles come from an arc cosine, which rounding pushes beyond 1 when joint 5 is
exactly 0 (as in the arm's zero pose), and it then drops the branch. Here they are arc tangents,
which know no such gap. The forward direction is written out too: the library's is a few
microseconds, wrapped into some eighty of transform objects.
"""

from __future__ import annotations

import enum
import math
from collections.abc import Sequence
from typing import Final, NamedTuple

import numpy as np
import numpy.typing as npt
from py_opw_kinematics import KinematicModel, Robot
from scipy.spatial.transform import RigidTransform, Rotation

from armui.kinematics.wrist import STRETCHED_DEG, bend_deg, bent_wrist, stretched_wrist

Matrix = npt.NDArray[np.float64]
Joints = tuple[float, ...]
"""Six angles in degrees, joint 1 first."""


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


_FLIPPED_AXES: Final = (False, False, False, False, True, False)

BASE_MM: Final = 123.0
UPPER_ARM_MM: Final = 285.03
ELBOW_MM: Final = -21.98
FOREARM_MM: Final = 250.75
HAND_MM: Final = 91.0
"""From the centre of the wrist to the flange."""

_EDGE_MM: Final = 1e-6
"""A pose the arm itself has reported, stretched to its limit, may be this far out by rounding."""

_SAME_DEG: Final = 1e-6

MIDDLES_DEG: Final = (0.0, 90.0, -85.0)
"""The middles of the factory ranges of joints 1–3; the others' are 0."""

_HAND_TURNS: Final = tuple(Rotation.from_euler("y", angle).as_matrix() for angle in (0.1, -0.23))
"""See `Kinematics._ask_library`."""


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
    return _pose(matrix[:3].ravel().tolist())


def _pose(rows: Sequence[float]) -> Pose:
    """The pose of a transform's upper three rows."""
    xx, _, _, x, yx, yy, yz, y, zx, zy, zz, z = rows
    horizontal = math.hypot(xx, yx)
    ry = math.atan2(-zx, horizontal)
    if horizontal > 1e-9:
        rx, rz = math.atan2(zy, zz), math.atan2(yx, xx)
    else:
        rx, rz = math.atan2(-yz, yy), 0.0
    return Pose(x, y, z, math.degrees(rx), math.degrees(ry), math.degrees(rz))


class Kinematics:
    """The arm's kinematics for one geometry.

    Angles are those of the protocol in degrees, joint 1 first; lengths are mm.
    """

    def __init__(self, geometry: Geometry = Geometry.CURRENT) -> None:
        self.geometry = geometry
        self.shoulder_zero_deg = -90.0 - geometry.value[1]
        self.forearm_zero_deg = -geometry.value[1] - geometry.value[2]
        self._robot = Robot(
            KinematicModel(
                a1=0.0,
                a2=ELBOW_MM,
                b=0.0,
                c1=BASE_MM,
                c2=UPPER_ARM_MM,
                c3=FOREARM_MM,
                c4=HAND_MM,
                offsets=geometry.value,
                flip_axes=_FLIPPED_AXES,
            ),
            degrees=True,
        )

    def __reduce__(self) -> tuple[type[Kinematics], tuple[Geometry]]:
        """To another process goes what it is made from: the library's part cannot."""
        return Kinematics, (self.geometry,)

    def matrix(self, joints_deg: Sequence[float]) -> Matrix:
        """The flange's 4×4 transform in the base frame, lengths in mm."""
        return np.array((*self._flange(joints_deg), 0.0, 0.0, 0.0, 1.0)).reshape(4, 4)

    def forward(self, joints_deg: Sequence[float]) -> Pose:
        """The flange's pose at six joint angles."""
        return _pose(self._flange(joints_deg))

    def inverse(self, pose: Pose, near_deg: Sequence[float]) -> list[Joints]:
        """All ways to bring the flange to a pose, whatever the joints' limits.

        With a wrist stretched to 0.002° joint 4 stays where it is in `near_deg`: a pose rounded
        to the protocol's steps must not turn the wrist about. Angles lie within half a turn of
        the middle of their joint's range.

        Args:
            pose: Where the flange shall be.
            near_deg: Six angles; the solutions nearest to them come first.

        Returns:
            Up to eight solutions; none when the pose is out of reach.
        """
        if not all(map(math.isfinite, pose)):
            return []
        target = pose_to_matrix(pose)
        solutions: list[Joints] = []
        for arm_deg in self.arm_branches(target[None])[0]:
            if np.isnan(arm_deg[0]):
                continue
            shoulder_elbow = tuple(float(angle) for angle in arm_deg)
            for wrist_deg in self._wrists(arm_deg, target, near_deg[3]):
                solution = (*shoulder_elbow, *wrist_deg)
                if not any(_same(solution, other) for other in solutions):
                    solutions.append(solution)
        return sorted(solutions, key=lambda joints: math.dist(joints, near_deg))

    def missing_mm(self, pose: Pose) -> float:
        """How far the wrist's centre is out of the arm's reach for a pose; 0 within it."""
        _, extension_mm = self._ask_library(pose_to_matrix(pose)[None])
        return max(0.0, -float(extension_mm[0]))

    def arm_branches(self, targets: Matrix) -> Matrix:
        """Joints 1–3 of the ways to bring the wrist's centre where the targets want it.

        Args:
            targets: (n, 4, 4) transforms of the flange.

        Returns:
            (n, 4, 3) angles in degrees, NaN where a way does not exist. A way keeps its place
            along a continuous path: 2·(reaching back) + (elbow the other way round).
        """
        ways, extension_mm = self._ask_library(targets)
        edge = np.abs(extension_mm) < _EDGE_MM
        if edge.any():
            outward = _wrist_centres(targets) - (0.0, 0.0, BASE_MM)
            outward /= np.linalg.norm(outward, axis=1, keepdims=True)
            drawn_in = targets.copy()
            drawn_in[edge, :3, 3] -= 2.0 * _EDGE_MM * outward[edge]
            ways, _ = self._ask_library(drawn_in)
        return _near_middle(ways)

    def hands(self, arms_deg: Matrix, targets: Matrix) -> Matrix:
        """How the hand must lie in the forearm when joints 1–3 are known.

        Args:
            arms_deg: (n, 3) joints 1–3.
            targets: (n, 4, 4) transforms of the flange.

        Returns:
            (n, 3, 3) orientations, as `armui.kinematics.wrist` wants them.
        """
        turn = np.radians(arms_deg[:, 0])
        pitch = np.radians(arms_deg[:, 1] + arms_deg[:, 2] + self.forearm_zero_deg)
        forearm = np.zeros((len(arms_deg), 3, 3))
        forearm[:, 0, 0] = np.cos(turn) * np.cos(pitch)
        forearm[:, 0, 1] = -np.sin(turn)
        forearm[:, 0, 2] = np.cos(turn) * np.sin(pitch)
        forearm[:, 1, 0] = np.sin(turn) * np.cos(pitch)
        forearm[:, 1, 1] = np.cos(turn)
        forearm[:, 1, 2] = np.sin(turn) * np.sin(pitch)
        forearm[:, 2, 0] = -np.sin(pitch)
        forearm[:, 2, 2] = np.cos(pitch)
        return np.asarray(forearm.transpose(0, 2, 1) @ targets[:, :3, :3])

    def smallest_singular_value(self, joints_deg: Sequence[float]) -> float:
        """How far the arm is from a singular pose: 0 in one, some 0.1 in a comfortable one.

        Of the Jacobian in metres and radians a radian. Its inverse is the most a joint turns for
        1 m, or 1 rad, of the flange's way.
        """
        return float(np.linalg.svd(self.jacobian(joints_deg), compute_uv=False)[-1])

    def jacobian(self, joints_deg: Sequence[float]) -> Matrix:
        """How the flange moves with each joint.

        Returns:
            (6, 6): rows are its velocity in m/rad, then its angular velocity in rad/rad.
        """
        j1, j2, j3, j4, j5, _ = map(math.radians, joints_deg)
        s = j2 + math.radians(self.shoulder_zero_deg)
        e = j2 + j3 + math.radians(self.forearm_zero_deg)
        side = np.array((-math.sin(j1), math.cos(j1), 0.0))
        ahead = np.array((math.cos(j1), math.sin(j1), 0.0))
        up = np.array((0.0, 0.0, 1.0))
        forearm = math.sin(e) * ahead + math.cos(e) * up
        across = math.cos(e) * ahead - math.sin(e) * up
        shoulder = BASE_MM * up
        elbow = shoulder + UPPER_ARM_MM * (math.cos(s) * ahead - math.sin(s) * up)
        centre = elbow + ELBOW_MM * across + FOREARM_MM * forearm
        bend_axis = math.cos(j4) * side - math.sin(j4) * across
        swing = math.cos(j4) * across + math.sin(j4) * side
        hand = math.cos(j5) * forearm + math.sin(j5) * swing
        axes = np.array((up, side, side, forearm, bend_axis, hand))
        origins = np.array((shoulder, shoulder, elbow, centre, centre, centre))
        flange = centre + HAND_MM * hand
        return np.vstack((np.cross(axes, flange - origins).T / 1e3, axes.T))

    def _wrists(self, arm_deg: Matrix, target: Matrix, joint_4_deg: float) -> list[Joints]:
        hand = self.hands(arm_deg[None], target[None])
        if float(bend_deg(hand)[0]) < STRETCHED_DEG:
            j4, j5, j6 = stretched_wrist(hand[0], joint_4_deg)
            return [(j4, j5, wrapped_deg(j6))]
        return [
            tuple(wrapped_deg(float(angle)) for angle in wrist) for wrist in bent_wrist(hand)[0]
        ]

    def _ask_library(self, targets: Matrix) -> tuple[Matrix, Matrix]:
        """Joints 1–3 of four ways, (n, 4, 3), and how far within reach the centre is, (n,).

        Its branches of a stretched wrist are missing now and then, so it is asked twice, with the
        hand turned about the centre of the wrist: at most one of the two can be stretched.
        """
        centres = _wrist_centres(targets)
        turned = np.empty((len(_HAND_TURNS), *targets.shape))
        turned[:] = targets
        for copy, turn in zip(turned, _HAND_TURNS, strict=True):
            copy[:, :3, :3] = targets[:, :3, :3] @ turn
            copy[:, :3, 3] = centres + HAND_MM * copy[:, :3, 2]
        answer = self._robot.reach(RigidTransform.from_matrix(turned.reshape(-1, 4, 4)))
        ways = answer.joints[:, :, :3].reshape(len(_HAND_TURNS), len(targets), 2, 4, 3)
        return np.fmax.reduce(ways, axis=(0, 2)), answer.extension[: len(targets)]

    def _flange(self, joints_deg: Sequence[float]) -> tuple[float, ...]:
        """The upper three rows of the flange's transform.

        The arm's plane is turned by joint 1; in it the upper arm points along (cos s, −sin s)
        and the forearm along (sin e, cos e). The hand's orientation is Rz·Ry·Rz of joints 4–6.
        """
        j1, j2, j3, j4, j5, j6 = map(math.radians, joints_deg)
        s = j2 + math.radians(self.shoulder_zero_deg)
        e = j2 + j3 + math.radians(self.forearm_zero_deg)
        c1, s1, ce, se = math.cos(j1), math.sin(j1), math.cos(e), math.sin(e)
        c4, s4, c5, s5 = math.cos(j4), math.sin(j4), math.cos(j5), math.sin(j5)
        c6, s6 = math.cos(j6), math.sin(j6)
        # the columns of Rz(j4)·Ry(j5)·Rz(j6)
        ux, uy, uz = c4 * c5 * c6 - s4 * s6, s4 * c5 * c6 + c4 * s6, -s5 * c6
        vx, vy, vz = -c4 * c5 * s6 - s4 * c6, -s4 * c5 * s6 + c4 * c6, s5 * s6
        wx, wy, wz = c4 * s5, s4 * s5, c5
        # turned by Ry(e): its y stays
        ur, vr, wr = ce * ux + se * uz, ce * vx + se * vz, ce * wx + se * wz
        zx, zy, zz = ce * uz - se * ux, ce * vz - se * vx, ce * wz - se * wx
        radius = UPPER_ARM_MM * math.cos(s) + ELBOW_MM * ce + FOREARM_MM * se + HAND_MM * wr
        height = (
            BASE_MM - UPPER_ARM_MM * math.sin(s) - ELBOW_MM * se + FOREARM_MM * ce + HAND_MM * zz
        )
        aside = HAND_MM * wy
        # turned by Rz(j1)
        return (
            *(c1 * ur - s1 * uy, c1 * vr - s1 * vy, c1 * wr - s1 * wy, c1 * radius - s1 * aside),
            *(s1 * ur + c1 * uy, s1 * vr + c1 * vy, s1 * wr + c1 * wy, s1 * radius + c1 * aside),
            *(zx, zy, zz, height),
        )


def _wrist_centres(targets: Matrix) -> Matrix:
    centres: Matrix = targets[:, :3, 3] - HAND_MM * targets[:, :3, 2]
    return centres


def _near_middle(ways_deg: Matrix) -> Matrix:
    """The same angles of joints 1–3, in the turn around the middles of their ranges."""
    offset = 180.0 - np.array(MIDDLES_DEG)
    near: Matrix = (ways_deg + offset) % 360.0 - offset
    return near


def wrapped_deg(angle_deg: float) -> float:
    """The same angle within −180° to 180°."""
    return (angle_deg + 180.0) % 360.0 - 180.0


def _same(joints_deg: Joints, others_deg: Joints) -> bool:
    return all(abs(a - b) < _SAME_DEG for a, b in zip(joints_deg, others_deg, strict=True))
