"""Shapes for the picture: smooth surfaces, the floor and the axes.

It is slow to import (VTK).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

if TYPE_CHECKING:
    from armui.viewport.process.robot import Matrix, Surface

_SMOOTH_BELOW_DEG = 35.0


def smooth(surface: Surface) -> pv.PolyData:
    """Return the same triangles with normals that are smooth except at sharp edges."""
    faces = np.asarray(surface.faces, int)
    triangles: pv.PolyData = pv.PolyData.from_regular_faces(surface.vertices, faces)
    # Only merged corners let normals run over from one triangle to the next.
    shaded: pv.PolyData = triangles.clean().compute_normals(
        feature_angle=_SMOOTH_BELOW_DEG, split_vertices=True, cell_normals=False
    )
    return shaded


def is_closed(surface: Surface) -> bool:
    """Return whether a surface encloses a body and all its triangles face outwards.

    The triangles of such a body that face away from the eye need not be drawn.
    """
    corners, places = np.unique(surface.vertices, axis=0, return_inverse=True)
    faces = places.reshape(-1)[np.asarray(surface.faces, np.int64)]
    starts, ends = faces.ravel(), np.roll(faces, -1, axis=1).ravel()
    is_edge = starts != ends
    starts, ends = starts[is_edge], ends[is_edge]
    count = len(corners)
    forth, back = np.sort(starts * count + ends), np.sort(ends * count + starts)
    if not np.array_equal(forth, back):  # an edge has no neighbour, or both have one direction
        return False
    one, two, three = (corners[faces[:, corner]] for corner in range(3))
    return float(np.einsum("ij,ij->", one, np.cross(two, three))) > 0.0


def floor_lines(radius_m: float, step_m: float) -> tuple[pv.PolyData, np.ndarray]:
    """Return a round grid on the floor, made of squares.

    Returns:
        The lines in short pieces, and for each point its distance from the centre (0 centre, 1
        rim).
    """
    offsets = np.arange(-np.floor(radius_m / step_m), np.floor(radius_m / step_m) + 1) * step_m
    starts, ends = [], []
    for offset in offsets:
        half = np.sqrt(max(radius_m**2 - offset**2, 0.0))
        cuts = np.arange(-half, half, step_m / 4.0)
        cuts = np.append(cuts, half)
        along = np.column_stack([np.full_like(cuts, offset), cuts, np.full_like(cuts, -0.0005)])
        across = along[:, [1, 0, 2]]
        for line in (along, across):
            starts.append(line[:-1])
            ends.append(line[1:])
    points = np.stack([np.concatenate(starts), np.concatenate(ends)], axis=1).reshape(-1, 3)
    lines = pv.line_segments_from_points(points)
    outward = np.linalg.norm(lines.points[:, :2], axis=1) / radius_m
    return lines, outward


def axis_arrow(direction: tuple[float, float, float], length_m: float) -> pv.PolyData:
    """Return a thin arrow from the origin."""
    return pv.Arrow(
        direction=direction,
        scale=length_m,
        shaft_radius=0.007,
        tip_radius=0.022,
        tip_length=0.1,
        tip_resolution=24,
        shaft_resolution=16,
    )


def actor_of(surface: pv.PolyData) -> vtkActor:
    """Return an actor for a renderer."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(surface)
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


def flat(matrix: Matrix) -> list[float]:
    """Return the sixteen numbers of a 4×4 matrix, row by row, for VTK."""
    return [float(number) for number in matrix.ravel()]
