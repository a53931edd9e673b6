"""`.log`, our own text format: made to be read and written by people, one point a line.

A first line with the kind and the version, some lines `key: value`, an empty line, then points or
samples. Empty lines are ignored; lines that begin with # are comments, and are kept.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterator
from dataclasses import replace
from typing import Any, Final

import numpy as np

from armui.arm.refusal import Reason
from armui.cell.tools import Tool
from armui.cell.user_frames import UserFrame
from armui.trajectory.files.errors import FILE_VERSION, HEADER_UNKNOWN, TrajectoryFileError, broken
from armui.trajectory.files.log_points import (
    OPTION_TWICE,
    VALUES_COUNT,
    read_point,
    read_text,
    write_point,
)
from armui.trajectory.files.model import (
    VERSIONS,
    Content,
    UnwritableError,
    parse_time,
    verified,
    verify,
    version_of,
)
from armui.trajectory.files.text import number, parse_number, read_figures
from armui.trajectory.points.program import OF_FLANGE, Trajectory, Waypoint, check_point
from armui.trajectory.samples.recording import COLUMN_COUNT, GRIPPER, Array, Recording

FILE_KIND_UNKNOWN = Reason(
    "file_kind_unknown",
    ("This is not a trajectory file that the program knows. Import it by columns."),
)


_FIRST: Final = re.compile(r"armui (trajectory|recording) (\d{1,9})\s*")
_ENTRY: Final = re.compile(r"([A-Za-z]\w*):[ \t]*(.*?)[ \t]*")


_NAMED_POSE: Final = re.compile(r'("(?:[^"\\]|\\.)*")((?:\s+[^\s"]+){6})')

_TITLES: Final = "# t_s J1 J2 J3 J4 J5 J6 (deg) gripper_mm"


def is_log(text: str) -> bool:
    """Return whether a text begins as this format does."""
    return _FIRST.match(text) is not None


def name_in(beginning: str) -> str | None:
    """Return the name in a text that this program wrote: it is in the second line.

    Args:
        beginning: The beginning of the text, at least its first two lines.
    """
    first, _, rest = beginning.partition("\n")
    entry = _ENTRY.fullmatch(rest.partition("\n")[0])
    if not is_log(first) or entry is None or entry.group(1) != "name":
        return None
    try:
        return read_text(entry.group(2), 2, 1)
    except TrajectoryFileError:
        return None


def write(content: Content) -> str:
    """Return a trajectory or recording as text.

    Raises:
        UnwritableError: The content cannot be written.
    """
    if isinstance(content, Trajectory):
        return "".join(lines(content))
    verify(content)
    return "".join(_header(content)) + write_samples(content.samples)


def lines(trajectory: Trajectory) -> Iterator[str]:
    """Yield a trajectory as text, point by point, so that its writer may pause between them.

    Yields:
        Lines with their ends; several at once if they belong together.

    Raises:
        UnwritableError: The trajectory cannot be written; discard the lines yielded before.
    """
    verify(replace(trajectory, points=()))
    yield from _header(trajectory)
    for row, point in enumerate(trajectory.points, start=1):
        reason = check_point(point)
        if reason is not None:
            raise UnwritableError(trajectory.name, row, reason)
        yield "".join(f"#{comment}\n" for comment in point.comments) + write_point(point) + "\n"
    for comment in trajectory.closing:
        yield f"#{comment}\n"


def _header(content: Content) -> Iterator[str]:
    kind = "trajectory" if isinstance(content, Trajectory) else "recording"
    yield f"armui {kind} {version_of(content)}\n"
    yield f"name: {_text(content.name)}\n"
    if content.note:
        yield f"note: {_text(content.note)}\n"
    if content.taught_on:
        yield f"taught_on: {_text(content.taught_on)}\n"
    if isinstance(content, Trajectory):
        named = (("frame", frame) for frame in content.poses_of.frames)
        tool = () if content.poses_of.tool is None else (("tool", content.poses_of.tool),)
        for key, each in (*tool, *named):
            figures = " ".join(map(number, each.pose))
            yield f"{key}: {json.dumps(each.name, ensure_ascii=False)} {figures}\n"
    yield f"modified: {content.modified.isoformat()}\n\n"


def read(text: str, name: str) -> Content:
    """Return the trajectory or recording in a text.

    Args:
        text: The text of the file.
        name: The name used if the header holds none.

    Raises:
        TrajectoryFileError: With line and column.
    """
    lines = text.split("\n")
    first = _FIRST.fullmatch(lines[0])
    if first is None:
        raise broken(FILE_KIND_UNKNOWN, 1, 1)
    kind, version = first.group(1), int(first.group(2))
    if version not in VERSIONS:
        column = first.start(2) + 1
        raise broken(FILE_VERSION, 1, column, value=version, maximum=VERSIONS[-1])
    fields, begin, comments = _read_header(lines)
    fields.setdefault("name", name)
    if kind == "recording":
        if "poses_of" in fields:
            raise broken(HEADER_UNKNOWN, value="tool / frame")
        return read_samples(lines, begin, fields)
    points, closing, numbers = _read_points(lines, begin, comments)
    return verified(Trajectory(points=points, closing=closing, **fields), numbers)


def _read_header(lines: list[str]) -> tuple[dict[str, Any], int, list[str]]:
    """Return the entries, the index of the first line after them, and the comments among them."""
    fields: dict[str, Any] = {}
    comments: list[str] = []
    frames: list[UserFrame] = []
    for index, raw in enumerate(lines[1:], start=1):
        line = raw.strip()
        if line.startswith("#"):
            comments.append(_comment(raw))
            continue
        entry = _ENTRY.fullmatch(line)
        if entry is None:
            if line:
                return fields, index, comments
            continue
        key, value = entry.groups()
        column = entry.start(2) + 1
        if key == "frame":
            frames.append(UserFrame(*_named_pose(value, index + 1, column)))
            fields["poses_of"] = replace(fields.get("poses_of", OF_FLANGE), frames=tuple(frames))
            continue
        if key in fields or (key == "tool" and fields.get("poses_of", OF_FLANGE).tool):
            raise broken(OPTION_TWICE, index + 1, 1, value=key)
        if key == "tool":
            tool = Tool(*_named_pose(value, index + 1, column))
            fields["poses_of"] = replace(fields.get("poses_of", OF_FLANGE), tool=tool)
        elif key == "modified":
            fields[key] = parse_time(value, index + 1, column)
        elif key in ("name", "note", "taught_on"):
            fields[key] = read_text(value, index + 1, column)
        else:
            raise broken(HEADER_UNKNOWN, index + 1, 1, value=key)
    return fields, len(lines), comments


def _named_pose(text: str, line: int, column: int) -> tuple[str, tuple[float, ...]]:
    """Return a name in quotation marks and the six figures behind it."""
    found = _NAMED_POSE.fullmatch(text)
    if found is None:
        raise broken(VALUES_COUNT, line, column, value=max(0, len(text.split()) - 1), expected=6)
    figures = tuple(parse_number(word, line, column) for word in found.group(2).split())
    return read_text(found.group(1), line, column), figures


def _read_points(
    lines: list[str], begin: int, comments: list[str]
) -> tuple[tuple[Waypoint, ...], tuple[str, ...], list[int]]:
    """Return the points, the comments after the last, and the number of each point's line."""
    points: list[Waypoint] = []
    numbers: list[int] = []
    for line, raw in enumerate(lines[begin:], start=begin + 1):
        text = raw.strip()
        if not text:
            continue
        if text.startswith("#"):
            comments.append(_comment(raw))
            continue
        points.append(read_point(raw.rstrip("\r"), line, tuple(comments)))
        numbers.append(line)
        comments.clear()
    return tuple(points), tuple(comments), numbers


