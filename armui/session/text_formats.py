"""What python-can's readers of line-based logs leave unsaid about their formats."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

import can

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

_NEVER: Final = r"(?!)"
_ERROR_FLAG: Final = 0x20000000
_CANDUMP_FRAME: Final = re.compile(r"\s([0-9a-f]+)#([0-9a-f]*)", re.IGNORECASE)
_CANDUMP_LENGTH_CODE: Final = re.compile(r"(#[0-9a-f]{16})_[9-f]\b", re.IGNORECASE)
_LONGEST_SCREEN_LINE: Final = 400
"""Characters; 64 bytes of CAN FD with their text take some 300."""
_CANDUMP_SCREEN: Final = re.compile(
    r"\((?P<time>[\d.]+)\)\s+(?P<channel>\S+)\s+(?:(?P<sent>TX)\s+[-BE\s]+|RX\s+[-BE\s]+)?"
    r"(?P<id>[0-9a-f]{3}|[0-9a-f]{8})\s+(?:\[\d\]|(?P<fd>\[\d\d\]))\s+"
    r"(?:(?P<remote>remote request)|(?P<data>(?:[0-9a-f]{2}(?:\s+|$))*))"
    r"(?:\s*'.*)?(?:ERRORFRAME)?$",
    re.IGNORECASE,
)


def _unchanged(message: can.Message, _line: str) -> None:
    """Nothing to add to what the reader made of a line."""


def _no_repair(_line: str) -> str | None:
    """No other way to write a line."""
    return None


@dataclass(frozen=True)
class TextFormat:
    """One format's peculiarities; the patterns ignore case.

    Attributes:
        name: What people call it.
        reader: The reader of python-can; it takes a stream of lines and is iterated for messages.
        header: Lines that open a log of this format: it is one, even when no frame follows.
        silent: Lines that rightly yield no frame: comments, events, statistics.
        opening: Line that the reader swallows before its first frame. It is slipped in where the
            log lacks it and whenever the reader starts anew, so that no frame is swallowed instead.
        sound: What a line with a frame looks like, where the reader makes frames of other lines.
        complete: Adds to a message what stands in its line and the reader passes over; called for
            extended identifiers and error frames only.
        rewrite: Another way to write a line that the reader cannot read, None if there is none.
    """

    name: str
    reader: Callable[[Any], Iterable[can.Message]]
    header: str = _NEVER
    silent: str = _NEVER
    opening: str = ""
    sound: str = ""
    complete: Callable[[can.Message, str], None] = _unchanged
    rewrite: Callable[[str], str | None] = _no_repair


def _complete_candump(message: can.Message, line: str) -> None:
    """Error frames of every class, with their class bits and details.

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


def _rewrite_candump(line: str) -> str | None:
    """A line of candump's screen output with times, or with a length code (-8), as -L has it."""
    without_code = _CANDUMP_LENGTH_CODE.sub(r"\1", line)
    if without_code != line:
        return without_code
    # of a longer one, made to be slow to match, nothing would be left to read
    found = _CANDUMP_SCREEN.match(line) if len(line) <= _LONGEST_SCREEN_LINE else None
    if found is None:
        return None
    payload = "R" if found["remote"] else (found["data"] or "").replace(" ", "")
    mark = "##0" if found["fd"] else "#"
    sent = " T" if found["sent"] else ""
    return f"({found['time']}) {found['channel']} {found['id']}{mark}{payload}{sent}"


CANDUMP: Final = TextFormat(
    "candump",
    can.CanutilsLogReader,
    sound=r"\([\d.]+\)\s+\S+\s+[\da-f]+#((#[\da-f])?([\da-f]{2})*|r\d*)(\s+[rt])?$",
    complete=_complete_candump,
    rewrite=_rewrite_candump,
)
CSV: Final = TextFormat("CSV", can.CSVReader, header=r"timestamp,", opening="timestamp,")
ASC: Final = TextFormat(
    "ASC",
    can.ASCReader,
    header=r"date\s|base\s+(hex|dec)|(no\s+)?internal\s+events\s+logged",
    silent=(
        r"//|(begin|end)\s+triggerblock|previous\s+log\s+file"
        r"|[\d.]+\s+(start of measurement|log\s|[a-z][\w ]*:"
        r"|(can\s*)?\d+\s+(status|statistic)|(\w+\s+)*j1939)"
    ),
    opening="no internal events logged",
)
TRC: Final = TextFormat(
    "TRC",
    can.TRCReader,
    header=r";\$(fileversion|starttime|columns)",
    silent=r";|\s*\d+\)?\s+[\d.]+\s+(\d+\s+)?(st|er|ec|ev|warng|error|ffffffff)\b",
)
TEXT_FORMATS: Final = {".log": CANDUMP, ".txt": CANDUMP, ".csv": CSV, ".asc": ASC, ".trc": TRC}
"""By file suffix."""
