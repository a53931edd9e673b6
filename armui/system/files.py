"""The one place where files are opened: regular files only, and never by waiting for anybody.

Opening a pipe waits until somebody opens its other end, which may be never; a device or a socket
does whatever it does. Each is refused here as what it is. Everything here still waits for the disk:
while a device is open, only the file thread or another process may call it (safety S2).
"""

from __future__ import annotations

import contextlib
import errno
import os
import stat
from typing import TYPE_CHECKING, Any, BinaryIO, Final, Literal

if TYPE_CHECKING:
    from pathlib import Path

Mode = Literal["rb", "r+b", "wb", "xb", "x+b", "ab", "a+b"]

_AT_ONCE: Final = getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_NOCTTY", 0)
"""A pipe that takes the file's place between two looks is not waited for either; on a regular file
these change nothing."""
_KINDS: Final = (
    (stat.S_ISDIR, "a folder"),
    (stat.S_ISFIFO, "a pipe"),
    (stat.S_ISSOCK, "a socket"),
    (stat.S_ISCHR, "a device"),
    (stat.S_ISBLK, "a device"),
)


class NotAFileError(OSError):
    """There is something at a path that is no regular file."""


def open_file(path: Path | str, mode: Mode = "rb") -> BinaryIO:
    """Open a regular file.

    Args:
        path: Where it is; a link is followed.
        mode: As of Python's ``open``; binary.

    Raises:
        NotAFileError: It is a folder, a pipe, a socket or a device.
        OSError: It cannot be opened.
    """
    # the last word on what was opened is _opened's
    opened: Any = open(path, mode, opener=_opened)  # noqa: SIM115 - handed on; the one place
    file: BinaryIO = opened
    return file


def open_stream(path: Path) -> BinaryIO:
    """Open a file or a pipe to read from, waiting for whoever feeds it; for commands only.

    Raises:
        OSError: It cannot be opened.
    """
    return open(path, "rb")  # noqa: PTH123 - as above


def read_file(path: Path | str, most_bytes: int | None = None) -> bytes:
    """Return the bytes of a regular file.

    Args:
        path: Where it is.
        most_bytes: A file that has more is not read.

    Raises:
        NotAFileError: As of `open_file`.
        OSError: It cannot be read, or is too large (``EFBIG``).
    """
    with open_file(path) as file:
        data = file.read() if most_bytes is None else file.read(most_bytes + 1)
    if most_bytes is not None and len(data) > most_bytes:
        raise OSError(errno.EFBIG, os.strerror(errno.EFBIG), str(path))
    return data


def check_file(path: Path | str) -> None:
    """Refuse what a library that opens paths by itself must not be given.

    Raises:
        NotAFileError: It is there, and no regular file.
        OSError: It cannot be looked at.
    """
    with contextlib.suppress(FileNotFoundError):
        _check(os.stat(path), path)  # noqa: PTH116 - no pathlib for the first file of the start


def _opened(path: Any, flags: int) -> int:
    check_file(path)
    handle = os.open(path, flags | _AT_ONCE, 0o666)
    try:
        _check(os.fstat(handle), path)
    except BaseException:
        os.close(handle)
        raise
    return handle


def _check(found: os.stat_result, path: Any) -> None:
    if not stat.S_ISREG(found.st_mode):
        kind = next((name for is_it, name in _KINDS if is_it(found.st_mode)), "something else")
        raise NotAFileError(errno.EINVAL, f"it is {kind}, not a file", str(path))


def error_text(error: BaseException) -> str:
    """Of the system's errors its words without number and path, of others theirs, or the kind."""
    return getattr(error, "strerror", None) or str(error) or type(error).__name__
