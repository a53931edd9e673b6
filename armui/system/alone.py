"""Keeps other programs of the user from writing a file while this one does (safety S21)."""

from __future__ import annotations

import contextlib
import hashlib
from collections.abc import Iterator
from pathlib import Path
from typing import Final

from filelock import FileLock, Timeout

from armui.system import paths

_LOCK_S: Final = 0.05
"""The longest time for which another program that writes the same file is waited for."""


@contextlib.contextmanager
def alone_with(path: Path) -> Iterator[None]:
    """Lock a file for this program; on a file system without locks, go on without one.

    The system releases the lock of a program that is killed.

    Args:
        path: The file; it need not exist.

    Raises:
        Timeout: Another program is writing it.
    """
    with contextlib.ExitStack() as locked:
        try:
            locked.enter_context(FileLock(lock_path(path), timeout=_LOCK_S))
        except Timeout:
            raise
        except (OSError, NotImplementedError):
            pass  # without locks no other program can be noticed; `presence` reports that
        yield


def lock_path(path: Path) -> Path:
    """Return where programs wait for each other; not beside the file: that folder is not ours.

    Raises:
        OSError: The folder cannot be made, or is another user's.
    """
    folder = paths.runtime()
    paths.make_private(folder)
    name = hashlib.sha256(str(path.absolute()).encode("utf-8", "surrogatepass")).hexdigest()[:16]
    return folder / f"settings-{name}.lock"
