"""Mutation testing of the modules that keep the safety promises: ``python -m tests.mutants``.

Each module is changed in one place at a time by the operators of cosmic-ray, and the tests named
for it are run; a change that no test notices is told with its line. Not part of CI: it takes
minutes to hours. It needs cosmic-ray (``pip install -e .[mutation]``) and a system that can fork.

cosmic-ray's own runner starts a Python and loads Qt for each of them; here the tests run in forks
of a process that has loaded everything but the project.
"""

from __future__ import annotations

import argparse
import ast
import contextlib
import difflib
import itertools
import os
import shutil
import signal
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
_COPIED = ("armui", "tests", "resources", "urdf", "pyproject.toml")
_PRELOADED = ("pytest", "PySide6.QtTest", "can", "cantools", "numpy", "scipy.interpolate", "ruckig")
_OURS = frozenset({"armui", "tests"})
_LEAST_LIMIT_S = 60.0
_SLOWER = 5.0
_IS_NO_FAULT = ("# noqa", "TYPE_CHECKING", "__slots__")

TESTS: dict[str, tuple[str, ...]] = {
    "armui/bus/outbox.py": ("tests/bus", "tests/safety/test_s03*", "tests/safety/test_s17*"),
    "armui/control/safety/emergency_stop.py": (
        "tests/safety/test_s0[456]*",
        "tests/safety/test_s27*",
        "tests/control/test_arm_controller.py",
    ),
    "armui/control/authority.py": ("tests/control/test_authority*",),
    "armui/control/safety/other_command.py": (
        "tests/control/test_other_command.py",
        "tests/control/test_authority*",
    ),
    "armui/control/safety/overspeed.py": ("tests/control/test_authority*",),
    "armui/control/safety/hearing.py": ("tests/control/test_authority*",),
    "armui/control/safety/standstill.py": ("tests/control/test_authority*",),
    "armui/control/safety/interlocks.py": ("tests/control/test_gates.py", "tests/safety/test_s*"),
    "armui/control/assessment.py": ("tests/control/test_gates.py", "tests/safety/test_s*"),
    "armui/control/link/offsets.py": ("tests/safety/test_s04*", "tests/control/test_linkage.py"),
    "armui/control/link/handshake.py": (
        "tests/safety/test_s15*",
        "tests/control/test_arm_controller.py",
    ),
    "armui/control/requests/transactions.py": (
        "tests/safety/test_s14*",
        "tests/control/test_zeroing.py",
    ),
}
"""Which tests must notice a change of which module; patterns that match nothing are left out."""


@dataclass(frozen=True)
class Mutant:
    """One change of one module.

    Attributes:
        operator: cosmic-ray's name of it.
        source: The module's text with it.
        change: The lines that differ.
    """

    operator: str
    source: str
    change: str


def mutants(source: str) -> Iterator[Mutant]:
    """Every change of a module's text that is not only in a string of documentation."""
    import cosmic_ray.plugins as plugins  # noqa: PLC0415 - needed for this command only
    from cosmic_ray.mutating import mutate_code  # noqa: PLC0415

    seen = {_meaning(source)}
    for name in sorted(plugins.operator_names()):
        operator = plugins.get_operator(name)
        if operator.arguments():
            continue
        for occurrence in itertools.count():
            try:
                changed = mutate_code(source, operator(), occurrence)
            except AttributeError:  # a tuple of exceptions is more than the operator knows
                continue
            if changed is None:
                break
            text = changed.decode() if isinstance(changed, bytes) else changed
            change = _difference(source, text)
            meaning = _meaning(text)
            if meaning not in seen and not any(word in change for word in _IS_NO_FAULT):
                seen.add(meaning)
                yield Mutant(name, text, change)


def _meaning(source: str) -> str:
    """What a module does, without its annotations: nothing evaluates them."""
    try:
        tree = ast.parse(source)
    except SyntaxError:
        return source
    for node in ast.walk(tree):
        if isinstance(node, ast.AnnAssign | ast.arg):
            node.annotation = ast.Constant(None)
        elif isinstance(node, ast.FunctionDef):
            node.returns = None
    return ast.dump(tree)


