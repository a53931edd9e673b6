"""Loads what windows need before a window is asked for.

The program starts with the least it can; what is loaded when a window is first opened would hold up
the GUI thread, and the stop with it, for up to half a second.
"""

from __future__ import annotations

import pkgutil
from collections.abc import Iterator
from typing import Any, Final

_PACKAGES: Final = (
    *("armui.arm", "armui.protocol", "armui.trajectory", "armui.bus", "armui.control", "armui.ui"),
)
_OTHERS: Final = (
    "filelock",
    "scipy.spatial.transform",
    "concurrent.futures.process",
    "multiprocessing",
)


def steps() -> Iterator[str]:
    """Import every module of the program's windows, and read the icons; one at each step.

    In the GUI thread, while nothing else happens there: classes of Qt's are made in no other.
    """
    for name in _OTHERS:
        _load(name)
        yield name
    for package in _PACKAGES:
        for module in pkgutil.walk_packages(_load(package).__path__, f"{package}."):
            _load(module.name)
            yield module.name
    _load("armui.ui.widgets.icons").load_all()
    yield "icons"


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
