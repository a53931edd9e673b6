"""Who uses a library's files: one thread at a time."""

from __future__ import annotations

import errno
import os
from collections.abc import Callable
from typing import TypeVar

from armui.trajectory.library.store import LIBRARY_UNREADABLE, Library, LibraryError

Result = TypeVar("Result")


def take_turn(library: Library, action: Callable[[], Result]) -> Result:
    """Return the result of an action on a library's files.

    Raises:
        LibraryError: Another thread is at them, which waits for a disk that does not answer; or the
            action raises it.
        TrajectoryFileError: The action raises it.
    """
    if not library.turn.acquire(blocking=False):
        figures = {"name": str(library.folder), "text": os.strerror(errno.ETIMEDOUT)}
        raise LibraryError(LIBRARY_UNREADABLE(**figures))
    try:
        return action()
    finally:
        library.turn.release()
