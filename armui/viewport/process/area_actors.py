"""The work area and what the hand holds, as translucent bodies; those near the arm are lit."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np
import pyvista as pv
from vtkmodules.vtkCommonMath import vtkMatrix4x4

from armui.viewport.palette import ScenePalette, rgb
from armui.viewport.process.geometry import actor_of, flat

if TYPE_CHECKING:
    from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer

    from armui.viewport.area_picture import AreaPicture, AreaShape
    from armui.viewport.process.robot import Matrix

_MM: Final = 0.001
_OPACITY: Final = 0.14
_NEAR_OPACITY: Final = 0.26
_PLANE_M: Final = 1.2
_PLANE_CELLS: Final = 8
_SPIKE_M: Final = 0.06
_MIDDLE_M: Final = (0.0, 0.0, 0.25, 1.0)
"""The middle of the arm's work space: a plane is drawn around its place nearest to this."""


class AreaActors:
    """The work area in a renderer."""

    def __init__(self, renderer: vtkRenderer) -> None:
        self._renderer = renderer
        self._actors: list[vtkActor] = []
        self._shown: tuple[AreaPicture, ScenePalette] | None = None
        self._flange = vtkMatrix4x4()

    def show(self, area: AreaPicture, palette: ScenePalette) -> None:
        """Show an area; do nothing if it is the same as before."""
        if (area, palette) == self._shown:
            return
        self._shown = (area, palette)
        for actor in self._actors:
            self._renderer.RemoveActor(actor)
        self._actors = [self._add(shape, palette) for shape in area]

    def follow(self, flange: Matrix) -> None:
        """Move what the hand holds to where the flange is: (4, 4), in metres."""
        self._flange.DeepCopy(flat(flange))

    def _add(self, shape: AreaShape, palette: ScenePalette) -> vtkActor:
        actor = actor_of(_surface(shape))
        appearance = actor.GetProperty()
        lit = (shape.near or shape.held) and not shape.pale
        color = rgb((palette.accent if shape.held else palette.warning) if lit else palette.muted)
        appearance.SetColor(*color)
        appearance.SetOpacity(_NEAR_OPACITY if lit or shape.pale else _OPACITY)
        if shape.pale:
            appearance.SetRepresentationToWireframe()
        appearance.LightingOff()
        appearance.BackfaceCullingOff()
        appearance.EdgeVisibilityOn()
        appearance.SetEdgeColor(*color)
        actor.PickableOff()
        if shape.held:
            actor.SetUserMatrix(self._flange)
        self._renderer.AddActor(actor)
        return actor


def _surface(shape: AreaShape) -> pv.PolyData:
    """Return a plane, box or rod in the frame it is given in, in metres."""
    frame = np.vstack((np.reshape(shape.rows, (3, 4)), (0.0, 0.0, 0.0, 1.0)))
    if shape.size_mm is not None and shape.is_rod:
        x, y, z = (_MM * edge for edge in shape.size_mm)
        radius = max(x, y) / 2.0
        length = max(z - 2.0 * radius, 0.0)
        surface = pv.Capsule(
            direction=(0.0, 0.0, 1.0), radius=radius, cylinder_length=length, resolution=24
        )
    elif shape.size_mm is not None:
        x, y, z = (_MM * edge for edge in shape.size_mm)
        surface = pv.Cube(x_length=x, y_length=y, z_length=z)
    else:
        across, along, _, _ = np.linalg.inv(frame) @ _MIDDLE_M
        surface = pv.Plane(
            center=(across, along, 0.0),
            i_size=_PLANE_M,
            j_size=_PLANE_M,
            i_resolution=_PLANE_CELLS,
            j_resolution=_PLANE_CELLS,
        )
        places = np.array([-1.0, 0.0, 1.0]) * _PLANE_M / 3.0
        surface = surface.merge([_spike(across + x, along + y) for x in places for y in places])
    return surface.transform(frame, inplace=False)


def _spike(x: float, y: float) -> pv.PolyData:
    """Return a mark on the side of a plane where the arm may not be: it points into that."""
    at = (x, y, -_SPIKE_M / 2.0)
    return pv.Cone(
        center=at, direction=(0.0, 0.0, -1.0), height=_SPIKE_M, radius=_SPIKE_M / 6.0, resolution=6
    )
