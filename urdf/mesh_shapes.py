"""Solids for the meshes of the arms.

Everything is made of two ideas. A *section* is the hull of a few circles, sampled at fixed
directions: a disc, a rounded rectangle and a teardrop are sections with the same number of points,
in the same order. A *loft* joins sections into a closed skin. Lengths are in millimetres.
"""

from __future__ import annotations

import math

import numpy as np
import trimesh
from numpy.typing import NDArray
from scipy.interpolate import PchipInterpolator

Array = NDArray[np.float64]
Circle = tuple[float, float, float]
"""Centre x, centre y, radius."""

_POINTS = 36
_POINTS_OF_SMALL_PARTS = 16
_FILLET_STEPS = 2
_SMOOTH_STEPS = 2

# Which way a section's own x and y and the direction of its extrusion point.
ALONG_X = np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]])
ALONG_Y = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]])
ALONG_Z = np.eye(3)


def section(circles: list[Circle], inset: float = 0.0, points: int = _POINTS) -> Array:
    """Outline of the hull of circles, each made smaller by `inset`; (points, 2)."""
    directions = np.linspace(0.0, 2.0 * math.pi, points, endpoint=False)
    units = np.column_stack([np.cos(directions), np.sin(directions)])
    centres = np.array([circle[:2] for circle in circles])
    radii = np.array([max(circle[2] - inset, 0.05) for circle in circles])
    farthest = np.argmax(units @ centres.T + radii, axis=1)
    return centres[farthest] + radii[farthest, np.newaxis] * units


def rectangle(half_x: float, half_y: float, corner: float) -> list[Circle]:
    """Circles whose hull is a rectangle with round corners."""
    corner = min(corner, half_x, half_y)
    return [
        (sign_x * (half_x - corner), sign_y * (half_y - corner), corner)
        for sign_x in (-1.0, 1.0)
        for sign_y in (-1.0, 1.0)
    ]


def loft(rings: Array) -> trimesh.Trimesh:
    """Closed skin over rings of points (rings, points, 3), both ends covered."""
    count, points = rings.shape[:2]
    vertices = [*rings.reshape(-1, 3), rings[0].mean(axis=0), rings[-1].mean(axis=0)]
    here = np.arange(points)
    following = (here + 1) % points
    faces = []
    for ring in range(count - 1):
        low, high = ring * points, (ring + 1) * points
        faces.append(np.column_stack([low + here, low + following, high + following]))
        faces.append(np.column_stack([low + here, high + following, high + here]))
    first_centre, last_centre, last = count * points, count * points + 1, (count - 1) * points
    faces.append(np.column_stack([np.full(points, first_centre), following, here]))
    faces.append(np.column_stack([np.full(points, last_centre), last + here, last + following]))
    solid = trimesh.Trimesh(np.array(vertices), np.concatenate(faces), process=False)
    if solid.volume < 0.0:
        solid.invert()
    return solid


def prism(
    circles: list[Circle],
    low: float,
    high: float,
    fillet: float = 1.5,
    axes: Array = ALONG_Z,
    *,
    points: int = _POINTS,
) -> trimesh.Trimesh:
    """A section pushed from `low` to `high`, with rounded rims."""
    rims = []
    for step in range(_FILLET_STEPS + 1):
        angle = 0.5 * math.pi * step / _FILLET_STEPS
        rims.append((fillet * (1.0 - math.sin(angle)), fillet * (1.0 - math.cos(angle))))
    levels = [(inset, low + rise) for inset, rise in rims]
    levels += [(inset, high - rise) for inset, rise in reversed(rims)]
    rings = [
        np.column_stack([section(circles, inset, points), np.full(points, level)])
        for inset, level in levels
    ]
    return loft(np.array(rings) @ axes)


def disc(
    radius: float,
    low: float,
    high: float,
    fillet: float = 1.5,
    axes: Array = ALONG_Z,
    *,
    centre: tuple[float, float] = (0.0, 0.0),
) -> trimesh.Trimesh:
    """A round prism; `centre` in the section's own plane."""
    points = _POINTS if radius > 10.0 else _POINTS_OF_SMALL_PARTS
    return prism([(*centre, radius)], low, high, fillet, axes, points=points)


def smooth_loft(stations: list[Array]) -> trimesh.Trimesh:
    """Skin that runs smoothly, without overshoot, through rings of points (points, 3)."""
    keys = np.arange(len(stations), dtype=float)
    fine = np.linspace(0.0, keys[-1], (len(stations) - 1) * _SMOOTH_STEPS + 1)
    return loft(PchipInterpolator(keys, np.array(stations), axis=0)(fine))


def across_x(x: float, y: float, tilt_deg: float, half_height: float, half_width: float) -> Array:
    """Ring of the upper arm: a rounded rectangle across a direction in the xy plane."""
    outline = section(rectangle(half_height, half_width, 11.0))
    tilt = math.radians(tilt_deg)
    return np.column_stack(
        [
            x - outline[:, 0] * math.sin(tilt),
            y + outline[:, 0] * math.cos(tilt),
            outline[:, 1],
        ]
    )


def across_y(y: float, x_low: float, x_high: float, half_width: float, corner: float) -> Array:
    """Ring of the forearm: a rounded rectangle across the y axis."""
    outline = section(rectangle((x_high - x_low) / 2.0, half_width, corner))
    return np.column_stack(
        [outline[:, 0] + (x_low + x_high) / 2.0, np.full(_POINTS, y), outline[:, 1]]
    )


def across_z(z: float, circles: list[Circle]) -> Array:
    """Ring across the z axis."""
    return np.column_stack([section(circles), np.full(_POINTS, z)])
