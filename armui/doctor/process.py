"""`armui doctor` in a process of its own, for the window: what it looks at may hang or crash."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Callable, Sequence
from typing import Final

from armui.doctor.adapter_change import helper_is_there
from armui.doctor.facts import Diagnosis
from armui.doctor.report import findings_of_json, load_texts
from armui.system.command_process import CommandProcess

_PATIENCE_S: Final = 180.0
_LAST_WORDS: Final = 300

Tell = Callable[[list[Diagnosis] | str], object]
"""Given the findings, or in one line why there are none; called in another thread."""


class DoctorProcess(CommandProcess):
    """One examination; it begins at once.

    Args:
        arguments: Of the command, beside ``--json``.
        tell: Told once, unless it is ended before.
    """

    def __init__(self, arguments: Sequence[str], tell: Tell) -> None:
        super().__init__(["doctor", "--json", *arguments], tell)

    def _listen(self, process: subprocess.Popen[str] | OSError) -> None:
        if isinstance(process, OSError):
            self._answer(process.strerror or str(process))
            return
        try:
            out, err = process.communicate(timeout=_PATIENCE_S)
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            self._answer(f"no answer within {_PATIENCE_S:.0f} s")
        else:
            self._answer(_findings(out, err))

    def _answer(self, answer: object) -> None:
        load_texts()  # here, where nobody waits for the disk
        helper_is_there()
        super()._answer(answer)


def _findings(out: str, err: str) -> list[Diagnosis] | str:
    try:
        return findings_of_json(out)
    except (json.JSONDecodeError, ValueError, KeyError, TypeError):
        return err.strip()[-_LAST_WORDS:] or "the examination ended without a report"
