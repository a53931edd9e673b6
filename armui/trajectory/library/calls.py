"""Which work of the library takes long, and what does it: large files are read elsewhere."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any, Final

from armui.system.atomic import write_whole
from armui.trajectory import files
from armui.trajectory.files import Content
from armui.trajectory.library.index import IndexEntry, entry_of
from armui.trajectory.samples.recording import Recording

Call = Callable[..., Any]
"""Calls a function of a module with its arguments, somewhere, and returns what it returns."""

_LARGE_BYTES: Final = 65536
"""A text of this size is read in a twentieth of a second."""
_LARGE_COUNT: Final = 1000


def call_directly(function: Callable[..., Any], *args: Any) -> Any:
    """Call it here."""
    return function(*args)


def is_large(content: Content) -> bool:
    """Whether writing or checking it takes long."""
    rows = content.samples if isinstance(content, Recording) else content.points
    return len(rows) >= _LARGE_COUNT


def load_by(call: Call, path: Path, size: int) -> Content:
    """What a file holds, read elsewhere if it is large.

    Raises:
        TrajectoryFileError: It is damaged, or gone.
    """
    content: Content = (call if size >= _LARGE_BYTES else call_directly)(files.load, path)
    return content


def entry_by(call: Call, path: Path, size: int) -> IndexEntry:
    """The entry of a file, as `load_by`.

    Raises:
        TrajectoryFileError: It is damaged, or gone.
    """
    entry: IndexEntry = (call if size >= _LARGE_BYTES else call_directly)(read_entry, path)
    return entry


def read_entry(path: Path) -> IndexEntry:
    """The entry of a file.

    Raises:
        TrajectoryFileError: It is damaged, or gone.
    """
    return entry_of(files.load(path))


def write_content(path: Path, content: Content) -> None:
    """Write a file, whole or not at all.

    Raises:
        OSError: It was not written.
        UnwritableError: It is not possible.
    """
    write_whole(path, files.to_bytes(content, path.suffix))
