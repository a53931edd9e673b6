"""Opens a recorded CAN log of any format and reads what can be read of it."""

from __future__ import annotations

import gzip
import logging
from typing import IO, TYPE_CHECKING, cast

from armui.decode.blf_logs import read_blf_log
from armui.decode.entries import LogFrame, NotALogError, Unreadable
from armui.decode.text_logs import TEXT_FORMATS, Lines, read_text_log
from armui.system.error_text import error_text

if TYPE_CHECKING:
    from collections.abc import Generator, Iterator
    from pathlib import Path

_BLF = ".blf"
_SUFFIXES = (".log", ".asc", _BLF, ".trc", ".csv")
_PATIENCE = 1_000
"""So many unreadable lines before the first frame, and the file is no log."""


def read_log(path: Path) -> Generator[LogFrame | Unreadable]:
    """Frames of a log in order, and between them the places that could not be read.

    Reads the formats of candump -L (.log), Vector (.asc, .blf), PEAK (.trc) and python-can (.csv),
    also compressed (.log.gz), with constant memory.

    Args:
        path: The log.

    Raises:
        NotALogError: The file cannot be opened, its suffix is of no known format, or nothing in it
            is a frame.
    """
    # The readers comment on damaged lines through logging; here they are reported by number.
    logging.getLogger("can").addHandler(logging.NullHandler())
    suffix = _log_suffix(path)
    try:
        with _open(path) as stream:
            if suffix == _BLF:
                yield from _expect_frames(read_blf_log(stream), suffix, None)
            else:
                log_format = TEXT_FORMATS[suffix]
                lines = Lines(stream, log_format)
                yield from _expect_frames(read_text_log(lines, log_format), suffix, lines)
    except OSError as error:
        raise NotALogError(error_text(error)) from error


def _log_suffix(path: Path) -> str:
    suffixes = [suffix.lower() for suffix in path.suffixes]
    if suffixes and suffixes[-1] == ".gz":
        suffixes.pop()
    suffix = suffixes[-1] if suffixes else ""
    if suffix not in _SUFFIXES:
        known = ", ".join(_SUFFIXES)
        raise NotALogError(f"unknown kind of log {suffix!r}; known are {known} and these with .gz")
    return suffix


def _open(path: Path) -> IO[bytes]:
    if path.suffix.lower() == ".gz":
        return cast("IO[bytes]", gzip.open(path, "rb"))
    return path.open("rb")


def _expect_frames(
    entries: Iterator[LogFrame | Unreadable], suffix: str, lines: Lines | None
) -> Iterator[LogFrame | Unreadable]:
    """Passes entries on, but holds back complaints until a frame shows that the file is a log."""
    complaints: list[Unreadable] = []
    for entry in entries:
        if isinstance(entry, LogFrame):
            yield from complaints
            yield entry
            yield from entries
            return
        complaints.append(entry)
        if len(complaints) > _PATIENCE:
            break
    if lines is None or not lines.header_seen:
        raise NotALogError(f"no CAN log: nothing in it reads as a frame of a {suffix} file")
    yield from complaints
