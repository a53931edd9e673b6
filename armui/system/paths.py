"""Where the program's own files are, beside the package or inside it; and the operator's."""

from __future__ import annotations

import os
import tempfile
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


def runtime() -> Path:
    """Where running programs of one user meet: locks, which mean nothing after the program ends.

    The system's folder for that where there is one, else one in the user's temporary files.
    """
    folder = Path(os.environ.get("XDG_RUNTIME_DIR") or "")
    if folder.is_absolute() and os.access(folder, os.W_OK):
        return folder / "armui"
    import getpass  # noqa: PLC0415 - faster start

    return Path(tempfile.gettempdir()) / f"armui-{getpass.getuser()}"


def logs() -> Path:
    """Where the operating system keeps the logs of a user's programs."""
    return platformdirs.user_log_path("armui", appauthor=False)


def trajectories() -> Path:
    """Where the operator's trajectories are kept: the user's folder for data of programs."""
    return platformdirs.user_data_path("armui", appauthor=False) / "trajectories"


def sessions() -> Path:
    """Where recordings of sessions are kept, unless the operator chooses another folder."""
    return platformdirs.user_data_path("armui", appauthor=False) / "sessions"
