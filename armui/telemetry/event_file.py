"""Lines of events in a file that rotates; whoever calls this waits for a disk."""

from __future__ import annotations

import contextlib
from itertools import pairwise
from pathlib import Path
from typing import Final

from armui.system.files import open_file

NAME: Final = "events.jsonl"
_MOST_BYTES: Final = 2_000_000
_OLD_FILES: Final = 4


def append(
    folder: Path, text: str, most_bytes: int = _MOST_BYTES, old_files: int = _OLD_FILES
) -> None:
    """Add lines to the file; when it is full, it makes room for a new one.

    Args:
        folder: It need not exist.
        text: Whole lines.
        most_bytes: A file that is larger becomes ``events.1.jsonl``.
        old_files: So many of those are kept.

    Raises:
        OSError: The disk or the folder does not allow it.
    """
    path = folder / NAME
    folder.mkdir(parents=True, exist_ok=True)
    with open_file(path, "a+b") as file:
        size = file.seek(0, 2)
        torn = False
        if size:
            file.seek(size - 1)
            torn = file.read(1) != b"\n"  # the disk was full in the middle of a line
        data = (b"\n" if torn else b"") + text.encode("utf-8", "replace")
        file.write(data)
        size += len(data)
    if size > most_bytes:
        _rotate(folder, old_files)


def _rotate(folder: Path, old_files: int) -> None:
    names = [NAME, *(f"events.{number}.jsonl" for number in range(1, old_files + 1))]
    for newer, older in reversed(list(pairwise(names))):
        with contextlib.suppress(FileNotFoundError):
            (folder / newer).replace(folder / older)
