"""Signals, pipes and processes as POSIX has them; a test that asks for them is skipped elsewhere.

Looked up by name at run time: the types of the tests are checked for Windows and macOS as well,
whose modules lack them.
"""

import os
import signal
from pathlib import Path
from typing import Any, Final

import pytest

KILL: Final[signal.Signals] = getattr(signal, "SIGKILL", signal.SIGTERM)
"""Ends a process at once. Python does so on Windows for every signal but the console's two."""
STOP: Final[signal.Signals] = getattr(signal, "SIGSTOP", KILL)
"""Has a process stand still. Whoever sends this or the next two is skipped where there is none."""
CONTINUE: Final[signal.Signals] = getattr(signal, "SIGCONT", KILL)
HANG_UP: Final[signal.Signals] = getattr(signal, "SIGHUP", KILL)


def of_system(name: str, module: Any = os) -> Any:
    """Return what only some systems have; a test that asks elsewhere is skipped."""
    found = getattr(module, name, None)
    if found is None:
        pytest.skip(f"{module.__name__}.{name} is not of this system")
    return found


def kill(pid: int) -> None:
    """End a process at once."""
    os.kill(pid, KILL)


def stand_still(pid: int) -> None:
    """Have a process do nothing from now on; it hears nothing but a kill."""
    os.kill(pid, of_system("SIGSTOP", signal))


def make_pipe(path: Path) -> None:
    """Make a pipe with a name in a folder."""
    of_system("mkfifo")(path)
