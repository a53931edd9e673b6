"""Reads a file in an unknown format, and finds the table in it."""

from __future__ import annotations

import codecs
from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path
from typing import Final

from armui.arm.refusal import Reason
from armui.protocol.codes import MoveMode
from armui.trajectory import files
from armui.trajectory.columns.apply import apply, check_mapping
from armui.trajectory.columns.foreign import FILE_COMMANDS, FILE_FOREIGN, as_table, is_structured
from armui.trajectory.columns.guess import units_in_doubt
from armui.trajectory.columns.model import JOINTS, ColumnMapping, Dialect, Sheet
from armui.trajectory.columns.sniff import sniff
from armui.trajectory.files.errors import TrajectoryFileError, broken
from armui.trajectory.files.json_file import JSON_BAD
from armui.trajectory.files.log_file import FILE_KIND_UNKNOWN
from armui.trajectory.files.model import Content

FILE_NOT_ENCODING = Reason(
    "file_not_encoding", "This is not text in {value}. Choose another encoding."
)


SPEED_PERCENT: Final = 100
"""The speed of points that tell none, as of those made here: the operator's speed is the slider."""
_LOOKED_AT_BYTES: Final = 4096
_MANY: Final = 0.3
"""The share of zero bytes at even or odd places above which a text counts as UTF-16."""


class Encoding(StrEnum):
    """The usual encodings of text files; the value is Python's name of each."""

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
"""The common name of each encoding."""

_MARKS: Final = {codecs.BOM_UTF16_LE: Encoding.UTF_16_LE, codecs.BOM_UTF16_BE: Encoding.UTF_16_BE}


def guess_encoding(data: bytes) -> Encoding:
    """Return the likely encoding of bytes.

    A byte order mark decides; UTF-16 without one is full of zeros, and valid UTF-8 is hardly ever
    anything else. Chinese Windows writes GBK by default, Western Windows writes Windows-1252.
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
    """Return the text of bytes in an encoding, without the byte order mark.

    Raises:
        TrajectoryFileError: The bytes are not in this encoding; it names the line and the
            character.
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
    """Return the error for the first wrong character, which is the one after a decoded text."""
    lines = before.removeprefix("\ufeff").splitlines(keepends=True)
    line, column = max(1, len(lines)), len(lines[-1]) + 1 if lines else 1
    if lines and lines[-1].endswith(("\n", "\r")):
        line, column = len(lines) + 1, 1
    return broken(FILE_NOT_ENCODING, line, column, value=LABELS[encoding])


@dataclass(frozen=True, slots=True)
class TableFile:
    """The whole text of a file, and the layout of the table in it.

    Attributes:
        file_name: The file's name without its folder.
        data: The bytes of the file.
        encoding: The encoding of the text.
        text: The decoded text.
        sheet: The layout of the table.
        is_record: True if the file is no table itself, but records whose figures have names.
    """

    file_name: str
    data: bytes
    encoding: Encoding
    text: str
    sheet: Sheet
    is_record: bool = False

    def read_anew(self, encoding: Encoding | None, dialect: Dialect) -> TableFile:
        """Return the same file read with the operator's settings; the rest is guessed.

        Raises:
            TrajectoryFileError: It cannot be read so; the error names the file.
        """
        return _read(self.file_name, self.data, encoding, dialect)


def open_table(path: Path) -> TableFile:
    """Read a file and detect the layout of the table in it.

    Raises:
        TrajectoryFileError: It cannot be read, or holds no table; the error names the file.
    """
    return _read(path.name, files.load_bytes(path), None, Dialect())


def _read(file_name: str, data: bytes, encoding: Encoding | None, dialect: Dialect) -> TableFile:
    try:
        encoding = encoding or guess_encoding(data)
        text = decode_as(data, encoding)
        if files.is_ours(text):
            return TableFile(file_name, data, encoding, text, sniff(text, dialect))
        table = as_table(text)
        if table is not None:
            sheet = sniff(table.text, dialect)
            return TableFile(file_name, data, encoding, table.text, sheet, table.is_record)
        return TableFile(file_name, data, encoding, text, _sniff_plain(text, dialect))
    except TrajectoryFileError as error:
        raise TrajectoryFileError(error.refusal, error.line, error.column, file_name) from error


def _sniff_plain(text: str, dialect: Dialect) -> Sheet:
    """Return the layout of the table in a text; an error if it holds records without points."""
    try:
        sheet = sniff(text, dialect)
    except TrajectoryFileError as error:
        raise (broken(FILE_FOREIGN) if is_structured(text) else error) from error
    if sheet.width < len(JOINTS) and is_structured(text):
        raise broken(FILE_FOREIGN)
    return sheet


def look_closer(path: Path, error: TrajectoryFileError) -> tuple[TrajectoryFileError, bool]:
    """Return the error to show for a file that could not be loaded, and whether it holds a table.

    A table may also be a file that one of our formats took for its own, as degrees for the maker's
    radians.

    Args:
        path: The file.
        error: The error from loading it.

    Returns:
        The better error, and whether the file can be imported by columns.
    """
    try:
        table = open_table(path)
    except TrajectoryFileError as closer:
        found = closer.refusal.reason
        is_better = error.refusal.reason == FILE_KIND_UNKNOWN or found == FILE_COMMANDS
        is_better |= found == FILE_FOREIGN and error.refusal.reason != JSON_BAD
        return (closer if is_better else error), False
    return error, not files.is_ours(table.text)


def told_by_names(path: Path, name: str) -> Content | None:
    """Return the content of a file of records whose names tell all that is wanted, else ``None``.

    Raises:
        TrajectoryFileError: It cannot be read so; the error names the file.
    """
    table = open_table(path)
    if not table.is_record:
        return None
    guesses = table.sheet.guesses
    columns = tuple(guess.column for guess in guesses)
    angles = [
        (guess.column.quantity, guess)
        for guess in guesses
        if guess.column is not None
        and guess.column.quantity in JOINTS
        and guess.column.unit != guess.titled_unit
    ]
    moves = (None, MoveMode.MOVE_J) if table.sheet.count > 1 else (MoveMode.MOVE_J,)
    for move in moves:
        mapping = ColumnMapping(columns, move, SPEED_PERCENT)
        if check_mapping(mapping) is None and not units_in_doubt(angles):
            return apply(table.text, table.sheet, mapping, name)
    return None
