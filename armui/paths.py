"""Where the program's own files are, beside the package or inside it; and the operator's."""

from __future__ import annotations

from pathlib import Path

import platformdirs

_PACKAGE = Path(__file__).resolve().parent


def _data_folder(name: str) -> Path:
    installed = _PACKAGE / name
    return installed if installed.is_dir() else _PACKAGE.parent / name


RESOURCES = _data_folder("resources")
"""Protocol databases, translations, icons."""

URDF = _data_folder("urdf")
"""The robot description with its meshes."""


def trajectories() -> Path:
    """Where the operator's trajectories are kept: the user's folder for data of programs."""
    return platformdirs.user_data_path("armui", appauthor=False) / "trajectories"
