"""Where the tool goes: straight lines and arcs of the flange, and the joints that lead it there.

Geometry without time; the simulated arm moves by it, and the host checks by it before it sends.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final, Protocol

import numpy as np
import numpy.typing as npt
from scipy.spatial.transform import Rotation, RotationSpline, Slerp

from armui.kinematics.kinematics import Kinematics, Matrix, wrapped_deg
from armui.kinematics.wrist import STRETCHED_DEG, bend_deg, bent_wrist, stretched_wrist

_SMALLEST_TRIANGLE: Final = 1e-4
"""Sine of the angle at an arc's start under which its three points lie on a line."""

Shares = npt.NDArray[np.float64]
"""(n,) parts of the way, 0 at the start and 1 at the end."""


class ToolPath(Protocol):
    """A way of the flange.

    Attributes:
        length_mm: Of the way.
        angle_deg: How much the hand turns on it.
    """

    length_mm: float
    angle_deg: float

    def poses(self, shares: Shares) -> Matrix:
        """(n, 4, 4) transforms at parts of the way."""
        ...


class ArcError(ValueError):
    """Three points that lie on no circle."""


class Line:
    """Straight, with the hand turning evenly about one axis."""

    def __init__(self, start: Matrix, end: Matrix) -> None:
        self._start_mm = start[:3, 3]
        self._way_mm = end[:3, 3] - start[:3, 3]
        ends = Rotation.from_matrix(np.stack((start[:3, :3], end[:3, :3])))
        self._turn = Slerp((0.0, 1.0), ends)
        self.length_mm = float(np.linalg.norm(self._way_mm))
        self.angle_deg = math.degrees((ends[0].inv() * ends[1]).magnitude())

    def poses(self, shares: Shares) -> Matrix:
        """(n, 4, 4) transforms at parts of the way."""
        places = self._start_mm + shares[:, None] * self._way_mm
        return _transforms(places, self._turn(shares))


class Arc:
    """The circle through three points, from the first over the second to the third.

    The hand turns smoothly through its three orientations.

    Raises:
        ArcError: The points lie on a line or upon one another.
    """

    def __init__(self, start: Matrix, middle: Matrix, end: Matrix) -> None:
        first, second, third = (pose[:3, 3] for pose in (start, middle, end))
        over, across = second - first, third - first
        normal = np.cross(over, across)
        if np.linalg.norm(normal) <= _SMALLEST_TRIANGLE * float(
            np.linalg.norm(over) * np.linalg.norm(across)
        ):
            raise ArcError("three points on a line, or two in one place, make no arc")
        normal /= np.linalg.norm(normal)
        self._centre_mm = first + _to_centre(over, across)
        self._ahead = first - self._centre_mm
        self._aside = np.cross(normal, self._ahead)
        self._angle_rad = self._angle_to(third)
        middle_share = self._angle_to(second) / self._angle_rad
        self.length_mm = float(np.linalg.norm(self._ahead)) * self._angle_rad
        turns = Rotation.from_matrix(np.stack([pose[:3, :3] for pose in (start, middle, end)]))
        self._turn = RotationSpline((0.0, middle_share, 1.0), turns)
        legs = (turns[0].inv() * turns[1], turns[1].inv() * turns[2])
        self.angle_deg = math.degrees(sum(float(leg.magnitude()) for leg in legs))

    def poses(self, shares: Shares) -> Matrix:
        """(n, 4, 4) transforms at parts of the way."""
        angles = (shares * self._angle_rad)[:, None]
        places = self._centre_mm + np.cos(angles) * self._ahead + np.sin(angles) * self._aside
        return _transforms(places, self._turn(shares))

    def _angle_to(self, point_mm: Matrix) -> float:
        """The angle from the start, in the sense in which the middle comes before the end."""
        spoke = point_mm - self._centre_mm
        angle = math.atan2(float(spoke @ self._aside), float(spoke @ self._ahead))
        return angle % (2.0 * math.pi)


def follow(kinematics: Kinematics, targets: Matrix, start_deg: Sequence[float]) -> Matrix:
    """Joints along a path, on the branch where the arm stands.

    Args:
        kinematics: Of the arm.
        targets: (n, 4, 4) transforms of the flange, the first of them where it is.
        start_deg: Six joint angles there.

    Returns:
        (n, 6) angles in degrees, NaN from where the branch ends.
    """
    ways = kinematics.arm_branches(targets)
    gaps = np.abs(ways[0] - np.asarray(start_deg[:3])).max(axis=1)
    arms = ways[:, int(np.argmin(np.where(np.isnan(gaps), math.inf, gaps)))]
    joints = np.full((len(targets), len(start_deg)), math.nan)
    missing = np.isnan(arms[:, 0])
    count = int(np.argmax(missing)) if missing.any() else len(targets)
    joints[:count, :3] = arms[:count]
    hands = kinematics.hands(arms[:count], targets[:count])
    stretched = bend_deg(hands) < STRETCHED_DEG
    joints[0] = start_deg
    last: Sequence[float] = tuple(start_deg[3:])
    for index, wrists in enumerate(bent_wrist(hands).tolist()):
        if stretched[index]:
            wrists = [stretched_wrist(hands[index], last[0])]  # noqa: PLW2901 - the same thing
        near = [
            [
                before + wrapped_deg(angle - before)
                for angle, before in zip(wrist, last, strict=True)
            ]
            for wrist in wrists
        ]
        last = min(near, key=lambda wrist: math.dist(wrist, last))
        if index:
            joints[index, 3:] = last
    return joints


def _to_centre(over: Matrix, across: Matrix) -> Matrix:
    """From one corner of a triangle to the centre of its circle; the sides start there."""
    normal = np.cross(over, across)
    weighted = float(over @ over) * across - float(across @ across) * over
    centre: Matrix = -np.cross(normal, weighted) / (2.0 * float(normal @ normal))
    return centre


def _transforms(places_mm: Matrix, turns: Rotation) -> Matrix:
    transforms = np.zeros((len(places_mm), 4, 4))
    transforms[:, :3, :3] = turns.as_matrix()
    transforms[:, :3, 3] = places_mm
    transforms[:, 3, 3] = 1.0
    return transforms
