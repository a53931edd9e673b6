"""Reads the line-based log formats with python-can, beyond lines at which its readers fail.

A reader of python-can is one generator: an exception in a line ends it. Here it is fed with lines
one by one; when the reader fails, the line is noted and a new generator of the same reader goes on
with the next one.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

import can
import numpy as np

from armui.protocol.frame import FrameFlag
from armui.session.batch_builder import LOG_LAST_LINE_TORN
from armui.session.candump_lines import FRAME, CandumpLines
from armui.session.frames import CLASSIC_BYTES, FrameBatch
from armui.session.tables import TITLES_BEGIN, TableReader
from armui.system.sentence import Told

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator

    from armui.session.batch_builder import BatchBuilder
    from armui.session.source import LogSource

_NEVER: Final = r"(?!)"
_ERROR_FLAG: Final = 0x20000000
_CANDUMP_FRAME: Final = re.compile(r"\s([0-9a-f]+)#([0-9a-f]*)", re.IGNORECASE)
_ASC_FLAGS_BEHIND: Final = 2
"""The columns between the data of a line of CAN FD and its flags."""
_ASC_IS_FD: Final = 0x1000
_ASC_NAMED: Final = re.compile(
    r"([\d.]+\s+\d+\s+)(?![\da-f]+x?\s)\S+(\s+[RT]x\s+[dr]\b.*\bID = (\d+)(x?))", re.IGNORECASE
)
_TRC_1_2: Final = re.compile(r"^(\d+\)\s+[\d.]+\s+\d+\s+[RT]x\s+[0-9A-F]+)(\s+\d)", re.IGNORECASE)

_LINE: Final = re.compile(
    r"^\((\d+\.\d+)\) ([^\s#]+) ([0-7][0-9A-Fa-f]{2}|[01][0-9A-Fa-f]{7})"
    r"#((?:[0-9A-Fa-f]{2}){0,8})( [RT])?$",
    re.ASCII | re.MULTILINE,
)
_HEX_BYTES: Final = 2 * CLASSIC_BYTES

_ROWS: Final = 4_096
"""The most frames of a batch."""
_LINES_AT_ONCE: Final = 512
"""The lines that go through python-can's reader together when one of them is unusual."""
_EXCERPT: Final = 60
_PATIENT_LINES: Final = 1_000
"""After this many unreadable lines before the first frame the file is no log."""
_PATIENT_BYTES: Final = 1 << 26
"""After this many bytes without a frame the file is no log, or none from here on."""


def _unchanged(message: can.Message, _line: str) -> None:
    """Leave a message as python-can's reader made it of a line."""


@dataclass(frozen=True)
class TextFormat:
    """The properties of one format; the patterns ignore case.

    Attributes:
        name: Its common name.
        reader: The reader of python-can; it takes a stream of lines and is iterated for messages.
        header: Lines that open a log of this format: it is one, even when no frame follows.
        silent: Lines that rightly yield no frame: comments, events, statistics.
        opening: Line that the reader swallows before its first frame. It is slipped in where the
            log lacks it and whenever the reader starts anew, so that no frame is swallowed instead.
        sound: The pattern of a line with a frame, if the reader also makes frames of other lines.
        complete: Adds to a message the parts of its line that the reader ignores; called for
            extended identifiers, CAN FD and error frames only.
        adapt: Rewrites each line that the reader would misread.
        pauses: A line of the header that says that times are those since the frame before.
        encoding: The assumed encoding of a text that is not UTF-8.
    """

    name: str
    reader: Callable[[Any], Iterable[can.Message]]
    header: str = _NEVER
    silent: str = _NEVER
    opening: str = ""
    sound: str = ""
    complete: Callable[[can.Message, str], None] = _unchanged
    adapt: Callable[[str], str] = str
    pauses: str = _NEVER
    encoding: str = "utf-8"


def _complete_candump(message: can.Message, line: str) -> None:
    """Give an error frame its class bits and details, which python-can's reader leaves out.

    The reader knows those of the bus only, and drops what they say (linux/can/error.h).
    """
    found = _CANDUMP_FRAME.search(line)
    if found is None or len(found.group(1)) != 8:
        return
    arbitration_id = int(found.group(1), 16)
    if not arbitration_id & _ERROR_FLAG:
        return
    channel = line.split(maxsplit=2)[1]
    message.is_error_frame = True
    message.arbitration_id = arbitration_id & (_ERROR_FLAG - 1)
    message.data = bytearray.fromhex(found.group(2))
    message.dlc = len(message.data)
    message.channel = int(channel) if channel.isdigit() else channel


