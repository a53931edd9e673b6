"""Writing a file so that whoever reads it, at any moment, finds the old one or the new one, whole.

The new bytes go to a file of another name in the same folder and to the disk; then that file takes
the place of the old one in a single step of the file system, and the folder goes to the disk.
"""

from __future__ import annotations

import contextlib
import os
import shutil
import time
from pathlib import Path
from typing import Final

UNFINISHED: Final = ".unfinished"
"""How the name of a file ends that is still being written, or was when the program was killed."""

_ABANDONED_S: Final = 600.0
"""A file this old is nobody's: another running program may be writing a younger one."""


def unfinished_name() -> str:
    """A name for a file that is still being written, unlike any other."""
    return f".{os.urandom(8).hex()}{UNFINISHED}"


def write_whole(path: Path, data: bytes, *, to_disk: bool = True) -> None:
    """Put bytes into a file, all or none of them.

    Args:
        path: The file; it need not exist, its folder must.
        data: What it is to hold.
        to_disk: Whether it must outlive a power cut; what can be made anew need not wait for it.

    Raises:
        OSError: It was not written; the old file is as it was.
    """
    fresh = path.with_name(unfinished_name())
    try:
        handle = os.open(fresh, os.O_WRONLY | os.O_CREAT | os.O_EXCL | _BINARY, 0o666)
        with os.fdopen(handle, "wb") as file:
            file.write(data)
            if to_disk:
                file.flush()
                os.fsync(file.fileno())
        fresh.replace(path)
    except OSError:
        with contextlib.suppress(OSError):
            fresh.unlink(missing_ok=True)
        raise
    if to_disk:
        sync_folder(path.parent)


_BINARY: Final[int] = getattr(os, "O_BINARY", 0)
"""Without it Windows rewrites line ends."""


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
