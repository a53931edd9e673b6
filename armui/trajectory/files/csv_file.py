"""`.csv`, for spreadsheets: one row of titles, then a row for each point or sample.

Rows whose first cell is # hold a comment. Rows that begin with #name, #note, #taught_on, #tool,
#frame or #modified hold properties of the whole; they come last, where they do not disturb a table.
Before points that name things of a cell, or poses of a tool, stands a line with the version: no
program that knows of neither takes this for a plain table.
"""

from __future__ import annotations

import csv
import io
import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any, Final

import numpy as np

from armui.arm.models import widest_ranges_deg
from armui.arm.refusal import Reason
from armui.cell.tools import Tool
from armui.cell.user_frames import UserFrame
from armui.protocol.codes import ALL_LAMPS
from armui.trajectory.files.errors import FILE_DAMAGED, FILE_VERSION, HEADER_UNKNOWN, broken
from armui.trajectory.files.log_file import FILE_KIND_UNKNOWN
from armui.trajectory.files.log_points import LETTER_OF, LETTERS
from armui.trajectory.files.model import (
    VERSION,
    VERSIONS,
    Content,
    parse_time,
    verified,
    verified_point,
    verify,
    version_of,
)
from armui.trajectory.files.text import number, parse_number
from armui.trajectory.points.program import (
    OF_FLANGE,
    POINT_MOVE_UNKNOWN,
    POINT_NOT_WHOLE,
    GripperAction,
    GripperAngle,
    GripperOpening,
    LightAction,
    Trajectory,
    Values,
    Waypoint,
)
from armui.trajectory.samples.recording import COLUMN_COUNT, GRIPPER, Recording

COLUMN_UNKNOWN = Reason("column_unknown", "The column “{value}” is unknown.")
COLUMN_TWICE = Reason("column_twice", "The column “{field}” is there twice.")
COLUMN_MISSING = Reason("column_missing", "The column “{field}” is missing.")
TOOL_UNCLEAR = Reason(
    "tool_unclear",
    "The titles of the poses and the row “#tool” belong together: titles with tcp_ are of the tool "
    "in that row, those without are of the flange. Export the file again.",
)
CELLS_COUNT = Reason("cells_count", "{value} cells where there are {expected} columns.")


SAMPLE_TITLES: Final = ("t_s", *(f"j{joint}_deg" for joint in range(1, 7)), "gripper_mm")
_LONGEST_CELL: Final = 1 << 20
_MARK: Final = re.compile(r'"?armui trajectory (\d{1,9})"?[,;\t]*\r?\n(?=[\w,;\t "\r]+\n)')
"""The line with the version before a line of titles, which a header of `.log` is not: it has a
colon. A spreadsheet may have put it in quotation marks, and cells behind.
"""

Row = tuple[int, list[str]]
"""The number of the row's first line, and its cells."""

_JOINTS: Final = tuple(f"j{joint}_deg" for joint in range(1, 7))
_POSE: Final = ("x_mm", "y_mm", "z_mm", "rx_deg", "ry_deg", "rz_deg")
_MIDDLE: Final = tuple(f"middle_{title}" for title in _POSE)
_OPENING: Final = ("gripper_opening_mm", "gripper_torque_nm")
_ANGLE: Final = ("gripper_angle_deg", "gripper_speed_rad_s")
_LIGHT: Final = ("light_joint", "light_red", "light_green", "light_blue")
_LAMP: Final = "light_lamp"
_OF_CELL: Final = ("frame", "holds")
"""The columns of a file in which points name things of a cell."""
_OF_TOOL: Final = {
    **{title: f"tcp_{title}" for title in _POSE},
    **{f"middle_{title}": f"middle_tcp_{title}" for title in _POSE},
}
"""The titles of poses that are a tool's, by those of the flange's."""
_PLAIN: Final = {of_tool: title for title, of_tool in _OF_TOOL.items()}
_NOTHING: Final = "<nothing>"
"""The cell of a point from which on nothing is held; no name can be written so."""

TITLES: Final = (
    *("move", *_JOINTS, *_POSE, *_MIDDLE, "speed_percent", "dwell_s"),
    *(*_OPENING, *_ANGLE, *_LIGHT, _LAMP, "note"),
)
_WHOLE_DEFAULT: Final = 30
"""The speed in percent of a row that names none."""

_BEYOND_DEG: Final = 20.0
"""Arms in the field carry other limits than the factory's, and lie beyond them at rest."""
_COUNTS: Final = (GRIPPER, COLUMN_COUNT)
_STEP_DIGITS: Final = 6


