"""Loads what windows need before a window is asked for.

The program starts with the least it can; what is loaded when a window is first opened would hold up
the GUI thread, and the stop with it, for up to half a second.
"""

from __future__ import annotations

import pkgutil
from collections.abc import Iterator
from typing import Any, Final

_PACKAGES: Final = (
    *(
        "armui.arm",
        "armui.kinematics",
        "armui.protocol",
        "armui.session.recording",
        "armui.telemetry",
        "armui.trajectory",
        "armui.bus",
        "armui.control",
        "armui.ui",
    ),
)
_OTHERS: Final = (
    *("filelock", "scipy.spatial.transform", "concurrent.futures.process", "multiprocessing"),
    *("PySide6.QtOpenGLWidgets", "PySide6.QtSvg", "PySide6.QtTest"),
)
_QT: Final = ("PySide6.QtCore", "PySide6.QtGui", "PySide6.QtWidgets")
_CLASSES_AT_ONCE: Final = 60
"""PySide makes each class when it is first asked for, and pyqtgraph asks for all of them."""


def steps() -> Iterator[str]:
    """Import every module of the program's windows, and read the icons; one at each step.

    In the GUI thread, while nothing else happens there: classes of Qt's are made in no other.
    """
    for name in _OTHERS:
        _load(name)
        yield name
    yield from _make_classes()
    for package in _PACKAGES:
        for module in pkgutil.walk_packages(_load(package).__path__, f"{package}."):
            _load(module.name)
            yield module.name
    _load("armui.ui.widgets.icons").load_all()
    yield "icons"


def _make_classes() -> Iterator[str]:
    """Have Qt's classes made, some at each step: all at once they take a tenth of a second."""
    for module in _QT:
        names = dir(_load(module))
        for first in range(0, len(names), _CLASSES_AT_ONCE):
            for name in names[first : first + _CLASSES_AT_ONCE]:
                getattr(_load(module), name, None)
            yield f"{module} {first}"
    _load("pyqtgraph")
    yield "pyqtgraph"


def preload() -> None:
    """All of it at once."""
    for _name in steps():
        pass


def _load(name: str) -> Any:
    """Import a module as an import statement does.

    PySide reads the source of each module when a statement imports it for the first time, even if
    it is loaded already; importlib's own functions would leave that to the GUI thread.
    """
    return __import__(name, fromlist=["__name__"])
