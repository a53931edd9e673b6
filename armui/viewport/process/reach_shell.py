"""The border of what the tool can reach, as surfaces: from without, and around what it can't."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final, NamedTuple

import numpy as np
import pyvista as pv

from armui.viewport.process.reach_volume import VOXEL_M, reached

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from armui.viewport.path_picture import Reach
    from armui.viewport.process.reach_volume import ReachVolume
    from armui.viewport.process.robot import Robot

_HALF: Final = 0.5
_LEFT_OUT: Final = 0.88
"""Of the triangles: the border is smooth, and is drawn in every picture."""
_DIRECTIONS: Final = 400
_DEEP_M: Final = 0.09
"""What lies so far within counts as the border of something inside."""
_SMOOTHINGS: Final = 20


class ReachShell(NamedTuple):
    """Surfaces in the base frame, metres.

    Attributes:
        outer: What bounds the reach from without.
        inner: What bounds places within it that can't be reached.
        floor: Where both meet the floor, as lines.
    """

    outer: pv.PolyData
    inner: pv.PolyData
    floor: pv.PolyData


def shell_of(robot: Robot, reach: Reach) -> ReachShell:
    """Work the border out; takes some tenths of a second."""
    volume = reached(robot, reach)
    border = _border(volume)
    border.point_data["depth"] = _depths(border.points)
    inner = border.clip_scalar(scalars="depth", value=_DEEP_M, invert=False)
    outer = border.clip_scalar(scalars="depth", value=_DEEP_M)
    floor = border.slice(normal="z", origin=(0.0, 0.0, 0.0))
    for shape in (inner, outer, floor):
        shape.clear_data()
    return ReachShell(outer, inner, floor)


def _border(volume: ReachVolume) -> pv.PolyData:
    """Where half of a voxel is reached, without the voxels' steps."""
    box = pv.ImageData(dimensions=volume.shares.shape, spacing=(VOXEL_M,) * 3, origin=volume.origin)
    box.point_data["share"] = volume.shares.ravel(order="F")
    border: pv.PolyData = box.contour([_HALF], scalars="share", method="flying_edges")
    smooth: pv.PolyData = border.smooth_taubin(n_iter=_SMOOTHINGS, pass_band=0.08)
    smooth.clear_data()
    few: pv.PolyData = smooth.decimate_pro(_LEFT_OUT, preserve_topology=True)
    return few


def _depths(places: NDArray[np.floating]) -> NDArray[np.float64]:
    """How far within the smallest convex body around all places each of them is."""
    # directions spread evenly over a sphere: a spiral from pole to pole
    numbers = np.arange(_DIRECTIONS) + 0.5
    heights = 1.0 - 2.0 * numbers / _DIRECTIONS
    turns = numbers * math.pi * (3.0 - math.sqrt(5.0))
    out = np.sqrt(1.0 - heights * heights)
    ways = np.array([out * np.cos(turns), out * np.sin(turns), heights])
    along = places @ ways
    depths: NDArray[np.float64] = (along.max(axis=0) - along).min(axis=1)
    return depths
