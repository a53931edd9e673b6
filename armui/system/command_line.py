"""What several of the program's commands share."""

from __future__ import annotations

import errno
import os
import sys
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import argparse


def add_device(parser: argparse.ArgumentParser) -> None:
    """Declares the options that name a CAN adapter."""
    parser.add_argument("--interface", help="python-can's name of the adapter, e.g. socketcan")
    parser.add_argument("--channel", help="the adapter's channel, e.g. can0")
    parser.add_argument("--bitrate", type=int, help="bit/s, where the program sets it (1000000)")


def write_out(text: str) -> None:
    """Write to the output, at once.

    Raises:
        BrokenPipeError: Whoever read it has gone, as `head` that has seen enough. Windows calls
            that an invalid argument.
    """
    try:
        sys.stdout.write(text)
        sys.stdout.flush()
    except OSError as error:
        system: str = sys.platform
        if system == "win32" and error.errno == errno.EINVAL:
            raise BrokenPipeError(errno.EPIPE, os.strerror(errno.EPIPE)) from error
        raise


def detach_output() -> None:
    """Keeps the interpreter from failing once more when it flushes the closed output at its end."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, sys.stdout.fileno())
    os.close(nowhere)


def has_display() -> bool:
    """Tell whether there is a desktop session to show a window in."""
    system: str = sys.platform
    if system in {"win32", "darwin"} or os.environ.get("QT_QPA_PLATFORM"):
        return True
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))
