"""Where the program's own files are, beside the package or inside it; and the operator's."""

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
"""Protocol databases, translations, icons."""

URDF = _data_folder("urdf")
"""The robot description with its meshes."""


def settings_file() -> Path:
    """Return where the operating system keeps settings of a user's programs."""
    return platformdirs.user_config_path("armui", appauthor=False) / "settings.json"


def runtime() -> Path:
    """Return where running programs of one user meet: locks, void when they have ended.

    The system's folder for that where it is the user's own, also where the environment does not
    name it; else one among the user's files, for this computer alone.
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
    """Return whether a folder is there, is no link, and only its user can change what is in it."""
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
    """Make a folder that is closed to other users, if it is not there.

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
    """Return where the operating system keeps the logs of a user's programs."""
    return platformdirs.user_log_path("armui", appauthor=False)


def trajectories() -> Path:
    """Return where the operator's trajectories are kept: the user's folder for data of programs."""
    return platformdirs.user_data_path("armui", appauthor=False) / "trajectories"


def sessions() -> Path:
    """Return where recordings of sessions are kept, unless the operator chooses another folder."""
    return platformdirs.user_data_path("armui", appauthor=False) / "sessions"
