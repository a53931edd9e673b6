"""`.csv`, for spreadsheets: one row of titles, then a row for each point or sample.

Rows whose first cell is # hold a comment; rows that begin with #name, #note, #taught_on or
#modified hold what belongs to the whole, and stand at the end, where they do not disturb a table.
"""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterator
from typing import Any, Final

import numpy as np

from armui.arm.refusal_codes import RefusalCode
from armui.trajectory.files import csv_points
from armui.trajectory.files.errors import broken
from armui.trajectory.files.model import Content, parse_time, verified, verify
from armui.trajectory.files.text import number, parse_number
from armui.trajectory.points.program import Trajectory, Waypoint
from armui.trajectory.samples.recording import COLUMN_COUNT, GRIPPER, Recording

SAMPLE_TITLES: Final = ("t_s", *(f"j{joint}_deg" for joint in range(1, 7)), "gripper_mm")
_LONGEST_CELL: Final = 1 << 20

Row = tuple[int, list[str]]
"""Number of its first line, and its cells."""


def is_csv(text: str) -> bool:
    """Whether a text has the titles of this format, in any order."""
    titles = _titles(text.partition("\n")[0])
    return "move" in titles or titles >= set(SAMPLE_TITLES[:GRIPPER])


def write(content: Content) -> str:
    """A trajectory or recording as text.

    Raises:
        UnwritableError: It is not possible.
    """
    verify(content)
    stream = io.StringIO(newline="")
    writer = csv.writer(stream)
    if isinstance(content, Trajectory):
        writer.writerow(csv_points.TITLES)
        for point in content.points:
            writer.writerows(("#", comment) for comment in point.comments)
            writer.writerow(csv_points.write_cells(point))
        writer.writerows(("#", comment) for comment in content.closing)
    else:
        writer.writerow(SAMPLE_TITLES)
        for row in content.samples.tolist():
            writer.writerow(["" if math.isnan(value) else number(value) for value in row])
    writer.writerow(("#name", content.name))
    if content.note:
        writer.writerow(("#note", content.note))
    if content.taught_on:
        writer.writerow(("#taught_on", content.taught_on))
    writer.writerow(("#modified", content.modified.isoformat()))
    return stream.getvalue()


def read(text: str, name: str) -> Content:
    """The trajectory or recording of a text.

    Args:
        text: Of the file, line ends as they are.
        name: What it is called where no row says so.

    Raises:
        TrajectoryFileError: With the line and, as column, the cell.
    """
    table = rows(text, _delimiter(text.partition("\n")[0]))
    _, titles = next(table, (1, []))
    titles = [title.strip().lower() for title in titles]
    fields: dict[str, Any] = {"name": name}
    body = _body(table, fields)
    if "move" in titles:
        points, closing, lines = _read_points(csv_points.Columns(titles), body)
        return verified(Trajectory(points=points, closing=closing, **fields), lines)
    return _read_samples(titles, body, fields)


def rows(text: str, delimiter: str = ",", first_line: int = 1) -> Iterator[Row]:
    """The rows of a table that hold anything.

    Args:
        text: Of the whole file.
        delimiter: Between cells.
        first_line: Where the table begins; what stands before is no table and is not parsed.

    Raises:
        TrajectoryFileError: It cannot be parted into rows.
    """
    stream = io.StringIO(text, newline="")
    for _ in range(first_line - 1):
        stream.readline()
    reader = csv.reader(stream, delimiter=delimiter)
    line = first_line
    csv.field_size_limit(_LONGEST_CELL)
    while True:
        try:
            cells = next(reader, None)
        except csv.Error as error:
            raise broken(RefusalCode.FILE_DAMAGED, line, text=str(error)) from error
        if cells is None:
            return
        if any(cells):
            yield line, cells
        line = first_line + reader.line_num


def _titles(line: str) -> set[str]:
    return {title.strip(' "\r').lower() for title in line.split(_delimiter(line))}


def _delimiter(line: str) -> str:
    """A spreadsheet of some countries parts cells by semicolons."""
    return max(",;\t", key=line.count)


def _body(table: Iterator[Row], fields: dict[str, Any]) -> Iterator[Row]:
    """The rows of points and comments; what belongs to the whole goes into `fields`."""
    for line, cells in table:
        key = cells[0]
        if not key.startswith("#") or key == "#":
            yield line, cells
            continue
        value = cells[1] if len(cells) > 1 else ""
        if key == "#modified":
            fields["modified"] = parse_time(value, line, 2)
        elif key in ("#name", "#note", "#taught_on"):
            fields[key[1:]] = value
        else:
            raise broken(RefusalCode.HEADER_UNKNOWN, line, 1, value=key)


def _read_points(
    columns: csv_points.Columns, body: Iterator[Row]
) -> tuple[tuple[Waypoint, ...], tuple[str, ...], list[int]]:
    points: list[Waypoint] = []
    lines: list[int] = []
    comments: list[str] = []
    for line, cells in body:
        if cells[0] == "#":
            comments.append(cells[1] if len(cells) > 1 else "")
            continue
        points.append(csv_points.read_cells(columns, cells, line, tuple(comments)))
        lines.append(line)
        comments.clear()
    return tuple(points), tuple(comments), lines


def _read_samples(titles: list[str], body: Iterator[Row], fields: dict[str, Any]) -> Content:
    for title in titles:
        if title not in SAMPLE_TITLES:
            raise broken(RefusalCode.COLUMN_UNKNOWN, 1, titles.index(title) + 1, value=title)
        if titles.count(title) > 1:
            raise broken(RefusalCode.COLUMN_TWICE, 1, titles.index(title) + 1, field=title)
    for title in SAMPLE_TITLES[:GRIPPER]:
        if title not in titles:
            raise broken(RefusalCode.COLUMN_MISSING, 1, field=title)
    order = [titles.index(title) for title in SAMPLE_TITLES if title in titles]
    samples: list[list[float]] = []
    lines: list[int] = []
    for line, cells in body:
        if cells[0] == "#":
            continue
        if len(cells) != len(titles):
            raise broken(RefusalCode.CELLS_COUNT, line, value=len(cells), expected=len(titles))
        row = [
            math.nan
            if place == GRIPPER and not cells[index].strip()
            else parse_number(cells[index], line, index + 1)
            for place, index in enumerate(order)
        ]
        samples.append(row if len(row) == COLUMN_COUNT else [*row, math.nan])
        lines.append(line)
    array = np.array(samples, dtype=np.float64).reshape(-1, COLUMN_COUNT)
    return verified(Recording(samples=array, **fields), lines)
