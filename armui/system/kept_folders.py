"""Tells in which of the user's folders nothing can be kept."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass
from pathlib import Path

from armui.system import paths
from armui.system.files import error_text, open_file, read_file


@dataclass(frozen=True, slots=True)
class ClosedFolder:
    """A folder in which nothing can be kept.

    Attributes:
        folder: The folder.
        place: The folder or file that the system refuses: itself, or the nearest above that exists.
        text: The system's words.
        denied: True if this user lacks the right, which can be granted.
    """

    folder: str
    place: str
    text: str
    denied: bool

    def __str__(self) -> str:
        return f"{self.folder} ({self.text})"


def closed_folders() -> tuple[ClosedFolder, ...]:
    """Return the closed ones of settings, library, recordings and events; waits for the disk.

    A folder that is missing is made when it is needed: a file is tried in the nearest one above.
    """
    settings = paths.settings_file()
    try:
        chosen = json.loads(read_file(settings)).get("session_folder")
    except (OSError, ValueError, AttributeError):
        chosen = None
    sessions = Path(chosen) if isinstance(chosen, str) and chosen else paths.sessions()
    folders = dict.fromkeys((settings.parent, paths.trajectories(), sessions, paths.logs()))
    return tuple(closed for folder in folders if (closed := _try(folder)) is not None)


def _try(folder: Path) -> ClosedFolder | None:
    place = folder
    while not os.path.lexists(place) and place != place.parent:
        place = place.parent
    tried = place / f".armui-{os.getpid()}"
    try:
        open_file(tried, "xb").close()
        tried.unlink()
    except OSError as error:
        denied = isinstance(error, PermissionError)
        return ClosedFolder(str(folder), str(place), str(error_text(error)), denied)
    return None
