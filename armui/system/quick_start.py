"""What makes the program's start quicker; called before its modules are imported.

PySide looks for the name of a feature of its own in the source text of every module that is
imported after it, the standard library's included: a tenth of the start. No module of this program
uses that feature. And Python looks for garbage again and again among what is only being built.
"""

from __future__ import annotations

import gc
import sys
from types import ModuleType
from typing import Final

_FEATURE: Final = "shibokensupport.feature"
_READS: Final = "_mod_uses_pyside"
"""Internal to PySide 6.11. Where there is none of that name, PySide goes on reading."""


def begin_quickly() -> None:
    """Look for no garbage until :func:`begun`, and have PySide read no sources from now on."""
    gc.disable()
    import PySide6.QtCore  # noqa: F401, PLC0415 - brings what is spoken of here

    feature = sys.modules.get(_FEATURE)
    if hasattr(feature, _READS):
        setattr(feature, _READS, _is_of_this_program)


def begun() -> None:
    """The program stands: what it was built from is no garbage, what comes now may be."""
    gc.freeze()
    gc.enable()


def _is_of_this_program(module: ModuleType) -> bool:
    """Stands for the question whether a module uses PySide."""
    return module.__name__.partition(".")[0] == "armui"
