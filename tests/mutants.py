"""Mutation testing of the modules that keep the safety promises: ``python -m tests.mutants``.

Each module is changed in one place at a time, and the tests named for it are run; a change that no
test notices is told with its line. Not part of CI: all modules take half an hour. It needs
cosmic-ray (``pip install -e .[mutation]``) and a system that can fork. What it has found stands in
``resources/docs/mutation.md``.

cosmic-ray's own runner starts a Python and loads Qt for each of them; here the tests run in forks
of a process that has loaded everything but the project.
"""

from __future__ import annotations

import argparse
import ast
import contextlib
import gc
import importlib
import os
import shutil
import sys
import tempfile
import time
import traceback
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from tests.mutations import Mutant, mutants
from tests.posix import kill, of_system

ROOT = Path(__file__).resolve().parents[1]
_COPIED = ("armui", "tests", "resources", "urdf", "pyproject.toml")
_PRELOADED = (
    "pytest",
    "PySide6.QtTest",
    "can",
    "cantools",
    "numpy",
    "scipy.interpolate",
    "ruckig",
    "hypothesis",
    "pytestqt.plugin",
    "pytest_timeout",
)
_OURS = frozenset({"armui", "tests"})
_OPTIONS = ("-x", "-q", "--assert=plain", "-p", "no:cacheprovider", "-p", "no:unraisableexception")
_PLUGINS = ("pytestqt.plugin", "pytest_timeout")
_NOT_PRELOADED = ("armui.viewport", "armui.ui")
_LEAST_LIMIT_S = 3.0
_SLOWER = 5.0


@dataclass(frozen=True)
class Judges:
    """The tests that must notice a change of a module; patterns that match nothing are left out.

    Attributes:
        fast: Tests of the module itself, which need nothing of ``tests/conftest.py``.
        slow: Tests of the whole program, for what the fast ones do not notice.
        fixtures: The module with the fixtures of the fast ones, if they have any from elsewhere.
    """

    fast: tuple[str, ...] = ()
    slow: tuple[str, ...] = ()
    fixtures: str = ""


TESTS: dict[str, Judges] = {
    "armui/control/authority.py": Judges(
        ("tests/control/test_authority*",),
        ("tests/safety/test_s0[789]*", "tests/safety/test_s1[0123]*"),
    ),
    "armui/control/authority_watch.py": Judges(
        ("tests/control/test_authority_watch.py",),
        ("tests/safety/test_s07*", "tests/safety/test_s13*"),
    ),
    "armui/control/context.py": Judges(
        ("tests/control/test_context.py",), ("tests/safety/test_s12*", "tests/safety/test_s13*")
    ),
    "armui/bus/outbox.py": Judges(
        ("tests/bus/test_outbox*", "tests/bus/test_sending.py"),
        (
            *("tests/bus/test_worker.py", "tests/safety/test_s03*"),
            *("tests/safety/test_s17*", "tests/safety/test_s35_one_gate.py"),
        ),
        fixtures="tests.bus.conftest",
    ),
    "armui/control/safety/emergency_stop.py": Judges(
        ("tests/control/test_emergency_stop.py",),
        ("tests/safety/test_s0[456]*", "tests/safety/test_s27*"),
    ),
    "armui/control/safety/stopping.py": Judges(
        ("tests/control/test_stopping.py",),
        ("tests/safety/test_s0[456]*", "tests/safety/test_s26*", "tests/safety/test_s27*"),
    ),
    "armui/control/link/offsets.py": Judges(
        ("tests/control/test_offsets.py",),
        ("tests/safety/test_s04*", "tests/control/test_linkage.py"),
    ),
    "armui/control/link/handshake.py": Judges(
        ("tests/control/test_handshake.py",), ("tests/safety/test_s15*",)
    ),
    "armui/control/requests/transactions.py": Judges(
        ("tests/control/test_transaction*",),
        ("tests/safety/test_s14*", "tests/control/test_zeroing.py"),
        fixtures="tests.control.conftest",
    ),
    "armui/control/safety/overspeed.py": Judges(
        ("tests/control/test_overspeed*", "tests/control/test_authority_speed.py"),
        ("tests/safety/test_s12*",),
    ),
    "armui/control/safety/command_acknowledgement.py": Judges(
        ("tests/control/test_command_acknowledgement.py",), ("tests/safety/test_s07_a_motion*",)
    ),
    "armui/control/safety/feedback_freshness.py": Judges(
        ("tests/control/test_feedback_freshness.py",), ("tests/safety/test_s09*",)
    ),
    "armui/control/safety/standstill.py": Judges(
        ("tests/control/test_standstill.py",), ("tests/safety/test_s1[03]*",)
    ),
    "armui/control/safety/interlocks.py": Judges(
        ("tests/control/test_interlocks.py",), ("tests/control/test_refused_meanwhile.py",)
    ),
    "armui/control/assessment.py": Judges(
        ("tests/control/test_assessment.py",),
        ("tests/control/test_refused_meanwhile.py", "tests/safety/test_s09*"),
    ),
    "armui/control/safety/other_command.py": Judges(
        ("tests/control/test_other_command.py",),
        ("tests/safety/test_s13*", "tests/safety/test_s25*"),
    ),
    "armui/control/motion/motion_command.py": Judges(
        ("tests/control/test_authority*", "tests/control/test_motion_command.py"),
        ("tests/safety/test_s0[789]*",),
    ),
    "armui/arm/other_hosts.py": Judges(
        ("tests/arm/test_other_hosts.py",), ("tests/safety/test_s13*",)
    ),
}
"""Which tests must notice a change of which module."""


