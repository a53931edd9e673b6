"""Distances of lines from boxes.

Distance and depth of a place to a box are together one convex function
of the place; along a line the least value of it is found exactly.
"""

from __future__ import annotations

import itertools

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]

_SMALL = 1e-12
_SAME_MM = 1e-9
_STEEPEST = 1e300
_ONES, _OTHERS = (np.array(each) for each in zip(*itertools.combinations(range(6), 2), strict=True))


def segment_box_supports(begin: Array, along: Array, half: Array) -> Array:
    """Return (m, 5) the least signed distance of lines from a box, and what supports it there.

    Args:
        begin: (m, 3) one end of each line.
        along: (m, 3) from there to the other end.
        half: (3,) or (m, 3) half the box's edges, which lie along the axes.

    Returns:
        The distance, of a line that goes into the box minus the depth of its deepest place; a
        direction of length 1 at most, three figures; a height. How far a place is
        along the direction, less the height, is its distance from the box at most, wherever it is;
        of a line's ends the lesser one is the line's distance, here.
    """
    half = np.broadcast_to(half, begin.shape)
    found = np.empty((len(begin), 5))
    place = begin + _nearest_shares(begin, along, half)[:, None] * along
    off = place - np.clip(place, -half, half)
    distances = np.sqrt(np.einsum("mi,mi->m", off, off))
    inside = np.flatnonzero(distances <= _SMALL)
    distances[inside] = 1.0
    off /= distances[:, None]
    found[:, 0], found[:, 1:4] = distances, off
    np.einsum("mi,mi->m", np.abs(off), half, out=found[:, 4])
    if len(inside):
        found[inside] = _depths(begin[inside], along[inside], half[inside])
    return found


def _nearest_shares(begin: Array, along: Array, half: Array) -> Array:
    """Return the shares of the lines at which they are nearest to a box, or in it.

    The square of the distance is convex along a line, and a parabola between the places where the
    line crosses the planes of the sides: its slope is straight in between.
    """
    steep = np.abs(along) > _SMALL
    inverse = 1.0 / np.where(steep, along, np.inf)
    shares = np.empty((len(begin), 8))
    shares[:, 0], shares[:, 7] = 0.0, 1.0
    shares[:, 1:4], shares[:, 4:7] = (-half - begin) * inverse, (half - begin) * inverse
    np.clip(shares, 0.0, 1.0, out=shares)
    places = begin[:, :, None] + along[:, :, None] * shares[:, None]
    beyond = places - np.clip(places, -half[:, :, None], half[:, :, None])
    slopes = np.einsum("mis,mi->ms", beyond, along)
    # The least value lies between the last falling and the first rising stretch.
    rising = slopes > 0.0
    low = np.where(rising, 0.0, shares).max(axis=1)
    high = np.where(rising, shares, 1.0).min(axis=1)
    falls = np.where(rising, -_STEEPEST, slopes).max(axis=1)
    rises = np.where(rising, slopes, _STEEPEST).min(axis=1)
    nearest: Array = low - falls / (rises - falls) * (high - low)
    return nearest


def _depths(begin: Array, along: Array, half: Array) -> Array:
    """Return minus the depth of the deepest place of lines that go into a box, with its support.

    How far a place is beyond each of the six sides is straight along the line; the largest of the
    six is convex, and least where two of them meet, or at an end. These two support it: a mean of
    them is level along the line.
    """
    rows = np.arange(len(begin))
    slopes = np.concatenate((along, -along), axis=1)
    values = np.concatenate((begin - half, -begin - half), axis=1)
    steep = slopes[:, _ONES] - slopes[:, _OTHERS]
    apart = values[:, _OTHERS] - values[:, _ONES]
    at = np.zeros((len(begin), len(_ONES) + 1))
    np.divide(apart, steep, out=at[:, 1:], where=np.abs(steep) > _SMALL)
    at = np.concatenate((np.clip(at, 0.0, 1.0), np.ones((len(begin), 1))), axis=1)
    worst = (values[:, None, :] + at[..., None] * slopes[:, None, :]).max(axis=2)
    where = worst.argmin(axis=1)
    depths, share = worst[rows, where], at[rows, where]
    # of the active sides, the one that falls most and the one that rises most
    counts = values + share[:, None] * slopes >= depths[:, None] - _SAME_MM
    falling = np.where(counts, slopes, np.inf).argmin(axis=1)
    rising = np.where(counts, slopes, -np.inf).argmax(axis=1)
    fall, rise = slopes[rows, falling], slopes[rows, rising]
    part = np.where(rise - fall > _SMALL, rise / np.maximum(rise - fall, _SMALL), 1.0)
    part = np.clip(part, 0.0, 1.0)
    found = np.zeros((len(begin), 5))
    found[:, 0] = depths
    for side, weight in ((falling, part), (rising, 1.0 - part)):
        found[rows, 1 + side % 3] += np.where(side < 3, weight, -weight)
        found[:, 4] += weight * half[rows, side % 3]
    return found
