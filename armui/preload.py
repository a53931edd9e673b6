"""Loads what windows need beside the GUI thread, before a window is asked for.

The program starts with the least it can; what is loaded when a window is first opened would hold up
that thread, and the stop with it, for up to half a second.
"""

from __future__ import annotations

import pkgutil
import threading
from typing import Any, Final

_PACKAGES: Final = (
    *("armui.arm", "armui.protocol", "armui.trajectory", "armui.bus", "armui.control", "armui.ui"),
)
_OTHERS: Final = ("scipy.spatial.transform", "concurrent.futures.process", "multiprocessing")


def preload() -> None:
    """Import every module of the program's windows, and read the icons."""
    for name in _OTHERS:
        _load(name)
    for package in _PACKAGES:
        for module in pkgutil.walk_packages(_load(package).__path__, f"{package}."):
            _load(module.name)
    _load("armui.ui.widgets.icons").load_all()


def _load(name: str) -> Any:
    """Import a module as an import statement does.

    PySide reads the source of each module when a statement imports it for the first time, even if
    it is loaded already; importlib's own functions would leave that to the GUI thread.
    """
    return __import__(name, fromlist=["__name__"])


def begin() -> None:
    """The same in a thread, which the program does not wait for."""
    threading.Thread(target=preload, name="armui-preload", daemon=True).start()
