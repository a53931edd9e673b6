"""Rewrites candump's output on a screen, as it was pasted or saved, as lines of ``candump -L``.

Source: candump.c and lib.c of can-utils; with its options -t, -N, -c, -i, -a, -S, -d, -e, -8, -x.
"""

from __future__ import annotations

import contextlib
import re
from datetime import datetime
from typing import TYPE_CHECKING, Final

from armui.session.batch_builder import LOG_LAST_LINE_TORN, LOG_NO_TIMES

if TYPE_CHECKING:
    from collections.abc import Sequence

    from armui.session.batch_builder import BatchBuilder

_LONGEST: Final = 800
"""The most characters of a line of the screen; 64 bytes in binary digits take some 640."""
_STEP_S: Final = 1e-3
_LOOKED_AT: Final = 64
_ADDED: Final = re.compile(r"(?:\x1b|\^\[)\[[\d;]*[A-Za-z]")
"""The escape sequences for the colours of option -c."""
_ENDED: Final = re.compile(r"\^C|\x03")
_DATE: Final = re.compile(r"\((\d{4}-\d\d-\d\d \d\d:\d\d:\d\d)(\.\d+)\)\s*")
_LENGTH_CODE: Final = re.compile(r"(#[0-9a-f]{16})_[9-f]\b", re.IGNORECASE)
_SCREEN: Final = re.compile(
    r"(?:\((?P<time>[\d.]+)\)\s*)?(?P<channel>[^\s()#]+)\s+"
    r"(?:(?P<way>[TR])X\s+(?P<switched>[-B])\s+(?P<state>[-E])\s+)?"
    r"(?P<id>[0-9A-F]{3}|[0-9A-F]{8})\s+"
    r"(?:\[(?P<length>\d\d?)\]|\{(?P<code>[0-9A-F])\})(?P<rest>\s.*)?$",
    re.IGNORECASE,
)
_BARE: Final = re.compile(r"[^\s()#]+\s+[0-9A-F]{3,8}#[0-9A-FR#]*(\s[RT])?$", re.IGNORECASE)
FRAME: Final = r"\([\d.]+\)\s+\S+\s+[\da-f]+#((#[\da-f])?([\da-f]{2})*|r\d*)(\s+[rt])?$"
"""A line with a frame, as -L has it."""
_FRAME: Final = re.compile(FRAME, re.IGNORECASE)
_BYTE: Final = re.compile(r"[0-9A-F]{2}|[01]{8}", re.IGNORECASE)
_BETWEEN: Final = re.compile(r"[\s`]+")
_BESIDE: Final = re.compile(
    r"DROPCOUNT:|(tx-timeout|lost-arbitration|controller-problem|protocol-violation"
    r"|transceiver-status|no-acknowledgement-on-tx|bus-off|bus-error|restarted-after-bus-off"
    r"|error-counter-tx-rx)\b|[^\s@]+@[^\s:]+:.*[$#]|([$#>]\s*)?(sudo\s+)?candump\s|script\s\w+\s(on|,)",
    re.IGNORECASE,
)
"""Lines between the frames that hold none: the words of -d and -e, or a shell's prompt."""
_SINCE: Final = re.compile(r"\(0\d\d\.\d{6}(\d{3})?\)\s")
"""A time of -t d or -t z: the first ones are small, in three digits."""


class CandumpLines:
    """Rewrites the lines of one log, in their order.

    Args:
        builder: Gets the notes on the log, and is to find out whether times are relative.
    """

    def __init__(self, builder: BatchBuilder) -> None:
        self._builder = builder
        self._begun = False
        self._last_s: float | None = None

    def look_at(self, lines: Sequence[str]) -> None:
        """Look at the beginning of the log for the kind of its times."""
        if not self._begun and any(lines):
            self._begun = True
            first = [_ADDED.sub("", line).strip() for line in lines[:_LOOKED_AT]]
            if any(map(_SINCE.match, first)):
                self._builder.pauses = None

    def plain(self, line: str, *, unended: bool) -> str:
        """Return a line as -L has it, "" for one that rightly has no frame, else the line itself.

        Args:
            line: A stripped line.
            unended: True for the last line of a log that breaks off.
        """
        cleaned = _ADDED.sub("", line) if "[" in line else line
        ended = _ENDED.search(cleaned) is not None
        cleaned = _ENDED.sub("", cleaned).strip() if ended else cleaned.strip()
        cleaned = _DATE.sub(_seconds, cleaned, count=1)
        made = self._of_screen(cleaned) or _LENGTH_CODE.sub(r"\1", cleaned)
        if _BARE.match(made):
            made = f"({self._made_up()}) {made}"
        if _FRAME.match(made):
            with contextlib.suppress(ValueError):  # a time with two points
                self._last_s = float(made[1 : made.index(")")])
            return made
        if ended or unended:
            if made:
                self._builder.damages.remark(LOG_LAST_LINE_TORN())
            return ""
        return "" if _BESIDE.match(made) else line

    def _of_screen(self, line: str) -> str:
        """Return a line of the screen as -L has it, "" if it is none."""
        # A longer line is no frame, and could be made to match slowly.
        found = _SCREEN.match(line) if len(line) <= _LONGEST else None
        if found is None:
            return ""
        length = min(int(found["code"], 16), 8) if found["code"] else int(found["length"])
        rest = found["rest"] or ""
        if "remote request" in rest:
            payload = f"R{length}"
        else:
            parts = _BETWEEN.split(rest.strip(), maxsplit=length)[:length]
            if len(parts) < length or not all(map(_BYTE.fullmatch, parts)):
                return ""
            if length > 1 and rest.strip()[len(parts[0])] == "`":
                parts.reverse()
            payload = "".join(f"{int(each, 2):02X}" if len(each) == 8 else each for each in parts)
        flags = (found["switched"] in {"B", "b"}) + 2 * (found["state"] in {"E", "e"})
        mark = f"##{flags}" if len(found["length"] or "") == 2 else "#"
        sent = " T" if found["way"] in {"T", "t"} else ""
        time = found["time"] or self._made_up()
        return f"({time}) {found['channel']} {found['id']}{mark}{payload}{sent}"

    def _made_up(self) -> str:
        """Return a time for a frame without one: a fixed step after the frame before it."""
        self._builder.damages.remark(LOG_NO_TIMES())
        return f"{0.0 if self._last_s is None else self._last_s + _STEP_S:.6f}"


def _seconds(found: re.Match[str]) -> str:
    """Return the date of -t A, which is local, in seconds since 1970."""
    try:
        since_s = datetime.fromisoformat(found[1]).timestamp()
    except (ValueError, OverflowError, OSError):
        return found[0]
    return f"({since_s:.0f}{found[2]}) "
