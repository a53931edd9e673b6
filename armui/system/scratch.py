"""Folders for temporary files; the next program removes those that a killed one left.

In each folder lies a file that its program locks until it ends. The lock is checked first, because
the system may give an ended process's number to another one. Without a lock, in a folder of an
older version or on a file system without locks, the process number in the folder's name is checked.
"""

from __future__ import annotations

import contextlib
import ctypes
import os
import re
import shutil
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from filelock import FileLock, Timeout

_NAME: Final = re.compile(r"armui-(?:replay|work)-(?:(\d{1,10})-)?[a-z0-9_]+")
_OLD_S: Final = 600.0
"""A younger folder may belong to a program that has just started."""
_FORGOTTEN_S: Final = 7 * 86_400.0
"""Without a lock only the age counts from then on: another process may have the number by now."""
_LOCK: Final = "in-use.lock"
"""It lies inside the folder, which other users cannot open: beside it they could place a link."""
_SYNCHRONIZE: Final = 0x100000
_WAIT_TIMEOUT: Final = 0x102
_ACCESS_DENIED: Final = 5


@dataclass(frozen=True, slots=True)
class ScratchFolder:
    """A folder for temporary files, in use as long as this object lives.

    Attributes:
        path: The folder.
        lock: Tells other programs that it is in use; not held on a file system without locks.
    """

    path: Path
    lock: FileLock

    def remove(self) -> None:
        """Remove the folder; if a file in it cannot be removed, the folder stays, and stays locked.

        Windows does not remove open files. The rest is removed by the next call, or by a later
        program.
        """
        with contextlib.suppress(OSError):
            for each in self.path.iterdir():
                if each.name != _LOCK:
                    _remove(each)
            if {each.name for each in self.path.iterdir()} <= {_LOCK}:
                self.lock.release()
                shutil.rmtree(self.path)


def _remove(path: Path) -> None:
    with contextlib.suppress(OSError):
        if path.is_dir() and not path.is_symlink():
            shutil.rmtree(path)
        else:
            path.unlink()


def make_folder(purpose: str) -> ScratchFolder:
    """Return a new folder whose name holds its purpose and the number of this process.

    Args:
        purpose: ``replay`` or ``work``.

    Raises:
        OSError: It cannot be created.
    """
    path = Path(tempfile.mkdtemp(prefix=f"armui-{purpose}-{os.getpid()}-"))
    lock = FileLock(path / _LOCK, thread_local=False)
    # on a file system without locks, the process number in the name is checked instead
    with contextlib.suppress(OSError, NotImplementedError, Timeout):
        lock.acquire(blocking=False)
    return ScratchFolder(path, lock)


def remove_leftovers() -> int:
    """Remove the folders of ended programs, and return their number.

    Only folders of this user with a name by `make_folder` are touched. Waits for a disk.
    """
    removed = 0
    with contextlib.suppress(OSError):
        for folder in Path(tempfile.gettempdir()).glob("armui-*"):
            with contextlib.suppress(OSError):
                if _is_left(folder):
                    shutil.rmtree(folder)
                    removed += 1
    return removed


def _is_held(path: Path) -> bool:
    """Return whether a running program holds a lock; true, too, if that cannot be found out."""
    lock = FileLock(path, thread_local=False)
    try:
        lock.acquire(blocking=False)
    except (OSError, NotImplementedError, Timeout):
        return True
    lock.release()
    return False


def _is_left(folder: Path) -> bool:
    named = _NAME.fullmatch(folder.name)
    if named is None or folder.is_symlink() or not folder.is_dir():
        return False
    about = folder.stat()
    if hasattr(os, "getuid") and about.st_uid != os.getuid():
        return False
    age_s = time.time() - about.st_mtime
    lock = folder / _LOCK
    if lock.is_file():
        return age_s > _OLD_S and not _is_held(lock)
    if named[1] is None or age_s > _FORGOTTEN_S:
        return age_s > _FORGOTTEN_S
    return age_s > _OLD_S and not _is_living(int(named[1]))


if sys.platform == "win32":

    def _is_living(process: int) -> bool:
        kernel = ctypes.WinDLL("kernel32", use_last_error=True)
        kernel.OpenProcess.restype = ctypes.c_void_p
        return lives_on_windows(kernel, process, ctypes.get_last_error)

else:

    def _is_living(process: int) -> bool:
        """Return whether a process of this number exists; true if that cannot be found out."""
        try:
            os.kill(process, 0)
        except ProcessLookupError:
            return False
        except (OSError, OverflowError):
            return True
        return True


def lives_on_windows(kernel: Any, process: int, last_error: Any) -> bool:
    """Return whether a process exists; `os.kill` would end it on Windows.

    Args:
        kernel: The library kernel32.
        process: Its number.
        last_error: Returns the error of the last call.
    """
    handle = kernel.OpenProcess(_SYNCHRONIZE, False, process)
    if not handle:
        # access denied: it exists, but belongs to another user or to the system
        return bool(last_error() == _ACCESS_DENIED)
    try:
        # an ended process keeps its number as long as somebody holds a handle of it
        return bool(kernel.WaitForSingleObject(ctypes.c_void_p(handle), 0) == _WAIT_TIMEOUT)
    finally:
        kernel.CloseHandle(ctypes.c_void_p(handle))
