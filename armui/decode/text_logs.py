"""Reads the line-based log formats with python-can, past lines that its readers give up on.

A reader of python-can is one generator: an exception in a line ends it. Here it is fed through a
stream that knows which line it handed out last; when the reader fails, the line is reported and a
new generator of the same reader goes on with the next one.
"""

from __future__ import annotations

import re
import zlib
from dataclasses import dataclass
from typing import IO, TYPE_CHECKING, Any

import can

from armui.decode.entries import LogFrame, Unreadable, log_frame

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator

_LONGEST_LINE = 16_384
_EXCERPT = 60
_NEVER = r"(?!)"
_CANDUMP_EXTENDED_ID = re.compile(r"\s([0-9A-F]{8})#", re.IGNORECASE)
_CANDUMP_ERROR_FLAG = 0x20000000


@dataclass(frozen=True)
class TextFormat:
    """One format's peculiarities; the patterns ignore case.

    Attributes:
        reader: The reader of python-can; it takes a stream of lines and is iterated for messages.
        header: Lines that open a log of this format: it is one, even when no frame follows.
        silent: Lines that rightly yield no frame: comments, events, statistics.
        opening: Line that the reader swallows before its first frame. It is slipped in where the
            log lacks it and whenever the reader starts anew, so that no frame is swallowed instead.
        sound: What a line with a frame looks like, where the reader is too easily content.
        is_error: Whether a line holds an error frame that the reader takes for a data frame.
    """

    reader: Callable[[Any], Iterable[can.Message]]
    header: str = _NEVER
    silent: str = _NEVER
    opening: str = ""
    sound: str = ""
    is_error: Callable[[str], bool] = lambda _line: False


def _is_candump_error(line: str) -> bool:
    found = _CANDUMP_EXTENDED_ID.search(line)
    return found is not None and bool(int(found.group(1), 16) & _CANDUMP_ERROR_FLAG)


TEXT_FORMATS = {
    ".log": TextFormat(
        can.CanutilsLogReader,
        sound=r"\([\d.]+\)\s+\S+\s+[\da-f]+#[\da-fr#]*(\s+[rt])?$",
        is_error=_is_candump_error,
    ),
    ".csv": TextFormat(can.CSVReader, header=r"timestamp,", opening="timestamp,"),
    ".asc": TextFormat(
        can.ASCReader,
        header=r"date\s|base\s+(hex|dec)|(no\s+)?internal\s+events\s+logged",
        silent=(
            r"//|(begin|end)\s+triggerblock|previous\s+log\s+file"
            r"|[\d.]+\s+(start of measurement|log\s|[a-z][\w ]*:"
            r"|(can\s*)?\d+\s+(status|statistic)|(\w+\s+)*j1939)"
        ),
        opening="no internal events logged",
    ),
    ".trc": TextFormat(
        can.TRCReader,
        header=r";\$(fileversion|starttime|columns)",
        silent=r";|\s*\d+\)?\s+[\d.]+\s+(\d+\s+)?(st|er|ec|ev|warng|error|ffffffff)\b",
    ),
}
"""By file suffix."""


class Lines:
    """The stream a reader reads from: lines, counted, until the file ends or breaks.

    Attributes:
        number: Number of the line handed out last, from 1.
        pending: That line, until a frame came of it.
        header_seen: A line that opens a log of this format has gone by.
        skipped: Lines that yielded no frame though they should.
        broken: Why the file could not be read to its end, "" if it could.
    """

    def __init__(self, stream: IO[bytes], log_format: TextFormat) -> None:
        self._stream = stream
        self._header = re.compile(log_format.header, re.IGNORECASE)
        self._silent = re.compile(log_format.silent, re.IGNORECASE)
        self._opening = log_format.opening
        self._opened = not self._opening
        self._held_back: str | None = None
        self.number = 0
        self.pending: str | None = None
        self.header_seen = False
        self.skipped: list[Unreadable] = []
        self.broken = ""

    def __iter__(self) -> Iterator[str]:
        return self

    def __next__(self) -> str:
        self.settle()
        line = self._held_back or self._read()
        self._held_back = None
        if self._header.match(line):
            self.header_seen = True
            self._opened = self._opened or line.startswith(self._opening)
            return line
        if not self._opened and not self._silent.match(line):
            self._opened = True
            self._held_back = line
            return self._opening
        self.pending = line
        return line

    def close(self) -> None:
        """Called by readers at their end; the file belongs to whoever opened it."""

    def restart(self) -> None:
        """Prepares for a new generator of the reader, which swallows the opening again."""
        self._opened = not self._opening

    def settle(self) -> None:
        """The reader is done with the pending line: it is skipped unless it may yield nothing."""
        if self.pending is not None and not self._silent.match(self.pending):
            self.skip()
        self.pending = None

    def skip(self) -> None:
        """Notes the pending line as unreadable."""
        if self.pending is not None:
            text = self.pending
            excerpt = text if len(text) <= _EXCERPT else text[:_EXCERPT] + "..."
            self.skipped.append(Unreadable(f"line {self.number}", ascii(excerpt)))
            self.pending = None

    def take_skipped(self) -> list[Unreadable]:
        """The lines skipped since the last call."""
        taken, self.skipped = self.skipped, []
        return taken

    def _read(self) -> str:
        """The next line that is not blank; of an overlong one its beginning.

        Raises:
            StopIteration: The file ends here, or cannot be read on.
        """
        while True:
            try:
                raw = rest = self._stream.readline(_LONGEST_LINE)
                while len(rest) == _LONGEST_LINE and not rest.endswith(b"\n"):
                    rest = self._stream.readline(_LONGEST_LINE)
            except (OSError, EOFError, zlib.error) as error:
                self.broken = str(error)
                raise StopIteration from None
            if not raw:
                raise StopIteration
            self.number += 1
            line = raw.decode("utf-8-sig" if self.number == 1 else "utf-8", "replace").strip()
            if line:
                return line


def read_text_log(lines: Lines, log_format: TextFormat) -> Iterator[LogFrame | Unreadable]:
    """Frames and unreadable lines of a log, in order, one at a time.

    Args:
        lines: The log.
        log_format: Its format.
    """
    sound = re.compile(log_format.sound, re.IGNORECASE)
    reader = log_format.reader(lines)
    messages = iter(reader)
    restarted_at = -1
    while True:
        try:
            message = next(messages)
        except StopIteration:
            break
        except Exception:  # noqa: BLE001 - a damaged line makes the readers raise whatever it hits
            if lines.number == restarted_at:
                break
            restarted_at = lines.number
            lines.skip()
            lines.restart()
            messages = iter(reader)
            continue
        line = lines.pending or ""
        message.is_error_frame |= log_format.is_error(line)
        entry = log_frame(message) if sound.match(line) else None
        if entry is None:
            lines.skip()
        lines.pending = None
        yield from lines.take_skipped()
        if entry is not None:
            yield entry
    lines.settle()
    yield from lines.take_skipped()
    if lines.broken:
        yield Unreadable(f"after line {lines.number}", lines.broken)
