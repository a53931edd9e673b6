"""The files of the library on the disk, and the content of each."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Final

from armui.system.atomic import write_whole
from armui.trajectory import files
from armui.trajectory.files import Content, TrajectoryFileError
from armui.trajectory.library.file_names import file_stem
from armui.trajectory.library.folders import Folders, shown_folder
from armui.trajectory.library.index import Index, IndexEntry, Stamp, entry_of
from armui.trajectory.points.program import LONGEST_NAME
from armui.trajectory.samples.recording import Recording

Call = Callable[..., Any]
"""Calls a function of a module with its arguments, here or elsewhere, and returns its result."""

_LARGE_BYTES: Final = 65536
"""A text of this size takes a twentieth of a second to read."""
_LARGE_COUNT: Final = 1000

_SUFFIXES: Final = (".log", ".npz")
_INDEX: Final = ".index.json"
_ROOM_FOR_NUMBER: Final = 8
_UNKNOWN: Final = Stamp(0, 0, 0)
"""The stamp of a file that cannot be looked at."""


def call_directly(function: Callable[..., Any], *args: Any) -> Any:
    """Call the function in this thread."""
    return function(*args)


def is_large(content: Content) -> bool:
    """Return whether writing or checking a content takes long."""
    rows = content.samples if isinstance(content, Recording) else content.points
    return len(rows) >= _LARGE_COUNT


def load_by(call: Call, path: Path, size: int) -> Content:
    """Return the content of a file; a large one is read through `call`.

    Raises:
        TrajectoryFileError: It is damaged, or gone.
    """
    content: Content = (call if size >= _LARGE_BYTES else call_directly)(files.load, path)
    return content


def entry_by(call: Call, path: Path, size: int) -> IndexEntry:
    """Return the entry of a file; a large one is read through `call`.

    Raises:
        TrajectoryFileError: It is damaged, or gone.
    """
    entry: IndexEntry = (call if size >= _LARGE_BYTES else call_directly)(read_entry, path)
    return entry


def read_entry(path: Path) -> IndexEntry:
    """Return the entry of a file.

    Raises:
        TrajectoryFileError: It is damaged, or gone.
    """
    return entry_of(files.load(path))


def write_content(path: Path, content: Content) -> None:
    """Write a file completely or not at all.

    Raises:
        OSError: It was not written.
        UnwritableError: The content cannot be written.
    """
    write_whole(path, files.to_bytes(content, path.suffix))


@dataclass(frozen=True, slots=True)
class StoredFile:
    """A file of the library with its stamp and its entry."""

    path: Path
    stamp: Stamp
    entry: IndexEntry


class FileStore:
    """The files in a folder and its sub-folders, by the name of their content.

    Args:
        folder: The folder; it need not exist.
        call: Calls the function that reads a large file.

    Attributes:
        folders: The sub-folders that were there at the last scan, sorted.
        closed: Those of them that could not be read.
    """

    def __init__(self, folder: Path, call: Call = call_directly) -> None:
        self._folder = folder
        self._call = call
        self._index = Index(folder / _INDEX)
        self._subfolders = Folders(folder)
        self.folders: tuple[str, ...] = ()
        self.closed: tuple[str, ...] = ()

    def scan(self) -> dict[str, StoredFile]:
        """Return all files by name; only new or changed ones are opened.

        Raises:
            OSError: The folder cannot be read.
        """
        self._index.follow()
        files = (self._stored_file(path, stamp) for path, stamp in self._all_files())
        found = [kept for kept in files if kept is not None]
        self._index.keep_only([self._key(kept.path) for kept in found], self.closed)
        self._index.save()
        return _by_name(found)

    def note(self, path: Path, entry: IndexEntry) -> Stamp:
        """Store the entry of a file that was just written, and return its stamp.

        Raises:
            OSError: It is gone.
        """
        stamp = Stamp.of(path.stat())
        self._index.put(self._key(path), stamp, entry)
        self._index.save()
        return stamp

    def note_moved(self, moves: Iterable[tuple[Path, Path]]) -> None:
        """Move the entries of files that were moved.

        Args:
            moves: The old and the new path of each.
        """
        for old, new in moves:
            with contextlib.suppress(FileNotFoundError):  # another program has deleted it meanwhile
                self._index.move(self._key(old), self._key(new), Stamp.of(new.stat()))
        self._index.save()

    def mark(self, kept: StoredFile, entry: IndexEntry) -> None:
        """Store a new entry for a file, valid only if the file is as it was at the scan."""
        self.mark_all([(kept, entry)])

    def mark_all(self, marked: Iterable[tuple[StoredFile, IndexEntry]]) -> None:
        """Take over what was found out about files, as `mark`; written once."""
        for kept, entry in marked:
            self._index.put(self._key(kept.path), kept.stamp, entry)
        self._index.save()

    def _key(self, path: Path) -> str:
        return path.relative_to(self._folder).as_posix()

    def _all_files(self) -> list[tuple[Path, Stamp]]:
        """Return the files of every folder; a sub-folder that cannot be read hides no other."""
        self.folders, self.closed = (), ()
        if not self._folder.is_dir():
            return []
        found = list(_files(self._folder))
        folders = []
        for name in self._subfolders.names():
            try:
                found += list(_files(self._folder / name))
            except (FileNotFoundError, NotADirectoryError):
                continue  # gone, or renamed meanwhile
            except OSError:  # no rights, a bad disk, a share that is gone
                self.closed = (*self.closed, name)
            folders.append(name)
        self.folders = tuple(folders)
        return found

    def _stored_file(self, path: Path, stamp: Stamp) -> StoredFile | None:
        """Return the entry of a file, which is opened only if it is new or has changed."""
        key = self._key(path)
        entry = self._index.entry(key, stamp)
        if entry is None:
            try:
                entry = entry_by(self._call, path, stamp.size)
            except TrajectoryFileError as error:
                if _is_gone(path):  # another program has deleted it meanwhile
                    return None
                kind: Final = "points" if path.suffix == ".log" else "recording"
                name = self._index.last_name(key) or _name_of(path)
                entry = IndexEntry(name, kind, 0, None, stamp.changed(), damage=error)
            self._index.put(key, stamp, entry)
        folder = key.rpartition("/")[0]
        if entry.folder != folder:
            entry = replace(entry, folder=folder)
        return StoredFile(path, stamp, entry)


def _files(folder: Path) -> Iterator[tuple[Path, Stamp]]:
    """Find the trajectories in one folder, with their stamps.

    Raises:
        OSError: The folder cannot be read.
    """
    with os.scandir(folder) as items:
        for item in items:
            if item.name.startswith(".") or not item.name.endswith(_SUFFIXES):
                continue
            try:
                if item.is_file():
                    yield Path(item.path), Stamp.of(Path(item.path).stat())
            except FileNotFoundError:
                continue  # another program has deleted it
            except OSError:  # listed as unreadable
                yield Path(item.path), _UNKNOWN


def _is_gone(path: Path) -> bool:
    try:
        path.lstat()
    except FileNotFoundError:
        return True
    except OSError:
        return False
    return False


def _by_name(found: list[StoredFile]) -> dict[str, StoredFile]:
    """Return the files by name; a copy with a name already taken goes by its file's name.

    One in a sub-folder has the folder's name appended. Files directly in the library's folder come
    first.
    """
    named: dict[str, StoredFile] = {}
    found = sorted(
        found,
        key=lambda kept: (
            kept.path.stem != file_stem(kept.entry.name),
            kept.entry.folder,
            kept.path,
        ),
    )
    for kept in found:
        name, number = kept.entry.name, 1
        if name in named:
            name = stem = _copy_name(kept)
            while name in named:
                number += 1
                name = f"{stem} {number}"
        entry = kept.entry if name == kept.entry.name else replace(kept.entry, name=name)
        named[name] = replace(kept, entry=entry)
    return named


def _copy_name(kept: StoredFile) -> str:
    """Return a name for a copy whose own name is taken."""
    if not kept.entry.folder:
        return _name_of(kept.path)
    folder = shown_folder(kept.entry.folder)
    return f"{_name_of(kept.path)} ({folder})"[: LONGEST_NAME - _ROOM_FOR_NUMBER]


def _name_of(path: Path) -> str:
    """Return the name made of a file's own name, as far as that can be shown."""
    return path.stem.encode(errors="replace").decode()


def name_inside(path: Path) -> str:
    """Return the name in a file of the library, or one made from the file's own name.

    Args:
        path: The file of a trajectory, recording or draft; only its beginning is read.
    """
    found = None
    with contextlib.suppress(OSError):
        found = files.name_in(path)
    return found or _name_of(path)


def suffix_of(content: Content) -> str:
    """Return the suffix of the file for a content."""
    return ".npz" if isinstance(content, Recording) else ".log"
