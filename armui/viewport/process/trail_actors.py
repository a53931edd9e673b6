"""Where the tool has been, as a line that fades towards its old end; and where it was sent."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv

from armui.viewport.palette import ScenePalette, rgb
from armui.viewport.process.geometry import actor_of

if TYPE_CHECKING:
    from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer

    from armui.viewport.path_picture import Trail

_MM = 0.001
_DRIVEN_PX, _COMMANDED_PX = 7.0, 2.0
_OLDEST_SHARE = 0.12
"""Of its colour is left to the oldest place; the rest is the background's."""


class TrailActors:
    """Keeps the lines of a trail in a renderer."""

    def __init__(self, renderer: vtkRenderer) -> None:
        self._renderer = renderer
        self._actors: list[vtkActor] = []
        self._shown: tuple[Trail | None, ScenePalette, float] | None = None

    def show(self, trail: Trail | None, palette: ScenePalette, pixel_ratio: float) -> None:
        """Show a trail; nothing is built where it is the same as before."""
        wanted = (trail, palette, pixel_ratio)
        if wanted == self._shown:
            return
        self._shown = wanted
        for actor in self._actors:
            self._renderer.RemoveActor(actor)
        self._actors.clear()
        if trail is None:
            return
        for places, color, width_px in (
            (trail.commanded, palette.commanded, _COMMANDED_PX),
            (trail.driven, palette.driven, _DRIVEN_PX),
        ):
            points = np.frombuffer(places, np.float32).reshape(-1, 3) * _MM
            if len(points) > 1:
                self._add(_fading(points, color, palette), width_px * pixel_ratio)

    def _add(self, line: pv.PolyData, width_px: float) -> None:
        actor = actor_of(line)
        actor.GetProperty().LightingOff()
        actor.GetProperty().SetLineWidth(width_px)
        actor.PickableOff()
        self._renderer.AddActor(actor)
        self._actors.append(actor)


def _fading(points: np.ndarray, color: str, palette: ScenePalette) -> pv.PolyData:
    line = pv.lines_from_points(points)
    shares = np.linspace(_OLDEST_SHARE, 1.0, len(points))[:, np.newaxis]
    ground, own = np.asarray(rgb(palette.background)), np.asarray(rgb(color))
    line.point_data["color"] = np.round((ground * (1.0 - shares) + own * shares) * 255.0).astype(
        np.uint8
    )
    line.point_data.active_scalars_name = "color"
    return line
