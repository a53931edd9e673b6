"""Reads the logs of python-can that are databases (.db, SQLite)."""

from __future__ import annotations

import sqlite3
from typing import TYPE_CHECKING, Any, Final

import can

from armui.session.frames import NotALogError
from armui.system.files import error_text
from armui.system.sentence import Told

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from armui.session.batch_builder import BatchBuilder
    from armui.session.frames import FrameBatch

_ROWS: Final = 4_096
_MOST_FAILURES: Final = 200
"""The reading ends after this many damaged rows, each of which costs a further query."""
_ALL_ROWS: Final = "SELECT * FROM messages"
_LONGEST_VALUE: Final = 1 << 16
"""The most bytes of a value; a frame has 64 at most."""


class _Database(can.SqliteReader):
    """python-can's reader on a database that is only read, row by row past damaged ones."""

    def __init__(self, path: Path) -> None:
        super().__init__(path)
        self._conn.setlimit(sqlite3.SQLITE_LIMIT_LENGTH, _LONGEST_VALUE)
        self._conn.execute("PRAGMA query_only = 1")

    def has_table(self) -> bool:
        """Return whether there is a table of frames; a view might never end."""
        found = self._conn.execute(
            "SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = 'messages'"
        )
        return found.fetchone() is not None

    def rows(self) -> Iterator[can.Message | Exception]:
        """Yield each row's message, or the reason why it is none.

        Raises:
            sqlite3.Error: The file is damaged from here on.
        """
        number = 0
        for _failure in range(_MOST_FAILURES):
            try:
                for row in self._conn.execute(f"{_ALL_ROWS} LIMIT -1 OFFSET {number}"):
                    number += 1
                    yield self._message(row)
            except sqlite3.Error:
                # sqlite3 reads one row ahead: the last one before the bad one was not given yet
                try:
                    row = self._conn.execute(f"{_ALL_ROWS} LIMIT 1 OFFSET {number}").fetchone()
                except sqlite3.Error as error:
                    yield error
                else:
                    yield self._message(row)
                number += 1
            else:
                return
        raise sqlite3.DatabaseError("too many of its rows cannot be read")

    def _message(self, row: Any) -> can.Message | Exception:
        try:
            return self._assemble_message(row)
        except Exception as error:  # noqa: BLE001 - rows may hold any type of value
            return error


def read_database(path: Path, builder: BatchBuilder) -> Iterator[FrameBatch]:
    """Yield the frames of a log written by `can.SqliteWriter`, in the order of its table.

    Raises:
        NotALogError: The file is no database, or lacks the table.
    """
    try:
        database = _Database(path)
    except sqlite3.Error as error:
        raise NotALogError(Told("no CAN log: {error}", error=error_text(error))) from error
    with database:
        try:
            has_table = database.has_table()
        except sqlite3.Error as error:
            raise NotALogError(Told("no CAN log: {error}", error=error_text(error))) from error
        if not has_table:
            raise NotALogError(Told("no CAN log: the database has no table «messages»"))
        builder.header_seen = True
        yield from _gathered(database.rows(), builder)


def _gathered(
    entries: Iterator[can.Message | Exception], builder: BatchBuilder
) -> Iterator[FrameBatch]:
    """Yield batches of the rows that are frames, up to where the file can be read."""
    gathered: list[can.Message] = []
    places: list[int] = []
    row = 0

    def place(index: int) -> str:
        return Told("row {row}", row=places[index])

    while True:
        row += 1
        try:
            entry = next(entries, None)
        except Exception as error:  # noqa: BLE001 - a damaged file raises whatever it hits
            reason = Told("the file is damaged from here on ({error})", error=error_text(error))
            builder.note(Told("row {row}", row=row), reason, len(gathered))
            entry = None
        if isinstance(entry, Exception):
            builder.note(Told("row {row}", row=row), error_text(entry), len(gathered))
            continue
        if entry is not None:
            gathered.append(entry)
            places.append(row)
        if gathered and (entry is None or len(gathered) >= _ROWS):
            yield builder.batch(gathered, place)
            gathered.clear()
            places.clear()
        if entry is None:
            return
