"""The places of an arm's links, as capsules, at joint angles, and how far each joint moves them."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from armui.cell.enclosure import Capsule
from armui.kinematics.geometry import JOINT_COUNT, Geometry

Array = npt.NDArray[np.float64]
Whole = npt.NDArray[np.int64]

_FRAMES = JOINT_COUNT + 1


class MovedCapsules:
    """Capsules fixed to the links of an arm, seen from a link before.

    Args:
        geometry: The arm's geometry with its zeros.
        capsules: The capsules.
        seen_from: The link in whose frame each is to be placed, 0 for the base; what is between
            that link and the capsule's own moves it. All are seen from the base if it is empty.
    """

    def __init__(
        self, geometry: Geometry, capsules: Sequence[Capsule], seen_from: Sequence[int] = ()
    ) -> None:
        bases = seen_from or [0] * len(capsules)
        self._bases = sorted(set(bases))
        self._zeros_deg = np.array([row.theta_deg for row in geometry.rows])
        self._fixed, self._cosines, self._sines = _steps(geometry)
        self._ends = np.ones((len(capsules), 2, 4))
        self._ends[:, :, :3] = np.array(
            [(each.start_mm, each.end_mm) for each in capsules]
        ).reshape(-1, 2, 3)
        rows = [self._bases.index(base) * _FRAMES for base in bases]
        links = [each.link for each in capsules]
        self._axes = np.array(rows, dtype=np.int64)[:, None] + np.arange(1, _FRAMES)
        self._frame_of = np.array(rows, dtype=np.int64) + np.array(links, dtype=np.int64)
        self.parts = tuple(each.part for each in capsules)
        """The part of each of k."""
        self.links = links
        """The link that each is fixed to."""
        self.radii_mm = np.array([each.radius_mm for each in capsules])
        """(k,) the radii."""
        self.first_joints = np.minimum(np.array(bases, dtype=np.int64), JOINT_COUNT - 1)
        """(k,) the index of the first joint that may move each."""
        alphas = np.radians([geometry.rows[joint].alpha_deg for joint in self.first_joints])
        self.first_axes = np.stack((np.zeros(len(alphas)), -np.sin(alphas), np.cos(alphas)), axis=1)
        """(k, 3) its axis, which stays where it is."""
        pairs = list(zip(capsules, bases, strict=True))
        self.reaches_mm = np.array(
            [
                [
                    _reaches_mm(geometry, end, each.link, base)
                    for end in (each.start_mm, each.end_mm)
                ]
                for each, base in pairs
            ]
        ).reshape(-1, 2, JOINT_COUNT)
        """(k, 2, 6) how far from each joint's axis the line's ends can be; 0 if it moves none."""
        self.moves: npt.NDArray[np.bool_] = np.any(self.reaches_mm > 0.0, axis=1)
        """(k, 6) whether a joint moves it."""

    def __len__(self) -> int:
        return len(self.radii_mm)

    def frames(self, joints_deg: Array) -> Array:
        """Return (n, …, 4, 4) the frames of all links at (n, 6) angles, for the other methods."""
        angles = np.radians(joints_deg + self._zeros_deg)[..., None, None]
        steps = np.cos(angles) * self._cosines
        steps += np.sin(angles) * self._sines
        steps += self._fixed
        # Zeros, as `rises` also reads the links before a base, which then contribute nothing.
        frames = np.zeros((len(joints_deg), _FRAMES * len(self._bases), 4, 4))
        for row, base in enumerate(self._bases):
            place = row * _FRAMES + base
            frames[:, place] = np.eye(4)
            for joint in range(base, JOINT_COUNT):
                np.matmul(frames[:, place], steps[:, joint], out=frames[:, place + 1])
                place += 1
        return frames

    def ends(self, frames: Array, poses: Whole, capsules: Whole) -> Array:
        """Return (m, 2, 3) where m capsules end.

        Args:
            frames: The frames of some poses.
            poses: (m,) which of them.
            capsules: (m,) which capsule there.
        """
        chosen = frames[poses, self._frame_of[capsules]]
        placed: Array = self._ends[capsules] @ chosen[:, :3].swapaxes(1, 2)
        return placed

    def all_ends(self, frames: Array) -> Array:
        """Return (n, k, 2, 3) where all capsules end at all poses."""
        placed: Array = self._ends @ frames[:, self._frame_of, :3].swapaxes(2, 3)
        return placed

    def rises(
        self, frames: Array, poses: Whole, capsules: Whole, ends: Array, directions: Array
    ) -> Array:
        """Return (m, 2, 6) how m capsules' ends move along directions by each joint.

        Args:
            frames: As in `ends`.
            poses: Likewise.
            capsules: Likewise.
            ends: The result of `ends`.
            directions: (m, 3) the direction for each capsule.

        Returns:
            Millimetres for a radian.
        """
        chosen = frames[poses[:, None], self._axes[capsules], :3]
        turned = np.cross(ends[:, :, None] - chosen[:, None, :, :, 3], directions[:, None, None])
        rises = np.einsum("mji,meji->mej", chosen[..., 2], turned)
        return np.where(self.moves[capsules, None], rises, 0.0)


def _steps(geometry: Geometry) -> tuple[Array, Array, Array]:
    """Return (6, 4, 4) each joint's frame in the one before: fixed, by its cosine, by its sine."""
    fixed, cosines, sines = np.zeros((3, JOINT_COUNT, 4, 4))
    for index, row in enumerate(geometry.rows):
        alpha = math.radians(row.alpha_deg)
        ca, sa = math.cos(alpha), math.sin(alpha)
        fixed[index] = (
            (0.0, 0.0, 0.0, row.a_mm),
            (0.0, 0.0, -sa, -sa * row.d_mm),
            (0.0, 0.0, ca, ca * row.d_mm),
            (0.0, 0.0, 0.0, 1.0),
        )
        cosines[index, 0, 0], cosines[index, 1, 1], cosines[index, 2, 1] = 1.0, ca, sa
        sines[index, 0, 1], sines[index, 1, 0], sines[index, 2, 0] = -1.0, ca, sa
    return fixed, cosines, sines


def _reaches_mm(geometry: Geometry, place: Sequence[float], link: int, base: int) -> Array:
    """Return (6,) how far from each joint's axis a place on a link can be at most."""
    reaches_mm = np.zeros(JOINT_COUNT)
    if link > base:
        # the axis of the link's own joint is the Z axis of its frame
        reaches_mm[link - 1] = math.hypot(*place[:2])
    furthest_mm = math.hypot(*place)
    for joint in reversed(range(base, link - 1)):
        row = geometry.rows[joint + 1]
        furthest_mm += math.hypot(row.a_mm, row.d_mm)
        reaches_mm[joint] = furthest_mm
    return reaches_mm
