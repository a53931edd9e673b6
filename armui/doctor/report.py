"""Findings as text to read, or as JSON, in Chinese or English."""

from __future__ import annotations

import json
import locale
import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar, Final, Literal, get_args
from xml.etree import ElementTree as ET

from armui import __version__
from armui.doctor.facts import Diagnosis, DiagnosisLevel, Section
from armui.doctor.judge import BY_ID
from armui.system.files import read_file
from armui.system.sentence import Sentence

Language = Literal["zh", "en"]
LANGUAGES: Final[tuple[Language, ...]] = get_args(Language)

Translate = Callable[[str, str], str]
"""Translates a text of a context, like Qt's own function."""


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
_INDENT: Final = "       "


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


def translation(language: Language) -> Translate:
    """Return a function that translates into a language by reading the texts' file, without Qt."""
    if language == "en":
        return lambda _context, source: source
    file = _resources() / "i18n" / "armui_zh.ts"
    content = ET.fromstring(read_file(file))  # noqa: S314 - our own
    texts = {
        (context.findtext("name"), message.findtext("source")): message.findtext("translation")
        for context in content.iter("context")
        for message in context.iter("message")
    }
    return lambda context, source: texts.get((context, source)) or source


def _resources() -> Path:
    """As `armui.system.paths` has it, which wants a package that may be missing."""
    package = Path(__file__).resolve().parents[1]
    installed = package / "resources"
    return installed if installed.is_dir() else package.parent / "resources"


def language_of_system(settings_file: Path | None = None) -> Language:
    """Return the program's chosen language, else Chinese if the system uses it, else English."""
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