def run_tests(tests: list[str], options: tuple[str, ...], limit_s: float) -> int | None:
    """The exit code of tests in the folder one is in, run in a fork; None: they took too long."""
    child: int = of_system("fork")()
    if child == 0:
        _be_child(tests, options)
    deadline = time.monotonic() + limit_s
    while time.monotonic() < deadline:
        ended, status = os.waitpid(child, of_system("WNOHANG"))
        if ended:
            return os.waitstatus_to_exitcode(status)
        time.sleep(0.005)
    with contextlib.suppress(ProcessLookupError):
        kill(child)
    os.waitpid(child, 0)
    return None


def _be_child(tests: list[str], options: tuple[str, ...]) -> None:
    import pytest  # noqa: PLC0415 - loaded before the fork

    plugins = [word for name in _PLUGINS for word in ("-p", name)]
    code = 1
    try:
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, 1)
        os.dup2(nowhere, 2)
        code = int(pytest.main([*_OPTIONS, *options, *plugins, *tests]))
    finally:
        os._exit(code)


def _files(patterns: tuple[str, ...]) -> list[str]:
    return sorted(
        {str(path.relative_to(ROOT)) for pattern in patterns for path in ROOT.glob(pattern)}
    )


def _name(path: Path) -> str:
    parts = path.with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def _imports(path: Path, names: frozenset[str]) -> set[str]:
    """The modules of the project that one of its files imports, anywhere in it."""
    found: set[str] = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            found.update(each.name for each in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module is not None:
            found.add(node.module)
            found.update(f"{node.module}.{each.name}" for each in node.names)
    return found & names


def _dependents(folder: Path, module: str) -> set[str]:
    """A module and all that import it, directly or not: they are loaded anew with each change."""
    paths = {_name(path.relative_to(folder)): path for path in (folder / "armui").rglob("*.py")}
    names = frozenset(paths)
    imported = {name: _imports(path, names) for name, path in paths.items()}
    found: set[str] = set()
    new = {module}
    while new:
        found |= new
        # a package is loaded for each of its modules, and may import others of them itself
        new = {
            name
            for name, others in imported.items()
            if any(each in found or each.startswith(f"{name}.") for each in others)
            and others & found
        } - found
    return found


def _load(folder: Path, module: str) -> None:
    """Be in a folder, with all of the program loaded that does not depend on a module."""
    os.chdir(folder)
    for name in [each for each in sys.modules if each.partition(".")[0] in _OURS]:
        del sys.modules[name]
    sys.path[:] = [str(folder), *(each for each in sys.path if each not in ("", str(ROOT)))]
    left = _dependents(folder, module)
    for path in sorted((folder / "armui").rglob("*.py")):
        name = _name(path.relative_to(folder))
        apart = name.endswith("__main__") or name.startswith(_NOT_PRELOADED)
        if not apart and not any(each == name or each.startswith(f"{name}.") for each in left):
            importlib.import_module(name)
    gc.collect()
    gc.freeze()


def examine(module: str, chosen: Callable[[int, Mutant], bool], *, fast_only: bool) -> int:
    """Run all mutants of a module; tells the survivors and returns how many there are."""
    source = (ROOT / module).read_text(encoding="utf-8")
    judges = TESTS[module]
    alone = ("--noconftest", *(("-p", judges.fixtures) if judges.fixtures else ()))
    rounds: list[tuple[list[str], tuple[str, ...]]] = [(_files(judges.fast), alone)]
    if not fast_only:
        rounds.append((_files(judges.slow), ()))
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for each in _COPIED:
            _copy(ROOT / each, folder / each)
        _load(folder, _name(Path(module)))
        limits_s = []
        for tests, options in rounds:
            began_s = time.monotonic()
            if tests and run_tests(tests, options, 600.0) != 0:
                sys.stdout.write(f"{module}: {tests} fail without any change\n")
                return 1
            limits_s.append(_SLOWER * (time.monotonic() - began_s) + _LEAST_LIMIT_S)
            sys.stdout.write(f"{module}: {tests} take {time.monotonic() - began_s:.2f} s\n")
        sys.dont_write_bytecode = True  # a change may be as long as another, and of the same second
        for path in (folder / module).parent.glob(f"__pycache__/{Path(module).stem}.*"):
            path.unlink()
        every = list(mutants(source))
        numbered = [(k, mutant) for k, mutant in enumerate(every) if chosen(k, mutant)]
        sys.stdout.write(f"{module}: {len(numbered)} of {len(every)} mutants\n")
        survivors = 0
        began_s = time.monotonic()
        for number, mutant in numbered:
            (folder / module).write_text(mutant.source, encoding="utf-8")
            lives = all(
                not tests or run_tests(tests, options, limit_s) == 0
                for (tests, options), limit_s in zip(rounds, limits_s, strict=True)
            )
            if lives:
                survivors += 1
                sys.stdout.write(f"  {number} survives: {mutant.operator}\n{mutant.change}\n")
            sys.stdout.flush()
        wall_s = time.monotonic() - began_s
        killed = len(numbered) - survivors
        sys.stdout.write(f"{module}: {killed} of {len(numbered)} killed in {wall_s:.0f} s\n")
        return survivors


def _apart(module: str, chosen: Callable[[int, Mutant], bool], *, fast_only: bool) -> int:
    """The same in a process of its own: another module needs others to be loaded."""
    sys.stdout.flush()
    child: int = of_system("fork")()
    if child == 0:
        code = 1
        try:
            code = min(1, examine(module, chosen, fast_only=fast_only))
        except Exception:  # noqa: BLE001 - told, and the next module goes on
            traceback.print_exc()
        finally:
            sys.stdout.flush()
            os._exit(code)
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])


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
    parser.add_argument("--only", type=int, nargs="+", help="numbers of single mutants")
    parser.add_argument("--operator", default="", help="part of the operator's name")
    parser.add_argument("--fast", action="store_true", help="only the tests of the module itself")
    options = parser.parse_args()
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    os.environ["PYTEST_DISABLE_PLUGIN_AUTOLOAD"] = "1"  # to look for them takes long
    for name in (*_PRELOADED, *_PLUGINS):
        __import__(name)
    import _pytest.config  # noqa: PLC0415 - needed for this command only

    for name in _pytest.config.default_plugins:
        __import__(f"_pytest.{name}")
    last = sys.maxsize if options.last is None else options.last

    def chosen(number: int, mutant: Mutant) -> bool:
        of_kind = options.operator in mutant.operator
        in_range = options.first <= number < last and number in (options.only or [number])
        return of_kind and in_range

    left = [_apart(module, chosen, fast_only=options.fast) for module in options.module or TESTS]
    return 1 if any(left) else 0


if __name__ == "__main__":
    raise SystemExit(main())
