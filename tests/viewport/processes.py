"""What a picture's process can be made to run in tests."""

import ctypes.util
import os

from armui.viewport.process import main


def without_opengl(connection) -> None:
    """As on a computer without a graphics driver: VTK's last resort, and no library for it."""
    os.environ["VTK_DEFAULT_OPENGL_WINDOW"] = "vtkOSOpenGLRenderWindow"
    ctypes.util.find_library = lambda _name: None
    main.run(connection)
