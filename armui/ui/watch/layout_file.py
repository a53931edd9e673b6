"""The file of the operator's own plots, beside the settings."""

from __future__ import annotations

from pathlib import Path
from typing import Final

from armui.system.atomic import write_whole
from armui.system.files import read_file

_MOST_BYTES: Final = 1 << 16
"""A larger file is no layout, and is ignored."""


def path_beside(settings: Path) -> Path:
    """Return the file that goes with a file of settings."""
    return settings.with_name("plots.json")


def read_text(path: Path) -> str:
    """Return its text; "" if it is missing, too large, or no text.

    Waits for a disk.
    """
    try:
        return read_file(path, _MOST_BYTES).decode()
    except (OSError, ValueError):
        return ""


def write_text(path: Path, text: str) -> None:
    """Write its text.

    Waits for a disk.

    Raises:
        OSError: The disk or the folder does not allow it.
    """
    path.parent.mkdir(parents=True, exist_ok=True)  # missing before the first setting is saved
    write_whole(path, text.encode())
