"""The path of a trajectory in the picture: a line coloured by speed, and a mark at each point."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv
from vtkmodules.vtkRenderingCore import vtkActor, vtkCoordinate

from armui.viewport.geometry import actor_of
from armui.viewport.palette import ScenePalette, rgb

if TYPE_CHECKING:
    from numpy.typing import NDArray
    from vtkmodules.vtkRenderingCore import vtkRenderer

    from armui.viewport.path_picture import PathPicture, Preview

_MM = 0.001
_LINE_PX = 3.0
_MARK_PX = 11.0
_SELECTED_PX = 17.0
_NEAR_PX = 12.0
"""How near to a mark a click counts as one on it."""


class PreviewActors:
    """Keeps the actors of a preview in a renderer."""

    def __init__(self, renderer: vtkRenderer) -> None:
        self._renderer = renderer
        self._actors: list[vtkActor] = []
        self._path: PathPicture | None = None

    def show(self, preview: Preview, palette: ScenePalette, pixel_ratio: float) -> None:
        """Build the actors anew; a path is small beside the arm."""
        for actor in self._actors:
            self._renderer.RemoveActor(actor)
        self._actors.clear()
        path = self._path = preview.path
        if path is None:
            return
        if len(path.places_mm) > 1:
            self._add(_line(path, palette), _LINE_PX * pixel_ratio)
        plain: list[int] = []
        bad: list[int] = []
        selected: list[int] = []
        for index, row in enumerate(path.rows):
            if row == preview.selected_row:
                selected.append(index)
            (bad if row in path.bad_rows else plain).append(index)
        for indices, color, size_px in (
            (plain, palette.accent, _MARK_PX),
            (bad, palette.fault, _MARK_PX),
            (selected, palette.text, _SELECTED_PX),
        ):
            if indices:
                actor = self._add(pv.PolyData(path.marks_mm[indices] * _MM), 1.0)
                look = actor.GetProperty()
                look.SetColor(*rgb(color))
                look.SetPointSize(size_px * pixel_ratio)
                look.RenderPointsAsSpheresOn()

    def row_at(self, x_px: float, y_px: float, pixel_ratio: float) -> int | None:
        """The row of the mark next to a pixel, counted from the top left; None: there is none."""
        path = self._path
        if path is None or not len(path.rows):
            return None
        away_px = np.hypot(*(self._pixels(path.marks_mm * _MM) - (x_px, y_px)).T)
        nearest = int(away_px.argmin())
        return path.rows[nearest] if away_px[nearest] <= _NEAR_PX * pixel_ratio else None

    def _pixels(self, places_m: NDArray[np.float64]) -> NDArray[np.float64]:
        """(n, 2) where places are in the picture, from its top left."""
        _, height_px = self._renderer.GetSize()
        coordinate = vtkCoordinate()
        coordinate.SetCoordinateSystemToWorld()
        pixels = np.empty((len(places_m), 2))
        for index, place in enumerate(places_m):
            coordinate.SetValue(*(float(part) for part in place))
            x_px, y_px = coordinate.GetComputedDoubleDisplayValue(self._renderer)
            pixels[index] = x_px, height_px - 1 - y_px
        return pixels

    def _add(self, surface: pv.PolyData, width_px: float) -> vtkActor:
        actor = actor_of(surface)
        look = actor.GetProperty()
        look.LightingOff()
        look.SetLineWidth(width_px)
        actor.PickableOff()
        self._renderer.AddActor(actor)
        self._actors.append(actor)
        return actor


def _line(path: PathPicture, palette: ScenePalette) -> pv.PolyData:
    """The path as one line; slow parts take the theme's cold colour, fast ones the warm one."""
    line = pv.lines_from_points(path.places_mm * _MM)
    fastest = float(path.speeds_mm_s.max(initial=0.0)) or 1.0
    shares = (path.speeds_mm_s / fastest)[:, np.newaxis]
    slow, fast = (np.asarray(rgb(color)) for color in palette.speeds)
    line.point_data["color"] = np.round((slow * (1.0 - shares) + fast * shares) * 255.0).astype(
        np.uint8
    )
    line.point_data.active_scalars_name = "color"
    return line