def _difference(before: str, after: str) -> str:
    lines = difflib.unified_diff(before.splitlines(), after.splitlines(), n=0, lineterm="")
    return "\n".join(f"    {line}" for line in lines if not line.startswith(("---", "+++")))


def run_tests(folder: Path, tests: list[str], limit_s: float) -> int | None:
    """The exit code of the tests in a folder, run in a fork; None: they took too long."""
    child = os.fork()
    if child == 0:
        _be_child(folder, tests)
    deadline = time.monotonic() + limit_s
    while time.monotonic() < deadline:
        ended, status = os.waitpid(child, os.WNOHANG)
        if ended:
            return os.waitstatus_to_exitcode(status)
        time.sleep(0.02)
    with contextlib.suppress(ProcessLookupError):
        os.kill(child, signal.SIGKILL)
    os.waitpid(child, 0)
    return None


def _be_child(folder: Path, tests: list[str]) -> None:
    import pytest  # noqa: PLC0415 - loaded before the fork

    code = 1
    try:
        os.chdir(folder)
        for name in [each for each in sys.modules if each.partition(".")[0] in _OURS]:
            del sys.modules[name]
        sys.path[:] = [str(folder), *(each for each in sys.path if each not in ("", str(ROOT)))]
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, 1)
        os.dup2(nowhere, 2)
        options = ["-x", "-q", "-p", "no:cacheprovider", "-p", "no:xdist", "-p", "no:benchmark"]
        code = int(pytest.main([*options, *tests]))
    finally:
        os._exit(code)


def examine(module: str, first: int, last: int | None) -> int:
    """Run all mutants of a module; tells the survivors and returns how many there are."""
    source = (ROOT / module).read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for each in _COPIED:
            _copy(ROOT / each, folder / each)
        tests = sorted(
            {
                str(path.relative_to(ROOT))
                for pattern in TESTS[module]
                for path in ROOT.glob(pattern)
            }
        )
        if not tests:
            sys.stdout.write(f"{module}: none of its tests is there\n")
            return 0
        began_s = time.monotonic()
        if run_tests(folder, tests, 3600.0) != 0:
            sys.stdout.write(f"{module}: its tests fail without any change; nothing can be told\n")
            return 1
        took_s = time.monotonic() - began_s
        every = list(mutants(source))
        chosen = every[first:last]
        sys.stdout.write(
            f"{module}: {len(chosen)} of {len(every)} mutants, tests take {took_s:.1f} s\n"
        )
        survivors = 0
        for number, mutant in enumerate(chosen, start=first):
            (folder / module).write_text(mutant.source, encoding="utf-8")
            if run_tests(folder, tests, max(_LEAST_LIMIT_S, _SLOWER * took_s)) == 0:
                survivors += 1
                sys.stdout.write(f"  {number} survives: {mutant.operator}\n{mutant.change}\n")
            sys.stdout.flush()
        wall_s = time.monotonic() - began_s
        killed = len(chosen) - survivors
        sys.stdout.write(f"{module}: {killed} of {len(chosen)} killed in {wall_s:.0f} s\n")
        return survivors


def _copy(source: Path, target: Path) -> None:
    if source.is_dir():
        shutil.copytree(source, target, ignore=shutil.ignore_patterns("__pycache__"))
    else:
        shutil.copy2(source, target)


def main() -> int:
    """Examine the modules named, or all."""
    parser = argparse.ArgumentParser(prog="python -m tests.mutants", description=__doc__)
    parser.add_argument("module", nargs="*", choices=[[], *TESTS], help="all of them by default")
    parser.add_argument("--first", type=int, default=0, help="number of the first mutant (0)")
    parser.add_argument("--last", type=int, help="number behind the last mutant")
    options = parser.parse_args()
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    os.environ["PYTHONDONTWRITEBYTECODE"] = "1"
    sys.dont_write_bytecode = True
    for name in _PRELOADED:
        __import__(name)
    left = [examine(module, options.first, options.last) for module in options.module or TESTS]
    return 1 if any(left) else 0


if __name__ == "__main__":
    raise SystemExit(main())
