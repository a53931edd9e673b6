"""Where deleted files of the library wait to be brought back."""

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
from armui.trajectory.library.index import IndexEntry
from armui.trajectory.library.stored_files import name_inside

KEPT: Final = timedelta(days=30)
"""How long a deleted file is kept."""

_GRACE: Final = timedelta(days=7)
"""What is found to be too old is only marked, and removed when it is found so this much later: the
clock may have been set wrong when it was deleted, or be wrong now."""
_DUE: Final = ".due"
"""The mark: a file that holds the time at which it was made."""


@dataclass(frozen=True, slots=True)
class Deleted:
    """What was deleted together, to be brought back together.

    Attributes:
        names: Of the trajectories.
        places: For every file, drafts included: its name in the library, and where it is now.
        when: It was deleted.
        entries: What the library knew of them, where it still knows.
    """

    names: tuple[str, ...]
    places: tuple[tuple[str, Path], ...]
    when: datetime
    entries: tuple[IndexEntry, ...] = ()

    @property
    def only_draft(self) -> bool:
        """True if nothing of it was ever saved, or what was saved is gone."""
        return all(is_draft(place) for _, place in self.places)


class Bin:
    """A folder of deleted files, each in a folder of its own that is called by the time.

    Args:
        folder: It need not exist; on the same disk as the files.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder

    def take(self, paths: Sequence[Path]) -> tuple[tuple[tuple[str, Path], ...], datetime]:
        """Move files here, all or none.

        Returns:
            For each its name and where it is now; and the time they are kept from.

        Raises:
            OSError: One cannot be moved; the others are back in their places.
        """
        seconds, rest_ns = divmod(time.time_ns(), 1_000_000_000)
        when = datetime.fromtimestamp(seconds, UTC)
        if not paths:
            return (), when
        room = self._new_room(seconds, rest_ns)
        moved: list[tuple[Path, Path]] = []
        try:
            for path in paths:
                replace_file(path, room / path.name)
                moved.append((path, room / path.name))
        except OSError:
            for path, place in moved:
                replace_file(place, path)
            with contextlib.suppress(OSError):
                room.rmdir()
            raise
        sync_folder(room)
        sync_folder(paths[0].parent)
        return tuple((path.name, place) for path, place in moved), when

    def keep_copy(self, path: Path) -> None:
        """Keep what a file holds that is about to be replaced.

        Raises:
            OSError: It cannot be kept.
        """
        room = self._new_room(*divmod(time.time_ns(), 1_000_000_000))
        try:
            check_file(path)
            shutil.copy2(path, room / path.name)
        except OSError:
            shutil.rmtree(room, ignore_errors=True)
            raise
        sync_folder(room)

    def _new_room(self, seconds: int, rest_ns: int) -> Path:
        room = self._folder / f"{seconds}-{rest_ns:09}-{secrets.token_hex(4)}"
        room.mkdir(parents=True)
        return room

    def contents(self) -> list[Deleted]:
        """Everything here, the last deleted first: each trajectory by itself, with its draft.

        Raises:
            OSError: The folder cannot be read.
        """
        found: list[Deleted] = []
        for when, room in sorted(self._rooms(), reverse=True):
            by_name: dict[str, list[tuple[str, Path]]] = {}
            # a trajectory goes before the draft of it, and a draft alone is one, too
            for path in sorted(_files(room), key=lambda path: (is_draft(path), path.name)):
                places = by_name.setdefault(name_inside(path), [])
                places.append((path.name, path))
            found += [Deleted((name,), tuple(places), when) for name, places in by_name.items()]
        return found

    def give_back(self, file: str, place: Path, folder: Path) -> Path:
        """Move a file back, under a free name where its own is taken by now.

        Args:
            file: What it was called.
            place: Where it is here.
            folder: Where to.

        Returns:
            Where it is now.

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
        """Remove a file for good.

        Raises:
            OSError: It cannot be removed.
        """
        place.unlink(missing_ok=True)
        self._tidy(place)

    def remove_outdated(self) -> None:
        """Remove for good what was deleted long ago, if it was found so some days before, too."""
        now = datetime.now(UTC)
        with contextlib.suppress(OSError):
            for when, room in list(self._rooms()):
                if when < now - KEPT and _due_since(room, now) <= now - _GRACE:
                    for path in room.iterdir():
                        path.unlink()
                    room.rmdir()
                elif when >= now - KEPT:
                    (room / _DUE).unlink(missing_ok=True)

    def _rooms(self) -> Iterator[tuple[datetime, Path]]:
        """Return the time and the folder of every deletion, in no order."""
        for room in self._folder.glob("[0-9]*-*"):
            with contextlib.suppress(ValueError, OverflowError):
                yield datetime.fromtimestamp(int(room.name.partition("-")[0]), UTC), room

    def _tidy(self, place: Path) -> None:
        with contextlib.suppress(OSError):  # another file of the same deletion is still there
            if not _files(place.parent):
                (place.parent / _DUE).unlink(missing_ok=True)
            place.parent.rmdir()


def _due_since(room: Path, now: datetime) -> datetime:
    """Since when something is marked as too old; it is marked now if it was not, or in the future.

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
    """Return what is in a folder; nothing if another program has removed it meanwhile."""
    try:
        return [path for path in room.iterdir() if path.is_file() and path.name != _DUE]
    except FileNotFoundError:
        return []
