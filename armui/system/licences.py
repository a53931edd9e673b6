"""The licences of the program and of all that it brings, as files that can be read."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from importlib import metadata
from pathlib import Path
from typing import Final

from armui.system.command_process import is_packaged
from armui.system.paths import RESOURCES

_TEXT: Final = re.compile(r"(licen[cs]e|copying|notice|copyright)", re.IGNORECASE)
_QT: Final = ("PySide6-Essentials", "shiboken6")
_OF_QT: Final = ("LGPL-3.0.txt", "GPL-3.0.txt")
"""Qt's wheels bring no text: the LGPL 3, and the GPL 3 that it refers to."""
_LISTS: Final = frozenset({"names.txt"})


@dataclass(frozen=True, slots=True)
class Licence:
    """The text of a licence.

    Attributes:
        of: The name of the licensed program or library.
        path: The file of the text.
    """

    of: str
    path: Path


def licences() -> tuple[Licence, ...]:
    """Return every text, the program's own first, then Qt's; waits for the disk.

    A packaged program has them in a folder, for each library that it contains. From the source, or
    installed by pip, they are taken from the installed packages that the program requires.
    """
    found = _of_package() if is_packaged() else _of_installed()
    order = {"armui": 0, **{name.lower(): 1 for name in _QT}}
    return tuple(sorted(found, key=lambda each: (order.get(each.of.lower(), 2), each.of.lower())))


def _of_package() -> Iterator[Licence]:
    folders = (Path(sys.executable).parent / "licences", Path("/usr/share/doc/armui/licences"))
    for folder in folders:
        for path in sorted(folder.rglob("*")) if folder.is_dir() else ():
            if path.is_file() and path.name not in _LISTS:
                inside = path.relative_to(folder)
                of = inside.stem if len(inside.parts) == 1 else inside.parts[0]
                yield Licence(inside.stem if of == "system" else of, path)


def _of_installed() -> Iterator[Licence]:
    own = RESOURCES.parent / "LICENSE"
    if own.is_file():
        yield Licence("armui", own)
    for each in _QT:
        for name in _OF_QT:
            yield Licence(each, RESOURCES / "licences" / name)
    for each in sorted(_wanted("armui", set())):
        try:
            files = metadata.distribution(each).files or ()
        except metadata.PackageNotFoundError:
            continue
        for file in files:
            if ".dist-info" in str(file) and _TEXT.search(file.name) and file.suffix != ".py":
                yield Licence(each, Path(str(file.locate())))


def _wanted(name: str, seen: set[str]) -> set[str]:
    """Return the installed distributions that one requires, directly or by others."""
    try:
        found = metadata.distribution(name)
    except metadata.PackageNotFoundError:
        return seen
    if found.metadata["Name"] not in seen:
        seen.add(found.metadata["Name"])
        for line in found.requires or ():
            if "extra ==" not in line:
                _wanted(re.split(r"[^A-Za-z0-9._-]", line.strip())[0], seen)
    return seen
