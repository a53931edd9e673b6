"""Distances of an arm's capsules from planes and boxes.

A gap is measured from a capsule's surface: above 0 it is free room, below 0 it is how deep the
capsule reaches in. Distance and depth of a place to a plane or box are together one convex function
of the place; along the line of a capsule the least value of it is found exactly.
"""

from __future__ import annotations

import itertools

import numpy as np
import numpy.typing as npt

from armui.cell.enclosure import Capsules

Array = npt.NDArray[np.float64]

_SMALL = 1e-12


def plane_gaps(capsules: Capsules, frames: Array) -> Array:
    """Return (n, k, p) the gaps between n × k capsules and p planes.

    Args:
        capsules: The capsules.
        frames: (p, 4, 4) a frame on each plane, in mm; its Z axis points to the free side.
    """
    normals, places = frames[:, :3, 2], frames[:, :3, 3]
    heights = np.einsum("pi,pi->p", normals, places)
    nearest = np.minimum(capsules.starts @ normals.T, capsules.ends @ normals.T)
    gaps: Array = nearest - heights - capsules.radii[:, None]
    return gaps


def box_gaps(
    capsules: Capsules,
    frames: Array,
    sizes_mm: Array,
    near_mm: float = np.inf,
    wanted: npt.NDArray[np.bool_] | None = None,
) -> Array:
    """Return (n, k, b) the gaps between n × k capsules and b boxes.

    Args:
        capsules: The capsules.
        frames: (b, 4, 4) the frame of each box's centre, in mm.
        sizes_mm: (b, 3) its edges along the axes of that frame.
        near_mm: A gap of this or more may be given too small, but never below this: what is far is
            not computed exactly.
        wanted: (n, b) the poses and boxes that are not known to be that far apart.
    """
    gaps = np.full((*capsules.starts.shape[:2], len(frames)), near_mm)
    middles = (capsules.starts + capsules.ends) / 2.0
    lines = capsules.ends - capsules.starts
    reach = np.linalg.norm(lines, axis=-1) / 2.0 + capsules.radii
    for index, (frame, size) in enumerate(zip(frames, sizes_mm, strict=True)):
        turn, half = frame[:3, :3], size / 2.0
        rows = slice(None) if wanted is None else np.flatnonzero(wanted[:, index])
        outside = np.maximum(np.abs((middles[rows] - frame[:3, 3]) @ turn) - half, 0.0)
        bound = np.sqrt(np.einsum("nki,nki->nk", outside, outside)) - reach[rows]
        near = np.nonzero(bound < near_mm)
        if len(near[0]):
            begin = (capsules.starts[rows][near] - frame[:3, 3]) @ turn
            along = lines[rows][near] @ turn
            bound[near] = segment_box_distances(begin, along, half) - capsules.radii[near[1]]
        gaps[rows, :, index] = bound
    return gaps


def segment_box_distances(begin: Array, along: Array, half: Array) -> Array:
    """Return (m,) the least signed distance of each straight line from a box about the origin.

    Args:
        begin: (m, 3) one end of each line.
        along: (m, 3) from there to the other end.
        half: (3,) half the box's edges, which lie along the axes.

    Returns:
        The distance; of a line that goes into the box, minus the depth of its deepest place.
    """
    distances = _outside(begin, along, half)
    inside = distances <= 0.0
    if inside.any():
        distances[inside] = _depth(begin[inside], along[inside], half)
    return distances


def _outside(begin: Array, along: Array, half: Array) -> Array:
    """Return the least distance of lines from a box, 0 for those that touch it.

    The square of the distance is convex along a line, and a parabola between the places where the
    line crosses the planes of the sides: its slope is straight in between.
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        crossed = np.stack(((-half - begin) / along, (half - begin) / along), axis=-1)
    crossed = np.where(np.abs(along)[..., None] > _SMALL, crossed, 0.0).reshape(len(begin), 6)
    shares = np.sort(np.clip(crossed, 0.0, 1.0), axis=1)
    shares = np.concatenate((np.zeros((len(begin), 1)), shares, np.ones((len(begin), 1))), axis=1)
    places = begin[:, None, :] + shares[..., None] * along[:, None, :]
    beyond = places - np.clip(places, -half, half)
    slopes = np.einsum("msi,mi->ms", beyond, along)
    # the first place from which it rises; the least value lies just before it, or at an end
    rising = slopes > 0.0
    after = np.where(rising.any(axis=1), rising.argmax(axis=1), shares.shape[1] - 1)
    before = np.maximum(after - 1, 0)
    rows = np.arange(len(begin))
    low, high = slopes[rows, before], slopes[rows, after]
    part = np.where(high - low > _SMALL, -low / np.where(high - low > _SMALL, high - low, 1.0), 0.0)
    part = np.clip(part, 0.0, 1.0)
    share = shares[rows, before] + part * (shares[rows, after] - shares[rows, before])
    place = begin + share[:, None] * along
    distances: Array = np.linalg.norm(place - np.clip(place, -half, half), axis=1)
    return distances


def _depth(begin: Array, along: Array, half: Array) -> Array:
    """Return minus the depth of the deepest place of lines that go into a box.

    How far a place is beyond each of the six sides is straight along the line; the largest of the
    six is convex, and least where two of them meet, or at an end.
    """
    slopes = np.concatenate((along, -along), axis=1)
    values = np.concatenate((begin - half, -begin - half), axis=1)
    shares = [np.zeros(len(begin)), np.ones(len(begin))]
    for one, other in itertools.combinations(range(6), 2):
        steep = slopes[:, one] - slopes[:, other]
        with np.errstate(divide="ignore", invalid="ignore"):
            meets = (values[:, other] - values[:, one]) / steep
        shares.append(np.where(np.abs(steep) > _SMALL, np.clip(meets, 0.0, 1.0), 0.0))
    at = np.stack(shares, axis=1)
    worst = (values[:, None, :] + at[..., None] * slopes[:, None, :]).max(axis=2)
    depths: Array = worst.min(axis=1)
    return depths
