"""Findings as text to read, or as JSON, in Chinese or English."""

from __future__ import annotations

import json
import locale
import os
from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import Final, Literal

from armui import __version__
from armui.doctor.adapter_change import helper_is_there
from armui.doctor.facts import Diagnosis, DiagnosisLevel, Section
from armui.doctor.judge import judge_can
from armui.doctor.probes.can_devices import look_at_adapters
from armui.system.files import read_file

Language = Literal["zh", "en"]

_TEXTS: Final = Path("doctor") / "texts.toml"
_MARKS: Final = {
    "en": {
        DiagnosisLevel.OK: "[ ok ]",
        DiagnosisLevel.NOTE: "[note]",
        DiagnosisLevel.WARNING: "[warn]",
        DiagnosisLevel.FAULT: "[FAIL]",
    },
    "zh": {
        DiagnosisLevel.OK: "[正常]",
        DiagnosisLevel.NOTE: "[提示]",
        DiagnosisLevel.WARNING: "[注意]",
        DiagnosisLevel.FAULT: "[故障]",
    },
}
_INDENT: Final = "       "


class Words:
    """The words of one language.

    Args:
        language: Which.
    """

    def __init__(self, language: Language) -> None:
        self.language: Language = language

    def text(self, finding: Diagnosis) -> str:
        """A finding as a sentence."""
        return self._get("finding", finding.code).format_map(finding.params)

    def section(self, section: Section) -> str:
        """What a section is called."""
        return self._get("section", section.value)

    def plain(self, name: str) -> str:
        """A sentence of the report itself."""
        return self._get("report", name)

    def mark(self, severity: DiagnosisLevel) -> str:
        """How a severity is marked at the beginning of a line."""
        return _MARKS[self.language][severity]

    def _get(self, table: str, name: str) -> str:
        return load_texts()[table][name][self.language]


@cache
def load_texts() -> Mapping[str, Mapping[str, Mapping[str, str]]]:
    """The words, by table, name and language; read once, by whoever may wait for the disk."""
    import tomllib  # noqa: PLC0415 - Python 3.10 lacks it, and is to be told so

    return tomllib.loads(read_file(_resources() / _TEXTS).decode())


def _resources() -> Path:
    """As `armui.system.paths` has it, which wants a package that may be missing."""
    package = Path(__file__).resolve().parents[1]
    installed = package / "resources"
    return installed if installed.is_dir() else package.parent / "resources"


def language_of_system(settings_file: Path | None = None) -> Language:
    """The language chosen in the program, else Chinese if the system speaks it, else English."""
    if settings_file is not None:
        try:
            chosen = json.loads(read_file(settings_file)).get("language")
        except (OSError, ValueError, AttributeError):
            chosen = None
        if chosen == "zh":
            return "zh"
        if chosen == "en":
            return "en"
    names = [os.environ.get(name, "") for name in ("LC_ALL", "LC_MESSAGES", "LANG")]
    name = next((each for each in names if each), "") or (locale.getlocale()[0] or "")
    return "zh" if name.lower().startswith(("zh", "chinese")) else "en"


def as_text(findings: Sequence[Diagnosis], words: Words, *, arm_answers: bool, asked: bool) -> str:
    """The report for people, and for a support mail."""
    lines = [f"armui doctor {__version__}"]
    lines.append(words.plain("asked" if asked else "listened"))
    for section in Section:
        mine = [each for each in findings if each.section is section]
        if mine:
            lines += ["", words.section(section)]
        for finding in mine:
            lines.append(f"{words.mark(finding.severity)} {words.text(finding)}")
            lines += [f"{_INDENT}$ {command}" for command in finding.commands]
    lines += ["", words.plain("arm_answers" if arm_answers else "no_arm_answers")]
    return "\n".join(lines) + "\n"


def as_json(findings: Sequence[Diagnosis], words: Words, *, arm_answers: bool, asked: bool) -> str:
    """One object: "armui", "arm_answers", "asked", and "findings" with their parts and words."""
    return (
        json.dumps(
            {
                "armui": __version__,
                "arm_answers": arm_answers,
                "asked": asked,
                "findings": [
                    {
                        "section": each.section.value,
                        "code": each.code,
                        "severity": each.severity.value,
                        "text": words.text(each),
                        "commands": list(each.commands),
                        "remedies": [list(words) for words in each.remedies],
                        "params": dict(each.params),
                    }
                    for each in findings
                ],
            },
            ensure_ascii=False,
            indent=2,
        )
        + "\n"
    )


def findings_of_json(text: str) -> list[Diagnosis]:
    """The findings in what :func:`as_json` made.

    Raises:
        ValueError, KeyError: It is something else.
    """
    return [
        Diagnosis(
            Section(each["section"]),
            each["code"],
            DiagnosisLevel(each["severity"]),
            each["params"],
            tuple(each["commands"]),
            tuple(tuple(words) for words in each["remedies"]),
        )
        for each in json.loads(text)["findings"]
    ]


_GRAVE = (DiagnosisLevel.FAULT, DiagnosisLevel.WARNING)


def adapter_trouble() -> list[Diagnosis]:
    """Interfaces that are down or wrongly set, adapters without a driver, ports nobody may open.

    No device is opened, and python-can is not asked. Takes some milliseconds, as a rule; for a
    thread that may wait. Faults come first.
    """
    load_texts()  # whoever shows the findings must not wait for the disk
    helper_is_there()
    findings = judge_can(look_at_adapters())
    return [
        each
        for level in _GRAVE
        for each in findings
        if each.severity is level and each.code != "no_devices"
    ]
