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
TYPES_AND_LAYERS: tuple[Command, ...] = (
    *(
        (SCRIPTS / "mypy", "--platform", system, "--cache-dir", f".mypy_cache/{system}")
        for system in ("linux", "win32", "darwin")
    ),
    (SCRIPTS / "lint-imports",),
)
"""Types for every system, wherever the check runs: what only one of them has is found on all.

Each has its own cache: with one for all, each takes what the one before has found out for old.
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
            beside = lanes.submit(_in_turn, TYPES_AND_LAYERS)
            failed = _in_turn((COLLECTION, gallery)) or beside.result()
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
