"""The one error of trajectory files."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from armui.arm.json_fields import FieldError, FieldProblem
from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode

_WORDS: Final[Mapping[RefusalCode, str]] = {
    RefusalCode.FILE_GONE: "is not in the library any more",
    RefusalCode.FILE_UNREADABLE: "cannot be read: {text}",
    RefusalCode.FILE_TOO_LARGE: "has {value} MB; files up to {maximum} MB are read",
    RefusalCode.FILE_NOT_TEXT: "is no text in UTF-8 or GBK",
    RefusalCode.FILE_NOT_ENCODING: "is no text in {value}",
    RefusalCode.FILE_KIND_UNKNOWN: "is no trajectory file this program knows; import it by columns",
    RefusalCode.FILE_NO_TABLE: "holds no rows of numbers",
    RefusalCode.FILE_VERSION: "is of version {value}; this program reads up to {maximum}",
    RefusalCode.FILE_EMPTY: "holds nothing",
    RefusalCode.FILE_CUT_OFF: "ends too early",
    RefusalCode.FILE_DAMAGED: "is damaged: {text}",
    RefusalCode.LINE_UNKNOWN: "“{value}” is no kind of line; J, P, L, C and # are",
    RefusalCode.HEADER_UNKNOWN: "“{value}” is no entry of the header",
    RefusalCode.OPTION_UNKNOWN: "“{value}” is no option of a point",
    RefusalCode.OPTION_TWICE: "“{value}” is given twice",
    RefusalCode.OPTION_BAD: "“{value}” is no {field}; write it as {example}",
    RefusalCode.NUMBER_BAD: "“{value}” is no number",
    RefusalCode.VALUES_COUNT: "{value} numbers where {expected} belong",
    RefusalCode.TEXT_UNCLOSED: "a text in quotation marks has no end",
    RefusalCode.COLUMN_MISSING: "the column “{field}” is missing",
    RefusalCode.COLUMN_UNKNOWN: "the column “{value}” is unknown",
    RefusalCode.COLUMN_TWICE: "the column “{field}” is there twice",
    RefusalCode.CELLS_COUNT: "{value} cells where there are {expected} columns",
    RefusalCode.TIME_BAD: "“{value}” is no date and time",
    RefusalCode.JSON_BAD: "is no sound JSON: {text}",
    RefusalCode.JSON_FIELD_MISSING: "“{field}” is missing",
    RefusalCode.JSON_FIELD_UNKNOWN: "“{value}” is unknown",
    RefusalCode.JSON_FIELD_BAD: "“{field}” is not what it should be: {expected}",
    RefusalCode.POINT_OUT_OF_RANGE: (
        "{field} {value} {unit} is beyond {minimum} to {maximum} {unit}"
    ),
    RefusalCode.POINT_NOT_A_NUMBER: "{field} {value} is not a number",
    RefusalCode.POINT_NOT_WHOLE: "{field} {value} is not a whole number",
    RefusalCode.POINT_INCOMPLETE: "{field} has {value} values; 6 belong there",
    RefusalCode.POINT_MOVE_UNKNOWN: "“{value}” is no kind of motion; MOVE J, P, L and C are",
    RefusalCode.SAMPLE_BACK_IN_TIME: "the time {value} s is before the one above, {minimum} s",
    RefusalCode.TEXT_TOO_LONG: "{field}: {value} characters; up to {maximum} are kept",
    RefusalCode.TEXT_BAD: "{field}: holds a character that cannot be kept",
    RefusalCode.NAME_EMPTY: "has no name",
    RefusalCode.NAME_TOO_LONG: "the name has {value} characters; up to {maximum} are kept",
}
"""Every reason in English; the user interface has its own sentences for the same codes."""


def field_refusal(error: FieldError) -> Refusal:
    """What is wrong with a field, as a `TrajectoryFileError` says it."""
    if error.problem is FieldProblem.MISSING:
        return Refusal(RefusalCode.JSON_FIELD_MISSING, {"field": error.name})
    if error.problem is FieldProblem.UNKNOWN:
        return Refusal(RefusalCode.JSON_FIELD_UNKNOWN, {"value": error.name[:60]})
    bad = {"field": error.name, "expected": error.expected}
    return error.reason or Refusal(RefusalCode.JSON_FIELD_BAD, bad)


class TrajectoryFileError(Exception):
    """A file that is no trajectory, or a broken one; nothing of it is taken over.

    Attributes:
        file: The file's name, without its folder; "" where it has none.
        line: Where, from 1; 0 where no line is to blame.
        column: Where in the line, from 1: the character, in .csv the cell; 0 where unknown.
        reason: Why; its code is a key of the table above.
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
    code: RefusalCode, line: int = 0, column: int = 0, /, **params: float | str
) -> TrajectoryFileError:
    """A `TrajectoryFileError`, in short."""
    shown = {key: _short(value) for key, value in params.items()}
    return TrajectoryFileError(Refusal(code, shown), line, column)


def _short(value: float | str) -> float | str:
    """Foreign text cut to what fits a message."""
    if isinstance(value, str) and len(value) > 60:
        return value[:60] + "…"
    return value
