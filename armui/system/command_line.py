"""What several of the program's commands share."""

from __future__ import annotations

import argparse
import errno
import os
import sys
import textwrap
from collections.abc import Mapping
from typing import Final

_COLUMN: Final = 26
"""Where the help of an option begins, at most."""
_WIDTH: Final = 79


class HelpFormatter(argparse.RawDescriptionHelpFormatter):
    """Wraps help and description; the lists behind them stay as they are laid out."""

    def __init__(self, prog: str) -> None:
        super().__init__(prog, max_help_position=_COLUMN)

    def add_text(self, text: str | None) -> None:
        """Add a text; one of a single paragraph is wrapped."""
        if text is not None and "\n" not in text and text is not argparse.SUPPRESS:
            text = textwrap.fill(text, _WIDTH)
        super().add_text(text)


def name_list(title: str, meanings: Mapping[str, str]) -> str:
    """Return names with what each means, a line each, as argparse lists options.

    Args:
        title: Stands above them.
        meanings: By the names.
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
    """Return whether there is a desktop session to show a window in."""
    system: str = sys.platform
    if system in {"win32", "darwin"} or os.environ.get("QT_QPA_PLATFORM"):
        return True
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))
