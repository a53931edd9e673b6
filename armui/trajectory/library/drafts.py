"""Unsaved trajectories, kept through a crash: a `.draft` file each, beside the library's files.

A draft is a trajectory in our text format; its header holds the name it belongs to.
"""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Container
from dataclasses import replace
from pathlib import Path
from typing import Final

from armui.system.atomic import sync_folder, write_whole
from armui.trajectory.files import log_file
from armui.trajectory.files.errors import TrajectoryFileError
from armui.trajectory.library.file_names import folded, free_stem
from armui.trajectory.library.index import IndexEntry, Stamp
from armui.trajectory.library.stored_files import (
    Call,
    call_directly,
    entry_by,
    load_by,
    name_inside,
)
from armui.trajectory.points.program import Trajectory

_SUFFIX: Final = ".draft"
_AT_A_STRETCH: Final = 100
"""The lines written before a pause: a millisecond's work."""


class Drafts:
    """The drafts in a folder, by the name of their trajectory.

    Args:
        folder: The folder; it need not exist.
        call: Calls the function that reads a large file.
    """

    def __init__(self, folder: Path, call: Call = call_directly) -> None:
        self._folder = folder
        self._call = call
        self._known: dict[Path, tuple[Stamp, IndexEntry]] = {}

    def paths(self) -> dict[str, Path]:
        """Return the path of each draft by its name; only the files' beginnings are read."""
        found: dict[str, Path] = {}
        for path in sorted(self._folder.glob(f"[!.]*{_SUFFIX}")):
            if path.is_file():
                found.setdefault(name_inside(path), path)
        return found

    def names(self) -> list[str]:
        """Return the names of the trajectories that have a draft."""
        return sorted(self.paths())

    def entries(self, but: Container[str]) -> list[IndexEntry]:
        """Return the drafts' entries for the list; only new or changed drafts are opened.

        Args:
            but: The names to leave out.
        """
        known, self._known = self._known, {}
        for name, path in self.paths().items():
            if name in but:
                continue
            with contextlib.suppress(FileNotFoundError):  # another program has saved it meanwhile
                stamp = Stamp.of(path.stat())
                seen, entry = known.get(path, (None, None))
                if entry is None or seen != stamp:
                    entry = self._entry(name, path, stamp)
                self._known[path] = stamp, entry
        return [entry for _, entry in self._known.values()]

    def _entry(self, name: str, path: Path, stamp: Stamp) -> IndexEntry:
        entry = IndexEntry(name, "draft", 0, None, stamp.changed())
        try:
            read = entry_by(self._call, path, stamp.size)
        except TrajectoryFileError as error:
            return replace(entry, damage=error)
        return replace(entry, count=read.count, note=read.note)

    def save(self, content: Trajectory, rest: Callable[[], object] = lambda: None) -> None:
        """Write a draft in place of the last one of that name.

        Args:
            content: The trajectory to write.
            rest: Called about every millisecond of the work, which takes a tenth of a second for
                10,000 points: a background thread can let others run there.

        Raises:
            OSError: It was not written; the last draft is unchanged.
            UnwritableError: The trajectory cannot be written.
        """
        lines = []
        for count, line in enumerate(log_file.lines(content), start=1):
            lines.append(line)
            if count % _AT_A_STRETCH == 0:
                rest()
        self._folder.mkdir(parents=True, exist_ok=True)
        paths = self.paths()
        path = paths.get(content.name)
        if path is None:
            taken = {folded(other.stem) for other in paths.values()}
            path = self._folder / (free_stem(content.name, taken) + _SUFFIX)
        write_whole(path, "".join(lines).encode())

    def load(self, name: str) -> Trajectory | None:
        """Return the draft of a trajectory, or ``None`` if there is none.

        Raises:
            TrajectoryFileError: It is damaged.
        """
        path = self.paths().get(name)
        if path is None:
            return None
        try:
            size = path.stat().st_size
        except FileNotFoundError:  # another program has saved it meanwhile
            return None
        content = load_by(self._call, path, size)
        return content if isinstance(content, Trajectory) else None

    def copy(self, name: str, new: str) -> None:
        """Copy a draft to another trajectory's name; a damaged one is left alone.

        Raises:
            OSError: It was not written.
        """
        with contextlib.suppress(TrajectoryFileError):
            content = self.load(name)
            if content is not None:
                self.save(replace(content, name=new))

    def drop(self, name: str) -> None:
        """Delete a draft, if there is one.

        Raises:
            OSError: It cannot be deleted.
        """
        path = self.paths().get(name)
        if path is not None:
            path.unlink(missing_ok=True)
            sync_folder(self._folder)


def is_draft(path: Path) -> bool:
    """Return whether a file is a draft, by its suffix."""
    return path.suffix == _SUFFIX
