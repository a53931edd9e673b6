"""Finds other programs that have the library open: each has a locked file in its folder."""

from __future__ import annotations

import os
import secrets
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Final

from PySide6.QtCore import QLockFile, QObject, Signal
from PySide6.QtWidgets import QWidget
from shiboken6 import isValid

from armui.arm.refusal import Refusal
from armui.control.events import Level
from armui.ui import format as fmt
from armui.ui.background import Background, Job
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.seen_timer import SeenTimer
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
            if path.name == self._name or not path.is_file():  # opening a pipe would block
                continue
            other = self._file(path)
            if other.tryLock(0):  # its program was killed
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
        lock.setStaleLockTime(0)  # age never makes a lock stale: programs run for days
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


_LOOK_MS: Final = 1000
_YOUNG_S: Final = 2.0
"""A second change this soon after one may bear the same time; some file systems count in this."""

FolderTimes = dict[str, int | None]
"""When each folder was changed last, in ns, by its name; ``None``: too recent to be reliable."""


def folder_times(folder: Path, names: Sequence[str]) -> FolderTimes:
    """Return when the library's folder (``""``) and its sub-folders were changed. Waits for a disk.

    Args:
        folder: The library's folder; it need not exist.
        names: The names of its sub-folders.
    """
    return {name: _changed_ns(folder / name) for name in ("", *names)}


def _changed_ns(folder: Path) -> int | None:
    try:
        at_ns = folder.stat().st_mtime_ns
    except OSError:
        return -1
    return None if abs(time.time_ns() - at_ns) < _YOUNG_S * 1e9 else at_ns


class LibraryWatch(QObject):
    """Has the file thread look once a second, while a page is seen, whether folders have changed.

    A network share may hang, so the window's thread must not look; and the operating system does
    not report changes that other computers make on it.

    Args:
        folder: The folder; it need not exist.
        page: The page.
        background: Has the file thread.

    Signals:
        changed: Files have come, gone or been replaced since the content was listed.
    """

    changed = Signal()

    def __init__(self, folder: Path, page: QWidget, background: Background) -> None:
        super().__init__(page)
        self._folder = folder
        self._background = background
        self._names: tuple[str, ...] = ()
        self._listed: FolderTimes = {}
        self._asked: Job[FolderTimes] | None = None
        SeenTimer(page, _LOOK_MS, self._ask)

    def times(self) -> FolderTimes:
        """Return the times to be handed to `on_listed`; called before the content is listed."""
        return folder_times(self._folder, self._names)

    def on_listed(self, times: FolderTimes, names: Sequence[str]) -> None:
        """Compare with these times from now on.

        Args:
            times: What `times` returned.
            names: The names of the sub-folders there are.
        """
        self._listed, self._names = times, tuple(names)

    def _ask(self) -> None:
        if self._asked is None:  # one request at a time: a hanging disk must not collect them
            self._asked = Job(self._on_answer)
            self._background.begin_here(self._asked, folder_times, self._folder, self._names)

    def _on_answer(self, found: FolderTimes | Refusal) -> None:
        self._asked = None
        if isinstance(found, Refusal) or not isValid(self):
            return
        # a change this recent may have been missed by the listing
        if any(at is None or at != self._listed.get(name, at) for name, at in found.items()):
            self.changed.emit()
