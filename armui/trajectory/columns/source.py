"""A file that is not in a format of ours, and the table in it."""

from __future__ import annotations

import codecs
from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path
from typing import Final

from armui.arm.refusal import Reason
from armui.trajectory import files
from armui.trajectory.columns.model import Dialect, Sheet
from armui.trajectory.columns.sniff import sniff
from armui.trajectory.files.errors import TrajectoryFileError, broken
from armui.trajectory.files.log_file import FILE_KIND_UNKNOWN

FILE_NOT_ENCODING = Reason(
    "file_not_encoding", "This is not text in {value}. Choose another encoding."
)


_LOOKED_AT_BYTES: Final = 4096
_MANY: Final = 0.3
"""Of the bytes at even or odd places are zero where figures are written in UTF-16."""


class Encoding(StrEnum):
    """The encodings of text files that are met with; the value is Python's name of each."""

    UTF_8 = "utf-8-sig"
    GBK = "gb18030"
    UTF_16_LE = "utf-16-le"
    UTF_16_BE = "utf-16-be"
    WESTERN = "cp1252"


LABELS: Final[Mapping[Encoding, str]] = {
    Encoding.UTF_8: "UTF-8",
    Encoding.GBK: "GBK",
    Encoding.UTF_16_LE: "UTF-16 LE",
    Encoding.UTF_16_BE: "UTF-16 BE",
    Encoding.WESTERN: "Windows-1252",
}
"""What each is called everywhere."""

_MARKS: Final = {codecs.BOM_UTF16_LE: Encoding.UTF_16_LE, codecs.BOM_UTF16_BE: Encoding.UTF_16_BE}


def guess_encoding(data: bytes) -> Encoding:
    """Return the encoding that bytes seem to be in.

    A mark at the beginning says it; UTF-16 without one is full of zeros, and what is valid UTF-8
    is hardly ever anything else. GBK is what Chinese Windows writes by itself, Windows-1252 what
    the rest of the world's does.
    """
    for mark, encoding in _MARKS.items():
        if data.startswith(mark):
            return encoding
    head = data[:_LOOKED_AT_BYTES]
    for first, encoding in ((1, Encoding.UTF_16_LE), (0, Encoding.UTF_16_BE)):
        places = head[first::2]
        if places and places.count(0) > _MANY * len(places):
            return encoding
    for encoding in (Encoding.UTF_8, Encoding.GBK):
        try:
            data.decode(encoding)
        except UnicodeDecodeError:
            continue
        return encoding
    return Encoding.WESTERN


def decode_as(data: bytes, encoding: Encoding) -> str:
    """Return the text of bytes in an encoding, without the mark at its beginning.

    Raises:
        TrajectoryFileError: They are not in it, with the line and the character in it.
    """
    try:
        text = data.decode(encoding)
    except UnicodeDecodeError as error:
        before = data[: error.start].decode(encoding, errors="replace")
        raise _odd(before, encoding) from error
    nul = text.find("\0")
    if nul >= 0:
        raise _odd(text[:nul], encoding)
    return text.removeprefix("\ufeff")


def _odd(before: str, encoding: Encoding) -> TrajectoryFileError:
    """Blames the character that follows a text."""
    lines = before.removeprefix("\ufeff").splitlines(keepends=True)
    line, column = max(1, len(lines)), len(lines[-1]) + 1 if lines else 1
    if lines and lines[-1].endswith(("\n", "\r")):
        line, column = len(lines) + 1, 1
    return broken(FILE_NOT_ENCODING, line, column, value=LABELS[encoding])


@dataclass(frozen=True, slots=True)
class TableFile:
    """The whole text of a file, and how the table in it is built.

    Attributes:
        file_name: Without its folder.
        data: The bytes of the file.
        encoding: Of the text.
        text: What the bytes say in it.
        sheet: How the table is built.
    """

    file_name: str
    data: bytes
    encoding: Encoding
    text: str
    sheet: Sheet

    def read_anew(self, encoding: Encoding | None, dialect: Dialect) -> TableFile:
        """The same file, read as the operator says; what is left open is guessed.

        Raises:
            TrajectoryFileError: It is not possible; it names the file.
        """
        return _read(self.file_name, self.data, encoding, dialect)


def open_table(path: Path) -> TableFile:
    """Read a file and see how the table in it is built.

    Raises:
        TrajectoryFileError: It cannot be read, or holds no table; it names the file.
    """
    return _read(path.name, files.load_bytes(path), None, Dialect())


def _read(file_name: str, data: bytes, encoding: Encoding | None, dialect: Dialect) -> TableFile:
    try:
        encoding = encoding or guess_encoding(data)
        text = decode_as(data, encoding)
        return TableFile(file_name, data, encoding, text, sniff(text, dialect))
    except TrajectoryFileError as error:
        raise TrajectoryFileError(error.refusal, error.line, error.column, file_name) from error


def look_closer(path: Path, error: TrajectoryFileError) -> tuple[TrajectoryFileError, bool]:
    """Return whether a file that could not be loaded can be imported by columns.

    So can one that a format of ours mistook for its own: degrees for the maker's radians.

    Args:
        path: The file.
        error: Why it could not.

    Returns:
        What is wrong with it, and whether it holds a table all the same.
    """
    try:
        table = open_table(path)
    except TrajectoryFileError as closer:
        return (closer if error.refusal.reason == FILE_KIND_UNKNOWN else error), False
    return error, not files.is_ours(table.text)
