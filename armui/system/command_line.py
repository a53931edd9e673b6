"""What several of the program's commands share."""

from __future__ import annotations

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
