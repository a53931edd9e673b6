"""Finds other programs that have the library open: each has a locked file in its folder."""

from __future__ import annotations

import os
import secrets
from collections.abc import Sequence
from pathlib import Path
from typing import Final

from PySide6.QtCore import QFileSystemWatcher, QLockFile, QObject, QTimer, Signal

from armui.control.events import Level
from armui.ui import format as fmt
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.translated import Translated


class LibraryPresence:
    """Registers this program, and finds the others; used by one thread.

    The file of a killed program is ignored and removed. Programs of other computers on a network
    folder count as long as their file is there.

    Args:
        folder: The library's folder; it need not exist.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._name = f".program-{os.getpid()}-{secrets.token_hex(4)}.lock"
        self._lock: QLockFile | None = None

    def others(self) -> tuple[str, ...]:
        """Register this program, and return computer and process of each other one as a text."""
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
        """Unregister this program."""
        if self._lock is not None:
            self._lock.unlock()
            self._lock = None

    @staticmethod
    def _file(path: Path) -> QLockFile:
        lock = QLockFile(str(path))
        lock.setStaleLockTime(0)  # however long a program runs, it is there
        return lock


class SharedUseBanner(Translated, MessageLine):
    """A message shown while another copy of the program uses the library."""

    def __init__(self) -> None:
        super().__init__()
        self._others: Sequence[str] = ()
        self.setObjectName("library_shared_use")
        self.hide()

    def show_others(self, others: Sequence[str]) -> None:
        """Name the other programs, each by its computer and process."""
        if tuple(others) != tuple(self._others):
            self._others = tuple(others)
            self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.setVisible(bool(self._others))
        if not self._others:
            self.show_message("")
            return
        text = self.tr(
            "Another program has this library open, too ({names}). What it saves appears in this "
            "list. Do not edit the same trajectory in both."
        )
        self.show_message(text.format(names=fmt.name_list(list(self._others))), Level.WARNING)


_PAUSE_MS: Final = 150
"""The delay that collects several changes: a new file, its renaming, the cache of the list."""


class LibraryWatch(QObject):
    """Watches a folder; on network disks, where the system reports nothing, it stays silent.

    Args:
        folder: The folder; it need not exist.
        parent: Its owner.

    Signals:
        changed: Files have come, gone or been replaced.
    """

    changed = Signal()

    def __init__(self, folder: Path, parent: QObject) -> None:
        super().__init__(parent)
        self._folder = folder
        self._watcher = QFileSystemWatcher(self)
        self._timer = QTimer(self, singleShot=True, interval=_PAUSE_MS)
        self._timer.timeout.connect(self.changed)
        self._watcher.directoryChanged.connect(lambda _path: self.later())

    def follow(self, *, exists: bool, folders: Sequence[str] = ()) -> None:
        """Start watching the folder and its sub-folders, also those that were created only now.

        Args:
            exists: Whether the folder is there.
            folders: The names of its sub-folders.
        """
        wanted = {str(self._folder / name) for name in ("", *folders)} if exists else set()
        known = set(self._watcher.directories())
        if known - wanted:
            self._watcher.removePaths(sorted(known - wanted))
        if wanted - known:
            self._watcher.addPaths(sorted(wanted - known))

    def later(self) -> None:
        """Emit the change in a moment, starting the delay again."""
        self._timer.start()