def _complete_asc(message: can.Message, line: str) -> None:
    """Take a classic frame on a channel of CAN FD for what it is, which its flags tell."""
    if not message.is_fd or message.is_error_frame:
        return
    words = line.split()
    first = 9 if words[5].isdigit() else 10  # there may be a name behind the identifier
    flags = words[first + len(message.data) + _ASC_FLAGS_BEHIND :][:1]
    if flags and not int(flags[0], 16) & _ASC_IS_FD:
        message.is_fd = False


def _adapt_asc(line: str) -> str:
    """Return a date, in whatever language, as a comment: times are from the log's beginning.

    Where an identifier is a name, the number that stands behind the data takes its place.
    """
    if line[:4].lower() == "date":
        return f"// {line}"
    found = _ASC_NAMED.match(line)
    return line if found is None else f"{found[1]}0x{int(found[3]):X}{found[4]}{found[2]}"


def _adapt_trc(line: str) -> str:
    """Return a line of version 1.2, which python-can does not know, as one of version 1.3."""
    if line.startswith(";"):
        return re.sub(r"^(;\$FILEVERSION=)1\.2\s*$", r"\g<1>1.3", line)
    return _TRC_1_2.sub(r"\1 -\2", line)


CANDUMP: Final = TextFormat(
    "candump",
    can.CanutilsLogReader,
    sound=FRAME,
    complete=_complete_candump,
)
CSV: Final = TextFormat("CSV", TableReader, header=TITLES_BEGIN, encoding="gb18030")
ASC: Final = TextFormat(
    "ASC",
    can.ASCReader,
    header=r"date\s|base\s+(hex|dec)|(no\s+)?internal\s+events\s+logged",
    silent=(
        r"//|(begin|end)\s+triggerblock|previous\s+log\s+file"
        r"|[\d.]+\s+(?!can\s*\d|canfd)[^\d\s]"
        r"|[\d.]+\s+((can|canfd)?\s*\d+\s+([a-z]+frame$|[^\W\d]+(:|\s*:=))|(\w+\s+)*j1939)"
        r"|[\d.]+\s+can\s*\d+\s+status"
    ),
    opening="no internal events logged",
    complete=_complete_asc,
    adapt=_adapt_asc,
    pauses=r"base\s+\w+\s+timestamps\s+relative",
)
TRC: Final = TextFormat(
    "TRC",
    can.TRCReader,
    header=r";\$(fileversion|starttime|columns)",
    silent=r";|\s*\d+\)?\s+[\d.]+\s+(\d+\s+)?(st|er|ec|ev|warng|error|ffffffff)\b",
    adapt=_adapt_trc,
)
TEXT_FORMATS: Final = {".log": CANDUMP, ".txt": CANDUMP, ".csv": CSV, ".asc": ASC, ".trc": TRC}
"""The formats by file suffix."""


# Whole blocks of ordinary candump lines at once, as python-can's reader gives them, but faster.
#
# The tests hold it against that reader. A block with any other line goes through the reader.


