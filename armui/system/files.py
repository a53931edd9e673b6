"""Opens all files of the program: regular files only, without blocking on a pipe or device.

Opening a pipe blocks until its other end is opened, perhaps forever; devices and sockets are
unpredictable. All of them are refused, with their kind. These functions still wait for the disk:
while a device is open, only the file thread or another process may call it (safety S2).
"""

from __future__ import annotations

import contextlib
import errno
import os
import stat
from typing import TYPE_CHECKING, Any, BinaryIO, Final, Literal

from armui.system.sentence import Told

if TYPE_CHECKING:
    from pathlib import Path

Mode = Literal["rb", "r+b", "wb", "xb", "x+b", "ab", "a+b"]

_AT_ONCE: Final = getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_NOCTTY", 0)
"""The flags that keep a pipe which takes the file's place meanwhile from blocking; on a regular
file they change nothing.
"""
_KINDS: Final = (
    (stat.S_ISDIR, Told("it is a folder, not a file")),
    (stat.S_ISFIFO, Told("it is a pipe, not a file")),
    (stat.S_ISSOCK, Told("it is a socket, not a file")),
    (stat.S_ISCHR, Told("it is a device, not a file")),
    (stat.S_ISBLK, Told("it is a device, not a file")),
)


class NotAFileError(OSError):
    """The path leads to something that is no regular file."""


def open_file(path: Path | str, mode: Mode = "rb") -> BinaryIO:
    """Open a regular file.

    Args:
        path: The path; links are followed.
        mode: The mode as in Python's ``open``; binary.

    Raises:
        NotAFileError: It is a folder, a pipe, a socket or a device.
        OSError: It cannot be opened.
    """
    # `_opened` checks what was really opened: the path may have changed meanwhile.
    opened: Any = open(path, mode, opener=_opened)  # noqa: SIM115 - the caller closes it
    file: BinaryIO = opened
    return file


NO_STANDARD_INPUT: Final = Told(
    "a file is needed here, not the standard input: keep what comes first, for example with "
    "candump -L can0 > run.log"
)


def is_standard_input(path: Path) -> bool:
    """Return whether a path on the command line means the standard input."""
    return str(path) in {"-", "/dev/stdin", "/dev/fd/0", "/proc/self/fd/0"}


def open_stream(path: Path) -> BinaryIO:
    """Open a file, a pipe or the standard input (``-``) for reading; for commands only.

    A pipe's writer is waited for.

    Raises:
        OSError: It cannot be opened.
    """
    if is_standard_input(path):
        return open(0, "rb", closefd=False)
    return open(path, "rb")  # noqa: PTH123 - as above


def read_file(path: Path | str, most_bytes: int | None = None) -> bytes:
    """Return the bytes of a regular file.

    Args:
        path: The path.
        most_bytes: A larger file is not read.

    Raises:
        NotAFileError: See `open_file`.
        OSError: It cannot be read, or is too large (``EFBIG``).
    """
    with open_file(path) as file:
        data = file.read() if most_bytes is None else file.read(most_bytes + 1)
    if most_bytes is not None and len(data) > most_bytes:
        raise OSError(errno.EFBIG, os.strerror(errno.EFBIG), str(path))
    return data


def check_file(path: Path | str) -> None:
    """Raise an error for a path that must not be passed to a library that opens files by itself.

    Raises:
        NotAFileError: It exists and is no regular file.
        OSError: It cannot be examined.
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
        other = Told("it is something else, not a file")
        kind = next((name for is_it, name in _KINDS if is_it(found.st_mode)), other)
        raise NotAFileError(errno.EINVAL, kind, str(path))


def error_text(error: BaseException) -> Told:
    """Return an error's message, without number and path for errors of the system, or its type."""
    text = getattr(error, "strerror", None) or next(iter(error.args), None)
    if isinstance(text, Told):
        return text
    return Told(getattr(error, "strerror", None) or str(error) or type(error).__name__)


def size_text(count: int) -> str:
    """Return a number of bytes as text: ``999 B``, ``1.5 kB``, ``3.4 MB``, ``1.20 GB``."""
    if count < 1_000:
        return f"{count} B"
    if count < 999_500:  # more would be rounded to 1000 kB
        return f"{count / 1e3:.{1 if count < 9_950 else 0}f} kB"
    return f"{count / 1e6:.1f} MB" if count < 999_950_000 else f"{count / 1e9:.2f} GB"
