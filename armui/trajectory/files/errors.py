"""The one error of trajectory files."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from armui.arm.json_fields import FieldError, FieldProblem
from armui.arm.refusal import Refusal

_WORDS: Final[Mapping[str, str]] = {
    "file_gone": "is not in the library any more",
    "file_unreadable": "cannot be read: {text}",
    "file_too_large": "has {value} MB; files up to {maximum} MB are read",
    "file_not_text": "is no text in UTF-8 or GBK",
    "file_not_encoding": "is no text in {value}",
    "file_kind_unknown": "is no trajectory file this program knows; import it by columns",
    "file_no_table": "holds no rows of numbers",
    "file_version": "is of version {value}; this program reads up to {maximum}",
    "file_empty": "holds nothing",
    "file_cut_off": "ends too early",
    "file_damaged": "is damaged: {text}",
    "line_unknown": "“{value}” is no kind of line; J, P, L, C and # are",
    "header_unknown": "“{value}” is no entry of the header",
    "option_unknown": "“{value}” is no option of a point",
    "option_twice": "“{value}” is given twice",
    "option_bad": "“{value}” is no {field}; write it as {example}",
    "number_bad": "“{value}” is no number",
    "values_count": "{value} numbers where {expected} belong",
    "text_unclosed": "a text in quotation marks has no end",
    "column_missing": "the column “{field}” is missing",
    "column_unknown": "the column “{value}” is unknown",
    "column_twice": "the column “{field}” is there twice",
    "cells_count": "{value} cells where there are {expected} columns",
    "time_bad": "“{value}” is no date and time",
    "json_bad": "is no sound JSON: {text}",
    "json_field_missing": "“{field}” is missing",
    "json_field_unknown": "“{value}” is unknown",
    "json_field_bad": "“{field}” is not what it should be: {expected}",
    "point_out_of_range": "{field} {value} {unit} is beyond {minimum} to {maximum} {unit}",
    "point_not_a_number": "{field} {value} is not a number",
    "point_not_whole": "{field} {value} is not a whole number",
    "point_incomplete": "{field} has {value} values; 6 belong there",
    "point_move_unknown": "“{value}” is no kind of motion; MOVE J, P, L and C are",
    "sample_back_in_time": "the time {value} s is before the one above, {minimum} s",
    "text_too_long": "{field}: {value} characters; up to {maximum} are kept",
    "text_bad": "{field}: holds a character that cannot be kept",
    "name_empty": "has no name",
    "name_too_long": "the name has {value} characters; up to {maximum} are kept",
}
"""Every reason in English; the user interface has its own sentences for the same codes."""

CODES: Final = frozenset(_WORDS)


def field_refusal(error: FieldError) -> Refusal:
    """What is wrong with a field, as a `TrajectoryFileError` says it."""
    if error.problem is FieldProblem.MISSING:
        return Refusal("json_field_missing", {"field": error.name})
    if error.problem is FieldProblem.UNKNOWN:
        return Refusal("json_field_unknown", {"value": error.name[:60]})
    bad = {"field": error.name, "expected": error.expected}
    return error.reason or Refusal("json_field_bad", bad)


class TrajectoryFileError(Exception):
    """A file that is no trajectory, or a broken one; nothing of it is taken over.

    Attributes:
        file: The file's name, without its folder; "" where it has none.
        line: Where, from 1; 0 where no line is to blame.
        column: Where in the line, from 1: the character, in .csv the cell; 0 where unknown.
        reason: Why; its code is one of :data:`CODES`.
    """

    def __init__(self, reason: Refusal, line: int = 0, column: int = 0, file: str = "") -> None:
        self.reason = reason
        self.line = line
        self.column = column
        self.file = file
        super().__init__(reason, line, column, file)

    def __str__(self) -> str:
        text = _WORDS.get(self.reason.code, self.reason.code)
        words = text.format_map({**_NO_FIGURES, **self.reason.params})
        places = [self.file] if self.file else []
        if self.line:
            places.append(f"line {self.line}")
        if self.column:
            places.append(f"column {self.column}")
        return f"{', '.join(places)}: {words}" if places else words


_NO_FIGURES: Final = dict.fromkeys(
    ("field", "value", "minimum", "maximum", "unit", "expected", "text", "example"), "?"
)


def broken(
    code: str, line: int = 0, column: int = 0, /, **params: float | str
) -> TrajectoryFileError:
    """A `TrajectoryFileError`, in short."""
    shown = {key: _short(value) for key, value in params.items()}
    return TrajectoryFileError(Refusal(code, shown), line, column)


def _short(value: float | str) -> float | str:
    """Foreign text cut to what fits a message."""
    if isinstance(value, str) and len(value) > 60:
        return value[:60] + "…"
    return value