def _comment(line: str) -> str:
    return line.rstrip("\r").partition("#")[2]


def _text(text: str) -> str:
    """Return a text bare where it reads back as it is, else in quotation marks."""
    plain = text.isprintable() and text == text.strip() and not text.startswith('"')
    return text if plain and text else json.dumps(text, ensure_ascii=False)


def write_samples(samples: Array) -> str:
    """Return the lines of samples; the gripper is omitted if it was not recorded."""
    lines = [_TITLES]
    for row in samples.tolist():
        values = row[:GRIPPER] if math.isnan(row[GRIPPER]) else row
        lines.append(" ".join(map(number, values)))
    return "\n".join(lines) + "\n"


def read_samples(lines: list[str], begin: int, fields: dict[str, Any]) -> Content:
    """Return the recording in the lines of a file.

    Args:
        lines: The lines of the file.
        begin: The index of the first line after the header.
        fields: The fields of the header.

    Raises:
        TrajectoryFileError: With line and column.
    """
    places = [place for place in range(begin, len(lines)) if _is_sample(lines[place])]
    figures = read_figures([lines[place] for place in places], None)
    if figures is not None and figures.shape[1] in (GRIPPER, COLUMN_COUNT):
        samples = np.full((len(figures), COLUMN_COUNT), np.nan)
        samples[:, : figures.shape[1]] = figures
        return verified(Recording(samples=samples, **fields), [place + 1 for place in places])
    return _read_one_by_one(lines, begin, fields)


def _is_sample(line: str) -> bool:
    text = line.lstrip()
    return bool(text) and not text.startswith("#")


def _read_one_by_one(lines: list[str], begin: int, fields: dict[str, Any]) -> Content:
    """Return the same, line by line: only some samples hold the gripper, or one is wrong."""
    rows: list[list[float]] = []
    numbers: list[int] = []
    for line, text in enumerate(lines[begin:], start=begin + 1):
        words = text.split()
        if not words or words[0].startswith("#"):
            continue
        if len(words) not in (GRIPPER, COLUMN_COUNT):
            raise broken(VALUES_COUNT, line, 1, value=len(words), expected="7 or 8")
        try:
            row = list(map(float, words))
        except ValueError:
            row = [parse_number(word, line, text.find(word) + 1) for word in words]
        rows.append(row if len(row) == COLUMN_COUNT else [*row, math.nan])
        numbers.append(line)
    samples = np.array(rows, dtype=np.float64).reshape(-1, COLUMN_COUNT)
    return verified(Recording(samples=samples, **fields), numbers)
