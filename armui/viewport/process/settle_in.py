"""Makes a new process a good neighbour of the program that has started it."""

from __future__ import annotations

import contextlib
import ctypes
import faulthandler
import os
import signal
import sys
import threading
from collections.abc import Iterator
from multiprocessing import parent_process
from pathlib import Path
from typing import Final

from armui.system.files import open_file, read_file

_NICER_BY: Final = 5
"""The window, the bus and the stop go first where there are too few cores for all."""

_FIRST_TO_GO: Final = b"800"
_PR_SET_PDEATHSIG: Final = 1


def settle_in() -> None:
    """Leave Ctrl-C to the program, do not outlive it, say where a crash was."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    if sys.stderr is not None:
        faulthandler.enable()
    if sys.platform == "linux":
        # where memory runs out, the system ends the picture and not the window
        adjusted = Path("/proc/self/oom_score_adj")
        with contextlib.suppress(OSError), open_file(adjusted, "r+b") as file:
            file.write(_FIRST_TO_GO)
        # also where a driver keeps Python's lock, so that the thread below gets no turn
        with contextlib.suppress(OSError):
            ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGKILL)
    threading.Thread(target=_end_with_the_program, daemon=True).start()


@contextlib.contextmanager
def limited_memory(more_bytes: int) -> Iterator[None]:
    """Let this process take only so much more memory meanwhile; beyond it MemoryError is raised.

    Counted from what it has now, as graphics drivers claim addresses by the gigabyte. Linux only:
    Windows hands out no more than there is, macOS keeps no such limit.
    """
    if sys.platform != "linux":
        yield
    else:
        import resource  # noqa: PLC0415 - not on Windows

        pages = int(read_file("/proc/self/statm").split()[0])
        before, most = resource.getrlimit(resource.RLIMIT_AS)
        limit = pages * resource.getpagesize() + more_bytes
        if before != resource.RLIM_INFINITY:
            limit = min(limit, before)
        resource.setrlimit(resource.RLIMIT_AS, (limit, most))
        try:
            yield
        finally:
            resource.setrlimit(resource.RLIMIT_AS, (before, most))


def stand_back() -> None:
    """Draw behind the others, once the picture stands: to begin with, it is waited for.

    Linux counts it for each thread by itself, and those that a driver has begun, which do most of
    the drawing in software, are no threads of Python's.
    """
    if sys.platform == "linux":
        for thread in Path("/proc/self/task").iterdir():
            with contextlib.suppress(OSError):  # it has just ended
                if os.getpriority(os.PRIO_PROCESS, int(thread.name)) < _NICER_BY:
                    os.setpriority(os.PRIO_PROCESS, int(thread.name), _NICER_BY)
    elif hasattr(os, "nice"):
        os.nice(_NICER_BY)


def _end_with_the_program() -> None:
    program = parent_process()
    if program is not None:
        program.join()
        os._exit(1)
