"""A file that is not in a format of ours, and the table in it."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from armui.trajectory import files
from armui.trajectory.columns.model import Sheet
from armui.trajectory.columns.sniff import sniff
from armui.trajectory.files.errors import TrajectoryFileError


class TableFile(NamedTuple):
    """The whole text of a file, and how the table in it is built."""

    file_name: str
    text: str
    sheet: Sheet


def open_table(path: Path) -> TableFile:
    """Read a file and see how the table in it is built.

    Raises:
        TrajectoryFileError: It cannot be read, or holds no table; it names the file.
    """
    text = files.load_text(path)
    try:
        return TableFile(path.name, text, sniff(text))
    except TrajectoryFileError as error:
        raise TrajectoryFileError(error.reason, error.line, error.column, path.name) from error


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
        return (closer if error.reason.code == "file_kind_unknown" else error), False
    return error, not files.is_ours(table.text)
