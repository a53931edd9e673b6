"""Files that are brought into the library, each under a name that is free there."""

from __future__ import annotations

import contextlib
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from armui.trajectory import columns, files
from armui.trajectory.files import TrajectoryFileError
from armui.trajectory.library.store import Library, LibraryError


@dataclass(frozen=True, slots=True)
class Imported:
    """The result of importing a file.

    Attributes:
        path: The file.
        name: The name of its content in the library; "" if it was not imported.
        requested: The name given in the file.
        error: The reason why it was not imported.
        is_table: True if it is in none of our formats but holds rows of figures.
        was_there: True if the library already had the same content under this name.
    """

    path: Path
    name: str = ""
    requested: str = ""
    error: TrajectoryFileError | LibraryError | None = None
    is_table: bool = False
    was_there: bool = False


def find_or_import(folder: Path, path: Path, new_in: str = "") -> Imported:
    """Import a file, unless the library already has the same content under its name.

    Args:
        folder: The library's folder.
        path: The file; it may be one of the library's own.
        new_in: The sub-folder that it goes to, as `Library.new_in`.
    """
    library = Library(folder)
    library.new_in = new_in
    with contextlib.suppress(TrajectoryFileError, LibraryError):
        content = files.load(path)
        kept = library.load(content.name)
        if replace(content, modified=kept.modified) == kept:
            return Imported(path, kept.name, kept.name, was_there=True)
    return _import_file(library, path)


def import_files(folder: Path, paths: Sequence[Path], new_in: str = "") -> list[Imported]:
    """Import the valid ones among some files.

    Args:
        folder: The library's folder.
        paths: The files.
        new_in: The sub-folder that they go to, as `Library.new_in`.

    Returns:
        One result for each file, in their order.
    """
    library = Library(folder)
    library.new_in = new_in
    return [_import_file(library, path) for path in paths]


def _import_file(library: Library, path: Path) -> Imported:
    try:
        content = files.load(path)
    except TrajectoryFileError as error:
        told, is_table = columns.look_closer(path, error)
        return Imported(path, error=told, is_table=is_table)
    try:
        name = library.free_name(content.name)
        library.save(replace(content, name=name))
    except LibraryError as error:
        return Imported(path, requested=content.name, error=error)
    return Imported(path, name, content.name)
