"""Paths of the tool: straight lines and arcs of the flange.

These are geometry without time; the simulated arm moves along them, and the host checks them before
it sends.
"""

from __future__ import annotations

import math
from typing import Final, Protocol

import numpy as np
import numpy.typing as npt
from scipy.spatial.transform import Rotation, RotationSpline

from armui.kinematics.poses import Matrix

_SMALLEST_TRIANGLE: Final = 1e-4
"""The sine of the angle at an arc's start below which its three points count as a line."""

Shares = npt.NDArray[np.float64]
"""(n,) parts of the path, 0 at the start and 1 at the end."""


class ToolPath(Protocol):
    """A path of the flange.

    Attributes:
        length_mm: The length of the path.
        angle_deg: The angle by which the hand turns on it.
    """

    length_mm: float
    angle_deg: float

    def poses(self, shares: Shares) -> Matrix:
        """Return (n, 4, 4) transforms at parts of the path."""
        ...


class ArcError(ValueError):
    """Three points that lie on no circle."""


class Line:
    """A straight line, with the hand turning evenly about one axis."""

    def __init__(self, start: Matrix, end: Matrix) -> None:
        self._lines = StraightLines(start[None], end[None])
        self.length_mm = float(self._lines.lengths_mm[0])
        self.angle_deg = float(self._lines.angles_deg[0])

    def poses(self, shares: Shares) -> Matrix:
        """Return (n, 4, 4) transforms at parts of the path."""
        poses: Matrix = self._lines.poses(shares)[0]
        return poses


class StraightLines:
    """Many straight lines at once.

    Attributes:
        lengths_mm, angles_deg: (m,) lengths of the paths, and turns of the hand.
    """

    def __init__(self, starts: Matrix, ends: Matrix) -> None:
        self._starts = starts
        self._ways_mm = ends[:, :3, 3] - starts[:, :3, 3]
        first, last = (Rotation.from_matrix(poses[:, :3, :3]) for poses in (starts, ends))
        self._turns_rad = (first.inv() * last).as_rotvec()
        self.lengths_mm: Matrix = np.linalg.norm(self._ways_mm, axis=1)
        self.angles_deg: Matrix = np.degrees(np.linalg.norm(self._turns_rad, axis=1))

    def poses(self, shares: Shares) -> Matrix:
        """Return (m, n, 4, 4) transforms at parts of the paths."""
        starts = self._starts[:, None]
        turns = (self._turns_rad[:, None] * shares[:, None]).reshape(-1, 3)
        turned_by = Rotation.from_rotvec(turns).as_matrix().reshape(len(starts), -1, 3, 3)
        places = starts[..., :3, 3] + shares[:, None] * self._ways_mm[:, None]
        return _transforms(places, starts[..., :3, :3] @ turned_by)


class Arc:
    """An arc of the circle through three points, from the first over the second to the third.

    The hand turns smoothly through its three orientations.

    Raises:
        ArcError: The points lie on a line or coincide.
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
        """Return (n, 4, 4) transforms at parts of the path."""
        angles = (shares * self._angle_rad)[:, None]
        places = self._centre_mm + np.cos(angles) * self._ahead + np.sin(angles) * self._aside
        return _transforms(places, self._turn(shares).as_matrix())

    def _angle_to(self, point_mm: Matrix) -> float:
        """Return the angle from the start, turning so that the middle comes before the end."""
        spoke = point_mm - self._centre_mm
        angle = math.atan2(float(spoke @ self._aside), float(spoke @ self._ahead))
        return angle % (2.0 * math.pi)


def _to_centre(over: Matrix, across: Matrix) -> Matrix:
    """Return the way from a corner of a triangle, where the sides start, to its circle's centre."""
    normal = np.cross(over, across)
    weighted = float(over @ over) * across - float(across @ across) * over
    centre: Matrix = -np.cross(normal, weighted) / (2.0 * float(normal @ normal))
    return centre


def _transforms(places_mm: Matrix, turns: Matrix) -> Matrix:
    transforms = np.zeros((*places_mm.shape[:-1], 4, 4))
    transforms[..., :3, :3] = turns
    transforms[..., :3, 3] = places_mm
    transforms[..., 3, 3] = 1.0
    return transforms
