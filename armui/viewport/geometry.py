"""Shapes for the picture: meshes from files, simple solids, the floor and the axes.

Slow to import (VTK): the render thread imports it, nothing else does.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv

from armui.viewport.errors import SceneError

if TYPE_CHECKING:
    from pathlib import Path

    from armui.viewport.robot import Matrix, Visual

_SMOOTH_BELOW_DEG = 35.0
_VTK_READS = frozenset({".stl", ".ply", ".obj"})


def picture_of(visual: Visual) -> pv.PolyData:
    """Triangles of one visual in the frame of its link, metres, with normals for smooth shading.

    Raises:
        SceneError: the mesh file can't be read or holds no surface.
    """
    if visual.mesh is not None:
        surface: pv.PolyData = _read(visual.mesh).scale(visual.size, inplace=False)
    elif visual.kind == "box":
        x, y, z = visual.size
        surface = pv.Cube(x_length=x, y_length=y, z_length=z)
    elif visual.kind == "cylinder":
        radius, length = visual.size
        surface = pv.Cylinder(direction=(0, 0, 1), radius=radius, height=length, resolution=48)
    else:
        surface = pv.Sphere(radius=visual.size[0])
    surface = surface.transform(visual.pose, inplace=False)
    # STL files repeat each corner; merged corners are what lets normals run smoothly over a
    # surface.
    smooth: pv.PolyData = (
        surface.triangulate()
        .clean()
        .compute_normals(feature_angle=_SMOOTH_BELOW_DEG, split_vertices=True, cell_normals=False)
    )
    return smooth


def _read(path: Path) -> pv.PolyData:
    try:
        if path.suffix.lower() in _VTK_READS:
            surface = pv.read(path)
        else:
            import trimesh  # noqa: PLC0415 - half a second that only the rarer formats should cost

            surface = pv.wrap(trimesh.load(path, force="mesh"))
    except Exception as error:
        raise SceneError(f"{path}: the mesh can't be read ({error}); export it again.") from error
    if not isinstance(surface, pv.PolyData) or surface.n_cells == 0:
        raise SceneError(f"{path}: the mesh holds no surface; export it again.")
    return surface


def floor_lines(radius_m: float, step_m: float) -> tuple[pv.PolyData, np.ndarray]:
    """A square grid on the floor, cut out round.

    Returns:
        The lines, in short pieces, and for each of their points how far out it lies (0 centre, 1
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
    """A thin arrow from the origin."""
    return pv.Arrow(
        direction=direction,
        scale=length_m,
        shaft_radius=0.007,
        tip_radius=0.022,
        tip_length=0.1,
        tip_resolution=24,
        shaft_resolution=16,
    )


def flat(matrix: Matrix) -> list[float]:
    """The sixteen numbers of a 4×4 matrix, row by row, as VTK takes them."""
    return [float(number) for number in matrix.ravel()]
