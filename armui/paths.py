"""Where the program's own files are: beside the package in a checkout, inside it when installed."""

from __future__ import annotations

from pathlib import Path

_PACKAGE = Path(__file__).resolve().parent


def _data_folder(name: str) -> Path:
    installed = _PACKAGE / name
    return installed if installed.is_dir() else _PACKAGE.parent / name


RESOURCES = _data_folder("resources")
"""Protocol databases, translations, icons."""

URDF = _data_folder("urdf")
"""The robot description with its meshes."""
