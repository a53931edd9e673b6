"""Files taken over into a library, one after the other; each of the others is told what is wrong.

Reading 30 minutes of samples takes a second. Nothing here knows a window, so it may be done in
another process: a library bears several programs.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from armui.trajectory import columns, files
from armui.trajectory.files import TrajectoryFileError
from armui.trajectory.library.store import Library, LibraryError


@dataclass(frozen=True, slots=True)
class Imported:
    """What became of a file.

    Attributes:
        path: The file.
        name: Under which its content is in the library now; "" if it is not.
        requested: The name its content brought along.
        error: Why it is not in the library.
        is_table: Whether it is none of our formats and holds rows of figures.
    """

    path: Path
    name: str = ""
    requested: str = ""
    error: TrajectoryFileError | LibraryError | None = None
    is_table: bool = False


def import_files(folder: Path, paths: Sequence[Path]) -> list[Imported]:
    """Take over what is whole of some files.

    Args:
        folder: Of the library.
        paths: The files.

    Returns:
        One for each file, in their order.
    """
    library = Library(folder)
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
