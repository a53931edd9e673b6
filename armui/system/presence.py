"""Which programs of this computer use the same thing: each holds a lock of its own in a folder.

The operating system lets go of the lock of a program that was killed, so nobody is there who is
not. Everything here touches the disk: a thread of its own does it, nobody waits for it.
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
    """One of those who use a thing.

    Args:
        folder: Of that thing, the same for all of them; it need not exist.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._path = folder / f"{os.getpid()}-{os.urandom(4).hex()}{_SUFFIX}"
        self._lock = FileLock(self._path, thread_local=False)

    def enter(self) -> None:
        """Be there from now on.

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
        """Return how many others are there; what killed programs left is removed.

        Raises:
            OSError: The folder cannot be read.
        """
        paths = [path for path in self._folder.glob(f"*{_SUFFIX}") if path != self._path]
        return sum(map(_is_held, paths))

    def leave(self) -> None:
        """Be there no more; harmless if one never was."""
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
    """Is there until it is closed, and tells how many others are.

    Args:
        folder: Of the thing; see :class:`Presence`.
        tell: Called with their number whenever it changes, in a thread of its own; with what is
            wrong where nobody can be met there.
        look_s: How often to look.
    """

    def __init__(
        self, folder: Path, tell: Callable[[int | OSError], None], look_s: float = _LOOK_S
    ) -> None:
        self._presence = Presence(folder)
        self._tell = tell
        self._look_s = look_s
        self._closing = threading.Event()
        self._thread = threading.Thread(target=self._run, name="armui-presence", daemon=True)
        self._thread.start()

    def close(self, wait_s: float = 0.1) -> None:
        """Leave; a disk that does not answer is not waited for."""
        self._closing.set()
        self._thread.join(wait_s)

    def _run(self) -> None:
        before = 0
        try:
            self._presence.enter()
            while not self._closing.is_set():
                now = self._presence.others()
                if now != before and not self._closing.is_set():
                    self._tell(now)
                    before = now
                self._closing.wait(self._look_s)
        except OSError as error:
            if not self._closing.is_set():
                self._tell(error)
        finally:
            self._presence.leave()
