"""The exception raised by the readers of trajectory files."""

from __future__ import annotations

from typing import Final

from armui.arm.json_fields import FieldError, FieldProblem
from armui.arm.refusal import Reason, Refusal

JSON_FIELD_MISSING = Reason("json_field_missing", "“{field}” is missing.")
JSON_FIELD_UNKNOWN = Reason("json_field_unknown", "“{value}” is unknown.")
JSON_FIELD_BAD = Reason("json_field_bad", "“{field}” is not what it should be: {expected}.")
FILE_DAMAGED = Reason("file_damaged", "The file is damaged: {text}.")
FILE_VERSION = Reason(
    "file_version",
    "The file is of version {value}; this program reads up to version {maximum}. Update the "
    "program.",
)
HEADER_UNKNOWN = Reason(
    "header_unknown", "“{value}” is not an entry of the header; use name, note or modified."
)

_NO_FIGURES: Final = dict.fromkeys(
    ("field", "value", "minimum", "maximum", "unit", "expected", "text", "example"), "?"
)


def field_refusal(error: FieldError) -> Refusal:
    """Return the refusal for a wrong field, for a `TrajectoryFileError`."""
    if error.problem is FieldProblem.MISSING:
        return JSON_FIELD_MISSING(field=error.name)
    if error.problem is FieldProblem.UNKNOWN:
        return JSON_FIELD_UNKNOWN(value=error.name[:60])
    return error.refusal or JSON_FIELD_BAD(field=error.name, expected=error.expected)


class TrajectoryFileError(Exception):
    """A file that is no trajectory, or damaged; nothing of it is used.

    Attributes:
        file: The file's name without its folder; "" if there is none.
        line: The line, from 1; 0 if no line is to blame.
        column: The place in the line, from 1: the character, in .csv the cell; 0 if unknown.
        refusal: The reason.
    """

    def __init__(self, refusal: Refusal, line: int = 0, column: int = 0, file: str = "") -> None:
        self.refusal = refusal
        self.line = line
        self.column = column
        self.file = file
        super().__init__(refusal, line, column, file)

    def __str__(self) -> str:
        text = self.refusal.reason.source or self.refusal.code
        words = text.format_map({**_NO_FIGURES, **self.refusal.params})
        places = [self.file] if self.file else []
        if self.line:
            places.append(f"line {self.line}")
        if self.column:
            places.append(f"column {self.column}")
        return f"{', '.join(places)}: {words}" if places else words


def broken(
    code: Reason, line: int = 0, column: int = 0, /, **params: float | str
) -> TrajectoryFileError:
    """Return a `TrajectoryFileError` made of a reason, a place and the reason's figures."""
    shown = {key: _short(value) for key, value in params.items()}
    return TrajectoryFileError(Refusal(code, shown), line, column)


def _short(value: float | str) -> float | str:
    """Return a foreign text cut to what fits a message."""
    if isinstance(value, str) and len(value) > 60:
        return value[:60] + "…"
    return value
