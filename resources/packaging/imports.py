"""Imports all that the packaged program consists of, and what it is told; packed beside it once.

The build runs it in the folder and takes it out again: a module or library left out by mistake
ends the build, not an operator's work.
"""

import importlib
import pkgutil
import sys
from multiprocessing import freeze_support

if __name__ == "__main__":
    freeze_support()

    import armui

    own = (each.name for each in pkgutil.walk_packages(armui.__path__, "armui."))
    for name in (*(each for each in own if not each.endswith(".__main__")), *sys.argv[1:]):
        importlib.import_module(name)
    sys.stdout.write(f"{len(sys.modules)} modules\n")