def quick_batch(lines: list[str], builder: BatchBuilder) -> FrameBatch | None:
    """Return the frames of a block of lines.

    Args:
        lines: Stripped lines; empty ones are skipped.
        builder: Numbers frames and channels.

    Returns:
        The batch, or None when any line is not a data frame of at most 8 bytes written as
        ``candump -L`` writes it.
    """
    found = _LINE.findall("\n".join(lines))
    count = len(found)
    if count != len(lines) - lines.count(""):
        return None
    times, channels, ids, data, directions = zip(*found, strict=True) if count else ((),) * 5
    flags = np.zeros(count, np.uint8)
    id_digits = np.array(list(map(len, ids)), np.uint8)
    if " T" in directions:
        flags[[each == " T" for each in directions]] |= np.uint8(FrameFlag.TRANSMITTED)
    if (id_digits == 3).all():
        joined = bytes.fromhex("0" + "0".join(ids)) if count else b""
        id_column = np.frombuffer(joined, ">u2").astype(np.uint32)
    else:
        id_column = np.array([int(each, 16) for each in ids], np.uint32)
        flags[id_digits != 3] |= np.uint8(FrameFlag.EXTENDED)
    lengths = np.array(list(map(len, data)), np.uint8)
    if not (lengths == _HEX_BYTES).all():
        data = tuple(each.ljust(_HEX_BYTES, "0") for each in data)
    names = tuple(int(each) if each.isdigit() else each for each in channels)
    return builder.count(
        FrameBatch(
            first=builder.frames,
            times_s=np.array(list(map(float, times)), np.float64),
            ids=id_column,
            flags=flags,
            lengths=lengths // 2,
            payloads=np.frombuffer(bytes.fromhex("".join(data)), np.uint8).reshape(
                -1, CLASSIC_BYTES
            ),
            channels=builder.channel_column(names),
            channel_names=builder.channel_names,
        )
    )


class NonsenseError(Exception):
    """Too much was unreadable before the first frame."""


class _Lines:
    """The lines as the reader gets them.

    Attributes:
        number: Number of the line handed out last, from 1.
        pending: That line, until a frame was made of it; then "".
        rows: Frames gathered for the batch under way; set by the reader.
        hopeful: A frame has been read, so that nonsense no longer ends the reading.
    """

    def __init__(self, source: LogSource, log_format: TextFormat, builder: BatchBuilder) -> None:
        self._source = source
        self._builder = builder
        self._blocks: Iterable[list[str]] = ()
        self._header = re.compile(log_format.header, re.IGNORECASE)
        self._pauses = re.compile(log_format.pauses, re.IGNORECASE)
        self._silent = re.compile(log_format.silent, re.IGNORECASE)
        self._sound = re.compile(log_format.sound, re.IGNORECASE)
        self._format = log_format
        self._strict = bool(log_format.sound)
        self._opening = log_format.opening
        self._opened = not self._opening
        self._plain = not log_format.opening and log_format.header == r"(?!)"
        self._frames_before = 0
        self._sense_until = 0
        self._unreadable = 0
        self.number = 0
        self.pending = ""
        self.rows = 0
        self.hopeful = False

    def feed(self, blocks: Iterable[list[str]]) -> None:
        """Set the lines to hand out from here on."""
        self._blocks = blocks

    def __iter__(self) -> Iterator[str]:
        """Yield lines that are not blank, once each.

        Raises:
            NonsenseError: The file begins with too much that is no frame.
        """
        for block in self._blocks:
            for line in block:
                self.number += 1
                if not line:
                    continue
                if not self._plain:
                    if self._header.match(line):
                        self._read_header(line)
                        yield self._format.adapt(line)
                        continue
                    if not self._opened and not self._silent.match(line):
                        self._opened = True
                        yield self._opening
                self.pending = line
                if self._strict and not self._sound.match(line):
                    self.go_on()
                else:
                    yield self._format.adapt(line)
                if self.pending:
                    self.settle()
            self.look_for_end()

    def _read_header(self, line: str) -> None:
        self._builder.header_seen = True
        self._opened = self._opened or line.startswith(self._opening)
        if self._pauses.match(line):
            self._builder.pauses = True

    def look_for_end(self) -> None:
        """Give up on a file that has held nothing readable for too long.

        Raises:
            NonsenseError: Nothing was readable from the beginning on.
        """
        frames = self._builder.frames + self.rows
        if frames > self._frames_before:
            self._frames_before, self._sense_until = frames, self._source.taken
        elif self._source.taken - self._sense_until > _PATIENT_BYTES:
            if not self.hopeful:
                raise NonsenseError
            self._source.broken = Told("nothing in so many bytes is a frame; the rest is not read")

    def close(self) -> None:
        """Do nothing: readers call this at their end, but the file belongs to its opener."""

    def go_on(self) -> None:
        """Note the line at which the reader has failed, unless it may yield nothing.

        A new generator of the reader comes next, which swallows the opening again.
        """
        self._opened = not self._opening
        self.settle()

    def settle_with(self, message: can.Message) -> bool:
        """Mark the pending line as read, and return true, if a message can have come of it."""
        if not self._sound.match(self.pending) or self._is_torn(message):
            self.skip()
            return False
        if message.is_error_frame or message.is_extended_id or message.is_fd:
            self._format.complete(message, self.pending)
        self.pending = ""
        self.hopeful = True
        return True

    def _is_torn(self, message: can.Message) -> bool:
        """Return whether a frame is the rest of one, where the log breaks off."""
        whole = message.is_remote_frame or message.is_fd or len(message.data) >= message.dlc
        return self._source.unended and not whole

    def end(self) -> None:
        """Note the place where the file breaks off, if it does."""
        if self._source.broken:
            place = Told("after line {line}", line=self.number)
            self._builder.note(place, self._source.broken, 0)

    def settle(self) -> None:
        """Finish the pending line: it is noted unless it may yield nothing."""
        if self.pending and not self._silent.match(self.pending):
            self.skip()
        self.pending = ""

    def skip(self) -> None:
        """Note the pending line as unreadable; the last one may just break off."""
        if not self.pending:
            return
        if self._source.unended:
            self._builder.damages.remark(LOG_LAST_LINE_TORN())
        elif self._builder.damages.full:
            self._builder.damages.count += 1
        else:
            text = self.pending
            excerpt = text if len(text) <= _EXCERPT else text[:_EXCERPT] + "..."
            place = Told("line {line}", line=self.number)
            self._builder.note(place, ascii(excerpt), self.rows)
        self.pending = ""
        self._unreadable += 1
        if not self.hopeful and self._unreadable > _PATIENT_LINES:
            raise NonsenseError


