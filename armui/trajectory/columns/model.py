"""The possible contents of a column, their units, and the dialect of a table."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from itertools import islice
from typing import Final, NamedTuple

from armui.cell.tools import NO_TOOL
from armui.protocol.codes import MoveMode
from armui.trajectory.files.csv_file import Row, rows
from armui.trajectory.points.program import Values

SPACES: Final = " "
"""The delimiter of a table whose cells are separated by any number of blanks."""
DELIMITERS: Final = (",", ";", "\t", "|", SPACES)
DECIMALS: Final = (".", ",")
_COMMENTS: Final = ("#", "%", "//")

_TIMES: Final = {"s": 1.0, "ms": 1e-3, "µs": 1e-6, "ns": 1e-9}
_ANGLES: Final = {
    "°": 1.0,
    "rad": math.degrees(1.0),
    "0.1°": 0.1,
    "mrad": math.degrees(1e-3),
    "0.001°": 1e-3,
}
_LENGTHS: Final = {"mm": 1.0, "m": 1e3, "µm": 1e-3}

Figures = Sequence[float | None]
"""The figures of one column in order; ``None`` for a cell without a number."""


class ColumnQuantity(StrEnum):
    """The quantities a column can hold.

    Time counts from any moment; wait is the time since the row before.
    """

    TIME = "time"
    WAIT = "wait"
    J1 = "J1"
    J2 = "J2"
    J3 = "J3"
    J4 = "J4"
    J5 = "J5"
    J6 = "J6"
    X = "X"
    Y = "Y"
    Z = "Z"
    RX = "RX"
    RY = "RY"
    RZ = "RZ"
    GRIPPER = "gripper"
    SPEED = "speed"
    DWELL = "dwell"
    NOTE = "note"


JOINTS: Final = tuple(ColumnQuantity(f"J{joint}") for joint in range(1, 7))
POSE: Final = (
    ColumnQuantity.X,
    ColumnQuantity.Y,
    ColumnQuantity.Z,
    ColumnQuantity.RX,
    ColumnQuantity.RY,
    ColumnQuantity.RZ,
)


UNITS: Final[Mapping[ColumnQuantity, Mapping[str, float]]] = {
    **dict.fromkeys((ColumnQuantity.TIME, ColumnQuantity.WAIT, ColumnQuantity.DWELL), _TIMES),
    **dict.fromkeys((*JOINTS, *POSE[3:]), _ANGLES),
    **dict.fromkeys((*POSE[:3], ColumnQuantity.GRIPPER), _LENGTHS),
    ColumnQuantity.SPEED: {"%": 1.0},
    ColumnQuantity.NOTE: {"": 1.0},
}
"""The units of each quantity, with the factor that converts to ours: s, °, mm, %."""


class TableColumn(NamedTuple):
    """The quantity and the unit of a column."""

    quantity: ColumnQuantity
    unit: str


@dataclass(frozen=True, slots=True)
class Guess:
    """A guess of a column's content; `column` is ``None`` if there is no clue.

    `confidence` is 1 if the title names quantity and unit, less if one of them was guessed from the
    figures, 0 without a clue. `titled_unit` is the unit named in the title, whatever the column is;
    "" for none. `figures` are some of the column's. `custom` is the usual unit of programs that
    name columns so, "" where it is not known.
    """

    column: TableColumn | None
    confidence: float
    titled_unit: str = ""
    figures: Figures = ()
    custom: str = ""


@dataclass(frozen=True, slots=True)
class Dialect:
    """The table's dialect as the operator set it; fields that are ``None`` are guessed."""

    delimiter: str | None = None
    decimal: str | None = None
    first_line: int | None = None


@dataclass(frozen=True, slots=True)
class Sheet:
    """The layout of a text that holds a table.

    Attributes:
        delimiter: The separator of cells; :data:`SPACES` for any number of blanks.
        decimal: The decimal sign, a point or a comma.
        header: The titles of the columns; empty if there are none.
        first_line: The line of the first figures, from 1.
        width: The number of columns.
        count: The approximate number of rows: some may turn out to be comments.
        lines: The number of lines of the text.
        preview: The first rows, as text.
        guesses: A guess for every column.
    """

    delimiter: str
    decimal: str
    header: tuple[str, ...]
    first_line: int
    width: int
    count: int
    lines: int
    preview: tuple[tuple[str, ...], ...]
    guesses: tuple[Guess, ...]


@dataclass(frozen=True, slots=True)
class ColumnMapping:
    """The meaning of the columns, as the operator set it.

    Attributes:
        columns: The content of every column of the sheet; ``None`` for one that is left out.
        move: The motion to each row: MOVE_J to its joint angles, MOVE_P or MOVE_L to its pose;
            ``None`` makes a recording of joint angles over time. Columns not needed for that are
            left out.
        speed_percent: The speed of the points, if no column gives it.
        tool: The tool whose poses are in the table; zeros for the flange.
        frame: The user frame of the cell that they count from; "" for the base.
    """

    columns: tuple[TableColumn | None, ...]
    move: MoveMode | None = None
    speed_percent: int = 100
    tool: Values = NO_TOOL
    frame: str = ""


def split(line: str, delimiter: str) -> list[str]:
    """Return the cells of one line."""
    if delimiter == SPACES:
        return line.split()
    return next(csv.reader([line], delimiter=delimiter), [])


def table(text: str, delimiter: str, first_line: int) -> Iterator[Row]:
    """Yield the rows of a text from a line on, without comments.

    Raises:
        TrajectoryFileError: The text cannot be split into rows.
    """
    if delimiter == SPACES:
        parted = ((line, row.split()) for line, row in enumerate(lines_of(text), start=1))
        found: Iterable[Row] = islice(parted, first_line - 1, None)
    else:
        found = rows(text, delimiter, first_line)
    for line, cells in found:
        if cells and not is_comment(cells[0]):
            yield line, cells


def lines_from(text: str, first_line: int) -> Iterator[tuple[int, str]]:
    """Yield the lines of a table that are neither empty nor comments, with their numbers."""
    numbered = islice(enumerate(lines_of(text), start=1), first_line - 1, None)
    return ((number, line) for number, line in numbered if line.strip() and not is_comment(line))


def lines_of(text: str) -> Iterator[str]:
    """Yield the lines of a text, with any line ends, counted as the csv module does."""
    return iter(io.StringIO(text, newline=None))


def is_comment(text: str) -> bool:
    """Return whether a line or its first cell begins a comment."""
    return text.lstrip().startswith(_COMMENTS)


def as_number(cell: str, decimal: str) -> float | None:
    """Return the number in a cell, or ``None`` if it holds none."""
    text = cell.strip()
    if decimal != ".":
        if "." in text:
            return None
        text = text.replace(decimal, ".")
    try:
        value = float(text)
    except ValueError:
        return None
    return None if "_" in text else value
