"""Finds the capsules that stand for a held object in checks."""

from __future__ import annotations

import itertools
import math
from functools import lru_cache
from typing import Final

import numpy as np

from armui.arm.held_shape import HeldShape, Rod
from armui.cell.held_objects import HeldObject
from armui.kinematics.poses import pose_to_matrix

_CELL_MM: Final = 30.0
"""A box is cut across into bars that are this thick at most, each enclosed by a capsule,"""
_MOST_BARS: Final = 5
"""but into no more than these along either edge."""


@lru_cache(maxsize=16)
def held_shape(held: HeldObject) -> HeldShape:
    """Return the shape of an object.

    The hull of a box is wider than it by at most 0.74 times half the thickness of its bars: by
    11 mm for bars of 30 mm.
    """
    sizes = np.array(held.size_mm)
    if held.is_rod:
        radius = float(max(sizes[0], sizes[1])) / 2.0
        half = max(float(sizes[2]) / 2.0 - radius, 0.0)
        rod = _placed(held, np.array(((0.0, 0.0, -half), (0.0, 0.0, half))), radius)
        return HeldShape((rod,), (rod,))
    long = int(sizes.argmax())
    across = [axis for axis in range(3) if axis != long]
    counts = [min(_MOST_BARS, math.ceil(sizes[axis] / _CELL_MM)) for axis in across]
    halves = [sizes[axis] / count / 2.0 for axis, count in zip(across, counts, strict=True)]
    # The ends are drawn in so that the capsule reaches as far beyond its bar as beside it.
    drawn_in = min(*halves, sizes[long] / 2.0)
    radius = math.hypot(*halves, drawn_in)
    hull = []
    for places in itertools.product(*map(range, counts)):
        ends = np.zeros((2, 3))
        for axis, half, place in zip(across, halves, places, strict=True):
            ends[:, axis] = (2 * place + 1) * half - sizes[axis] / 2.0
        ends[:, long] = np.array((-1.0, 1.0)) * (sizes[long] / 2.0 - drawn_in)
        hull.append(_placed(held, ends, radius))
    edges = []
    for signs in itertools.product((-0.5, 0.5), repeat=2):
        ends = np.zeros((2, 3))
        ends[:, across] = np.array(signs) * sizes[across]
        ends[:, long] = np.array((-0.5, 0.5)) * sizes[long]
        edges.append(_placed(held, ends, 0.0))
    return HeldShape(tuple(hull), tuple(edges))


def _placed(
    held: HeldObject, ends: np.ndarray[tuple[int, ...], np.dtype[np.float64]], radius_mm: float
) -> Rod:
    frame = pose_to_matrix(held.pose)
    start, end = (tuple(map(float, each)) for each in ends @ frame[:3, :3].T + frame[:3, 3])
    return Rod(start, end, radius_mm)
