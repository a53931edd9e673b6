"""Turns the plain forms of other programs into tables: JSON, YAML, ROS, arrays in cells.

Their points are records of names and figures; a record becomes a row, nested names become titles
like ``position.joint1``. The meaning of the figures then follows from the titles, as in any table.
"""

from __future__ import annotations

import csv
import io
import json
import re
from collections.abc import Iterator, Mapping, Sequence
from itertools import islice
from typing import Any, Final, NamedTuple

from armui.arm.refusal import Reason
from armui.trajectory.columns.model import JOINTS, as_number
from armui.trajectory.files.errors import broken

FILE_FOREIGN = Reason(
    "file_foreign",
    "This file of another program has no plain list of places. Write each place as a row of a "
    "CSV file with the titles time_s, joint1_rad … joint6_rad, gripper_m (or joint1_deg …, "
    "gripper_mm), and import that.",
)
FILE_COMMANDS = Reason(
    "file_commands",
    "This file holds commands that only another program knows: {text}. Write each place as a row "
    "of a CSV file with the titles joint1_rad … joint6_rad (or joint1_deg …), dwell_s, and import "
    "that.",
)

_STRUCTURED: Final = re.compile(r"\s*(?:[{\[]|(?:[#;].*\n\s*)*(?:---|- |[\w./'\"]+:(?:\s|$)))")
"""The beginning of JSON and of YAML."""
_PPR: Final = re.compile(r"^\s*t(-?[\d.]+)\b.*?\bJ\d?\[([^\]]*)\](?:.*?\bGrp\[([^\],]*))?", re.M)
"""A line of a recording of joints in brackets, as ``t1701 x150 … J6[0,45,…] Grp[80,…]``."""
_WAITS: Final = re.compile(
    r"(?:wait|hold|dwell|pause|sleep|delay|duration)(?:_?time)?(_?(?:ms|s))?"
)
_SECONDS: Final = re.compile(r"(.*?)[._]?secs?(?:onds)?", re.I)
_NANOSECONDS: Final = re.compile(r"(.*?)[._]?n(?:ano)?secs?(?:onds)?", re.I)
_ARRAY: Final = re.compile(r"[\[(]([-+\d.eE,;\s]+)[\])]")
_NAMES: Final = ("name", "names", "joint_names", "joint_name")
_LEAST: Final = len(JOINTS)
_HEAD: Final = 20_000


class Table(NamedTuple):
    """A foreign text as a table of comma-separated values.

    Attributes:
        text: The table, with titles wherever the form tells names.
        is_record: True if the form tells by names what each figure is; false for a table before.
    """

    text: str
    is_record: bool


def is_structured(text: str) -> bool:
    """Return whether a text begins as JSON or YAML, or as one of the recordings known."""
    return _STRUCTURED.match(text) is not None or _PPR.search(text[:_HEAD]) is not None


def as_table(text: str) -> Table | None:
    """Return a foreign text as a table; ``None`` if it is a plain table, or no form known here.

    Raises:
        TrajectoryFileError: It holds commands with which a row of places cannot be told.
    """
    if _PPR.search(text[:_HEAD]):
        return Table(_of_brackets(text), True)
    if _STRUCTURED.match(text):
        try:
            records = _places(_parsed(text), {})
        except RecursionError:  # nested far too deep for points
            return None
        return None if not records else Table(_written(_rows(records)), True)
    return _of_cells(text)


def _of_brackets(text: str) -> str:
    comments = " ".join(line for line in text[:_HEAD].splitlines() if line.lstrip()[:1] in ";#")
    unit = next((unit for unit in ("deg", "rad") if unit in comments.lower()), "")
    titles = ["time_ms", *(f"j{joint} {unit}" for joint in range(1, 1 + _LEAST)), "gripper mm"]
    found = [(t, *joints.split(","), grip) for t, joints, grip in _PPR.findall(text)]
    return _written([titles[: len(found[0])], *found])


