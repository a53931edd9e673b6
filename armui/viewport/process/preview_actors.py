"""The path of a trajectory in the picture: a line coloured by speed, and a mark at each point."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv
from vtkmodules.vtkRenderingCore import vtkActor

from armui.viewport.palette import ScenePalette, rgb
from armui.viewport.process.geometry import actor_of

if TYPE_CHECKING:
    from numpy.typing import NDArray
    from vtkmodules.vtkRenderingCore import vtkRenderer

    from armui.viewport.path_picture import PathPicture, Preview

_MM = 0.001
_LINE_PX = 3.0
_MARK_PX = 11.0
_SELECTED_PX = 17.0
_LIT_PX = 23.0
_NEAR_PX = 12.0
"""The distance from a mark at which a click counts as one on it."""


class PreviewActors:
    """The actors of a preview in a renderer."""

    def __init__(self, renderer: vtkRenderer) -> None:
        self._renderer = renderer
        self._actors: list[vtkActor] = []
        self._selected: vtkActor | None = None
        self._lit: tuple[vtkActor, ...] = ()
        self._path: PathPicture | None = None
        self._palette: ScenePalette | None = None
        self._pixel_ratio = 1.0

    def show(self, preview: Preview, palette: ScenePalette, pixel_ratio: float) -> None:
        """Replace the actors of path and marks by those of another preview."""
        for actor in self._actors:
            self._renderer.RemoveActor(actor)
        self._actors.clear()
        path = self._path = preview.path
        self._palette, self._pixel_ratio = palette, pixel_ratio
        if path is not None:
            if len(path.places_mm) > 1:
                self._actors.append(self._add(_line(path, palette), _LINE_PX * pixel_ratio))
            bad = np.isin(path.rows, list(path.bad_rows))
            for which, color in ((~bad, palette.accent), (bad, palette.fault)):
                if which.any():
                    self._actors.append(self._marks(path.marks_mm[which], color, _MARK_PX))
        self.select(preview.selected_row)
        self.light(preview.current_row)

    def select(self, row: int | None) -> None:
        """Make the mark of a row stand out, and no other."""
        if self._selected is not None:
            self._renderer.RemoveActor(self._selected)
            self._selected = None
        path = self._path
        if path is not None and row in path.rows and self._palette is not None:
            place_mm = path.marks_mm[[path.rows.index(row)]]
            self._selected = self._marks(place_mm, self._palette.text, _SELECTED_PX)

    def light(self, row: int | None) -> None:
        """Light the mark of the row to which the arm moves, and no other."""
        for actor in self._lit:
            self._renderer.RemoveActor(actor)
        self._lit = ()
        path, palette = self._path, self._palette
        if path is not None and row in path.rows and palette is not None:
            place_mm = path.marks_mm[[path.rows.index(row)]]
            ring = self._marks(place_mm, palette.current, _LIT_PX)
            self._lit = (ring, self._marks(place_mm, palette.text, _MARK_PX))

    def row_at(self, x_px: float, y_px: float, pixel_ratio: float) -> int | None:
        """Return the row of the mark next to a pixel from the top left, or None."""
        path = self._path
        if path is None or not len(path.rows):
            return None
        away_px = np.hypot(*(self._pixels(path.marks_mm * _MM) - (x_px, y_px)).T)
        nearest = int(away_px.argmin())
        return path.rows[nearest] if away_px[nearest] <= _NEAR_PX * pixel_ratio else None

    def _pixels(self, places_m: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return places in (n, 2) pixels, from the top left; infinite behind the camera."""
        width_px, height_px = self._renderer.GetSize()
        projection = self._renderer.GetActiveCamera().GetCompositeProjectionTransformMatrix(
            self._renderer.GetTiledAspectRatio(), -1.0, 1.0
        )
        matrix = np.array([[projection.GetElement(i, j) for j in range(4)] for i in range(4)])
        seen = np.column_stack((places_m, np.ones(len(places_m)))) @ matrix.T
        ahead = seen[:, 3] > 0.0
        pixels = np.full((len(places_m), 2), np.inf)
        across, up = (seen[ahead, :2] / seen[ahead, 3:]).T
        pixels[ahead, 0] = (across + 1.0) / 2.0 * width_px
        pixels[ahead, 1] = height_px - 1 - (up + 1.0) / 2.0 * height_px
        return pixels

    def _marks(self, places_mm: NDArray[np.float64], color: str, size_px: float) -> vtkActor:
        actor = self._add(pv.PolyData(places_mm * _MM), 1.0)
        appearance = actor.GetProperty()
        appearance.SetColor(*rgb(color))
        appearance.SetPointSize(size_px * self._pixel_ratio)
        appearance.RenderPointsAsSpheresOn()
        return actor

    def _add(self, surface: pv.PolyData, width_px: float) -> vtkActor:
        actor = actor_of(surface)
        appearance = actor.GetProperty()
        appearance.LightingOff()
        appearance.SetLineWidth(width_px)
        actor.PickableOff()
        self._renderer.AddActor(actor)
        return actor


def _line(path: PathPicture, palette: ScenePalette) -> pv.PolyData:
    """Return the path as one line; slow parts in the cold colour, fast ones in the warm."""
    line = pv.lines_from_points(path.places_mm * _MM)
    fastest = float(path.speeds_mm_s.max(initial=0.0)) or 1.0
    shares = (path.speeds_mm_s / fastest)[:, np.newaxis]
    slow, fast = (np.asarray(rgb(color)) for color in palette.speeds)
    line.point_data["color"] = np.round((slow * (1.0 - shares) + fast * shares) * 255.0).astype(
        np.uint8
    )
    line.point_data.active_scalars_name = "color"
    return line
