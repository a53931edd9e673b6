"""A file that only grows, by whole pieces: one that does not fit leaves no trace."""

from __future__ import annotations

import contextlib
import errno
import os
import threading
import time
from pathlib import Path
from typing import Final

from armui.system.files import open_file

_TO_DISK_S: Final = 5.0
"""How often the system is asked to bring it to the disk: a power cut loses no more."""


class DiskFile:
    """Open for writing; nobody else's file is ever touched.

    Args:
        path: It must not exist.

    Attributes:
        path: As given.
        size: Bytes in it.

    Raises:
        FileExistsError: There is one of this name.
        OSError: It cannot be made.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self.size = 0
        self._file = open_file(path, "xb")
        self._handle = self._file.fileno()  # nothing waits in a buffer
        self._to_disk_s = time.monotonic()
        self._syncing: threading.Thread | None = None
        self._sync_error: OSError | None = None

    def append(self, data: bytes) -> None:
        """Write a piece behind the others.

        Raises:
            OSError: It was not written, or not wholly: then what there is of it is removed.
        """
        try:
            self._check_there()
            self._write(data)
        except OSError:
            with contextlib.suppress(OSError):
                os.ftruncate(self._handle, self.size)
                os.lseek(self._handle, self.size, os.SEEK_SET)
            raise
        self.size += len(data)

    def rewrite(self, data: bytes) -> None:
        """Write anew what stands at the beginning.

        Raises:
            OSError: It was not written.
        """
        os.lseek(self._handle, 0, os.SEEK_SET)
        try:
            self._write(data)
        finally:
            os.lseek(self._handle, self.size, os.SEEK_SET)

    def to_disk(self, *, now: bool = False) -> None:
        """Have the system bring it to the disk now and then, or wait for that now.

        Raises:
            OSError: The disk has failed.
        """
        if now:
            os.fsync(self._handle)
        elif time.monotonic() - self._to_disk_s >= _TO_DISK_S:
            self.begin_to_disk()
        error, self._sync_error = self._sync_error, None
        if error is not None:
            raise error

    def begin_to_disk(self) -> None:
        """Have the system bring it to the disk; what is written meanwhile does not wait.

        A busy disk takes seconds for that: a program killed then would lose them.

        Raises:
            OSError: There are no more handles.
        """
        if self._syncing is not None and self._syncing.is_alive():
            return
        self._to_disk_s = time.monotonic()
        same = os.dup(self._handle)  # it may be closed meanwhile
        self._syncing = threading.Thread(
            target=self._sync, args=(same,), name="armui-to-disk", daemon=True
        )
        self._syncing.start()

    def _sync(self, handle: int) -> None:
        try:
            os.fsync(handle)
        except OSError as error:
            self._sync_error = error
        finally:
            os.close(handle)

    def close(self) -> None:
        """Close it; a disk that is gone changes nothing."""
        with contextlib.suppress(OSError):
            self._file.close()

    def discard(self) -> None:
        """Close it and remove it: it was begun in vain."""
        self.close()
        with contextlib.suppress(OSError):
            self.path.unlink()

    def _write(self, data: bytes) -> None:
        left = memoryview(data)
        while left:
            left = left[os.write(self._handle, left) :]

    def _check_there(self) -> None:
        """A file that was deleted takes bytes without a word, where nobody can read them.

        Raises:
            OSError: It was deleted.
        """
        if os.fstat(self._handle).st_nlink == 0:
            raise OSError(errno.ENOENT, os.strerror(errno.ENOENT), str(self.path))
