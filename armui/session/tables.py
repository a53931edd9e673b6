"""Reads logs that are tables: those of python-can, of SavvyCAN, and of ZLG's programs.

Sources: the writers of python-can and SavvyCAN (GVRET, with and without the column Dir); files of
ZLG's CANTest and ZCANPRO and of USB_CAN TOOL, in Chinese and in English, in UTF-8 or GBK.
"""

from __future__ import annotations

import base64
import re
from datetime import datetime
from typing import TYPE_CHECKING, Final

import can

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping

TITLES_BEGIN: Final = (
    r'timestamp,arbitration_id\b|"?(time stamp|序号|index|no\.?)"?\s*[,;\t]'
    r"(?=.*id)(?=.*(len|dlc|长度))(?=.*(data|数据|d1\b))"
)
"""The titles of the tables that are read."""
_ROLES: Final[Mapping[str, str]] = {
    title: role
    for role, titles in {
        "mark": ("time stamp", "timestamp", "时间标识", "时间戳", "time mark"),
        "time": ("系统时间", "system time", "time", "时间"),
        "id": ("id", "id号", "帧id", "can id", "frame id"),
        "extended": ("extended", "帧格式", "format", "frame format"),
        "kind": ("帧类型", "type", "frame type"),
        "bus_kind": ("can类型", "can type", "协议类型"),
        "direction": ("dir", "传输方向", "方向", "direction", "收发"),
        "channel": ("bus", "can通道", "通道", "通道号", "源通道", "channel"),
        "length": ("len", "长度", "数据长度", "length", "dlc"),
        "data": ("数据", "data", "d1"),
    }.items()
    for title in titles
}
_NEEDED: Final = {"id", "length", "data"}
_BEHIND: Final = re.compile(r"[(（].*")
_SEPARATOR: Final = re.compile(r"[,;\t]")
_CLOCK: Final = re.compile(
    r"(?:(\d{4})\D(\d\d?)\D(\d\d?)\D+)?(\d\d?):(\d\d?):(\d\d?)(?:[.:]([\d.]+))?$"
)
_YES: Final = re.compile(r"true|1$|扩展|ext", re.IGNORECASE)
_REMOTE: Final = re.compile(r"远程|remote|rtr", re.IGNORECASE)
_SENT: Final = re.compile(r"tx|发送|send|transmit", re.IGNORECASE)
_MARKS_PER_S: Final = 10_000


class TableReader:
    """Reads lines as the readers of python-can do: iterated, it gives messages.

    Args:
        lines: The lines; titles may come at any place and hold from there on.
    """

    def __init__(self, lines: Iterable[str]) -> None:
        self._lines = lines
        self._places: Mapping[str, int] = {}
        self._in_us = False
        self._by_mark: bool | None = None
        self._titles = re.compile(TITLES_BEGIN, re.IGNORECASE)

    def __iter__(self) -> Iterator[can.Message]:
        """Yield a message for each row.

        Raises:
            ValueError, IndexError, KeyError: The row cannot be read.
        """
        for line in self._lines:
            if self._titles.match(line):
                self._read_titles(line)
            elif self._places:
                yield self._message(line)
            else:
                yield _of_python_can(line)

    def _read_titles(self, line: str) -> None:
        titles = [_BEHIND.sub("", each).strip(' "').lower() for each in _SEPARATOR.split(line)]
        places: dict[str, int] = {}
        for place, title in enumerate(titles):
            if title in _ROLES:
                places.setdefault(_ROLES[title], place)
        self._places = places if places.keys() >= _NEEDED else {}
        self._in_us = "d1" in titles
        self._by_mark = None

    def _message(self, line: str) -> can.Message:
        places = self._places
        cells = [each.strip(" =\"'") for each in _SEPARATOR.split(line)]
        cell = {role: cells[place] for role, place in places.items() if place < len(cells)}
        arbitration_id = int(cell["id"], 16)
        length = _number(cell["length"])
        texts = " ".join(cells[places["data"] :]).rpartition("|")[2].split()
        channel = cell.get("channel", "")
        is_remote = _REMOTE.match(cell.get("kind", "")) is not None
        return can.Message(
            timestamp=self._seconds(cell),
            arbitration_id=arbitration_id,
            is_extended_id=arbitration_id > 0x7FF
            or _YES.match(cell.get("extended", "")) is not None,
            is_remote_frame=is_remote,
            is_fd="fd" in cell.get("bus_kind", "").lower(),
            is_rx=_SENT.match(cell.get("direction", "")) is None,
            dlc=length,
            data=None if is_remote else bytes(int(each, 16) for each in texts[:length]),
            channel=int(channel) if channel.isdigit() else channel or None,
        )

    def _seconds(self, cell: Mapping[str, str]) -> float:
        """Return the time of a row.

        SavvyCAN counts µs. In the other tables a mark in hexadecimal counts 0.1 ms, one with a
        point seconds; where the first is none or zero, the time of day counts in the whole log.

        Raises:
            ValueError, KeyError: There is none.
        """
        mark = cell.get("mark", "")
        if self._in_us:
            return int(mark) / 1e6
        if self._by_mark is None:
            self._by_mark = "time" not in cell or mark.strip("0x.") not in {"", "无", "-"}
        text = mark if self._by_mark else cell["time"]
        if (found := _CLOCK.match(text)) is not None:
            return _of_clock(found)
        return int(text, 16) / _MARKS_PER_S if text[:2].lower() == "0x" else float(text)


def _of_clock(found: re.Match[str]) -> float:
    """Return a time of day in seconds, with a date the local one since 1970."""
    year, month, day, *clock = (int(each or 0) for each in found.groups()[:-1])
    hours, minutes, seconds = clock
    time_s = 3600.0 * hours + 60.0 * minutes + seconds
    time_s += float("0." + (found.groups()[-1] or "0").replace(".", ""))
    if year:
        return datetime(year, month, day).timestamp() + time_s
    return time_s


def _number(text: str) -> int:
    return int(text, 16 if text[:2].lower() == "0x" else 10)


def _of_python_can(line: str) -> can.Message:
    """Return the message of a row of python-can's own table.

    Raises:
        ValueError: It is none.
    """
    timestamp, arbitration_id, extended, remote, error, dlc, data = line.split(",")
    return can.Message(
        timestamp=float(timestamp),
        arbitration_id=int(arbitration_id, 16),
        is_extended_id=extended == "1",
        is_remote_frame=remote == "1",
        is_error_frame=error == "1",
        dlc=int(dlc),
        data=base64.b64decode(data),
    )