def is_csv(text: str) -> bool:
    """Return whether a text has the titles of this format, in any order."""
    titles = _titles(_marked(text)[1])
    return "move" in titles or titles >= set(SAMPLE_TITLES[:GRIPPER])


def write(content: Content) -> str:
    """Return a trajectory or recording as text.

    Raises:
        UnwritableError: The content cannot be written.
    """
    verify(content)
    stream = io.StringIO(newline="")
    writer = csv.writer(stream)
    if isinstance(content, Trajectory):
        of_cell, of = version_of(content) > VERSION, content.poses_of
        if of_cell:
            writer.writerow((f"armui trajectory {version_of(content)}",))
        titles = (*TITLES, *_OF_CELL) if of_cell else TITLES
        writer.writerow([_OF_TOOL.get(each, each) for each in titles] if of.tool else titles)
        for point in content.points:
            writer.writerows(("#", comment) for comment in point.comments)
            writer.writerow(write_cells(point, titles))
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
    if isinstance(content, Trajectory):
        named = () if of.tool is None else (("#tool", of.tool),)
        for key, each in (*named, *(("#frame", frame) for frame in of.frames)):
            writer.writerow((key, each.name, *map(number, each.pose)))
    writer.writerow(("#modified", content.modified.isoformat()))
    return stream.getvalue()


def read(text: str, name: str) -> Content:
    """Return the trajectory or recording in a text.

    Args:
        text: The text of the file, with its own line ends.
        name: The name used if no row holds one.

    Raises:
        TrajectoryFileError: With the line and, as column, the cell.
    """
    version, first = _marked(text)
    if version > VERSIONS[-1]:
        raise broken(FILE_VERSION, 1, 1, value=version, maximum=VERSIONS[-1])
    table = rows(text, _delimiter(first), 1 if version == VERSION else 2)
    _, titles = next(table, (1, []))
    titles = [title.strip().lower() for title in titles]
    fields: dict[str, Any] = {"name": name}
    body = _body(table, fields)
    if "move" in titles:
        of_tool = not set(titles).isdisjoint(_PLAIN)
        points, closing, lines = _read_points(
            Columns([_PLAIN.get(each, each) for each in titles]), body
        )
        if of_tool != (fields.get("poses_of", OF_FLANGE).tool is not None):
            raise broken(TOOL_UNCLEAR, 1 if version == VERSION else 2)
        return verified(Trajectory(points=points, closing=closing, **fields), lines)
    return _read_samples(titles, body, fields)


def rows(text: str, delimiter: str = ",", first_line: int = 1) -> Iterator[Row]:
    """Yield the rows of a table that are not empty.

    Args:
        text: The text of the whole file.
        delimiter: The separator of cells.
        first_line: The line at which the table begins; the text before is not parsed.

    Raises:
        TrajectoryFileError: The text cannot be split into rows.
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
            raise broken(FILE_DAMAGED, line, text=str(error)) from error
        if cells is None:
            return
        if any(cells):
            yield line, cells
        line = first_line + reader.line_num


def _marked(text: str) -> tuple[int, str]:
    """Return the version of a table's format, and the line of its titles."""
    mark = _MARK.match(text)
    version, begin = (VERSION, 0) if mark is None else (int(mark.group(1)), mark.end())
    return version, text[begin : begin + _LONGEST_CELL].partition("\n")[0]


def _titles(line: str) -> set[str]:
    return {title.strip(' "\r').lower() for title in line.split(_delimiter(line))}


def _delimiter(line: str) -> str:
    """Return the separator of cells: spreadsheets of some countries write semicolons."""
    return max(",;\t", key=line.count)


def _body(table: Iterator[Row], fields: dict[str, Any]) -> Iterator[Row]:
    """Return the rows of points and comments; what belongs to the whole goes into `fields`."""
    for line, cells in table:
        key = cells[0]
        if not key.startswith("#") or key == "#":
            yield line, cells
            continue
        value = cells[1] if len(cells) > 1 else ""
        if key in ("#tool", "#frame"):
            of = fields.get("poses_of", OF_FLANGE)
            pose = tuple(
                parse_number(cell, line, place) for place, cell in enumerate(cells[2:8], 3)
            )
            if len(pose) != len(_POSE):
                raise broken(CELLS_COUNT, line, value=len(cells), expected=len(_POSE) + 2)
            if key == "#frame":
                of = replace(of, frames=(*of.frames, UserFrame(value, pose)))
            else:
                of = replace(of, tool=Tool(value, pose))
            fields["poses_of"] = of
        elif key == "#modified":
            fields["modified"] = parse_time(value, line, 2)
        elif key in ("#name", "#note", "#taught_on"):
            fields[key[1:]] = value
        else:
            raise broken(HEADER_UNKNOWN, line, 1, value=key)


