"""Functions shared by several of the program's commands."""

from __future__ import annotations

import argparse
import errno
import os
import sys
import textwrap
from collections.abc import Mapping
from typing import Final

_COLUMN: Final = 26
"""The largest column at which the help of an option begins."""
_WIDTH: Final = 79


class HelpFormatter(argparse.RawDescriptionHelpFormatter):
    """Wraps help and description; the lists after them keep their layout."""

    def __init__(self, prog: str) -> None:
        super().__init__(prog, max_help_position=_COLUMN)

    def add_text(self, text: str | None) -> None:
        """Add a text; one of a single paragraph is wrapped."""
        if text is not None and "\n" not in text and text is not argparse.SUPPRESS:
            text = textwrap.fill(text, _WIDTH)
        super().add_text(text)


def name_list(title: str, meanings: Mapping[str, str]) -> str:
    """Return names with their meanings, a line each, as argparse lists options.

    Args:
        title: The line above them.
        meanings: The meanings by name.
    """
    lines = [f"{title}:"]
    for name, meaning in meanings.items():
        first = f"  {name}".ljust(_COLUMN - 1) + " "
        if len(first) > _COLUMN:
            lines.append(first.rstrip())
            first = " " * _COLUMN
        wrapped = textwrap.wrap(meaning, _WIDTH - _COLUMN)
        lines += [first + wrapped[0], *(" " * _COLUMN + each for each in wrapped[1:])]
    return "\n".join(lines)


def add_device(parser: argparse._ActionsContainer) -> None:
    """Declares the options that name a CAN adapter."""
    parser.add_argument("--interface", help="python-can's name of the adapter, e.g. socketcan")
    parser.add_argument("--channel", help="the adapter's channel, e.g. can0")
    parser.add_argument("--bitrate", type=int, help="bit/s, where the program sets it (1000000)")


def write_out(text: str) -> None:
    """Write to the output without buffering.

    Raises:
        BrokenPipeError: The reader has ended, for example `head`. Windows calls that an invalid
            argument.
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
    """Redirect the closed output, so that the interpreter's last flush does not fail again."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, sys.stdout.fileno())
    os.close(nowhere)


def has_display() -> bool:
    """Return whether there is a desktop session in which to show a window."""
    system: str = sys.platform
    if system in {"win32", "darwin"} or os.environ.get("QT_QPA_PLATFORM"):
        return True
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))
