"""Opens a recorded CAN log of any format that python-can reads, and reads as much as possible.

`armui decode`, replay, index and exports use it: a log is a sequence of batches of frames and a
list of damaged places.
"""

from __future__ import annotations

import logging
import re
from typing import TYPE_CHECKING, Final

from armui.session.batch_builder import BatchBuilder
from armui.session.blf_logs import read_blf_log
from armui.session.database_logs import read_database
from armui.session.frames import DamageList, FrameBatch, NotALogError
from armui.session.source import LogSource
from armui.session.text_logs import TEXT_FORMATS, NonsenseError, read_text_log
from armui.system.files import NO_STANDARD_INPUT, is_standard_input, open_file
from armui.system.sentence import Told

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path
    from typing import Self

SUFFIXES: Final = (".log", ".asc", ".blf", ".trc", ".csv", ".db", ".txt")
_BEGINNING: Final = 4_096
_SIGNS: Final = {
    ".blf": re.compile(rb"\ALOGG"),
    ".db": re.compile(rb"\ASQLite format 3\0"),
    ".gz": re.compile(rb"\A\x1f\x8b"),
    ".trc": re.compile(rb"^;\$FILEVERSION", re.MULTILINE),
    ".asc": re.compile(rb"^base\s+(hex|dec)\s", re.MULTILINE | re.IGNORECASE),
    ".csv": re.compile(
        rb"\A(\xef\xbb\xbf)?(timestamp,arbitration_id|time stamp,id|\xd0\xf2\xba\xc5|\xe5\xba\x8f)",
        re.IGNORECASE,
    ),
    ".log": re.compile(
        rb"^\s*(\([\d. :-]+\)\s+)?\w+\s+([0-9A-F]+#|([RT]X\s.{3}\s+)?[0-9A-F]{3,8}\s+\[\d)",
        re.MULTILINE | re.IGNORECASE,
    ),
}
"""The mark of each format near the beginning of its files."""
_WAYS: Final = {
    rb"\*\*\*BUSMASTER": Told("of BUSMASTER: convert it there to .asc"),
    rb"Chn\s+Identifier\s+Fl": Told("of Kvaser CanKing: save it there as Vector's .asc"),
    (
        rb"\A(\n\r\r\n|\xd4\xc3\xb2\xa1|\xa1\xb2\xc3\xd4|\x4d\x3c\xb2\xa1|\"?No\.\"?,\"?Time\"?,)"
    ): Told("of Wireshark: record with candump -l or armui record instead"),
    rb"\xe5\xb8\xa7|\xd6\xa1|\xe5\xba\x8f\xe5\x8f\xb7|\xd0\xf2\xba\xc5": Told(
        "of ZLG or the like with other titles than CANTest's: save it there as .asc"
    ),
    rb"\A[^\n,;]*[A-Za-z][^\n,;]*([,;][^\n,;]+){2}": Told(
        "with titles that are not known (SavvyCAN's, ZLG's and python-can's are): save it as .asc, "
        ".blf or .trc where it was recorded"
    ),
}
"""Advice for unsupported kinds of files, by signs near their beginning."""
_TABLES: Final = (".csv", ".txt", ".log")
_NOT_PACKED: Final = ".db"
"""The format that is not read sequentially, so that it cannot be compressed as .gz."""