def _read_points(
    columns: Columns, body: Iterator[Row]
) -> tuple[tuple[Waypoint, ...], tuple[str, ...], list[int]]:
    points: list[Waypoint] = []
    lines: list[int] = []
    comments: list[str] = []
    for line, cells in body:
        if cells[0] == "#":
            comments.append(cells[1] if len(cells) > 1 else "")
            continue
        points.append(read_cells(columns, cells, line, tuple(comments)))
        lines.append(line)
        comments.clear()
    return tuple(points), tuple(comments), lines


def _read_samples(titles: list[str], body: Iterator[Row], fields: dict[str, Any]) -> Content:
    for title in titles:
        if title not in SAMPLE_TITLES:
            raise broken(COLUMN_UNKNOWN, 1, titles.index(title) + 1, value=title)
        if titles.count(title) > 1:
            raise broken(COLUMN_TWICE, 1, titles.index(title) + 1, field=title)
    for title in SAMPLE_TITLES[:GRIPPER]:
        if title not in titles:
            raise broken(COLUMN_MISSING, 1, field=title)
    order = [titles.index(title) for title in SAMPLE_TITLES if title in titles]
    samples: list[list[float]] = []
    lines: list[int] = []
    for line, cells in body:
        if cells[0] == "#":
            continue
        if len(cells) != len(titles):
            raise broken(CELLS_COUNT, line, value=len(cells), expected=len(titles))
        row = [
            math.nan
            if place == GRIPPER and not cells[index].strip()
            else parse_number(cells[index], line, index + 1)
            for place, index in enumerate(order)
        ]
        samples.append(row if len(row) == COLUMN_COUNT else [*row, math.nan])
        lines.append(line)
    if "poses_of" in fields:
        raise broken(HEADER_UNKNOWN, value="#tool / #frame")
    array = np.array(samples, dtype=np.float64).reshape(-1, COLUMN_COUNT)
    return verified(Recording(samples=array, **fields), lines)


def write_cells(point: Waypoint, titles: Sequence[str] = TITLES) -> list[str]:
    """Return the cells of a point, in the order of the titles."""
    cells = {
        "move": f"MOVE {LETTER_OF[point.move]}",
        "speed_percent": str(point.speed_percent),
        "dwell_s": number(point.dwell_s),
        "note": point.note,
        "frame": point.frame,
        "holds": _NOTHING if point.holds == "" else point.holds or "",
    }
    cells |= _named(_JOINTS if point.is_joint else _POSE, point.target)
    if point.middle is not None:
        cells |= _named(_MIDDLE, point.middle)
    gripper, light = point.gripper, point.light
    if isinstance(gripper, GripperOpening):
        cells |= _named(_OPENING, (gripper.opening_mm, gripper.torque_nm))
    elif gripper is not None:
        cells |= _named(_ANGLE, (gripper.angle_deg, gripper.speed_rad_s))
    if light is not None:
        cells |= _named(_LIGHT, (light.joint, light.red, light.green, light.blue))
        cells[_LAMP] = "all" if light.lamp == ALL_LAMPS else str(light.lamp)
    return [cells.get(title, "") for title in titles]


class Columns:
    """Maps titles to columns.

    Raises:
        TrajectoryFileError: A title is unknown or there twice.
    """

    def __init__(self, titles: Sequence[str]) -> None:
        self._places: dict[str, int] = {}
        for place, title in enumerate(titles):
            if title not in TITLES and title not in _OF_CELL:
                raise broken(COLUMN_UNKNOWN, 1, place + 1, value=title)
            if title in self._places:
                raise broken(COLUMN_TWICE, 1, place + 1, field=title)
            self._places[title] = place
        self.count = len(titles)

    def column(self, title: str) -> int:
        """Return the number of a title's column, from 1; 0 if there is none."""
        return self._places.get(title, -1) + 1

    def cell(self, cells: Sequence[str], title: str) -> str:
        """Return the cell under a title, or "" if there is no such column."""
        place = self._places.get(title)
        return "" if place is None else cells[place]


