"""The lines beside a recording: its source, its events, and how it ended.

Each line is a JSON object with its ``kind``; the first one is the ``session``. Lines are only ever
added, so that a killed program damages at most the last one.

Kinds: ``session`` (format, program, device, time base), ``arm``, ``cell`` (what of a
cell held) and ``settings`` (as read while it was recorded), ``event`` (an entry of the program's
events, its log time and its kind of mark), ``file`` (a file was begun; the log time from which it
counts), ``lost`` (frames that are missing from here on), ``clock`` (the time of day was set
meanwhile), ``episode`` (an episode was marked), ``end``, ``counted`` (the counts of its frames, if
it has no events).
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Final

from armui.session.frames import LATEST_S
from armui.session.recording.kinds import RecordingFormat
from armui.session.session import MarkKind, SessionMark

SUFFIX: Final = ".armui.jsonl"
VERSION: Final = 1
Line = Mapping[str, object]
MOST_BYTES: Final = 64_000_000
"""A larger file is something else, or holds more events than anybody can look through."""
_LONGEST_TEXT: Final = 1_000

_TIMES: Final = ("at_s", "ended_s", "last_s")
"""The fields of an event with times by the program's clock."""
_OUTCOMES: Final = ("answer", "result")
"""The fields with the outcomes of an event, each of which has its own time."""


def path_of(folder: Path, name: str) -> Path:
    """Return the path of a recording's sidecar."""
    return folder / f"{name}{SUFFIX}"


def as_bytes(lines: Sequence[Line]) -> bytes:
    """Return lines as in the file; values that are no JSON become text."""
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
    """Return a line for an event.

    Args:
        at_s: Log time.
        mark: The kind of mark on a time line.
        entry: The event's JSON values.
    """
    return {"kind": "event", "time_s": at_s, "mark": mark.name.lower(), "entry": dict(entry)}


def read_lines(data: bytes) -> list[dict[str, Any]]:
    """Return the intact lines of a sidecar; the others are skipped."""
    lines = []
    for text in data[:MOST_BYTES].split(b"\n"):
        try:
            line = json.loads(text)
        except (ValueError, RecursionError):
            continue
        if isinstance(line, dict) and isinstance(line.get("kind"), str):
            lines.append(line)
    return lines


def number_in(line: Mapping[str, Any], name: str) -> float | None:
    """Return a number in a line, or ``None`` if there is none, or none that can be a time."""
    value = line.get(name)
    if isinstance(value, bool) or not isinstance(value, int | float):
        return None
    return float(value) if abs(value) <= LATEST_S else None


def text_in(line: Mapping[str, Any], name: str, default: str = "") -> str:
    """Return a text in a line, or the default if there is none."""
    value = line.get(name)
    return value[:_LONGEST_TEXT] if isinstance(value, str) else default


def format_in(line: Mapping[str, Any]) -> RecordingFormat | None:
    """Return the format named in a first line, or ``None`` if it names no known one."""
    named = text_in(line, "format")
    return RecordingFormat(named) if named in {each.value for each in RecordingFormat} else None


def events_of(lines: Sequence[Mapping[str, Any]]) -> list[Mapping[str, Any]]:
    """Return the lines with events; of one that was written again when it ended, the last."""
    found: dict[object, Mapping[str, Any]] = {}
    for place, line in enumerate(lines):
        entry = line.get("entry")
        if line["kind"] == "event" and isinstance(entry, dict):
            number = entry.get("number")
            found[number if isinstance(number, int) else f"line {place}"] = line
    return list(found.values())


def marks_of(lines: Sequence[Mapping[str, Any]]) -> list[SessionMark]:
    """Return the marks in the lines, in the order of time, in log times."""
    marks = []
    shift_s = _shift_s(lines[0]) if lines else 0.0
    for line in events_of(lines):
        at_s, name = number_in(line, "time_s"), text_in(line, "mark", "note").upper()
        kind = MarkKind[name] if name in MarkKind.__members__ else MarkKind.NOTE
        if at_s is not None:
            marks.append(SessionMark(at_s, kind, _shifted(line["entry"], shift_s)))
    for line in lines:
        at_s = number_in(line, "time_s")
        if line["kind"] == "lost" and at_s is not None:
            entry = {key: value for key, value in line.items() if key != "time_s"}
            marks.append(SessionMark(at_s, MarkKind.NOTE, entry))
    return sorted(marks, key=lambda mark: mark.at_s)


def _shift_s(first: Mapping[str, Any]) -> float:
    """Return the shift from the program's clock to log time, from the session's line."""
    unix_s, steady_s = number_in(first, "unix_s"), number_in(first, "steady_s")
    return 0.0 if unix_s is None or steady_s is None else unix_s - steady_s


def _shifted(entry: Mapping[str, Any], by_s: float) -> dict[str, Any]:
    times = {
        name: round(at_s + by_s, 6)
        for name in _TIMES
        if (at_s := number_in(entry, name)) is not None
    }
    outcomes = {
        name: _shifted(entry[name], by_s)
        for name in _OUTCOMES
        if isinstance(entry.get(name), dict) and by_s
    }
    return {**entry, **times, **outcomes}
