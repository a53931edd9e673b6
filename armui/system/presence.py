"""Counts this computer's programs that use the same thing: each holds a lock in a common folder.

The operating system releases the lock of a program that was killed, so no ended program is counted.
All work on the disk is done by a thread of its own.
"""

from __future__ import annotations

import contextlib
import errno
import os
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Final

from filelock import FileLock, Timeout

from armui.system.paths import make_private

_SUFFIX: Final = ".lock"
_LOOK_S: Final = 1.0


class Presence:
    """The presence of this program among the users of a thing.

    Args:
        folder: The thing's folder, the same for all users; it need not exist.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._path = folder / f"{os.getpid()}-{os.urandom(4).hex()}{_SUFFIX}"
        self._lock = FileLock(self._path, thread_local=False)

    def enter(self) -> None:
        """Register this program.

        Raises:
            OSError: The folder cannot be used.
        """
        make_private(self._folder.parent)
        make_private(self._folder)
        try:
            self._lock.acquire(blocking=False)
        except NotImplementedError as error:  # a file system without locks
            raise OSError(errno.ENOLCK, os.strerror(errno.ENOLCK), str(self._path)) from error

    def others(self) -> int:
        """Return the number of other programs; the files of killed ones are removed.

        Raises:
            OSError: The folder cannot be read.
        """
        paths = [path for path in self._folder.glob(f"*{_SUFFIX}") if path != self._path]
        return sum(map(_is_held, paths))

    def leave(self) -> None:
        """Unregister this program; harmless if it was not registered."""
        with contextlib.suppress(OSError):
            self._lock.release()
            self._path.unlink(missing_ok=True)


def _is_held(path: Path) -> bool:
    lock = FileLock(path, thread_local=False)
    try:
        lock.acquire(blocking=False)
    except Timeout:
        return True
    except OSError:
        return False
    with contextlib.suppress(OSError):
        lock.release()
        path.unlink(missing_ok=True)
    return False


class PresenceWatch:
    """Registers this program until it is closed, and reports the number of others.

    Args:
        folder: The thing's folder; see :class:`Presence`.
        on_count: Called in a thread of its own with their number whenever it changes, or with an
            error if the folder cannot be used.
        look_s: The period of checking.
    """

    def __init__(
        self, folder: Path, on_count: Callable[[int | OSError], None], look_s: float = _LOOK_S
    ) -> None:
        self._presence = Presence(folder)
        self._on_count = on_count
        self._look_s = look_s
        self._closing = threading.Event()
        self._thread = threading.Thread(target=self._run, name="armui-presence", daemon=True)
        self._thread.start()

    def close(self, wait_s: float = 0.1) -> None:
        """Unregister the program, without waiting for a disk that does not answer."""
        self._closing.set()
        self._thread.join(wait_s)

    def _run(self) -> None:
        before = 0
        try:
            self._presence.enter()
            while not self._closing.is_set():
                now = self._presence.others()
                if now != before and not self._closing.is_set():
                    self._on_count(now)
                    before = now
                self._closing.wait(self._look_s)
        except OSError as error:
            if not self._closing.is_set():
                self._on_count(error)
        finally:
            self._presence.leave()