def read_cells(
    columns: Columns, cells: Sequence[str], line: int, comments: tuple[str, ...]
) -> Waypoint:
    """Return the point of a row.

    Raises:
        TrajectoryFileError: With the cell as column.
    """
    if len(cells) != columns.count:
        raise broken(CELLS_COUNT, line, value=len(cells), expected=columns.count)
    row = _Row(columns, cells, line)
    text = row.text("move")
    move = LETTERS.get(text.upper().removeprefix("MOVE").strip())
    if move is None:
        raise broken(POINT_MOVE_UNKNOWN, line, columns.column("move"), value=text)
    target = row.numbers(_JOINTS if move.name == "MOVE_J" else _POSE)
    middle = row.numbers(_MIDDLE) if move.name == "MOVE_C" else None
    point = Waypoint(
        move,
        target,
        middle,
        row.whole("speed_percent") if row.text("speed_percent") else _WHOLE_DEFAULT,
        row.number("dwell_s") if row.text("dwell_s") else 0.0,
        row.gripper(),
        row.light(),
        columns.cell(cells, "note"),
        comments,
        row.text("frame"),
        "" if row.text("holds") == _NOTHING else row.text("holds") or None,
    )
    return verified_point(point, line)


class _Row:
    """One row, whose cells are read by title."""

    def __init__(self, columns: Columns, cells: Sequence[str], line: int) -> None:
        self._columns = columns
        self._cells = cells
        self._line = line

    def text(self, title: str) -> str:
        return self._columns.cell(self._cells, title).strip()

    def number(self, title: str) -> float:
        column = self._columns.column(title)
        if not column:
            raise broken(COLUMN_MISSING, self._line, field=title)
        return parse_number(self.text(title), self._line, column)

    def numbers(self, titles: Sequence[str]) -> Values:
        return tuple([self.number(title) for title in titles])

    def whole(self, title: str) -> int:
        value = self.number(title)
        if value != int(value):
            column = self._columns.column(title)
            raise broken(POINT_NOT_WHOLE, self._line, column, field=title, value=value)
        return int(value)

    def gripper(self) -> GripperAction | None:
        if any(map(self.text, _OPENING)):
            return GripperOpening(*self.numbers(_OPENING))
        if any(map(self.text, _ANGLE)):
            return GripperAngle(*self.numbers(_ANGLE))
        return None

    def light(self) -> LightAction | None:
        if not any(map(self.text, _LIGHT)):
            return None
        joint, red, green, blue = map(self.whole, _LIGHT)
        every = self.text(_LAMP) in ("", "all")
        return LightAction(joint, red, green, blue, ALL_LAMPS if every else self.whole(_LAMP))


def _named(titles: Sequence[str], values: Sequence[float]) -> dict[str, str]:
    return dict(zip(titles, map(number, values), strict=True))


def is_maker_csv(text: str) -> bool:
    """Return whether the first row holds 7 or 8 numbers and nothing else."""
    first = text.lstrip().partition("\n")[0].split(",")
    try:
        return len(first) in _COUNTS and all(math.isfinite(float(cell)) for cell in first)
    except ValueError:
        return False


def read_maker_csv(text: str, name: str) -> Content:
    """Return the recording in a CSV file of the maker's, which has no titles.

    Its cells are `wait_s, j1 … j6` in rad and optionally the gripper in m. The wait of a row is the
    time since the row before.

    Raises:
        TrajectoryFileError: With the line and, as column, the cell.
    """
    steps: list[list[float]] = []
    lines: list[int] = []
    for line, cells in rows(text):
        if len(cells) not in _COUNTS:
            raise broken(CELLS_COUNT, line, value=len(cells), expected="7 / 8")
        row = [parse_number(cell, line, column) for column, cell in enumerate(cells, start=1)]
        steps.append(row if len(row) == COLUMN_COUNT else [*row, math.nan])
        lines.append(line)
    raw = np.array(steps, dtype=np.float64).reshape(-1, COLUMN_COUNT)
    samples = np.empty_like(raw)
    samples[:, 0] = np.round(np.cumsum(raw[:, 0]) - raw[:1, 0].sum(), _STEP_DIGITS)
    samples[:, 1:GRIPPER] = np.degrees(raw[:, 1:GRIPPER])
    samples[:, GRIPPER] = 1e3 * raw[:, GRIPPER]
    low, high = np.array(widest_ranges_deg()).T
    beyond = (samples[:, 1:GRIPPER] < low - _BEYOND_DEG) | (
        samples[:, 1:GRIPPER] > high + _BEYOND_DEG
    )
    recording = verified(Recording(name, samples=samples), lines)
    if beyond.any():  # hardly radians: the operator must choose the unit
        raise broken(FILE_KIND_UNKNOWN, lines[int(beyond.any(axis=1).argmax())])
    return recording
