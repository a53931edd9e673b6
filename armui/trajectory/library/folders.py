"""The sub-folders of the library on the disk: one level of them, and real ones only.

A link or a Windows junction does not count as one: it may lead out of the library. Names that begin
with a dot are reserved for the library's own data: bin, index, recordings.
"""

from __future__ import annotations

import contextlib
import os
import stat
from pathlib import Path
from typing import Final

from armui.arm.refusal import Reason, Refusal
from armui.system.atomic import sync_folder
from armui.trajectory.library.file_names import file_stem, folded

FOLDER_NAMELESS = Reason("folder_nameless", "A folder needs a name. Enter one.")
FOLDER_TAKEN = Reason(
    "folder_taken", "There is a “{name}” in the library's folder already. Choose another name."
)
FOLDER_NAME_UNUSABLE = Reason(
    "folder_name_unusable", "Not every system takes a folder called “{name}”. “{fitting}” would do."
)
FOLDER_GONE = Reason(
    "folder_gone",
    "The folder “{name}” is not in the library any more. It was renamed, moved or deleted "
    "elsewhere.",
)
FOLDER_NOT_EMPTY = Reason(
    "folder_not_empty",
    "The folder “{name}” is not empty and is kept: {held}. Move or delete what is in it first.",
)
FOLDER_NOT_CHANGED = Reason(
    "folder_not_changed", "Not done: {name}: {text}. Check the rights to the library's folder."
)

_JUNCTION: Final = 0xA0000003
"""The tag by which Windows marks a folder that leads elsewhere (IO_REPARSE_TAG_MOUNT_POINT)."""
_MOST_TOLD: Final = 3


def is_real_folder(path: Path) -> bool:
    """Return whether a path is a folder itself, and no link to one.

    Raises:
        OSError: It cannot be looked at; one that is not there is no folder.
    """
    try:
        found = path.lstat()
    except FileNotFoundError:
        return False
    return stat.S_ISDIR(found.st_mode) and getattr(found, "st_reparse_tag", 0) != _JUNCTION


def _is_listed(item: os.DirEntry[str]) -> bool:
    """Return whether it is a sub-folder; one that cannot be read, by its folder's listing."""
    try:
        return is_real_folder(Path(item.path))
    except OSError:
        with contextlib.suppress(OSError):
            return item.is_dir(follow_symlinks=False)
        return False


def shown_folder(folder: str) -> str:
    """Return a sub-folder's name as far as it can be shown."""
    return folder.encode(errors="replace").decode()


def check_folder_name(name: str) -> Refusal | None:
    """Return why no folder can be called so, or ``None``."""
    if not name.strip():
        return FOLDER_NAMELESS()
    fitting = file_stem(name)
    return None if fitting == name else FOLDER_NAME_UNUSABLE(name=name, fitting=fitting)


class Folders:
    """The sub-folders of the library's folder, by their names.

    Args:
        root: The library's folder; it need not exist.
    """

    def __init__(self, root: Path) -> None:
        self._root = root

    def names(self) -> list[str]:
        """Return the names of all sub-folders, sorted.

        Raises:
            OSError: The library's folder cannot be read.
        """
        if not self._root.is_dir():
            return []
        with os.scandir(self._root) as items:
            found = [item for item in items if not item.name.startswith(".")]
        return sorted(item.name for item in found if _is_listed(item))

    def has(self, name: str) -> bool:
        """Return whether there is a sub-folder of this name; one that is out of reach is none."""
        try:
            return bool(name) and is_real_folder(self._root / name)
        except OSError:
            return False

    def path(self, name: str) -> Path | None:
        """Return the path of a sub-folder, or of the library's folder itself for ``""``.

        Returns:
            ``None`` if there is no such sub-folder any more.
        """
        if not name:
            return self._root
        return self._root / name if self.has(name) else None

    def is_taken(self, name: str, but: str = "") -> bool:
        """Return whether something in the library's folder has this name, but for one of them.

        Raises:
            OSError: The library's folder cannot be read.
        """
        if not self._root.is_dir():
            return False
        return folded(name) in {folded(each.name) for each in self._root.iterdir()} - {folded(but)}

    def create(self, name: str) -> None:
        """Make a sub-folder.

        Raises:
            OSError: It cannot be made, or something of that name is there.
        """
        self._root.mkdir(parents=True, exist_ok=True)
        (self._root / name).mkdir()
        sync_folder(self._root)

    def rename(self, old: str, new: str) -> None:
        """Give a sub-folder another name.

        Raises:
            OSError: It is gone, or the disk refuses.
        """
        (self._root / old).rename(self._root / new)
        sync_folder(self._root)

    def delete(self, name: str) -> None:
        """Delete an empty sub-folder.

        Raises:
            OSError: It is not empty, or the disk refuses.
        """
        (self._root / name).rmdir()
        sync_folder(self._root)

    def held(self, name: str) -> list[str]:
        """Return the names of the first things in a sub-folder; «…» last if there are more.

        Raises:
            OSError: It cannot be read.
        """
        names = sorted(shown_folder(each.name) for each in (self._root / name).iterdir())
        return names[:_MOST_TOLD] + ["…"] * (len(names) > _MOST_TOLD)
