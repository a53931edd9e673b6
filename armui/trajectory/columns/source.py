"""A file that is not in a format of ours, and the table in it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from armui.arm.refusal_codes import RefusalCode
from armui.trajectory import files
from armui.trajectory.columns.encodings import Encoding, decode_as, guess_encoding
from armui.trajectory.columns.model import Dialect, Sheet
from armui.trajectory.columns.sniff import sniff
from armui.trajectory.files.errors import TrajectoryFileError


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
        raise TrajectoryFileError(error.reason, error.line, error.column, file_name) from error


def look_closer(path: Path, error: TrajectoryFileError) -> tuple[TrajectoryFileError, bool]:
    """Whether a file that could not be loaded can be imported by columns.

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
        return (closer if error.reason.code == RefusalCode.FILE_KIND_UNKNOWN else error), False
    return error, not files.is_ours(table.text)
