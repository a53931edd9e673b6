"""Writes a file so that a reader finds, at any moment, either the old or the new one, complete.

The new bytes go to a file of another name in the same folder and to the disk; then that file takes
the place of the old one in a single step of the file system, and the folder goes to the disk.
"""

from __future__ import annotations

import contextlib
import errno
import os
import shutil
import sys
import time
from pathlib import Path
from typing import BinaryIO, Final, Self

from armui.system.files import check_file, open_file

UNFINISHED: Final = ".unfinished"
"""The ending of a file that is being written, or was when the program was killed."""

_SCANNER_PAUSES_S: Final = (0.01, 0.02, 0.04, 0.08, 0.15, 0.2)
"""The pauses between attempts while a virus scanner has the file open, half a second in all."""

_MOST_ASIDE: Final = 10
"""The most damaged files of one name that are put aside; a further one replaces the last."""

_ABANDONED_S: Final = 600.0
"""An unfinished file this old is abandoned; a younger one may belong to another running program."""


class WholeFile:
    """A file that gets its name only when it is complete; use it in a ``with`` statement.

    If the block is left by an exception or without `finish`, nothing remains of it.

    Args:
        path: The file's final path; its folder must exist.
        replace: True if a file of this name may be replaced.
        to_disk: True if it must survive a power cut; not needed for files that can be made again.

    Attributes:
        unfinished: Its path until it is finished.
        stream: The stream for its bytes.

    Raises:
        FileExistsError: There is one, and it may not be replaced.
        OSError: The folder does not allow it.
    """

    def __init__(self, path: Path, *, replace: bool = True, to_disk: bool = True) -> None:
        self._path = path
        self._replace = replace
        self._to_disk = to_disk
        if path.is_dir():
            raise _exists(path)
        check_file(path)  # refuse a device or a pipe: the final rename would replace it
        self._check()
        self.unfinished = _unfinished_name(path)
        self.stream: BinaryIO = open_file(self.unfinished, "xb")

    def _check(self) -> None:
        if not self._replace and self._path.exists():
            raise _exists(self._path)

    def finish(self) -> None:
        """Give the complete file its name.

        Raises:
            FileExistsError: A file of this name was created meanwhile.
            OSError: The disk does not take it.
        """
        if not self.stream.closed:
            self.stream.flush()
            if self._to_disk:
                os.fsync(self.stream.fileno())
            self.stream.close()
        self._check()
        written = self.unfinished.stat()
        try:
            replace_file(self.unfinished, self._path)
        except OSError:
            if not self._is_in_place(written):
                raise
        if self._to_disk:
            sync_folder(self._path.parent)

    def _is_in_place(self, written: os.stat_result) -> bool:
        """Return whether the file has its name: a share may have lost its answer only."""
        with contextlib.suppress(OSError):
            return os.path.samestat(self._path.stat(), written)
        return False

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_error: object) -> None:
        with contextlib.suppress(OSError):
            self.stream.close()
        with contextlib.suppress(OSError):
            self.unfinished.unlink(missing_ok=True)


def replace_file(source: Path, target: Path) -> None:
    """Move a file or folder into the place of another one in a single step.

    On Windows that is refused while a virus scanner or an indexer has either open, so it is tried
    again for half a second. Elsewhere a refusal is final.

    Raises:
        OSError: It is refused, or stays refused.
    """
    system: str = sys.platform
    pauses_s = list(_SCANNER_PAUSES_S) if system == "win32" else []
    while True:
        try:
            source.replace(target)
        except PermissionError:
            if not pauses_s:
                raise
            time.sleep(pauses_s.pop(0))
        else:
            return


def _exists(path: Path) -> FileExistsError:
    return FileExistsError(errno.EEXIST, os.strerror(errno.EEXIST), str(path))


def _unfinished_name(path: Path) -> Path:
    """Return a unique temporary name beside a file or folder."""
    return path.with_name(f".{os.urandom(8).hex()}{UNFINISHED}")


def aside_name(path: Path) -> Path:
    """Return the path under which a damaged file is kept, so that its owner can repair it.

    The first ones are not overwritten, because the cause of the damage may be found in them.
    """
    endings = (".broken", *(f".broken{number}" for number in range(2, _MOST_ASIDE + 1)))
    paths = [path.with_name(path.name + ending) for ending in endings]
    return next((each for each in paths if not os.path.lexists(each)), paths[-1])


def write_whole(path: Path, data: bytes, *, to_disk: bool = True) -> None:
    """Write bytes into a file, all or none of them.

    Args:
        path: The file; it need not exist, its folder must.
        data: The bytes.
        to_disk: As of :class:`WholeFile`.

    Raises:
        OSError: It was not written; the old file is unchanged.
    """
    with WholeFile(path, to_disk=to_disk) as whole:
        whole.stream.write(data)
        whole.finish()


def sync_folder(folder: Path) -> None:
    """Have the names in a folder synced to the disk, if the system supports it.

    Windows cannot open folders, and some network file systems lack this: then the change is only as
    durable as the system makes it.
    """
    with contextlib.suppress(OSError):
        handle = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)


def remove_abandoned(folder: Path) -> None:
    """Remove half-written files of killed programs from a folder."""
    oldest = time.time() - _ABANDONED_S
    for path in folder.glob(f".*{UNFINISHED}"):
        with contextlib.suppress(OSError):
            if path.stat().st_mtime < oldest:
                if path.is_dir():
                    shutil.rmtree(path)
                else:
                    path.unlink()


class WholeFolder:
    """A folder of files of one ending, written elsewhere until `finish`; for a ``with`` statement.

    If the block is left by an exception or without `finish`, nothing remains of it.

    Args:
        path: The final path; its parent folder must exist.
        ending: The ending of its files.
        replace: True if a folder of this name may be replaced, provided that it holds no other
            files.

    Attributes:
        unfinished: The folder until then.

    Raises:
        FileExistsError: There is one, and it may not be replaced.
        OSError: There is one with other files in it; or no folder can be made there.
    """

    def __init__(self, path: Path, ending: str, *, replace: bool) -> None:
        self._path = path
        self._ending = ending
        self._replace = replace
        self._check()
        self.unfinished = _unfinished_name(path)
        self.unfinished.mkdir()

    def _check(self) -> None:
        if not os.path.lexists(self._path):
            return
        if not self._replace:
            raise FileExistsError(str(self._path))
        others = [each.name for each in self._path.iterdir() if each.suffix != self._ending]
        if others:
            raise OSError(errno.ENOTEMPTY, f"it holds other files: {others[0]}")

    def finish(self) -> None:
        """Give the complete folder its name.

        Raises:
            FileExistsError: A folder of this name was created meanwhile.
            OSError: The disk does not allow it.
        """
        self._check()
        sync_folder(self.unfinished)
        if self._path.is_dir():
            before = _unfinished_name(self._path)
            replace_file(self._path, before)
            try:
                replace_file(self.unfinished, self._path)
            except OSError:
                replace_file(before, self._path)
                raise
            shutil.rmtree(before, ignore_errors=True)
        else:
            replace_file(self.unfinished, self._path)
        sync_folder(self._path.parent)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_error: object) -> None:
        shutil.rmtree(self.unfinished, ignore_errors=True)
