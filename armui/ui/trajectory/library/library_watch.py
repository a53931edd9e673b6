"""Notices when another program, or another window of this one, changes the library's folder."""

from __future__ import annotations

from pathlib import Path
from typing import Final

from PySide6.QtCore import QFileSystemWatcher, QObject, QTimer, Signal

_PAUSE_MS: Final = 150
"""A change comes as several: a new file, its renaming, the cache of the list."""


class LibraryWatch(QObject):
    """Follows a folder; where the system reports nothing, as on network disks, it stays silent.

    Args:
        folder: It need not exist.
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

    def follow(self, *, exists: bool) -> None:
        """Make sure that the folder is followed, also one that was made only now."""
        if exists and not self._watcher.directories():
            self._watcher.addPath(str(self._folder))

    def later(self) -> None:
        """Tell of the change in a moment, or once more."""
        self._timer.start()
