"""The distances of lines and places from the planes and boxes of a work area, all at once.

Distance and depth of a place to a plane or box are together one convex function of the place. So
there is, at the nearest place of a line, a support of it: a direction and a height. How far any
place is along the direction, less the height, is no more than its distance.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

import numpy as np
import numpy.typing as npt

from armui.cell.clearance import segment_box_supports
from armui.kinematics.poses import pose_to_matrix

if TYPE_CHECKING:
    from armui.cell.work_area import AreaBox, AreaPlane, Zone

Array = npt.NDArray[np.float64]
Whole = npt.NDArray[np.int64]

_BEYOND_MM: Final = 1e9


class Obstacles:
    """The planes and boxes of a work area, counted together: the planes first.

    Args:
        planes: The planes.
        boxes: The boxes.
    """

    def __init__(self, planes: Sequence[AreaPlane], boxes: Sequence[AreaBox]) -> None:
        frames, normals = _frames(planes), _frames(planes)[:, :3, 2]
        self._planes = np.column_stack((normals, np.einsum("pi,pi->p", normals, frames[:, :3, 3])))
        boxed = _frames(boxes)
        self._turns, self._centres = boxed[:, :3, :3].copy(), boxed[:, :3, 3].copy()
        self._halves = np.array([box.size_mm for box in boxes]).reshape(-1, 3) / 2.0

    def __len__(self) -> int:
        return len(self._planes) + len(self._halves)

    def supports(self, ends: Array, which: Whole) -> Array:
        """Return (m, 5) the signed distances of m lines from one obstacle each, and a support.

        Args:
            ends: (m, 2, 3) the ends of the lines, in mm in the base.
            which: (m,) the obstacle of each.

        Returns:
            The distance, the support's direction (three figures) and its height.
        """
        planes = len(self._planes)
        found = np.empty((len(ends), 5))
        rows = np.flatnonzero(which >= planes)
        if len(rows) < len(ends):
            flat = np.flatnonzero(which < planes)
            found[flat, 1:] = self._planes[which[flat]]
            heights = np.einsum("mei,mi->me", ends[flat], found[flat, 1:4])
            found[flat, 0] = heights.min(axis=1) - found[flat, 4]
        if len(rows):
            boxes = which[rows] - planes
            centres, turns = self._centres[boxes], self._turns[boxes]
            local = (ends[rows] - centres[:, None]) @ turns
            boxed = segment_box_supports(
                local[:, 0], local[:, 1] - local[:, 0], self._halves[boxes]
            )
            directions = np.einsum("mij,mj->mi", turns, boxed[:, 1:4])
            boxed[:, 1:4] = directions
            boxed[:, 4] += np.einsum("mi,mi->m", directions, centres)
            found[rows] = boxed
        return found

    def facing(self, places: Array) -> tuple[Array, Array]:
        """Return a support of each obstacle that faces each of (c, 3) places.

        Returns:
            (z, c, 3) the directions; (z, c) the heights, beyond everything for a place in a box.
        """
        planes, shape = len(self._planes), (len(self), len(places))
        directions, heights = np.empty((*shape, 3)), np.empty(shape)
        directions[:planes] = self._planes[:, None, :3]
        heights[:planes] = self._planes[:, 3:]
        local = (places - self._centres[:, None]) @ self._turns
        off = local - np.clip(local, -self._halves[:, None], self._halves[:, None])
        distances = np.sqrt(np.einsum("zci,zci->zc", off, off))
        outside = distances > 0.0
        off /= np.where(outside, distances, 1.0)[..., None]
        reach = np.einsum("zci,zi->zc", np.abs(off), self._halves)
        turned = off @ self._turns.swapaxes(1, 2)
        directions[planes:] = turned
        reach += np.einsum("zci,zi->zc", turned, self._centres)
        heights[planes:] = np.where(outside, reach, _BEYOND_MM)
        return directions, heights

    def distances(self, places: Array) -> Array:
        """Return (z, c) the signed distances of (c, 3) places."""
        planes = len(self._planes)
        found = np.empty((len(self), len(places)))
        found[:planes] = self._planes[:, :3] @ places.T - self._planes[:, 3:]
        beyond = np.abs((places - self._centres[:, None]) @ self._turns) - self._halves[:, None]
        off = np.maximum(beyond, 0.0)
        found[planes:] = np.sqrt(np.einsum("zci,zci->zc", off, off))
        found[planes:] += np.minimum(beyond.max(axis=2), 0.0)
        return found


def _frames(zones: Sequence[Zone]) -> Array:
    return pose_to_matrix(np.array([zone.pose for zone in zones]).reshape(-1, 6))
