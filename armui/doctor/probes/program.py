"""Examines Python and the packages that the program uses."""

from __future__ import annotations

import platform
import re
import sys
import threading
from importlib import metadata
from pathlib import Path
from typing import TYPE_CHECKING, Final

from armui import __version__
from armui.doctor.facts import PackageFacts, ProgramFacts
from armui.system.command_process import is_packaged
from armui.system.files import read_file
from armui.system.thread_priority import RaisedBy, Rise, raise_threads

if TYPE_CHECKING:
    from armui.system.kept_folders import ClosedFolder

_OLDEST_PYTHON: Final = (3, 11)
_ADAPTERS: Final = "adapters"
_REQUIREMENT: Final = re.compile(
    r"^\s*(?P<name>[A-Za-z0-9._-]+)\s*(\[[^]]*\])?\s*\(?(?P<wanted>[^;()]*)\)?\s*(;(?P<marker>.*))?$"
)
_EXTRA: Final = re.compile(r"extra\s*==\s*['\"]([^'\"]+)['\"]")
_SYSTEM: Final = re.compile(r"sys_platform\s*(==|!=)\s*['\"]([^'\"]+)['\"]")
_CLAUSE: Final = re.compile(r"(>=|<=|==|!=|<|>|~=)\s*([0-9][0-9A-Za-z.]*)")
_NUMBERS: Final = re.compile(r"\d+")


def probe_program() -> ProgramFacts:
    """Return the versions, packages, system and priority that this program runs with."""
    rise = try_priority()
    return ProgramFacts(
        armui=__version__,
        python=platform.python_version(),
        python_suffices=sys.version_info >= _OLDEST_PYTHON,
        executable=sys.executable,
        system=f"{platform.system()} {platform.release()} {platform.machine()}",
        families=_families(Path("/etc/os-release")),
        packages=tuple(map(_package, filter(_is_of_this_system, _requirements()))),
        goes_first=rise.by is not RaisedBy.NOBODY,
        priority_reason=rise.reason,
        packaged=is_packaged(),
        closed=_closed_folders(),
    )


def _closed_folders() -> tuple[ClosedFolder, ...]:
    try:
        from armui.system.kept_folders import closed_folders  # noqa: PLC0415 - platformdirs missing
    except ImportError:
        return ()
    return closed_folders()


def try_priority() -> Rise:
    """Request priority for a thread that ends at once: only trying shows whether it is granted."""
    rises: list[Rise] = []
    thread = threading.Thread(
        target=lambda: rises.append(raise_threads([threading.get_native_id()]))
    )
    thread.start()
    thread.join()
    return rises[0]


def _is_of_this_system(requirement: str) -> bool:
    system = _SYSTEM.search(requirement)
    return system is None or (system[2] == sys.platform) is (system[1] == "==")


def _requirements() -> list[str]:
    """Return what the installed program requires, else what the project file beside it does."""
    try:
        return list(metadata.requires("armui") or [])
    except metadata.PackageNotFoundError:
        return _requirements_of_project(Path(__file__).resolve().parents[3] / "pyproject.toml")


def _requirements_of_project(path: Path) -> list[str]:
    import tomllib  # noqa: PLC0415 - Python 3.10 lacks it, and is to be told so

    try:
        project = tomllib.loads(read_file(path).decode())["project"]
    except (OSError, ValueError, KeyError):
        return []
    extras = project.get("optional-dependencies", {}).get(_ADAPTERS, [])
    return [*project.get("dependencies", []), *(f'{e}; extra == "{_ADAPTERS}"' for e in extras)]


def _package(requirement: str) -> PackageFacts:
    found = _REQUIREMENT.match(requirement)
    name = found["name"] if found else requirement
    wanted = re.sub(r"\s+", "", found["wanted"]) if found else ""
    extra = _EXTRA.search((found["marker"] or "") if found else "")
    try:
        installed: str | None = metadata.version(name)
    except metadata.PackageNotFoundError:
        installed = None
    optional = extra.group(1) if extra else ""
    if optional not in {"", _ADAPTERS}:
        return PackageFacts(name, wanted, installed, satisfied=True, extra=optional)
    does = installed is not None and satisfies(installed, wanted)
    return PackageFacts(name, wanted, installed, does, optional)


def satisfies(installed: str, wanted: str) -> bool:
    """Return whether a version satisfies pip's bounds; letters in it are ignored.

    ``packaging`` would be more exact, but may be missing itself.
    """
    version = _key(installed)
    for operator, text in _CLAUSE.findall(wanted):
        bound = _key(text)
        padded, against = _same_length(version, bound)
        if not {
            ">=": padded >= against,
            "<=": padded <= against,
            ">": padded > against,
            "<": padded < against,
            "==": padded == against,
            "!=": padded != against,
            "~=": padded >= against and version[: len(bound) - 1] == bound[:-1],
        }[operator]:
            return False
    return True


def _key(version: str) -> tuple[int, ...]:
    return tuple(int(each) for each in _NUMBERS.findall(version.split("+", maxsplit=1)[0]))


def _same_length(
    one: tuple[int, ...], other: tuple[int, ...]
) -> tuple[tuple[int, ...], tuple[int, ...]]:
    length = max(len(one), len(other))
    return one + (0,) * (length - len(one)), other + (0,) * (length - len(other))


def _families(path: Path) -> tuple[str, ...]:
    try:
        lines = read_file(path).decode().splitlines()
    except OSError:
        return ()
    values = dict(line.split("=", 1) for line in lines if "=" in line)
    return tuple(f"{values.get('ID', '')} {values.get('ID_LIKE', '')}".replace('"', "").split())
