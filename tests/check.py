"""Every check of the project: ``python -m tests.check``.

Needs no display. Ends at the first check that fails, with its exit code. What keeps one core busy
runs beside what keeps another busy; the tests, which take all there are, come last.
"""

import os
import subprocess
import sys
import sysconfig
import tempfile
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SCRIPTS = Path(sysconfig.get_path("scripts"))

SCENES = ("online", "run", "library", "settings-refused")
"""Of the gallery: the 3D picture, a motion, a window with files, a dialog."""

Command = tuple[str | Path, ...]

RUFF: tuple[Command, ...] = (
    (SCRIPTS / "ruff", "check"),
    (SCRIPTS / "ruff", "format", "--check"),
)
SYSTEMS = ("linux", "win32", "darwin")


def _types(system: str, *folders: str) -> Command:
    """Check the types that a system has; with a cache of its own, as each takes another's for old.

    Args:
        system: As mypy calls it.
        folders: What is checked; by default all there is.
    """
    return (
        *(SCRIPTS / "mypy", "--platform", system, "--cache-dir", f".mypy_cache/{system}"),
        *folders,
    )


OWN_TYPES_AND_LAYERS: tuple[Command, ...] = (_types(sys.platform), (SCRIPTS / "lint-imports",))
OTHER_TYPES: tuple[Command, ...] = tuple(
    _types(system, "armui", "resources/packaging") for system in SYSTEMS if system != sys.platform
)
"""Of the program, for the systems this is not: what only one of them has is found on each.

The tests' own types are checked for the system that they are about to run on.
"""
COLLECTION: Command = (sys.executable, "-m", "pytest", "--collect-only", "-qq")
"""Leaves every test compiled, which each of pytest's workers would do for itself otherwise."""
TESTS: Command = (sys.executable, "-m", "pytest", "-n", "auto", "--dist", "worksteal")


def main() -> int:
    """Run the checks; returns the exit code of the first that fails, or 0."""
    with tempfile.TemporaryDirectory() as pictures, ThreadPoolExecutor() as lanes:
        gallery = (sys.executable, "-m", "tests.gallery", pictures, "--quick", *SCENES)
        failed = _in_turn(RUFF)
        if not failed:
            first_other, *others = OTHER_TYPES
            beside = lanes.submit(_in_turn, (*OWN_TYPES_AND_LAYERS, first_other))
            failed = _in_turn((COLLECTION, gallery, *others)) or beside.result()
        return failed or _in_turn((TESTS,), live=True)


def _in_turn(commands: Sequence[Command], *, live: bool = False) -> int:
    """Run some; what they say is shown once they are done, or while they say it."""
    for command in commands:
        words = [str(word) for word in command]
        shown = " ".join(["$", Path(words[0]).name, *words[1:]])
        if live:
            print(shown, flush=True)
        done = subprocess.run(
            words,
            cwd=ROOT,
            check=False,
            env=_environment(),
            stdout=None if live else subprocess.PIPE,
            stderr=None if live else subprocess.STDOUT,
            text=True,
        )
        if not live:
            told = "" if command is COLLECTION and not done.returncode else done.stdout
            print(shown, told, sep="\n", end="", flush=True)
        if done.returncode:
            return done.returncode
    return 0


def _environment() -> dict[str, str]:
    """That of this process, but that what was compiled is kept for the next process."""
    return {key: text for key, text in os.environ.items() if key != "PYTHONDONTWRITEBYTECODE"}


if __name__ == "__main__":
    raise SystemExit(main())
