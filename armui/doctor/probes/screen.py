"""Examines Qt, its system libraries and OpenGL, in processes of their own.

A missing library may end the process instead of raising an exception.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path
from typing import Final

from armui.doctor.facts import ScreenFacts
from armui.system.command_line import has_display
from armui.system.command_process import NO_CONSOLE, this_program

_PATIENCE_S: Final = 30.0
_RENDERER: Final = re.compile(r"OpenGL renderer string:\s*(.+)")
_VERSION: Final = re.compile(r"OpenGL version string:\s*(.+)")
_MISSING: Final = re.compile(r"^\s*(\S+) => not found", re.MULTILINE)
_IN_MESSAGE: Final = re.compile(r"(lib[\w.+-]+\.so[.\d]*): cannot open shared object")
_LAST_WORDS: Final = 400
_QT_LIBRARIES: Final = ("Qt/lib/libQt6Gui.so.6", "Qt/lib/libQt6Widgets.so.6")
_QT_PLATFORMS: Final = ("Qt/plugins/platforms/libqxcb.so",)
_QT_WAYLAND: Final = ("Qt/plugins/platforms/libqwayland.so",)


def probe_qt() -> None:
    """Load Qt and print its facts; runs in a process of its own."""
    import PySide6  # noqa: PLC0415 - may end this process

    _print("qt", PySide6.__version__)
    from PySide6.QtWidgets import QApplication  # noqa: PLC0415 - as above

    _print("platform", QApplication([]).platformName())


def probe_opengl() -> None:
    """Draw a picture and print the graphics driver's facts; runs in a process of its own."""
    import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, PLC0415 - as above; what windows draw with
    from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow  # noqa: PLC0415 - as above

    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(16, 16)
    window.AddRenderer(vtkRenderer())
    window.Render()
    _print(window.ReportCapabilities())


TRIALS: Final = {"qt": probe_qt, "opengl": probe_opengl}
"""The functions that `armui doctor --try` runs in a process of its own, by name."""


def _print(*words: str) -> None:
    sys.stdout.write(" ".join(words) + "\n")
    sys.stdout.flush()  # the next import may end the process


def probe_screen() -> ScreenFacts:
    """Return the facts on the screen; takes some seconds."""
    answers, error = _try("qt")
    words = dict(line.split(" ", 1) for line in answers.splitlines() if " " in line)
    missing = dict.fromkeys([*missing_libraries(), *_IN_MESSAGE.findall(error)])
    opengl, opengl_error = _probe_opengl()
    return ScreenFacts(
        has_display=has_display(),
        qt=words.get("qt"),
        platform=words.get("platform"),
        qt_error=error,
        missing_libraries=tuple(missing),
        opengl=opengl,
        opengl_error=opengl_error,
    )


def _probe_opengl() -> tuple[str | None, str]:
    answers, error = _try("opengl")
    renderer, version = _RENDERER.search(answers), _VERSION.search(answers)
    if renderer is None:
        return None, error or "the picture could not be drawn"
    return f"{renderer.group(1)}, {version.group(1) if version else ''}".strip(", "), ""


def _try(name: str) -> tuple[str, str]:
    """Run one of the trials in a process; return its output, and its last words if it failed."""
    environment = dict(os.environ, PYTHONFAULTHANDLER="")
    if not has_display():
        environment["QT_QPA_PLATFORM"] = "offscreen"
    try:
        done = subprocess.run(  # noqa: S603 - this program itself
            [*this_program(), "doctor", "--try", name],
            capture_output=True,
            timeout=_PATIENCE_S,
            env=environment,
            check=False,
            creationflags=NO_CONSOLE,
        )
    except subprocess.TimeoutExpired as error:
        said = (error.stdout or b"").decode("utf-8", "replace")
        return said, f"no answer within {_PATIENCE_S:.0f} s"
    except OSError as error:
        return "", str(error)
    said = done.stdout.decode("utf-8", "replace")
    if done.returncode == 0:
        return said, ""
    words = done.stderr.decode("utf-8", "replace").strip()
    return said, words[-_LAST_WORDS:] or f"it ended with {done.returncode}"


def missing_libraries() -> list[str]:
    """Return the system libraries that Qt's files need and that are missing; Linux only."""
    ldd = shutil.which("ldd")
    spec = find_spec("PySide6")
    if ldd is None or spec is None or not spec.submodule_search_locations:
        return []
    folder = Path(next(iter(spec.submodule_search_locations)))
    files = [*_QT_LIBRARIES, *_QT_PLATFORMS]
    if os.environ.get("WAYLAND_DISPLAY"):
        files += _QT_WAYLAND
    missing: list[str] = []
    for name in files:
        path = folder / name
        if path.is_file():
            missing += _MISSING.findall(_ldd(ldd, path))
    return list(dict.fromkeys(missing))


def _ldd(ldd: str, path: Path) -> str:
    try:
        done = subprocess.run(  # noqa: S603 - the system's ldd on Qt's own file
            [ldd, str(path)], capture_output=True, timeout=_PATIENCE_S, check=False
        )
    except (OSError, subprocess.TimeoutExpired):
        return ""
    return done.stdout.decode("utf-8", "replace")
