"""Findings as text to read, or as JSON, in Chinese or English."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar, Final

from armui import __version__
from armui.doctor.facts import Diagnosis, DiagnosisLevel, Section
from armui.doctor.judge import BY_ID
from armui.system.plain_words import Translate
from armui.system.sentence import Sentence

_INDENT: Final = "       "


@dataclass(frozen=True, slots=True)
class ReportText(Sentence):
    """A text of the report itself."""

    context: ClassVar[str] = "DoctorReport"


LISTENED = ReportText("listened", "Listened only: nothing was sent.")
ASKED = ReportText("asked", "Questions were sent to the arm (--ask): they move and change nothing.")
ARM_ANSWERS = ReportText("arm_answers", "An arm answers.")
NO_ARM_ANSWERS = ReportText("no_arm_answers", "No arm answers.")
OF_PROGRAM = ReportText("of_program", "Program")
OF_SCREEN = ReportText("of_screen", "Screen")
OF_CAN = ReportText("of_can", "CAN devices")
OF_ARM = ReportText("of_arm", "Bus and arm")
MARKED_OK = ReportText("marked_ok", "[ ok ]")
MARKED_NOTE = ReportText("marked_note", "[note]")
MARKED_WARNING = ReportText("marked_warning", "[warn]")
MARKED_FAULT = ReportText("marked_fault", "[FAIL]")

_SECTIONS: Final = {
    Section.PROGRAM: OF_PROGRAM,
    Section.SCREEN: OF_SCREEN,
    Section.CAN: OF_CAN,
    Section.ARM: OF_ARM,
}
_MARKS: Final = {
    DiagnosisLevel.OK: MARKED_OK,
    DiagnosisLevel.NOTE: MARKED_NOTE,
    DiagnosisLevel.WARNING: MARKED_WARNING,
    DiagnosisLevel.FAULT: MARKED_FAULT,
}


class Words:
    """The words of one language.

    Args:
        translate: Translates them.
    """

    def __init__(self, translate: Translate) -> None:
        self._translate = translate

    def text(self, finding: Diagnosis) -> str:
        """Return a finding as a sentence."""
        return self.plain(finding.kind).format_map(finding.params)

    def section(self, section: Section) -> str:
        """Return the title of a section."""
        return self.plain(_SECTIONS[section])

    def plain(self, text: Sentence) -> str:
        """Return a text without figures."""
        return self._translate(text.context, text.source)

    def mark(self, severity: DiagnosisLevel) -> str:
        """Return the mark of a severity at the beginning of a line."""
        return self.plain(_MARKS[severity])


def as_text(findings: Sequence[Diagnosis], words: Words, *, arm_answers: bool, asked: bool) -> str:
    """Return the report for people, and for a support mail."""
    lines = [f"armui doctor {__version__}"]
    lines.append(words.plain(ASKED if asked else LISTENED))
    for section in Section:
        mine = [each for each in findings if each.section is section]
        if mine:
            lines += ["", words.section(section)]
        for finding in mine:
            lines.append(f"{words.mark(finding.severity)} {words.text(finding)}")
            lines += [f"{_INDENT}$ {command}" for command in finding.commands]
    lines += ["", words.plain(ARM_ANSWERS if arm_answers else NO_ARM_ANSWERS)]
    return "\n".join(lines) + "\n"


def as_json(findings: Sequence[Diagnosis], words: Words, *, arm_answers: bool, asked: bool) -> str:
    """Return one object: "armui", "arm_answers", "asked", and "findings" with their sentences."""
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
    """Return the findings in a text by :func:`as_json`.

    Raises:
        ValueError, KeyError: The text is something else.
    """
    return [
        Diagnosis(
            BY_ID[each["code"]],
            DiagnosisLevel(each["severity"]),
            each["params"],
            tuple(each["commands"]),
            tuple(tuple(words) for words in each["remedies"]),
        )
        for each in json.loads(text)["findings"]
    ]
