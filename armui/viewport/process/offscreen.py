"""A window without a screen: opens it safely and reads its pixels.

VTK chooses a way to draw by itself (EGL, X, OSMesa, or Windows' own) and ends the whole process if
it finds none. So this is checked before the first drawing call.

Windows, actors and lights are VTK's own, not those of pyvista's plotter: that takes 0.7 s to
import, most of it for charts and matplotlib, which this picture does not need.
"""

from __future__ import annotations

import ctypes.util
from collections.abc import Iterator
from contextlib import contextmanager

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 - registers VTK's OpenGL implementations
from numpy.typing import NDArray
from vtkmodules.vtkCommonCore import vtkObject, vtkUnsignedCharArray
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

from armui.viewport.messages import NO_OPENGL, SceneError


class Pixels:
    """An image as VTK has it: red, green, blue and an unused byte, the bottom row first.

    Args:
        rows: height × width × 4 bytes; VTK's memory, valid until the next image is drawn.
    """

    def __init__(self, rows: NDArray[np.uint8]) -> None:
        self._rows = rows

    @property
    def size_px(self) -> tuple[int, int]:
        """Width and height."""
        height, width, _ = self._rows.shape
        return width, height

    @property
    def nbytes(self) -> int:
        """The number of bytes of a copy."""
        return self._rows.nbytes

    def top_down(self) -> NDArray[np.uint8]:
        """Return a copy: height × width × 4 bytes (red, green, blue, unused), the top row first."""
        return np.ascontiguousarray(self._rows[::-1])

    def copy_to(self, target: memoryview) -> tuple[int, int]:
        """Write a copy in the windows' format: blue, green, red, unused, the top row first.

        Args:
            target: `nbytes` bytes.

        Returns:
            Width and height.
        """
        width, height = self.size_px
        words = self._rows.view("<u4").reshape(height, width)[::-1]
        out = np.frombuffer(target, "<u4").reshape(height, width)
        np.left_shift(words & 0xFF, 16, out=out)
        out |= words & 0xFF00
        out |= (words >> 16) & 0xFF
        return width, height


@contextmanager
def _quiet_vtk() -> Iterator[None]:
    """Silence VTK's warnings, which each way to draw that fails would print on the terminal."""
    before = vtkObject.GetGlobalWarningDisplay()
    vtkObject.SetGlobalWarningDisplay(0)
    try:
        yield
    finally:
        vtkObject.SetGlobalWarningDisplay(before)


class Canvas:
    """An off-screen window for drawing.

    Attributes:
        renderer: where actors and lights go.

    Raises:
        SceneError: this computer offers no OpenGL, neither by a graphics driver nor in software.
    """

    def __init__(self, width_px: int, height_px: int) -> None:
        self.renderer = vtkRenderer()
        with _quiet_vtk():
            self._window = vtkRenderWindow()
            self._window.OffScreenRenderingOn()
            self._window.SetSize(width_px, height_px)
            if not _can_draw(self._window):
                raise SceneError(NO_OPENGL)
        self._window.AddRenderer(self.renderer)
        # Eightfold sampling triples the time of a frame where the processor draws it.
        self._window.SetMultiSamples(0)
        self._raw = vtkUnsignedCharArray()

    @property
    def size_px(self) -> tuple[int, int]:
        """Width and height of the picture."""
        width, height = self._window.GetSize()
        return int(width), int(height)

    def resize(self, width_px: int, height_px: int) -> None:
        """Change the size of the picture."""
        self._window.SetSize(max(width_px, 1), max(height_px, 1))

    def draw(self) -> Pixels:
        """Draw the picture.

        Returns:
            The image, valid until the next one is drawn.
        """
        self._window.Render()
        width, height = self._window.GetSize()
        self._window.GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, self._raw, 0)
        return Pixels(np.asarray(self._raw).reshape(height, width, 4))

    def close(self) -> None:
        """Free the graphics memory."""
        self._window.Finalize()


def _can_draw(window: vtkRenderWindow) -> bool:
    is_last_resort = window.GetClassName() == "vtkOSOpenGLRenderWindow"
    if is_last_resort and ctypes.util.find_library("OSMesa") is None:
        return False
    return bool(window.SupportsOpenGL())
