"""Runs `armui doctor` for the window in a process of its own: examined parts may hang or crash."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Callable, Sequence
from typing import Final

from armui.doctor.adapter_change import helper_is_there
from armui.doctor.facts import Diagnosis, DiagnosisLevel
from armui.doctor.judge import NO_DEVICES, SHARED, judge_can
from armui.doctor.probes.can_devices import probe_adapters
from armui.doctor.report import findings_of_json
from armui.system.command_process import CommandProcess

_PATIENCE_S: Final = 180.0
"""An examination that takes longer hangs, as in a driver, and is ended."""
_LAST_WORDS: Final = 300

OnAnswer = Callable[[list[Diagnosis] | str], object]
"""Called in another thread with the findings, or with one line on why there are none."""

_GRAVE = (DiagnosisLevel.FAULT, DiagnosisLevel.WARNING)


class DoctorProcess(CommandProcess):
    """One examination, which starts at once.

    Args:
        arguments: The command's arguments beside ``--json``.
        on_answer: Called once, unless it is ended before.
    """

    def __init__(self, arguments: Sequence[str], on_answer: OnAnswer) -> None:
        super().__init__(["doctor", "--json", *arguments], on_answer)

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
        helper_is_there()  # cached here: this thread may wait for the disk
        super()._answer(answer)


def _findings(out: str, err: str) -> list[Diagnosis] | str:
    try:
        return findings_of_json(out)
    except (json.JSONDecodeError, ValueError, KeyError, TypeError):
        return err.strip()[-_LAST_WORDS:] or "the examination ended without a report"


def adapter_trouble() -> list[Diagnosis]:
    """Return faults of adapters: interfaces down or wrongly set, missing drivers, closed ports.

    No device is opened, and python-can is not used. It usually takes some milliseconds, and is
    meant for a thread that may wait. Faults come first, adapters on one USB controller last.
    """
    helper_is_there()  # cached for the window, which must not wait
    findings = judge_can(probe_adapters())
    grave = [
        each
        for level in _GRAVE
        for each in findings
        if each.severity is level and each.kind != NO_DEVICES
    ]
    return grave + [each for each in findings if each.kind == SHARED]
