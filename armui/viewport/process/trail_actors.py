"""Where the tool has been, as a line that fades towards its old end; and where it was sent."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv

from armui.viewport.palette import ScenePalette, rgb
from armui.viewport.process.geometry import actor_of

if TYPE_CHECKING:
    from vtkmodules.vtkRenderingCore import vtkRenderer

    from armui.viewport.path_picture import Trail

_MM = 0.001
_DRIVEN_PX, _COMMANDED_PX = 7.0, 2.0
_OLDEST_SHARE = 0.12
"""Of its colour is left to the oldest place; the rest is the background's."""


class TrailActors:
    """Keeps the lines of a trail in a renderer."""

    def __init__(self, renderer: vtkRenderer) -> None:
        self._driven = _FadingLine(renderer, _DRIVEN_PX)
        self._commanded = _FadingLine(renderer, _COMMANDED_PX)
        self._shown: tuple[Trail | None, ScenePalette, float] | None = None

    def show(self, trail: Trail | None, palette: ScenePalette, pixel_ratio: float) -> None:
        """Show a trail; nothing is done where it is the same as before."""
        wanted = (trail, palette, pixel_ratio)
        if wanted == self._shown:
            return
        self._shown = wanted
        driven, commanded = (b"", b"") if trail is None else (trail.driven, trail.commanded)
        self._commanded.show(commanded, palette.commanded, palette.background, pixel_ratio)
        self._driven.show(driven, palette.driven, palette.background, pixel_ratio)


class _FadingLine:
    """One line; it grows ten times a second, so only its places are put in anew."""

    def __init__(self, renderer: vtkRenderer, width_px: float) -> None:
        self._renderer = renderer
        self._width_px = width_px
        self._line = pv.PolyData()
        self._actor = actor_of(self._line)
        self._actor.GetProperty().LightingOff()
        self._actor.PickableOff()
        self._is_there = False
        self._colors_of: tuple[int, str, str] | None = None

    def show(self, places: bytes, color: str, ground: str, pixel_ratio: float) -> None:
        """Go through places, three 32-bit floats each, mm; fewer than two are no line."""
        points = np.frombuffer(places, np.float32).reshape(-1, 3) * np.float32(_MM)
        is_there = len(points) > 1
        if is_there:
            self._line.points = points
            wanted = (len(points), color, ground)
            if wanted != self._colors_of:
                self._colors_of = wanted
                self._line.lines = np.concatenate(([len(points)], np.arange(len(points))))
                self._line.point_data["color"] = _fading(*wanted)
                self._line.point_data.active_scalars_name = "color"
            self._actor.GetProperty().SetLineWidth(self._width_px * pixel_ratio)
        if is_there != self._is_there:
            self._is_there = is_there
            change = self._renderer.AddActor if is_there else self._renderer.RemoveActor
            change(self._actor)


def _fading(count: int, color: str, ground: str) -> np.ndarray:
    shares = np.linspace(_OLDEST_SHARE, 1.0, count)[:, np.newaxis]
    far, own = np.asarray(rgb(ground)), np.asarray(rgb(color))
    return np.round((far * (1.0 - shares) + own * shares) * 255.0).astype(np.uint8)
