"""A window without a screen: opens it safely and reads its pixels.

VTK looks for a way to draw by itself (EGL, X, OSMesa, or Windows' own) and ends the whole process
if it finds none. A host program of an arm must not die of a missing graphics library, so that case
is found out before the first drawing call.
"""

from __future__ import annotations

import ctypes.util
from contextlib import contextmanager
from typing import TYPE_CHECKING, cast

import numpy as np
import pyvista as pv
from numpy.typing import NDArray
from vtkmodules.vtkCommonCore import vtkObject, vtkUnsignedCharArray

from armui.viewport.errors import SceneError

if TYPE_CHECKING:
    from collections.abc import Iterator

    from vtkmodules.vtkRenderingCore import vtkRenderWindow

Pixels = NDArray[np.uint8]


@contextmanager
def _quiet_vtk() -> Iterator[None]:
    """No lines on the terminal while VTK tries one way to draw after the other."""
    before = vtkObject.GetGlobalWarningDisplay()
    vtkObject.SetGlobalWarningDisplay(0)
    try:
        yield
    finally:
        vtkObject.SetGlobalWarningDisplay(before)


class Canvas:
    """An off-screen plotter that can draw.

    Attributes:
        renderer: where actors and lights go.

    Raises:
        SceneError: this computer offers no OpenGL, neither by a graphics driver nor in software.
    """

    def __init__(self, width_px: int, height_px: int) -> None:
        with _quiet_vtk():
            self._plotter = pv.Plotter(
                off_screen=True, window_size=[width_px, height_px], lighting="none"
            )
            self.renderer: pv.Renderer = self._plotter.renderer
            self._window = cast("vtkRenderWindow", self._plotter.render_window)
            if not _can_draw(self._window):
                self.close()
                raise SceneError(
                    "3D picture: this computer offers no OpenGL; install a graphics driver or Mesa "
                    "(on Debian the packages libegl1 and libgl1-mesa-dri)."
                )
        # Eightfold sampling triples the time of a frame where the processor draws it.
        self._window.SetMultiSamples(0)

    @property
    def size_px(self) -> tuple[int, int]:
        """Width and height of the picture."""
        width, height = self._window.GetSize()
        return int(width), int(height)

    def resize(self, width_px: int, height_px: int) -> None:
        """Change the size of the picture."""
        self._window.SetSize(max(width_px, 1), max(height_px, 1))

    def draw(self) -> Pixels:
        """Draw.

        Returns:
            height × width × 4 bytes (red, green, blue, unused), top row first, the caller's own.
        """
        self._window.Render()
        width, height = self._window.GetSize()
        raw = vtkUnsignedCharArray()
        self._window.GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, raw, 0)
        rows: Pixels = np.asarray(raw).reshape(height, width, 4)
        # VTK counts rows from the bottom. The copy frees the picture from VTK's memory.
        return np.ascontiguousarray(rows[::-1])

    def close(self) -> None:
        """Give the graphics memory back."""
        self._plotter.close()


def _can_draw(window: vtkRenderWindow) -> bool:
    is_last_resort = window.GetClassName() == "vtkOSOpenGLRenderWindow"
    if is_last_resort and ctypes.util.find_library("OSMesa") is None:
        return False
    return bool(window.SupportsOpenGL())
