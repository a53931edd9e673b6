"""Writing a file so that whoever reads it, at any moment, finds the old one or the new one, whole.

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
"""How the name of a file ends that is still being written, or was when the program was killed."""

_SCANNER_PAUSES_S: Final = (0.01, 0.02, 0.04, 0.08, 0.15, 0.2)
"""Together half a second."""

_ABANDONED_S: Final = 600.0
"""A file this old is nobody's: another running program may be writing a younger one."""


class WholeFile:
    """A file that has its name only when it is whole; use it in a ``with`` statement.

    Left by an exception, or without `finish`, nothing remains of it.

    Args:
        path: The name it shall have; its folder must exist.
        replace: Whether a file of this name may be replaced.
        to_disk: Whether it must outlive a power cut; what can be made anew need not wait for it.
        unfinished: What it is called meanwhile, for whoever may have to remove it after a kill.

    Attributes:
        unfinished: What it is called until then.
        stream: Where its bytes go.

    Raises:
        FileExistsError: There is one, and it may not be replaced.
        OSError: The folder does not allow it.
    """

    def __init__(
        self,
        path: Path,
        *,
        replace: bool = True,
        to_disk: bool = True,
        unfinished: Path | None = None,
    ) -> None:
        self._path = path
        self._replace = replace
        self._to_disk = to_disk
        if path.is_dir():
            raise _exists(path)
        check_file(path)  # a device or a pipe is not replaced
        self._check()
        self.unfinished = unfinished or unfinished_name(path)
        self.stream: BinaryIO = open_file(self.unfinished, "xb")

    def _check(self) -> None:
        if not self._replace and self._path.exists():
            raise _exists(self._path)

    def finish(self) -> None:
        """Everything is written: give it its name.

        Raises:
            FileExistsError: A file of this name has come meanwhile.
            OSError: The disk does not take it.
        """
        if not self.stream.closed:
            self.stream.flush()
            if self._to_disk:
                os.fsync(self.stream.fileno())
            self.stream.close()
        self._check()
        replace_file(self.unfinished, self._path)
        if self._to_disk:
            sync_folder(self._path.parent)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_error: object) -> None:
        with contextlib.suppress(OSError):
            self.stream.close()
        with contextlib.suppress(OSError):
            self.unfinished.unlink(missing_ok=True)


def replace_file(source: Path, target: Path) -> None:
    """Give a file or folder the place of another one in a single step.

    On Windows that is refused while a virus scanner or an index looks at either; they take a
    moment, so it is tried again for half a second. Elsewhere a refusal is meant.

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


def unfinished_name(path: Path) -> Path:
    """Return a name of its own, beside a file or folder, for what is to take its place."""
    return path.with_name(f".{os.urandom(8).hex()}{UNFINISHED}")


def write_whole(path: Path, data: bytes, *, to_disk: bool = True) -> None:
    """Put bytes into a file, all or none of them.

    Args:
        path: The file; it need not exist, its folder must.
        data: What it is to hold.
        to_disk: As of :class:`WholeFile`.

    Raises:
        OSError: It was not written; the old file is as it was.
    """
    with WholeFile(path, to_disk=to_disk) as whole:
        whole.stream.write(data)
        whole.finish()


def sync_folder(folder: Path) -> None:
    """Have the names in a folder written to the disk, where the system lets one ask.

    Windows opens no folders, some network file systems know no such thing: then the change is as
    durable as the system makes it, and it is made all the same.
    """
    with contextlib.suppress(OSError):
        handle = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)


def remove_abandoned(folder: Path) -> None:
    """Remove what killed programs left half written in a folder."""
    oldest = time.time() - _ABANDONED_S
    for path in folder.glob(f".*{UNFINISHED}"):
        with contextlib.suppress(OSError):
            if path.stat().st_mtime < oldest:
                if path.is_dir():
                    shutil.rmtree(path)
                else:
                    path.unlink()


class WholeFolder:
    """Nothing but files of one ending, written elsewhere until `finish`; for a ``with`` statement.

    Left by an exception, or without `finish`, nothing remains of it.

    Args:
        path: The name it shall have; the folder around it must exist.
        ending: Of its files.
        replace: Whether a folder of this name may be replaced, if it holds no other files.

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
        self.unfinished = unfinished_name(path)
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
        """Everything is written: give it its name.

        Raises:
            FileExistsError: A folder of this name has come meanwhile.
            OSError: The disk does not allow it.
        """
        self._check()
        sync_folder(self.unfinished)
        if self._path.is_dir():
            before = unfinished_name(self._path)
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
