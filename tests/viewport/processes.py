"""What a picture's process can be made to run in tests."""

import ctypes.util
import os
import threading

from armui.viewport.process import main, urdf_file


def without_opengl(connection) -> None:
    """As on a computer without a graphics driver: VTK's last resort, and no library for it."""
    os.environ["VTK_DEFAULT_OPENGL_WINDOW"] = "vtkOSOpenGLRenderWindow"
    ctypes.util.find_library = lambda name: None
    main.run(connection)


def endless_loading(connection) -> None:
    """Reading a file called ``endless.urdf`` does not come to an end."""
    load = urdf_file.load_robot

    def load_robot(path):
        if path.name == "endless.urdf":
            threading.Event().wait()
        return load(path)

    urdf_file.load_robot = load_robot
    main.run(connection)


def sleeping(_connection) -> None:
    """Says nothing, and does nothing."""
    threading.Event().wait()
