"""Detects the layout of a text that holds a table: delimiter, decimal sign, titles, first row."""

from __future__ import annotations

import contextlib
import csv
from collections import Counter
from collections.abc import Sequence
from itertools import islice
from typing import Final, NamedTuple

from armui.arm.refusal import Reason
from armui.trajectory.columns.guess import guess_columns
from armui.trajectory.columns.model import (
    DECIMALS,
    DELIMITERS,
    SPACES,
    Dialect,
    Sheet,
    as_number,
    is_comment,
    lines_of,
    split,
    table,
)
from armui.trajectory.files.errors import TrajectoryFileError, broken

FILE_NO_TABLE = Reason(
    "file_no_table", "No rows of numbers are found here. Choose a file with one point a row."
)


_STYLES: Final = (
    *((",", "."), (";", "."), (";", ","), ("\t", "."), ("\t", ",")),
    *(("|", "."), (SPACES, "."), (SPACES, ",")),
)
_LOOKED_AT: Final = 400
"""The number of lines, spread over the whole text, that are examined."""
_LOOKED_AT_CHARACTERS: Final = 100_000
_LEAST_LINES: Final = 10
_ALL_GUESSED: Final = Dialect()
_PREVIEW: Final = 20


class _Style(NamedTuple):
    """One way to read a table, and how much of it makes sense so."""

    delimiter: str
    decimal: str
    width: int
    sense: float


def sniff(text: str, dialect: Dialect = _ALL_GUESSED) -> Sheet:
    """Return the layout of the table in a text, with guesses of its columns.

    Args:
        text: The text of the whole file; other text and comments may come before the table.
        dialect: The settings of the operator; the rest is guessed.

    Raises:
        TrajectoryFileError: There are no rows of numbers, and the operator has not set where they
            begin.
    """
    lines = [line.rstrip("\n") for line in lines_of(text)]
    skipped = 0 if dialect.first_line is None else min(dialect.first_line, max(1, len(lines))) - 1
    spread = _spread(lines[skipped:])
    judged = (_judge(spread, *style) for style in _styles(dialect))
    style = max(judged, key=lambda one: one[2:][::-1])
    first = skipped if dialect.first_line is not None else _first_row(lines, style)
    if first is None:
        if dialect == _ALL_GUESSED or not spread:
            raise broken(FILE_NO_TABLE)
        first = 0
    style = style._replace(width=max(1, style.width))
    header = _header(lines[:first], style)
    body = [_parted(line, style.delimiter) for line in _spread(lines[first:])]
    body = [cells for cells in body if len(cells) == style.width]
    figures = [
        [as_number(row[index], style.decimal) for row in body] for index in range(style.width)
    ]
    return Sheet(
        style.delimiter,
        style.decimal,
        header,
        first + 1,
        style.width,
        sum(bool(line.strip()) and not is_comment(line) for line in lines[first:]),
        len(lines),
        _preview(text, style, first + 1),
        guess_columns(header, figures),
    )


def _styles(dialect: Dialect) -> list[tuple[str, str]]:
    """Return the delimiters and decimal signs that come into question."""
    if dialect.delimiter is None and dialect.decimal is None:
        return list(_STYLES)
    delimiters = DELIMITERS if dialect.delimiter is None else (dialect.delimiter,)
    decimals = DECIMALS if dialect.decimal is None else (dialect.decimal,)
    return [(delimiter, decimal) for delimiter in delimiters for decimal in decimals]


def _preview(text: str, style: _Style, first_line: int) -> tuple[tuple[str, ...], ...]:
    """Return the first rows, up to one that cannot be split; a full read reports that one."""
    shown: list[tuple[str, ...]] = []
    with contextlib.suppress(TrajectoryFileError):
        for _line, cells in islice(table(text, style.delimiter, first_line), _PREVIEW):
            shown.append(tuple(cells))
    return tuple(shown)


def _spread(lines: Sequence[str]) -> list[str]:
    """Return some lines of all parts of the text, without comments and empty ones.

    Fewer lines are taken if they are very long, to limit the time.
    """
    step = max(1, len(lines) // _LOOKED_AT)
    found: list[str] = []
    left = _LOOKED_AT_CHARACTERS
    for line in lines[::step]:
        if line.strip() and not is_comment(line):
            found.append(line)
            left -= len(line)
            if left < 0 and len(found) >= _LEAST_LINES:
                break
    return found


def _judge(lines: Sequence[str], delimiter: str, decimal: str) -> _Style:
    """Return how much sense lines make when parted so: the share of cells that are numbers."""
    parted = [_parted(line, delimiter) for line in lines]
    widths = Counter(map(len, parted))
    width = max(widths, key=lambda count: (widths[count], count), default=0)
    if width < 2:
        return _Style(delimiter, decimal, width, 0.0)
    fitting = [cells for cells in parted if len(cells) == width]
    numbers = sum(as_number(cell, decimal) is not None for cells in fitting for cell in cells)
    empty = sum(not cell.strip() for cells in fitting for cell in cells)
    share = numbers / max(1, width * len(fitting) - empty)
    return _Style(delimiter, decimal, width, round(share * len(fitting) / len(parted), 3))


def _first_row(lines: Sequence[str], style: _Style) -> int | None:
    """Return the index of the first line of figures, also of one with cells too many or too few."""
    for index, line in enumerate(lines):
        cells = [] if is_comment(line) else _parted(line, style.delimiter)
        numbers = sum(as_number(cell, style.decimal) is not None for cell in cells)
        if style.width >= 2 and 2 * numbers >= style.width:
            return index
    return None


def _header(lines: Sequence[str], style: _Style) -> tuple[str, ...]:
    """Return the titles in the last line before the figures, be it a comment or not; else none."""
    for line in reversed(lines):
        if not line.strip():
            continue
        cells = _parted(line.lstrip(" \t#%/"), style.delimiter)
        titles = tuple(cell.strip() for cell in cells)
        return titles if len(titles) == style.width else ()
    return ()


def _parted(line: str, delimiter: str) -> list[str]:
    try:
        return split(line, delimiter)
    except csv.Error:
        return []
