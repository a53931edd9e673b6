"""What makes the program's start quicker; called before its modules are imported.

PySide compiles a dozen modules of its own at every start; that is done once. And it puts a function
of its own in the place of the import statement, which looks for the name of a feature of its own at
every statement, and in the source text of every module imported after it, the standard library's
included: a tenth of the start. No module of this program uses that feature. And Python looks for
garbage again and again among what is only being built.
"""

from __future__ import annotations

import builtins
import gc
from typing import Final

from armui.system.compiled_once import compiled_once

_PYTHONS_OWN: Final = "__orig_import__"
"""Where PySide 6.11 keeps it. Where there is none of that name, PySide goes on looking."""


def begin_quickly() -> None:
    """Look for no garbage until :func:`begun`, and import as Python does from now on."""
    gc.disable()
    with compiled_once():
        import PySide6.QtCore  # noqa: F401, PLC0415 - brings what is spoken of here

    builtins.__import__ = getattr(builtins, _PYTHONS_OWN, builtins.__import__)


def begun() -> None:
    """The program stands: what it was built from is no garbage, what comes now may be."""
    gc.freeze()
    gc.enable()
