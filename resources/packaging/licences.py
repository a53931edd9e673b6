"""Collects the licences of all that PyInstaller has packed; runs in the environment it packs.

``python licences.py WORK TARGET ROOT``: a folder for each distribution with the texts it brings, of
the libraries of the build system what Debian says of them, and Qt's, which its wheels lack.
"""

from __future__ import annotations

import ast
import json
import platform
import re
import shutil
import sqlite3
import subprocess
import sys
import sysconfig
from collections.abc import Iterable, Iterator
from importlib import metadata
from pathlib import Path
from typing import Final

_TEXT: Final = re.compile(r"(licen[cs]e|copying|notice|copyright|authors)", re.IGNORECASE)
_TEXTS: Final = (
    (re.compile(r"^(pyside6|shiboken6)"), ("GPL-3.0.txt", "LGPL-3.0.txt")),
    # libusb, and libudev, are in their wheels
    (re.compile(r"^(hidapi|libusb-package)$"), ("LGPL-2.1.txt",)),
)
"""Of what has been left out of wheels."""
_NAMES: Final = "names.txt"
_SYSTEM: Final = "system.json"
"""What is packed beside Python's distributions, for the bill of materials."""


def collect(work: Path, target: Path, root: Path) -> list[str]:
    """Fill a folder; returns what has no text of its own, by name with what its metadata says."""
    shutil.rmtree(target, ignore_errors=True)
    target.mkdir(parents=True)
    shutil.copy(root / "LICENSE", target / "armui.txt")
    sources = set(_sources(work))
    names, without = ["armui"], []
    for each in metadata.distributions():
        name = re.sub(r"[-_.]+", "-", each.metadata["Name"]).lower()
        if name == "armui" or not any(
            str(each.locate_file(file)) in sources for file in each.files or ()
        ):
            continue
        names.append(name)
        texts = [file for file in each.files or () if _is_text(str(file))]
        for number, file in enumerate(texts):
            found = Path(str(each.locate_file(file)))
            _copy(found, target / name / (f"{number}-{found.name}" if number else found.name))
        missing = [own for kind, texts_of in _TEXTS if kind.match(name) for own in texts_of]
        for own in missing:
            _copy(root / "resources/licences" / own, target / name / own)
        if not texts and not missing:
            without.append(f"{name} {each.version}: {_said(each)}")
    _copy_python(target / "python")
    python = platform.python_version()
    system = [{"name": "cpython", "version": python, "purl": f"pkg:generic/cpython@{python}"}]
    if shutil.which("dpkg") is None:  # Debian's Python has it from a package, others their own
        sqlite = sqlite3.sqlite_version
        system.append({"name": "sqlite", "version": sqlite, "purl": f"pkg:generic/sqlite@{sqlite}"})
    for package, version, text in _of_the_system(sources):
        _copy(text, target / "system" / f"{package}.txt")
        purl = f"pkg:deb/debian/{package}@{version}"
        system.append({"name": package, "version": version, "purl": purl})
    (target / _SYSTEM).write_text(json.dumps(system, indent=1) + "\n", encoding="utf-8")
    (target / _NAMES).write_text("\n".join(sorted(names)) + "\n", encoding="utf-8")
    if without:
        (target / "without-a-text.txt").write_text("\n".join(without) + "\n", encoding="utf-8")
    return without


def _sources(work: Path) -> Iterator[str]:
    """The files that were packed, as PyInstaller has written them down.

    Its first list, of what it has found, has much that was then left out; metadata is no program.
    """
    lists = (
        each for each in (work / "armui").glob("*.toc") if not each.name.startswith("Analysis")
    )
    for list_ in lists:
        text = list_.read_text(encoding="utf-8")
        for string in re.findall(r"'(?:[^'\\]|\\.)*'", text):
            value = ast.literal_eval(string)
            if ("/" in value or "\\" in value) and ".dist-info" not in value:
                yield value


def _is_text(file: str) -> bool:
    path = Path(file)
    in_metadata = ".dist-info" in file and _TEXT.search(path.name) is not None
    return (in_metadata or "/licenses/" in file) and path.suffix not in {".py", ".pyc", ".json"}


def _said(each: metadata.Distribution) -> str:
    said = [
        each.metadata[name] for name in ("License-Expression", "License") if name in each.metadata
    ]
    kinds = [
        line.rpartition("::")[2].strip()
        for line in each.metadata.get_all("Classifier") or ()
        if line.startswith("License")
    ]
    return ", ".join(said or kinds) or "nothing said"


def _copy_python(target: Path) -> None:
    places = (
        Path(sys.base_prefix) / "LICENSE.txt",
        Path(sysconfig.get_path("stdlib")) / "LICENSE.txt",
        Path(f"/usr/share/doc/python3.{sys.version_info.minor}/copyright"),
        Path(f"/usr/share/doc/libpython3.{sys.version_info.minor}-minimal/copyright"),
    )
    for place in places:
        if place.is_file():
            _copy(place, target / "LICENSE.txt")
            return
    raise SystemExit("Python's own licence was not found; looked in " + ", ".join(map(str, places)))


def _of_the_system(sources: Iterable[str]) -> Iterator[tuple[str, str, Path]]:
    """What Debian says of the libraries that come from the build system: package, version, text."""
    asked = shutil.which("dpkg")
    if asked is None:
        return
    files = sorted(
        each for each in sources if each.startswith(("/usr/lib/", "/lib/")) and ".so" in each
    )
    seen = set()
    for file in files:
        done = subprocess.run(  # noqa: S603 - Debian's own tool
            [asked, "-S", str(Path(file).resolve()), file],
            capture_output=True,
            text=True,
            check=False,
        )
        for line in done.stdout.splitlines():
            package = line.partition(":")[0]
            text = Path("/usr/share/doc") / package / "copyright"
            if package not in seen and text.is_file():
                seen.add(package)
                words = [asked, "--status", package]
                told = subprocess.run(  # noqa: S603 - as above
                    words, capture_output=True, text=True, check=True
                ).stdout
                (version,) = re.findall(r"^Version: (.+)$", told, re.MULTILINE)
                yield package, version, text


def _copy(source: Path, target: Path) -> None:
    target.parent.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(source, target)


if __name__ == "__main__":
    for line in collect(*map(Path, sys.argv[1:4])):
        sys.stdout.write(f"no text of a licence: {line}\n")
