"""Keeps deleted files of the library for a while, so that they can be restored."""

from __future__ import annotations

import contextlib
import secrets
import shutil
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Final

from armui.system.atomic import replace_file, sync_folder, write_whole
from armui.system.files import check_file, read_file
from armui.trajectory.library.drafts import is_draft
from armui.trajectory.library.file_names import folded, free_stem
from armui.trajectory.library.folders import is_real_folder
from armui.trajectory.library.index import IndexEntry
from armui.trajectory.library.stored_files import name_inside

KEPT: Final = timedelta(days=30)
"""The time for which a deleted file is kept."""

_GRACE: Final = timedelta(days=7)
"""A file found to be too old is only marked at first, and removed when it still is after this time:
the clock may have been wrong when it was deleted, or be wrong now.
"""
_DUE: Final = ".due"
"""The name of the mark: a file that holds the time at which it was made."""


@dataclass(frozen=True, slots=True)
class Deleted:
    """Files that were deleted together, to be restored together.

    Attributes:
        names: The trajectories' names.
        places: For every file, drafts included: its path in the library from the library's folder
            on, with slashes, and its present path.
        when: The time of deletion.
        entries: Their entries in the index, as far as they are still known.
    """

    names: tuple[str, ...]
    places: tuple[tuple[str, Path], ...]
    when: datetime
    entries: tuple[IndexEntry, ...] = ()

    @property
    def only_draft(self) -> bool:
        """True if it holds drafts only: the trajectory was never saved, or its file is gone."""
        return all(is_draft(place) for _, place in self.places)

    @property
    def folder(self) -> str:
        """The sub-folder of the library it came from and goes back to; "" for none."""
        return self.places[0][0].rpartition("/")[0] if self.places else ""


class Bin:
    """A folder of deleted files, each in a subfolder named after the time.

    There it lies in a folder as in the library, if it was in one.

    Args:
        folder: The folder, within the library's; it need not exist.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder

    def take(self, paths: Sequence[Path]) -> tuple[tuple[tuple[str, Path], ...], datetime]:
        """Move files into the bin, all or none.

        Returns:
            The name and the present path of each, and the time of deletion.

        Raises:
            OSError: One cannot be moved; the others have been moved back.
        """
        seconds, rest_ns = divmod(time.time_ns(), 1_000_000_000)
        when = datetime.fromtimestamp(seconds, UTC)
        if not paths:
            return (), when
        room = self._new_room(seconds, rest_ns)
        moved: list[tuple[Path, Path]] = []
        try:
            for path in paths:
                place = room / self._file(path)
                place.parent.mkdir(exist_ok=True)
                replace_file(path, place)
                moved.append((path, place))
        except OSError:
            for path, place in moved:
                replace_file(place, path)
            _remove_empty(room)
            raise
        for folder in {room, *(each.parent for pair in moved for each in pair)}:
            sync_folder(folder)
        return tuple((self._file(path), place) for path, place in moved), when

    def keep_copy(self, path: Path) -> None:
        """Copy a file that is about to be replaced into the bin.

        Raises:
            OSError: It cannot be copied.
        """
        room = self._new_room(*divmod(time.time_ns(), 1_000_000_000))
        try:
            place = room / self._file(path)
            place.parent.mkdir(exist_ok=True)
            check_file(path)
            shutil.copy2(path, place)
        except OSError:
            shutil.rmtree(room, ignore_errors=True)
            raise
        sync_folder(place.parent)
        sync_folder(room)

    def _file(self, path: Path) -> str:
        """Return a file's path in the library, from the library's folder on."""
        return path.relative_to(self._folder.parent).as_posix()

    def _new_room(self, seconds: int, rest_ns: int) -> Path:
        room = self._folder / f"{seconds}-{rest_ns:09}-{secrets.token_hex(4)}"
        room.mkdir(parents=True)
        return room

    def contents(self) -> list[Deleted]:
        """Return everything in the bin, the last deleted first: each trajectory with its draft.

        Raises:
            OSError: The folder cannot be read.
        """
        found: list[Deleted] = []
        for when, room in sorted(self._rooms(), reverse=True):
            by_name: dict[str, list[tuple[str, Path]]] = {}
            # The file of a trajectory comes before its draft; a draft alone counts as a trajectory.
            for path in sorted(_files(room), key=lambda path: (is_draft(path), path.name)):
                places = by_name.setdefault(name_inside(path), [])
                places.append((path.relative_to(room).as_posix(), path))
            found += [Deleted((name,), tuple(places), when) for name, places in by_name.items()]
        return found

    def give_back(self, file: str, place: Path, folder: Path) -> Path:
        """Move a file back; if its name is taken by now, under a free name.

        Args:
            file: The file's former name.
            place: Its path in the bin.
            folder: The folder to move it to; it must exist.

        Returns:
            Its new path.

        Raises:
            OSError: It cannot be moved.
        """
        name = Path(file)
        taken = {folded(path.stem) for path in folder.iterdir() if is_draft(path) == is_draft(name)}
        path = folder / f"{free_stem(name.stem, taken)}{name.suffix}"
        replace_file(place, path)
        self._tidy(place)
        sync_folder(folder)
        return path

    def remove(self, place: Path) -> None:
        """Delete a file permanently.

        Raises:
            OSError: It cannot be removed.
        """
        place.unlink(missing_ok=True)
        self._tidy(place)

    def remove_outdated(self) -> None:
        """Delete outdated files permanently, if they were marked as such some days before."""
        now = datetime.now(UTC)
        with contextlib.suppress(OSError):
            for when, room in list(self._rooms()):
                if when < now - KEPT and _due_since(room, now) <= now - _GRACE:
                    for path in [*_files(room), room / _DUE]:
                        path.unlink(missing_ok=True)
                    _remove_empty(room)
                elif when >= now - KEPT:
                    (room / _DUE).unlink(missing_ok=True)

    def _rooms(self) -> Iterator[tuple[datetime, Path]]:
        """Return the time and the folder of every deletion, in no order."""
        for room in self._folder.glob("[0-9]*-*"):
            with contextlib.suppress(ValueError, OverflowError):
                yield datetime.fromtimestamp(int(room.name.partition("-")[0]), UTC), room

    def _tidy(self, place: Path) -> None:
        """Remove the folder of a deletion once nothing of it is left."""
        room = self._folder / place.relative_to(self._folder).parts[0]
        with contextlib.suppress(OSError):  # it is not empty
            if not _files(room):
                (room / _DUE).unlink(missing_ok=True)
            _remove_empty(room)


def _due_since(room: Path, now: datetime) -> datetime:
    """Return when an item was marked as too old; mark it now if it was not, or in the future.

    Raises:
        OSError: It cannot be marked.
    """
    mark = room / _DUE
    with contextlib.suppress(OSError, ValueError):
        since = datetime.fromisoformat(read_file(mark, 100).decode("ascii"))
        if since <= now:
            return since
    write_whole(mark, now.isoformat().encode(), to_disk=False)
    return now


def _files(room: Path) -> list[Path]:
    """Return the files of a folder and its sub-folders; none if it has been removed."""
    try:
        found = list(room.iterdir())
        for folder in filter(is_real_folder, list(found)):
            found += folder.iterdir()
        return [path for path in found if path.is_file() and path.name != _DUE]
    except FileNotFoundError:
        return []


def _remove_empty(room: Path) -> None:
    """Remove the folder of a deletion with its sub-folders, as far as they are empty."""
    with contextlib.suppress(OSError):
        for folder in filter(is_real_folder, list(room.iterdir())):
            with contextlib.suppress(OSError):
                folder.rmdir()
        room.rmdir()
