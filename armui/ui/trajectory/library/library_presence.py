"""Which programs of this computer have the library open: a locked file of each in its folder."""

from __future__ import annotations

import os
import secrets
from pathlib import Path

from PySide6.QtCore import QLockFile


class LibraryPresence:
    """Says that this program is there, and finds the others; used by one thread.

    The lock of a program that was killed counts as nothing and is removed. Programs of other
    computers on a network folder count as long as their file is there.

    Args:
        folder: Of the library; it need not exist.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._name = f".program-{os.getpid()}-{secrets.token_hex(4)}.lock"
        self._lock: QLockFile | None = None

    def others(self) -> tuple[str, ...]:
        """Be there, and tell the others: of each its computer and its process, as a text."""
        if not self._folder.is_dir():
            return ()
        if self._lock is None:
            lock = self._file(self._folder / self._name)
            self._lock = lock if lock.tryLock(0) else None
        found = []
        for path in sorted(self._folder.glob(".program-*.lock")):
            if path.name == self._name or not path.is_file():  # a pipe would be waited for
                continue
            other = self._file(path)
            if other.tryLock(0):  # a killed program's
                other.unlock()
            elif other.error() is QLockFile.LockError.LockFailedError:
                pid, host, _program = other.getLockInfo()[-3:]
                found.append(f"{host}, {pid}")
        return tuple(found)

    def leave(self) -> None:
        """This program uses the library no more."""
        if self._lock is not None:
            self._lock.unlock()
            self._lock = None

    @staticmethod
    def _file(path: Path) -> QLockFile:
        lock = QLockFile(str(path))
        lock.setStaleLockTime(0)  # however long a program runs, it is there
        return lock
