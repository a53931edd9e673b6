"""The lines beside a recording: what it is of, what happened, and how it ended.

Each line is a JSON object with its ``kind``; the first one is the ``session``. Lines are only ever
added, so that a killed program leaves all but the last one whole.

Kinds: ``session`` (format, program, device, time base), ``arm`` and ``settings`` (as read while it
was recorded), ``event`` (an entry of the program's events, its log time and the sort of mark it
is), ``file`` (a file was begun; the log time from which it
counts), ``lost`` (frames that are missing from here on), ``clock``
(the time of day was set meanwhile), ``end``.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any, Final

from armui.session.session import Mark, MarkKind

SUFFIX: Final = ".armui.jsonl"
VERSION: Final = 1
Line = Mapping[str, object]
MOST_BYTES: Final = 64_000_000
"""A larger file is something else, or holds events that nobody can look through."""


def as_bytes(lines: Sequence[Line]) -> bytes:
    """Lines as they stand in the file; what is no JSON value is told as text."""
    return "".join(
        f"{json.dumps(line, ensure_ascii=False, default=str, allow_nan=False)}\n"
        for line in map(_finite, lines)
    ).encode("utf-8", "replace")


def _finite(line: Line) -> Line:
    try:
        json.dumps(line, default=str, allow_nan=False)
    except ValueError:
        return {key: str(value) for key, value in line.items()}
    return line


def event_line(at_s: float, mark: MarkKind, entry: Mapping[str, object]) -> Line:
    """A line for an event.

    Args:
        at_s: Log time.
        mark: What sort of moment it is on a time line.
        entry: The event as it is written, JSON values only.
    """
    return {"kind": "event", "time_s": at_s, "mark": mark.name.lower(), "entry": dict(entry)}


def read_lines(data: bytes) -> list[dict[str, Any]]:
    """The lines of a sidecar that are whole; the others are passed over."""
    lines = []
    for text in data[:MOST_BYTES].split(b"\n"):
        try:
            line = json.loads(text)
        except (ValueError, RecursionError):
            continue
        if isinstance(line, dict) and isinstance(line.get("kind"), str):
            lines.append(line)
    return lines


def marks_of(lines: Sequence[Mapping[str, Any]]) -> list[Mark]:
    """The moments worth going to, in the order of time."""
    marks = []
    for line in lines:
        at_s, entry = line.get("time_s"), line.get("entry")
        if line["kind"] == "lost":
            entry = {key: value for key, value in line.items() if key != "time_s"}
        if not isinstance(at_s, int | float) or not isinstance(entry, dict):
            continue
        name = str(line.get("mark", "note")).upper()
        kind = MarkKind[name] if name in MarkKind.__members__ else MarkKind.NOTE
        marks.append(Mark(float(at_s), kind, entry))
    return sorted(marks, key=lambda mark: mark.at_s)
