"""What the doctor says: one finding each, in words of two languages, with commands to copy."""

from __future__ import annotations

import enum
from collections.abc import Mapping
from dataclasses import dataclass, field


class Severity(enum.Enum):
    """How grave a finding is."""

    OK = "ok"
    NOTE = "note"
    WARNING = "warning"
    FAULT = "fault"


class Section(enum.Enum):
    """What a finding is about."""

    PROGRAM = "program"
    SCREEN = "screen"
    CAN = "can"
    ARM = "arm"


@dataclass(frozen=True, slots=True)
class Finding:
    """One thing found out.

    Attributes:
        section: What it is about.
        code: Names its words in ``resources/doctor/texts.toml``.
        severity: How grave it is.
        params: What the words mention.
        commands: The remedy, to be copied; a line each.
    """

    section: Section
    code: str
    severity: Severity
    params: Mapping[str, str] = field(default_factory=dict)
    commands: tuple[str, ...] = ()