class LogFile:
    """An open log; use it in a ``with`` statement.

    Attributes:
        path: The file.
        damages: The damaged places met so far.
    """

    def __init__(self, path: Path, *, pipes: bool = False) -> None:
        """Open a log and read its first frames.

        Formats: candump, with -L or as its screen shows it (.log, .txt), Vector (.asc, .blf), PEAK
        (.trc), tables of python-can, SavvyCAN and ZLG (.csv), python-can (.db); compressed ones but
        .db with .gz behind. Memory stays bounded whatever the file holds.

        Args:
            path: The file; with `pipes` also ``-``, the standard input, or a pipe without a suffix,
                whose format is told by what comes first.
            pipes: See `LogSource`.

        Raises:
            NotALogError: The file cannot be opened, its suffix is of no known format, or nothing in
                it is a frame.
        """
        # The readers comment on damaged lines through logging; here they are noted by number.
        logging.getLogger("can").addHandler(logging.NullHandler())
        self.path = path
        self.damages = DamageList()
        unnamed = is_standard_input(path) or (pipes and not path.suffixes and path.is_fifo())
        if unnamed and not pipes:
            raise NotALogError(NO_STANDARD_INPUT)
        self._suffix = "" if unnamed else _log_suffix(path)
        self._builder = BatchBuilder(self.damages)
        self._source = LogSource(path, pipes=pipes)
        try:
            self._suffix = self._suffix or _suffix_of(self._source.peek())
            self._batches = self._read()
            self._first = next(self._batches, None)
        except NonsenseError:
            self.close()
            raise self._no_log() from None
        except BaseException:
            self.close()
            raise

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_error: object) -> None:
        self.close()

    @property
    def size(self) -> int:
        """The size of the file in bytes, 0 if not known."""
        return self._source.size

    @property
    def is_pipe(self) -> bool:
        """True if it comes through a pipe, perhaps while it is recorded."""
        return self._source.is_pipe

    @property
    def position(self) -> int:
        """The bytes of the file read so far."""
        return self._source.position

    @property
    def frames(self) -> int:
        """The number of frames read so far."""
        return self._builder.frames

    def batches(self) -> Iterator[FrameBatch]:
        """Yield the frames in the order of the file; this can be called only once."""
        if self._first is not None:
            first, self._first = self._first, None
            yield first
        yield from self._batches

    def close(self) -> None:
        """Close the log's file."""
        self._source.close()

    def _read(self) -> Iterator[FrameBatch]:
        """Yield the batches that hold frames.

        Raises:
            NotALogError: There are none, and no header of a log either.
        """
        found = False
        for batch in self._read_format():
            if len(batch):
                found = True
                yield batch
        if not found and not self._builder.header_seen:
            raise self._no_log()

    def _read_format(self) -> Iterator[FrameBatch]:
        if self._suffix == ".blf":
            return read_blf_log(self._source, self._builder)
        if self._suffix == ".db":
            return read_database(self.path, self._builder)
        return read_text_log(self._source, TEXT_FORMATS[self._suffix], self._builder)

    def _no_log(self) -> NotALogError:
        beginning = _beginning(self.path)
        looks_like = _looks_like(beginning)
        reason = Told(
            "no CAN log: nothing in it reads as a frame of a {kind} file", kind=self._suffix
        )
        if self._source.broken:
            reason = Told("{reason} ({error})", reason=reason, error=self._source.broken)
        elif looks_like not in {"", self._suffix}:
            reason = Told(
                "{reason}; it looks like a {kind} file: give it that suffix",
                reason=reason,
                kind=looks_like,
            )
        elif self._suffix in _TABLES:
            for sign, way in _WAYS.items():
                if re.search(sign, beginning):
                    reason = Told("{reason}; it looks like a file {way}", reason=reason, way=way)
                    break
        return NotALogError(reason)


def _beginning(path: Path) -> bytes:
    try:
        with open_file(path) as stream:
            return stream.read(_BEGINNING)
    except OSError:
        return b""


def _looks_like(beginning: bytes) -> str:
    """Return the suffix that a file's beginning speaks for, "" if none."""
    return next((suffix for suffix, sign in _SIGNS.items() if sign.search(beginning)), "")


def _suffix_of(beginning: bytes) -> str:
    """Return the suffix of what comes through a pipe, which has no name: candump's if none.

    Raises:
        NotALogError: It is of a kind that is read from files only.
    """
    suffix = _looks_like(beginning[:_BEGINNING]) or ".log"
    if suffix == ".gz":
        raise NotALogError(Told("it is packed: unpack it before, as with zcat run.log.gz | ..."))
    if suffix == _NOT_PACKED:
        raise NotALogError(Told("a database is read from its file only"))
    return suffix


def is_known_kind(path: Path) -> bool:
    """Return whether a file is a log by its name."""
    try:
        _log_suffix(path)
    except NotALogError:
        return False
    return True


def is_mf4(path: Path) -> bool:
    """Return whether a file is a log in ASAM's format by its name; those are not read."""
    return path.name.lower().removesuffix(".gz").endswith(".mf4")


def _log_suffix(path: Path) -> str:
    suffixes = [suffix.lower() for suffix in path.suffixes]
    packed = bool(suffixes) and suffixes[-1] == ".gz"
    if packed:
        suffixes.pop()
    suffix = suffixes[-1] if suffixes else ""
    if is_mf4(path):
        raise NotALogError(
            Told(
                "MF4 is not read: convert it to .asc or .blf with other software, for example "
                "asammdf"
            )
        )
    if suffix not in SUFFIXES or (packed and suffix == _NOT_PACKED):
        known = ", ".join(SUFFIXES)
        raise NotALogError(
            Told(
                "unknown kind of log {kind!r}; known are {known}, and these but {plain} with .gz",
                kind="".join(path.suffixes[-2:]),
                known=known,
                plain=_NOT_PACKED,
            )
        )
    return suffix
