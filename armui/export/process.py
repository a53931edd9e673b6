"""Runs `armui export` for the window in a process of its own, so that they share no lock.

It can be ended at any moment; the unfinished file is then removed.
"""

from __future__ import annotations

import contextlib
import json
import shutil
import subprocess
import threading
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from armui.session.exports.request import (
    ExportFormat,
    ExportProblem,
    ExportProgress,
    ExportRequest,
)
from armui.system.command_process import CommandProcess

_LAST_WORDS: Final = 300
_NICER_BY: Final = 5
"""The nice value's increase, so that window and bus come first if there are too few cores."""


@dataclass(frozen=True, slots=True)
class ExportDone:
    """The result of an export.

    Attributes:
        problem: The reason why nothing was written; ``None`` if it was.
        detail: Details of it, or the output of a process that failed.
        report: The fields of `ExportReport` by name; empty if nothing was written.
    """

    problem: ExportProblem | None = None
    detail: str = ""
    report: dict[str, Any] | None = None


OnAnswer = Callable[[ExportProgress | ExportDone], object]
"""Called in another thread with the progress, and at last with the result."""


class ExportProcess(CommandProcess):
    """One export, which starts at once.

    Args:
        request: The export that is wanted.
        on_answer: Called until it is over, unless it is ended before.
    """

    def __init__(self, request: ExportRequest, on_answer: OnAnswer) -> None:
        self._unfinished: Path | None = None
        super().__init__(_arguments(request), on_answer, nicer_by=_NICER_BY)

    def _listen(self, process: subprocess.Popen[str] | OSError) -> None:
        """Pass on the process's output until it has ended."""
        if isinstance(process, OSError):
            self._answer(ExportDone(None, process.strerror or str(process)))
            return
        last: ExportDone | None = None
        complaints: list[str] = []
        listener = threading.Thread(
            target=lambda: complaints.extend(process.stderr or ()), daemon=True
        )
        listener.start()
        for line in process.stdout or ():
            said = self._understood(line)
            if isinstance(said, ExportDone):
                last = said
            elif said is not None:
                self._answer(said)
        process.wait()
        listener.join()
        if last is None:
            self._remove_unfinished()
            text = "".join(complaints).strip()[-_LAST_WORDS:]
            last = ExportDone(None, text or f"ended with code {process.returncode}")
        self._answer(last)

    def _understood(self, line: str) -> ExportProgress | ExportDone | None:
        try:
            said = json.loads(line)
        except json.JSONDecodeError:
            return None
        if "unfinished" in said:
            self._unfinished = Path(said["unfinished"])
        elif "report" in said:
            return ExportDone(report=said["report"])
        elif said.get("problem") in set(ExportProblem):
            return ExportDone(ExportProblem(said["problem"]), said["detail"])
        elif "frames" in said:
            return ExportProgress(said["done"], said["frames"])
        return None

    def _remove_unfinished(self) -> None:
        """Remove what a killed process left unfinished, which it cannot remove itself."""
        if self._unfinished is not None:
            with contextlib.suppress(OSError):
                if self._unfinished.is_dir():
                    shutil.rmtree(self._unfinished)
                else:
                    self._unfinished.unlink(missing_ok=True)


def _arguments(request: ExportRequest) -> list[str]:
    command = ["export", "--json", "--to", str(ExportFormat(request.format))]
    command += ["--output", str(request.target), "--from", repr(request.begin_s)]
    if request.end_s != float("inf"):
        command += ["--to-time", repr(request.end_s)]
    if request.wishes.generation is not None:
        command += ["--generation", str(int(request.wishes.generation))]
    if request.wishes.firmware:
        command += ["--firmware", request.wishes.firmware]
    if request.wishes.channel:
        command += ["--channel", request.wishes.channel]
    if request.wishes.model is not None:
        command += ["--model", request.wishes.model.value]
    if request.replace:
        command.append("--force")
    # a name may begin like an option
    return [*command, "--", str(request.log)]
