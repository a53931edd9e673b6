"""Decodes text files, and converts between numbers and text without loss."""

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

    Chinese Windows writes GBK by default; all of GB 18030 is accepted.

    Raises:
        TrajectoryFileError: It is in none of them; the error names the line of the first wrong
            byte.
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
    """Return the shortest text of a number that loses nothing."""
    text = repr(float(value))
    return text[:-2] if text.endswith(".0") else text


def parse_number(text: str, line: int, column: int) -> float:
    """Return the number in a text of digits, a decimal point and perhaps an exponent.

    Raises:
        TrajectoryFileError: It is no finite number; the error names `line` and `column`.
    """
    try:
        value = float(text)
    except ValueError:
        raise broken(NUMBER_BAD, line, column, value=text) from None
    if value - value != 0.0 or "_" in text:  # infinite, or none
        raise broken(NUMBER_BAD, line, column, value=text)
    return value


def read_figures(lines: Sequence[str], delimiter: str | None) -> Array | None:
    """Return (n, columns) of the numbers in lines that hold equally many numbers and nothing else.

    Args:
        lines: Lines without empty ones and comments.
        delimiter: The separator of numbers; ``None`` for blanks.

    Returns:
        The finite numbers, or ``None`` if a line differs: the caller then reads the lines one by
        one to find the error.
    """
    if not lines:
        return None
    try:
        figures = np.loadtxt(lines, delimiter=delimiter, comments=None, ndmin=2, dtype=np.float64)
    except (ValueError, OverflowError):
        return None
    return figures if np.isfinite(figures).all() else None
