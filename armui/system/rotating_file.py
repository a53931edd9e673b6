"""The log's file; `logging.handlers` brings sockets and more, which no start needs."""

from __future__ import annotations

import logging
from io import TextIOWrapper
from logging.handlers import RotatingFileHandler
from pathlib import Path
from typing import Final

from armui.system.files import open_file

_MOST_BYTES: Final = 1_000_000
_OLD_FILES: Final = 4


class RotatingFile(RotatingFileHandler):
    """Takes lines; the file is opened with the first.

    Args:
        path: The file; older ones lie beside it, with a number.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        super().__init__(
            path, maxBytes=_MOST_BYTES, backupCount=_OLD_FILES, encoding="utf-8", delay=True
        )

    def add(self, line: str) -> None:
        """Write a line; waits for the disk."""
        self.handle(logging.makeLogRecord({"msg": line}))

    def _open(self) -> TextIOWrapper:
        return TextIOWrapper(open_file(self._path, "ab"), encoding="utf-8")

    def handleError(self, record: logging.LogRecord) -> None:  # noqa: N802 - logging's name
        """A disk that is full, or a file another program holds: the log goes on when it can."""
