"""Where deleted files of the library wait to be brought back."""

from __future__ import annotations

import contextlib
import secrets
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Final

from armui.trajectory.atomic import sync_folder
from armui.trajectory.file_names import folded, free_stem

_KEPT_S: Final = 30 * 24 * 3600
"""How long a deleted file is kept."""


class Bin:
    """A folder of deleted files, each in a folder of its own that is called by the time.

    Args:
        folder: It need not exist; on the same disk as the files.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder

    def take(self, paths: Sequence[Path]) -> tuple[tuple[str, Path], ...]:
        """Move files here, all or none.

        Returns:
            For each its name and where it is now.

        Raises:
            OSError: One cannot be moved; the others are back in their places.
        """
        if not paths:
            return ()
        room = self._folder / f"{int(time.time())}-{secrets.token_hex(4)}"
        room.mkdir(parents=True)
        moved: list[tuple[Path, Path]] = []
        try:
            for path in paths:
                path.replace(room / path.name)
                moved.append((path, room / path.name))
        except OSError:
            for path, place in moved:
                place.replace(path)
            raise
        sync_folder(room)
        sync_folder(paths[0].parent)
        return tuple((path.name, place) for path, place in moved)

    def give_back(self, places: Sequence[tuple[str, Path]], folder: Path) -> None:
        """Move files back, under a free name where theirs is taken by now.

        Args:
            places: As `take` has returned.
            folder: Where to.

        Raises:
            OSError: One cannot be moved; what was moved stays moved.
        """
        for file, place in places:
            name = Path(file)
            taken = {folded(path.stem) for path in folder.iterdir() if _same_sort(path, name)}
            place.replace(folder / f"{free_stem(name.stem, taken)}{name.suffix}")
            with contextlib.suppress(OSError):  # another file of the same deletion is still there
                place.parent.rmdir()
        sync_folder(folder)

    def remove_outdated(self) -> None:
        """Remove for good what was deleted long ago."""
        oldest = time.time() - _KEPT_S
        for room in self._folder.glob("[0-9]*-*"):
            with contextlib.suppress(OSError, ValueError):
                if int(room.name.partition("-")[0]) < oldest:
                    for path in room.iterdir():
                        path.unlink()
                    room.rmdir()


def _same_sort(path: Path, other: Path) -> bool:
    """Drafts beside drafts, trajectories beside trajectories."""
    return (path.suffix == ".draft") == (other.suffix == ".draft")
