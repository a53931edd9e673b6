"""From the bytes of a text file to its text, and from numbers to text that says the same."""

from __future__ import annotations

import codecs
from collections.abc import Sequence
from typing import Final

import numpy as np

from armui.arm.refusal import Reason
from armui.trajectory.files.errors import broken
from armui.trajectory.samples.recording import Array

FILE_NOT_TEXT = Reason(
    "file_not_text", "This is not text in UTF-8 or GBK. Save it as a text file in UTF-8."
)
NUMBER_BAD = Reason("number_bad", "“{value}” is not a number.")


_UTF_16: Final = (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)


def decode(data: bytes) -> str:
    """Return the text of a file: UTF-8, with or without a mark; UTF-16 with one; else GBK.

    GBK (here with all of GB 18030) is what Chinese Windows writes by itself.

    Raises:
        TrajectoryFileError: It is none of them, with the line of the first odd byte.
    """
    if data.startswith(_UTF_16):
        try:
            return data.decode("utf-16")
        except UnicodeDecodeError as error:
            raise broken(FILE_NOT_TEXT, 1) from error
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        try:
            text = data.decode("gb18030")
        except UnicodeDecodeError:
            line_start = data.rfind(b"\n", 0, error.start) + 1
            line = data.count(b"\n", 0, error.start) + 1
            raise broken(FILE_NOT_TEXT, line, error.start - line_start + 1) from error
    nul = text.find("\0")
    if nul >= 0:
        line = text.count("\n", 0, nul) + 1
        raise broken(FILE_NOT_TEXT, line, nul - text.rfind("\n", 0, nul))
    return text


def number(value: float) -> str:
    """Return a number as short as it can be written without losing anything."""
    text = repr(float(value))
    return text[:-2] if text.endswith(".0") else text


def parse_number(text: str, line: int, column: int) -> float:
    """Return a number as written with digits, a decimal point and perhaps an exponent.

    Raises:
        TrajectoryFileError: It is none, or an infinite one; `line` and `column` say where.
    """
    try:
        value = float(text)
    except ValueError:
        raise broken(NUMBER_BAD, line, column, value=text) from None
    if value - value != 0.0 or "_" in text:  # infinite, or none
        raise broken(NUMBER_BAD, line, column, value=text)
    return value


def read_figures(lines: Sequence[str], delimiter: str | None) -> Array | None:
    """Return the numbers (n, columns) of lines that all hold equally many of them and nothing else.

    Args:
        lines: Without empty ones and comments.
        delimiter: Between numbers; ``None`` for blanks.

    Returns:
        The finite numbers, or ``None`` where something is different: whoever then reads the lines
        one by one can say where and what.
    """
    if not lines:
        return None
    try:
        figures = np.loadtxt(lines, delimiter=delimiter, comments=None, ndmin=2, dtype=np.float64)
    except (ValueError, OverflowError):
        return None
    return figures if np.isfinite(figures).all() else None