def _parsed(text: str) -> Any:
    """Return the content of JSON, of a JSON object in each line, or of YAML; else ``None``."""
    try:
        return json.loads(text)
    except ValueError:
        pass
    try:
        return [json.loads(line) for line in text.splitlines() if line.strip()]
    except ValueError:
        from armui.trajectory.columns.plain_yaml import read_yaml  # noqa: PLC0415 - seldom wanted

        return read_yaml(text)


def _places(data: Any, around: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Return the first list of records with points, each with unit and names from around it."""
    if isinstance(data, dict):
        columns = [value for value in data.values() if _is_numbers(value)]
        if len(columns) >= _LEAST and len(set(map(len, columns))) == 1 and len(columns[0]) > 1:
            titles = [title for title, value in data.items() if _is_numbers(value)]
            return [dict(zip(titles, row, strict=True)) for row in zip(*columns, strict=True)]
        around = {**around, **data}
        found = (_places(value, around) for value in data.values())
        return next(filter(None, found), [])
    if not isinstance(data, list):
        return []
    if data and all(map(_is_place, data)) and all(map(_is_numbers, data)):
        return [{"": row} for row in data]
    records = [each for each in data if isinstance(each, dict)]
    if any(map(_is_place, records)) and len(records) == len(data):
        names = next((around[key] for key in _NAMES if _is_names(around.get(key))), None)
        unit = next((str(value) for key, value in around.items() if "unit" in key.lower()), "")
        return [{"unit": unit, "joint_names": names, **each} for each in records]
    return next(filter(None, (_places(each, around) for each in data)), [])


def _is_place(value: Any) -> bool:
    """Return whether a value holds six figures in a list, or by name."""
    if _is_numbers(value):
        return len(value) >= _LEAST
    if not isinstance(value, dict):
        return False
    named = sum(bool(re.search(r"(?:joint|j|q)_?\d", str(key), re.I)) for key in value)
    return named >= _LEAST or any(map(_is_place, value.values()))


def _is_numbers(value: Any) -> bool:
    return isinstance(value, list) and all(
        isinstance(each, int | float) and not isinstance(each, bool) for each in value
    )


def _is_names(value: Any) -> bool:
    return isinstance(value, list) and bool(value) and all(isinstance(each, str) for each in value)


def _rows(records: Sequence[dict[str, Any]]) -> list[Sequence[Any]]:
    """Return titles and rows; a wait between two points becomes a cell of the first one.

    Raises:
        TrajectoryFileError: A record between them is neither.
    """
    places: list[dict[str, Any]] = []
    unknown: dict[str, None] = {}
    for record in records:
        if _is_place(record):
            places.append(dict(_flat(record)))
            continue
        waits = {
            match.group(1) or "": value
            for key, value in record.items()
            if (match := _WAITS.fullmatch(str(key))) and isinstance(value, int | float)
        }
        if len(waits) == 1:
            ((unit, value),) = waits.items()
            title = f"dwell_{unit.strip('_') or 's'}"
            for place in places[-1:]:
                place[title] = place.get(title, 0) + value
            continue
        texts = [str(value) for key, value in record.items() if key in ("type", "command", "cmd")]
        if texts or record is not records[-1]:  # the last one may be cut off
            unknown[texts[0] if texts else "?"] = None
    if unknown:
        raise broken(FILE_COMMANDS, text=", ".join(unknown))
    titles = list(dict.fromkeys(title for place in places for title in place))
    return _merged([titles, *([place.get(title, "") for title in titles] for place in places)])


def _flat(record: Mapping[str, Any], before: str = "") -> Iterator[tuple[str, Any]]:
    """Yield the titles and figures of a record, those of nested ones after their names."""
    names = next((record[key] for key in _NAMES if _is_names(record.get(key))), ())
    unit = f" [{record['unit']}]" if record.get("unit") else ""
    for key, value in record.items():
        title = f"{before}{key}"
        if isinstance(value, dict):
            yield from _flat(value, f"{title}.")
        elif _is_numbers(value):
            named = len(names) == len(value)
            for place, each in enumerate(value):
                yield f"{title}.{names[place]}{unit}" if named else f"{title}_{place}{unit}", each
        elif isinstance(value, int | float) and not isinstance(value, bool):
            yield title, value
        elif isinstance(value, str) and key in ("name", "label"):
            yield "note", value


def _of_cells(text: str) -> Table | None:
    """Return a table whose cells hold arrays, names or parted times as one of plain figures."""
    first = text[:_HEAD].partition("\n")[0]
    delimiter = max(",;\t", key=first.count)
    try:
        head = list(islice(csv.reader(io.StringIO(text[:_HEAD]), delimiter=delimiter), 2))
    except csv.Error:
        return None
    if len(head) < 2 or len(head[0]) < 2:
        return None
    titles = _titles_of_echo(head[0])
    arrays = [place for place, cell in enumerate(head[1]) if _array(cell)]
    parted = any(_NANOSECONDS.fullmatch(title) for title in head[0])
    if not (titles or arrays or parted):
        return None
    rows: list[Sequence[Any]] = [titles] if titles else []
    try:
        rows += filter(None, csv.reader(io.StringIO(text), delimiter=delimiter))
    except csv.Error:
        return None
    if arrays and not titles:
        rows = [_spread(row, arrays, head[1], is_title=not place) for place, row in enumerate(rows)]
    return Table(_written(_merged(rows)), bool(titles))


def _titles_of_echo(cells: Sequence[str]) -> list[str]:
    """Return the titles of a row of ``ros2 topic echo --csv`` of joint states; else none.

    It holds seconds, nanoseconds, the frame, the names, and for each name a position, perhaps a
    velocity and an effort.
    """
    texts = [as_number(cell, ".") is None for cell in cells[3:]]
    count = next((place for place, is_text in enumerate(texts) if not is_text), 0)
    names = cells[3 : 3 + count]
    if count < _LEAST or any(texts[count:]) or len(texts) < 2 * count or not cells[1].isdigit():
        return []
    titles = ["sec", "nanosec", "frame", *(f"name_of_{each}" for each in names)]
    titles += [f"position.{name}" for name in names]
    return titles + [f"velocity or effort {each}" for each in range(len(cells) - len(titles))]


def _array(cell: str) -> list[str]:
    """Return the figures of an array written in a cell, if they are six or more."""
    match = _ARRAY.search(cell)
    found = re.split(r"[,;\s]+", match.group(1).strip(" ,;\n\r\t")) if match else []
    return found if len(found) >= _LEAST else []


def _spread(
    row: Sequence[str], arrays: Sequence[int], like: Sequence[str], *, is_title: bool
) -> list[str]:
    """Return a row with each array's figures in cells of their own; of titles, numbered ones."""
    cells: list[str] = []
    for place, cell in enumerate(row):
        if place not in arrays:
            cells.append(cell)
        elif is_title:
            cells += [f"{cell}_{number}" for number in range(len(_array(like[place])))]
        else:
            cells += _array(cell)
    return cells


def _merged(rows: Sequence[Sequence[Any]]) -> list[Sequence[Any]]:
    """Return a table whose times in seconds and nanoseconds are one column of seconds each."""
    titles = [str(title) for title in rows[0]]
    ends = [match.group(1) if (match := _SECONDS.fullmatch(each)) else None for each in titles]
    for place, title in enumerate(titles[1:], start=1):
        match = _NANOSECONDS.fullmatch(title)
        if match is None or ends[place - 1] != match.group(1):
            continue
        stem = match.group(1).rstrip("._")
        merged: list[Sequence[Any]] = [
            [*titles[: place - 1], f"{stem or 'time'} [s]", *titles[place + 1 :]]
        ]
        for row in rows[1:]:
            both = row[place - 1 : place + 1]
            time = f"{int(both[0])}.{int(both[1]):09d}" if len(both) == 2 else ""
            merged.append([*row[: place - 1], time, *row[place + 1 :]])
        return merged
    return list(rows)


def _written(rows: Sequence[Sequence[Any]]) -> str:
    stream = io.StringIO(newline="")
    csv.writer(stream, lineterminator="\n").writerows(rows)
    return stream.getvalue()
