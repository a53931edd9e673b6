"""Converts events to lines of JSON, and appends them to files; this waits for the disk."""

from __future__ import annotations

import contextlib
import json
import math
from collections.abc import Callable, Mapping
from dataclasses import asdict
from datetime import datetime
from itertools import pairwise
from pathlib import Path
from typing import Any, Final

from armui.arm.device import Device
from armui.arm.refusal import Reason, Refusal
from armui.system.files import open_file
from armui.telemetry.events import Asker, EventEntry, EventKind, EventOutcome, Level

_YEARS: Final = 1970, 2300
LATEST_S: Final = 1e10
"""Times further away overflow a calendar."""

NAME: Final = "events.jsonl"
_MOST_BYTES: Final = 2_000_000
_OLD_FILES: Final = 4


def to_json(entry: EventEntry) -> str:
    """Return the line of an event without its end; times are by the clock that does not go back."""
    fields: dict[str, object] = {
        "number": entry.number,
        "wall": entry.wall.isoformat(timespec="milliseconds"),
        "at_s": round(entry.at_s, 6),
        "level": entry.level.name.lower(),
        "kind": entry.kind.value,
        "who": entry.who.value,
        "code": entry.code,
    }
    if entry.params:
        fields["params"] = _plain(entry.params)
    if entry.lasts:
        fields["lasts"] = True
        fields["ended_s"] = None if entry.ended_s is None else round(entry.ended_s, 6)
    if entry.unheard:
        fields["unheard"] = True
    if entry.count != 1:
        fields["count"] = entry.count
    if entry.last_s is not None:
        fields["last_s"] = round(entry.last_s, 6)
    for name, outcome in (("answer", entry.answer), ("result", entry.result)):
        if outcome is not None:
            fields[name] = _outcome(outcome)
    return json.dumps(fields, ensure_ascii=False, separators=(",", ":"))


def from_record(record: Mapping[str, Any]) -> EventEntry:
    """Return the event in the JSON values of a line.

    Raises:
        ValueError: The values are no event, or are impossible.
    """
    try:
        return _entry(record)
    except (AttributeError, KeyError, TypeError, OverflowError, RecursionError) as error:
        raise ValueError(f"no event: {type(error).__name__}: {error}") from error


def _entry(read: Mapping[str, Any]) -> EventEntry:
    wall = datetime.fromisoformat(read["wall"])
    if wall.tzinfo is None:
        raise ValueError(f"the time {read['wall']!r} has no time zone")
    if not _YEARS[0] <= wall.year <= _YEARS[1]:
        raise ValueError(f"the time {read['wall']!r} is none of this program's")
    return EventEntry(
        number=_whole(read["number"]),
        at_s=_figure(read["at_s"]),
        wall=wall,
        level=Level[read["level"].upper()],
        kind=EventKind(read["kind"]),
        who=Asker(read["who"]),
        code=_text(read["code"]),
        params=_params(read.get("params", {})),
        lasts=bool(read.get("lasts", False)),
        ended_s=_if_any(_figure, read.get("ended_s")),
        unheard=bool(read.get("unheard", False)),
        count=_whole(read.get("count", 1)),
        last_s=_if_any(_figure, read.get("last_s")),
        answer=_if_any(_outcome_of, read.get("answer")),
        result=_if_any(_outcome_of, read.get("result")),
    )


def _outcome(outcome: EventOutcome) -> dict[str, object]:
    fields: dict[str, object] = {
        "code": outcome.code,
        "at_s": round(outcome.at_s, 6),
        "level": outcome.level.name.lower(),
    }
    if outcome.params:
        fields["params"] = _plain(outcome.params)
    return fields


def _outcome_of(read: Mapping[str, Any]) -> EventOutcome:
    return EventOutcome(
        _text(read["code"]),
        _figure(read["at_s"]),
        Level[read["level"].upper()],
        _params(read.get("params", {})),
    )


def _plain(params: Mapping[str, object]) -> dict[str, object]:
    return {name: _plain_value(value) for name, value in params.items()}


def _plain_value(value: object) -> object:
    if isinstance(value, Refusal):
        return {"refusal": str(value.code), "params": _plain(value.params)}
    if isinstance(value, Device):
        return {"device": asdict(value)}
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)
    if value is None or isinstance(value, bool | int | float | str):
        return value
    if isinstance(value, list | tuple):
        return [_plain_value(each) for each in value]
    return str(value)


def _params(read: Mapping[str, Any]) -> dict[str, object]:
    return {_text(name): _value(value) for name, value in read.items()}


def _value(read: Any) -> object:
    if isinstance(read, list):
        return tuple(_value(each) for each in read)
    if not isinstance(read, dict):
        return read
    if "refusal" in read:
        reason = Reason(_text(read["refusal"]))
        return Refusal(reason, _params(read.get("params", {})))  # type: ignore[arg-type]
    if "device" in read:
        fields = dict(read["device"])
        fields["options"] = tuple(tuple(each) for each in fields.get("options", ()))
        return Device(**fields)
    raise ValueError(f"a figure that is none: {str(read)[:60]}")


def _if_any(make: Callable[[Any], Any], read: object) -> Any:
    return None if read is None else make(read)


def _figure(read: object) -> float:
    if isinstance(read, bool) or not isinstance(read, int | float) or not abs(read) <= LATEST_S:
        raise ValueError(f"{str(read)[:60]!r} is no figure")
    return float(read)


def _whole(read: object) -> int:
    if isinstance(read, bool) or not isinstance(read, int):
        raise ValueError(f"{str(read)[:60]!r} is no whole number")  # noqa: TRY004 - what from_record raises
    return read


def _text(read: object) -> str:
    if not isinstance(read, str):
        raise ValueError(f"{str(read)[:60]!r} is no text")  # noqa: TRY004 - what from_record raises
    return read


def append(
    folder: Path, text: str, most_bytes: int = _MOST_BYTES, old_files: int = _OLD_FILES
) -> None:
    """Append lines to the file; a full file is renamed and a new one begun.

    Args:
        folder: The folder; it need not exist.
        text: Whole lines.
        most_bytes: A file that is larger becomes ``events.1.jsonl``.
        old_files: The number of those that are kept.

    Raises:
        OSError: The disk or the folder does not allow it.
    """
    path = folder / NAME
    folder.mkdir(parents=True, exist_ok=True)
    with open_file(path, "a+b") as file:
        size = file.seek(0, 2)
        torn = False
        if size:
            file.seek(size - 1)
            torn = file.read(1) != b"\n"  # the disk was full in the middle of a line
        data = (b"\n" if torn else b"") + text.encode("utf-8", "replace")
        file.write(data)
        size += len(data)
    if size > most_bytes:
        _rotate(folder, old_files)


def _rotate(folder: Path, old_files: int) -> None:
    names = [NAME, *(f"events.{number}.jsonl" for number in range(1, old_files + 1))]
    for newer, older in reversed(list(pairwise(names))):
        with contextlib.suppress(FileNotFoundError):
            (folder / newer).replace(folder / older)
