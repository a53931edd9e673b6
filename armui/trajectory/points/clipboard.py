"""Converts points to text for the clipboard, and text from it to points."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from armui.arm.limits import JointLimits, check_joints
from armui.arm.refusal import Refusal
from armui.protocol.codes import MoveMode
from armui.trajectory import files
from armui.trajectory.files import FILE_EMPTY, csv_file, json_file, log_file
from armui.trajectory.files.errors import TrajectoryFileError, broken
from armui.trajectory.files.log_file import FILE_KIND_UNKNOWN
from armui.trajectory.files.log_points import LETTERS, VALUES_COUNT, read_point
from armui.trajectory.files.model import verified_point
from armui.trajectory.points.cells import IN_FRAME, VALUES, PointColumn, edited, figure, text_of
from armui.trajectory.points.program import (
    JOINT_NAMES,
    POSE_NAMES,
    VALUE_COUNT,
    Trajectory,
    Waypoint,
)

_DELIMITERS: Final = ("\t", ";", ",")
_MOVES: Final = {
    **{f"MOVE {letter}": move for letter, move in LETTERS.items()},
    **{f"MOVE_{letter}": move for letter, move in LETTERS.items()},
    **LETTERS,
}
_NO_POSE: Final = (0.0,) * VALUE_COUNT
_OF_TOOL: Final = "TCP "
"""The prefix of a row whose pose is a tool's; programs without tools then refuse the row."""


def to_text(points: Sequence[Waypoint], *, of_tool: bool = False) -> str:
    """Return the text of points for a spreadsheet: a row for each, with tabs between its cells.

    Args:
        points: The points.
        of_tool: True if their poses are those of a tool: each row says so, before its motion.
    """
    return "\n".join(
        (_OF_TOOL if of_tool and not point.is_joint else "")
        + "\t".join(_one_line(text_of(point, column)) for column in PointColumn)
        for point in points
    )


@dataclass(frozen=True, slots=True)
class PastedPoints:
    """Points from a text.

    Attributes:
        points: All of them.
        taught_on: The arm they were taught on, if a file says so; "" if not known.
        is_file: True if the text is a whole file, which says by itself what its poses are of.
        of_tool: True if rows say that their poses are those of a tool.
    """

    points: tuple[Waypoint, ...]
    taught_on: str = ""
    is_file: bool = False
    of_tool: bool = False


def from_text(text: str, like: MoveMode = MoveMode.MOVE_J) -> tuple[Waypoint, ...]:
    """Return the points in a text; see `pasted`."""
    return pasted(text, like).points


def pasted(
    text: str, like: MoveMode = MoveMode.MOVE_J, limits: Sequence[JointLimits] = ()
) -> PastedPoints:
    """Return the points in a text, and the arm they were taught on.

    It understands the output of :func:`to_text`, whole files of this program, lines of its ``.log``
    format, and rows of a spreadsheet: optionally the kind of motion, six values, optionally speed
    in percent and dwell in seconds. A first row without a figure counts as titles.

    Args:
        text: The text from the clipboard.
        like: The kind of motion of rows that do not name one.
        limits: As for `armui.trajectory.points.cells.edited`.

    Raises:
        TrajectoryFileError: The text has another form; it names line and cell.
    """
    if log_file.is_log(text) or json_file.is_json(text) or csv_file.is_csv(text):
        content = files.read_text(text, "clipboard")
        if isinstance(content, Trajectory):
            points = tuple(_within(point, 0, limits) for point in content.points)
            return PastedPoints(points, content.taught_on, is_file=True)
        raise broken(FILE_KIND_UNKNOWN, 1)
    # not splitlines: it would part a note at signs that end no line in a spreadsheet
    numbered = enumerate(text.replace("\r\n", "\n").split("\n"), 1)
    lines = [(number, line) for number, line in numbered if line.strip()]
    if not lines:
        raise broken(FILE_EMPTY)
    if not _has_figure(lines[0][1]) and len(lines) > 1:
        lines = lines[1:]
    of_tool = any(line.startswith(_OF_TOOL) for _, line in lines)
    rows = ((line.removeprefix(_OF_TOOL), number) for number, line in lines)
    points = tuple(_within(_read_row(*row, like), row[1], limits) for row in rows)
    return PastedPoints(points, of_tool=of_tool)


def _within(point: Waypoint, line: int, limits: Sequence[JointLimits]) -> Waypoint:
    if limits and point.is_joint and (beyond := check_joints(point.target, limits)):
        raise TrajectoryFileError(beyond, line)
    return point


def _one_line(text: str) -> str:
    return " ".join(text.split()) if any(sign in text for sign in "\t\r\n") else text


def _has_figure(line: str) -> bool:
    """Return whether a row has a cell that is a figure: titles have none."""
    return any(
        not isinstance(figure("X", cell), Refusal)
        for cell in line.replace("\t", " ").replace(",", " ").replace(";", " ").split()
    )


def _read_row(line: str, number: int, like: MoveMode) -> Waypoint:
    delimiter = next((sign for sign in _DELIMITERS if sign in line), None)
    if delimiter is None and line.split(maxsplit=1)[0] in LETTERS:
        return read_point(line.strip(), number, ())
    cells = [cell.strip() for cell in line.split(delimiter)]
    word, _, frame = cells[0].partition(IN_FRAME)
    move = _MOVES.get(word.strip().upper())
    if move is None:
        move, cells, frame = like, ["", *cells], ""
    values = cells[1 : 1 + VALUE_COUNT]
    if len(values) != VALUE_COUNT:
        raise broken(VALUES_COUNT, number, 1, value=len(values), expected=VALUE_COUNT)
    names = JOINT_NAMES if move is MoveMode.MOVE_J else POSE_NAMES
    target = tuple(
        _taken(figure(name, cell, far=bool(frame)), number, place)
        for place, (name, cell) in enumerate(zip(names, values, strict=True), 1)
    )
    rest = cells[1 + VALUE_COUNT :]
    if len(rest) < len(PointColumn) - len(VALUES) - 1 and _is_figure(rest[:1]):
        rest = ["", *rest]  # rows of a spreadsheet lack the column of the middle pose
    # a placeholder until the middle pose's cell is read
    middle = _NO_POSE if move is MoveMode.MOVE_C else None
    point = Waypoint(move, target, middle, frame=frame.strip())
    if middle is not None and not (rest and rest[0]):
        raise broken(VALUES_COUNT, number, PointColumn.MIDDLE + 1, value=0, expected=VALUE_COUNT)
    for column, cell in zip(range(PointColumn.MIDDLE, len(PointColumn)), rest, strict=False):
        if cell:
            changed = edited(point, PointColumn(column), cell)
            if isinstance(changed, Refusal):
                raise TrajectoryFileError(changed, number, column + 1)
            point = changed
    return verified_point(point, number)


def _is_figure(cells: Sequence[str]) -> bool:
    return bool(cells) and bool(cells[0]) and not isinstance(figure("X", cells[0]), Refusal)


def _taken(value: float | Refusal, line: int, column: int) -> float:
    if isinstance(value, Refusal):
        raise TrajectoryFileError(value, line, column)
    return value