def read_text_log(
    source: LogSource, log_format: TextFormat, builder: BatchBuilder
) -> Iterator[FrameBatch]:
    """Yield the frames of a log in order.

    Args:
        source: The file.
        log_format: Its format.
        builder: Builds the batches, and notes what cannot be read.

    Raises:
        NonsenseError: Too much was unreadable before the first frame.
    """
    lines = _Lines(source, log_format, builder)
    if log_format is CANDUMP:
        yield from _read_candump(source, lines, builder)
    else:
        lines.feed(source.lines(log_format.encoding))
        yield from _read(lines, log_format, builder)
        lines.end()


def _read_candump(source: LogSource, lines: _Lines, builder: BatchBuilder) -> Iterator[FrameBatch]:
    """Yield blocks of ordinary lines at once, all others through python-can's reader."""
    screen = CandumpLines(builder)
    for read in source.lines():
        screen.look_at(read)
        whole = read
        batch = quick_batch(whole, builder)
        if batch is None:
            whole = [screen.plain(line, unended=source.unended) for line in read]
            batch = quick_batch(whole, builder)
        step = _LINES_AT_ONCE if batch is None else len(whole)
        for start in range(0, len(whole), step or 1):
            block = whole[start : start + step]
            batch = batch or quick_batch(block, builder)
            if batch is None:
                lines.feed([block])
                yield from _read(lines, CANDUMP, builder)
            else:
                lines.number += len(block)
                lines.hopeful = lines.hopeful or len(batch) > 0
                yield batch
            batch = None
        lines.look_for_end()
    lines.end()


def _read(lines: _Lines, log_format: TextFormat, builder: BatchBuilder) -> Iterator[FrameBatch]:
    """Yield the frames that python-can's reader makes of the lines."""
    handed_out = iter(lines)
    reader = log_format.reader(handed_out)
    messages = iter(reader)
    gathered: list[can.Message] = []
    places: list[int] = []

    def place(index: int) -> str:
        return Told("line {line}", line=places[index])

    while True:
        try:
            message = next(messages)
        except StopIteration:
            break
        except NonsenseError:
            raise
        except Exception:  # noqa: BLE001 - a damaged line makes the readers raise whatever it hits
            if not lines.pending:
                break
            lines.go_on()
            messages = iter(reader)
            continue
        if not lines.settle_with(message):
            continue
        gathered.append(message)
        places.append(lines.number)
        lines.rows = len(gathered)
        if len(gathered) >= _ROWS:
            yield builder.batch(gathered, place)
            gathered.clear()
            places.clear()
            lines.rows = 0
    if gathered:
        yield builder.batch(gathered, place)
        lines.rows = 0
