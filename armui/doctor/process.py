"""`armui doctor` in a process of its own, for the window: what it looks at may hang or crash."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import threading
from collections.abc import Callable, Sequence
from typing import Final

from armui.doctor.finding import Finding
from armui.doctor.report import findings_of_json, load_texts

_PATIENCE_S: Final = 180.0
_LAST_WORDS: Final = 300

Tell = Callable[[list[Finding] | str], object]
"""Given the findings, or in one line why there are none; called in another thread."""


class DoctorProcess:
    """One examination; it begins at once.

    Args:
        arguments: Of the command, beside ``--json``.
        tell: Told once, unless it is ended before.
    """

    def __init__(self, arguments: Sequence[str], tell: Tell) -> None:
        self._tell = tell
        self._process: subprocess.Popen[bytes] | None = None
        self._lock = threading.Lock()
        self._ended = False
        self._thread = threading.Thread(
            target=self._run, args=(_command(arguments),), name="armui-doctor", daemon=True
        )
        self._thread.start()

    def end(self) -> None:
        """End it, whatever it is doing: nobody waits for it any more."""
        with self._lock:
            self._ended = True
            if self._process is not None and self._process.poll() is None:
                self._process.kill()

    def wait(self, within_s: float) -> bool:
        """Whether it has ended, after a time at most."""
        self._thread.join(within_s)
        return not self._thread.is_alive()

    def _run(self, command: list[str]) -> None:
        try:
            process = self._start(command)
        except OSError as error:
            self._answer(error.strerror or str(error))
            return
        if process is None:
            return
        try:
            out, err = process.communicate(timeout=_PATIENCE_S)
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            self._answer(f"no answer within {_PATIENCE_S:.0f} s")
        else:
            self._answer(_findings(out.decode("utf-8", "replace"), err.decode("utf-8", "replace")))

    def _start(self, command: list[str]) -> subprocess.Popen[bytes] | None:
        with self._lock:
            if self._ended:
                return None
            self._process = subprocess.Popen(  # noqa: S603 - this program itself
                command,
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                env=dict(os.environ, PYTHONIOENCODING="utf-8"),
            )
            return self._process

    def _answer(self, answer: list[Finding] | str) -> None:
        load_texts()  # here, where nobody waits for the disk
        with self._lock:
            if self._ended:
                return
        self._tell(answer)


def _findings(out: str, err: str) -> list[Finding] | str:
    try:
        return findings_of_json(out)
    except (json.JSONDecodeError, ValueError, KeyError, TypeError):
        return err.strip()[-_LAST_WORDS:] or "the examination ended without a report"


def _command(arguments: Sequence[str]) -> list[str]:
    # a packaged program is its own interpreter
    start = [sys.executable] if getattr(sys, "frozen", False) else [sys.executable, "-m", "armui"]
    return [*start, "doctor", "--json", *arguments]
