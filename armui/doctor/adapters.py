"""What keeps an adapter of this computer from being used, and what mends it: a quick look."""

from __future__ import annotations

from armui.doctor.finding import Diagnosis, DiagnosisLevel
from armui.doctor.judge_can import judge_can
from armui.doctor.probes.can_devices import look_at_adapters
from armui.doctor.report import load_texts

_GRAVE = (DiagnosisLevel.FAULT, DiagnosisLevel.WARNING)


def adapter_trouble() -> list[Diagnosis]:
    """Interfaces that are down or wrongly set, adapters without a driver, ports nobody may open.

    No device is opened, and python-can is not asked. Takes some milliseconds, as a rule; for a
    thread that may wait. Faults come first.
    """
    load_texts()  # whoever shows the findings must not wait for the disk
    findings = judge_can(look_at_adapters())
    return [
        each
        for level in _GRAVE
        for each in findings
        if each.severity is level and each.code != "no_devices"
    ]
