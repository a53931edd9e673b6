"""A command of this program in a process of its own, for the window."""

from __future__ import annotations

import contextlib
import os
import subprocess
import sys
import threading
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, Final

_END_S: Final = 10.0
NO_CONSOLE: Final[int] = getattr(subprocess, "CREATE_NO_WINDOW", 0)
"""The flag by which a command, started without a console, gets none of its own that would flash up.
"""
_WITHOUT_CONSOLE: Final = "armui-window"


def is_packaged() -> bool:
    """Tell whether the program has a Python of its own, to which pip can add nothing."""
    return bool(getattr(sys, "frozen", False))


def this_program() -> list[str]:
    """Return the command line that starts this program again; the name of a command follows.

    A packaged program is its own interpreter, without an interpreter's options. On Windows there
    are two beside each other: one without a console, one whose output can be read.
    """
    if not is_packaged():
        return [sys.executable, "-m", "armui"]
    program = Path(sys.executable)
    return [str(program.with_stem("armui") if program.stem == _WITHOUT_CONSOLE else program)]


class CommandProcess:
    """Runs a command; it starts at once, and a thread reads its output.

    Args:
        arguments: The program's arguments: the name of the command first.
        on_answer: Called in that thread with its output and its result, until it is ended.
        nicer_by: The nice value's increase, so that window and bus come first if there are too few
            cores.

    Attributes:
        is_ended: True if it was ended by :meth:`end`.
    """

    def __init__(
        self, arguments: Sequence[str], on_answer: Callable[[Any], object], *, nicer_by: int = 0
    ) -> None:
        self._command = [*this_program(), *arguments]
        self._on_answer = on_answer
        self._nicer_by = nicer_by
        self._process: subprocess.Popen[str] | None = None
        self._lock = threading.Lock()
        self.is_ended = False
        self._thread = threading.Thread(target=self._run, name=f"armui-{arguments[0]}", daemon=True)
        self._thread.start()

    def end(self) -> None:
        """Kill the process, whatever it is doing."""
        with self._lock:
            self.is_ended = True
            if self._process is not None and self._process.poll() is None:
                self._process.kill()

    def wait(self, within_s: float = _END_S) -> bool:
        """Wait up to a time; return whether it has ended and its output was read."""
        self._thread.join(within_s)
        return not self._thread.is_alive()

    def _listen(self, process: subprocess.Popen[str] | OSError) -> None:
        """Listen to the process now that it runs, or to the error that kept it from running."""
        raise NotImplementedError

    def _answer(self, answer: object) -> None:
        if not self.is_ended:
            self._on_answer(answer)

    def _run(self) -> None:
        try:
            process = self._start()
        except OSError as error:
            self._listen(error)
            return
        if process is not None:
            with process:  # closes its pipes at the end of the block
                self._listen(process)

    def _start(self) -> subprocess.Popen[str] | None:
        with self._lock:
            if self.is_ended:
                return None
            self._process = subprocess.Popen(  # noqa: S603 - this program itself
                self._command,
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                env=dict(os.environ, PYTHONIOENCODING="utf-8"),
                encoding="utf-8",
                errors="replace",
                creationflags=NO_CONSOLE,
            )
            if sys.platform != "win32" and self._nicer_by:
                with contextlib.suppress(OSError):
                    os.setpriority(os.PRIO_PROCESS, self._process.pid, self._nicer_by)
            return self._process
