"""What stands still in the picture: floor, axes, lights."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from vtkmodules.vtkRenderingCore import vtkFollower, vtkLight, vtkPolyDataMapper
from vtkmodules.vtkRenderingFreeType import vtkVectorText

from armui.viewport.palette import ScenePalette, mix, rgb
from armui.viewport.process.geometry import actor_of, axis_arrow, floor_lines

if TYPE_CHECKING:
    import pyvista as pv
    from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer

_FLOOR_RADIUS_M = 0.9
_FLOOR_STEP_M = 0.1
_AXIS_LENGTH_M = 0.2
_LETTER_HEIGHT_M = 0.022
_AXES = (("X", (1.0, 0.0, 0.0)), ("Y", (0.0, 1.0, 0.0)), ("Z", (0.0, 0.0, 1.0)))


class Stage:
    """Floor grid, labelled axes and lights of one renderer."""

    def __init__(self, renderer: vtkRenderer) -> None:
        self._renderer = renderer
        lines, self._outward = floor_lines(_FLOOR_RADIUS_M, _FLOOR_STEP_M)
        self._lines = lines
        self._lines.point_data["color"] = np.zeros((lines.n_points, 3), np.uint8)
        self._lines.point_data.active_scalars_name = "color"
        self._grid = self._unlit(self._lines)
        self._arrows = [
            self._unlit(axis_arrow(direction, _AXIS_LENGTH_M)) for _, direction in _AXES
        ]
        self._letters = [self._letter(text, direction) for text, direction in _AXES]
        self._light()

    def paint(self, palette: ScenePalette) -> None:
        """Take the colours of a theme."""
        background, grid = rgb(palette.background), rgb(palette.grid)
        self._renderer.SetBackground(background)
        shares = self._outward[:, np.newaxis] ** 2
        colors = np.asarray(grid) * (1.0 - shares) + np.asarray(background) * shares
        self._lines.point_data["color"] = np.round(np.clip(colors, 0.0, 1.0) * 255.0).astype(
            np.uint8
        )
        for color, arrow, letter in zip(palette.axes, self._arrows, self._letters, strict=True):
            arrow.GetProperty().SetColor(*rgb(color))
            letter.GetProperty().SetColor(*mix(rgb(color), rgb(palette.text), 0.15))

    def scale_lines(self, pixel_ratio: float) -> None:
        """Keep the floor lines as wide to the eye on screens with small pixels."""
        self._grid.GetProperty().SetLineWidth(pixel_ratio)

    def _unlit(self, surface: pv.PolyData) -> vtkActor:
        actor = actor_of(surface)
        actor.GetProperty().LightingOff()
        self._add(actor)
        return actor

    def _letter(self, text: str, direction: tuple[float, float, float]) -> vtkFollower:
        shape = vtkVectorText()
        shape.SetText(text)
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(shape.GetOutputPort())
        follower = vtkFollower()
        follower.SetMapper(mapper)
        follower.SetScale(_LETTER_HEIGHT_M)
        follower.SetPosition([1.1 * _AXIS_LENGTH_M * part for part in direction])
        follower.SetCamera(self._renderer.GetActiveCamera())
        follower.GetProperty().LightingOff()
        self._add(follower)
        return follower

    def _add(self, actor: vtkActor) -> None:
        actor.PickableOff()
        self._renderer.AddActor(actor)

    def _light(self) -> None:
        """A soft head light, a key light over the left shoulder, a faint one from the right."""
        for position, intensity in (
            ((0, 0, 1), 0.40),
            ((-0.6, 1.2, 0.9), 0.56),
            ((0.9, 0.1, 0.5), 0.2),
        ):
            light = vtkLight()
            light.SetLightTypeToCameraLight()
            light.SetIntensity(intensity)
            light.SetPosition(position)
            self._renderer.AddLight(light)
