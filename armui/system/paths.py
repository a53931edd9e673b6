"""The places of the program's own files, beside the package or inside it, and of the operator's."""

from __future__ import annotations

import contextlib
import errno
import os
import platform
import stat
from pathlib import Path

import platformdirs

_PACKAGE = Path(__file__).resolve().parents[1]


def _data_folder(name: str) -> Path:
    installed = _PACKAGE / name
    return installed if installed.is_dir() else _PACKAGE.parent / name


RESOURCES = _data_folder("resources")
"""The folder of protocol databases, translations and icons."""

URDF = _data_folder("urdf")
"""The folder of the robot descriptions with their meshes."""


def settings_file() -> Path:
    """Return where the operating system keeps settings of a user's programs."""
    return platformdirs.user_config_path("armui", appauthor=False) / "settings.json"


def runtime() -> Path:
    """Return the folder for the locks of one user's running programs; locks of ended ones are void.

    It is the system's folder for that, even if the environment does not name it, provided that it
    belongs to the user; else a folder among the user's files, one for each computer.
    """
    named = [Path(os.environ.get("XDG_RUNTIME_DIR") or "")]
    if hasattr(os, "getuid"):
        named.append(Path(f"/run/user/{os.getuid()}"))
    for folder in named:
        if folder.is_absolute() and is_private(folder):
            return folder / "armui"
    state = platformdirs.user_state_path("armui", appauthor=False)
    return state / f"running-{platform.node() or 'here'}"


def is_private(folder: Path) -> bool:
    """Return whether a folder exists, is no link, and only its user can change its contents."""
    try:
        found = folder.lstat()
    except OSError:
        return False
    if not hasattr(os, "getuid"):  # Windows: a user's folders are closed to others
        return stat.S_ISDIR(found.st_mode)
    others_write = stat.S_IWGRP | stat.S_IWOTH
    own = found.st_uid == os.getuid() and not found.st_mode & others_write
    return stat.S_ISDIR(found.st_mode) and own


def make_private(folder: Path) -> None:
    """Create a folder that is closed to other users, if it does not exist.

    Raises:
        PermissionError: It is a link, or another user's.
        OSError: It cannot be made.
    """
    folder.parent.mkdir(parents=True, exist_ok=True)
    with contextlib.suppress(FileExistsError):
        folder.mkdir(mode=0o700)
    if hasattr(os, "getuid") and folder.lstat().st_uid == os.getuid() and not folder.is_symlink():
        folder.chmod(0o700)
    if not is_private(folder):
        raise PermissionError(errno.EPERM, "it belongs to another user", str(folder))


def logs() -> Path:
    """Return the operating system's folder for the logs of a user's programs."""
    return platformdirs.user_log_path("armui", appauthor=False)


def trajectories() -> Path:
    """Return the folder of the operator's trajectories, in the user's data of programs."""
    return platformdirs.user_data_path("armui", appauthor=False) / "trajectories"


def sessions() -> Path:
    """Return the default folder for recordings of sessions."""
    return platformdirs.user_data_path("armui", appauthor=False) / "sessions"
