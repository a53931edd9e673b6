"""Folders for temporary files; the next program removes those that a killed one left.

A folder's name holds the number of its process, and a check whether that process lives works on
every system. On Windows open files protect themselves, but not the folder of a program that is
about to open more of them.
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
from pathlib import Path
from typing import Any, Final

_NAME: Final = re.compile(r"armui-(?:replay|work)-(?:(\d{1,10})-)?[a-z0-9_]+")
_OLD_S: Final = 600.0
"""A younger folder may belong to a program that has just started."""
_FORGOTTEN_S: Final = 7 * 86_400.0
"""After this time a process number may belong to another process: nobody looks at one log for a
week.
"""
_SYNCHRONIZE: Final = 0x100000
_WAIT_TIMEOUT: Final = 0x102
_ACCESS_DENIED: Final = 5


def make_folder(purpose: str) -> Path:
    """Return a new folder whose name holds its purpose and the number of this process.

    Args:
        purpose: ``replay`` or ``work``.

    Raises:
        OSError: It cannot be created.
    """
    return Path(tempfile.mkdtemp(prefix=f"armui-{purpose}-{os.getpid()}-"))


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


def _is_left(folder: Path) -> bool:
    named = _NAME.fullmatch(folder.name)
    if named is None or folder.is_symlink() or not folder.is_dir():
        return False
    about = folder.stat()
    if hasattr(os, "getuid") and about.st_uid != os.getuid():
        return False
    age_s = time.time() - about.st_mtime
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
        """Tell whether there is a process of this number; where nobody can tell, there is."""
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
        # another user's, or the system's own, is there, and not ours to look at
        return bool(last_error() == _ACCESS_DENIED)
    try:
        # a process that somebody still holds a handle of has its number, also after its end
        return bool(kernel.WaitForSingleObject(ctypes.c_void_p(handle), 0) == _WAIT_TIMEOUT)
    finally:
        kernel.CloseHandle(ctypes.c_void_p(handle))
