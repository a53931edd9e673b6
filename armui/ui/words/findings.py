"""The findings of a check as sentences: the thing, its value and limit, the remedy."""

from __future__ import annotations

from typing import Final

from armui.trajectory.planning.check import OTHER_ARM
from armui.trajectory.planning.findings import Finding, Severity
from armui.ui.words.arm import ARM_PARTS, arm_kind
from armui.ui.words.text import Text, Texts, joined, said, sentence

_CYCLES: Final = Texts("FindingCycle") | {"later": "From cycle {cycle} on: {text}"}

_ROW: Final = Text("FindingsPane", "Row {row}: {text}")
_SAMPLE: Final = Text("FindingsPane", "Sample {row}, at {seconds} s: {text}")
_RECORDED: Final = Text(
    "FindingsPane", "Trim the recording there, or save it as points and change those."
)
_KINDS: Final = {
    Severity.ERROR: Text("FindingsPane", "✕ Error"),
    Severity.WARNING: Text("FindingsPane", "! Warning"),
}

PARTS: Final = frozenset(ARM_PARTS)
"""The parts of the arm that have a name."""


_APPROACH: Final = Texts("Finding") | {
    "way": (
        "On the way there from where the arm stands now: {text} Bringing the arm nearer to this "
        "point first helps, too."
    ),
}


def finding(found: Finding) -> str:
    """Return a finding in the operator's language; the row is shown beside it."""
    params = {k: str(v) if k == "name" else _text(v) for k, v in found.params.items()}
    if found.kind == OTHER_ARM:
        params = {k: arm_kind(v) for k, v in params.items()}
    recorded = found.at_s is not None and found.severity is Severity.ERROR
    remedy = sentence(found.kind.context, found.kind.remedy, {}) if found.kind.remedy else ""
    text = joined(said(found.kind, params), _RECORDED.text() if recorded else remedy)
    if found.approach:
        return _APPROACH.text("way", {"text": text})
    if found.cycle == 1:
        return text
    return _CYCLES.text("later", {"cycle": str(found.cycle), "text": text})


def finding_line(found: Finding) -> str:
    """Return a finding with its weight and its place."""
    return f"{_KINDS[found.severity].text()} · {placed_finding(found)}"


def placed_finding(found: Finding) -> str:
    """Return a finding with its row, or of a recording its sample."""
    text = finding(found)
    if found.row is None:
        return text
    where = _ROW if found.at_s is None else _SAMPLE
    return where.text().format(row=found.row + 1, seconds=found.at_s, text=text)


def _text(value: float | str) -> str:
    if isinstance(value, str):
        return ARM_PARTS.word(value)
    return f"{round(value, 3):g}" if isinstance(value, float) else str(value)
