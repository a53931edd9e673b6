"""Log formats written block by block: candump's lines, and Vector's by python-can's writer."""

from __future__ import annotations

import io
import math
import re
import zlib
from typing import TYPE_CHECKING, Any, Final

import can
import numpy as np
from can.io import blf
from can.util import len2dlc

from armui.protocol.frame import FrameFlag
from armui.session.recording.kinds import BlockFormat, RecordingFormat

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from armui.session.recording.rows import FrameRows

# BLF files that are whole after every block, written with python-can's layouts.
#
# python-can's own writer holds back up to 128 KB of frames, and tells in the file's header when it
# began only at the very end: of a program that was killed the last seconds and the time of day
# would be lost. Here a block of frames is a container of its own, and the header is right after
# each block. A container's head never lies across a page of the file system: where a killed
# program leaves half a write behind, python-can's reader meets a container that is too short, and
# reads what is in it.

_APPLICATION: Final = 5
"""The application number that python-can writes."""
_PAGE: Final = 4_096
_HEAD: Final = blf.OBJ_HEADER_BASE_STRUCT.size + blf.LOG_CONTAINER_STRUCT.size
_ALIGNED: Final = 4
_FAST: Final = 1
"""zlib's level: a third of the usual work, for a file a tenth larger."""
_OBJECT_HEAD: Final = blf.OBJ_HEADER_BASE_STRUCT.size + blf.OBJ_HEADER_V1_STRUCT.size
_CLASSIC_SIZE: Final = _OBJECT_HEAD + blf.CAN_MSG_STRUCT.size
MESSAGE: Final = np.dtype(
    [
        ("signature", "S4"),
        ("header_size", "<u2"),
        ("header_version", "<u2"),
        ("size", "<u4"),
        ("kind", "<u4"),
        ("time_flags", "<u4"),
        ("client", "<u2"),
        ("version", "<u2"),
        ("time", "<u8"),
        ("channel", "<u2"),
        ("flags", "u1"),
        ("length", "u1"),
        ("id", "<u4"),
        ("data", "u1", (8,)),
    ]
)
"""An object CAN_MESSAGE with its heads, as in python-can's structs."""

_PECULIAR: Final = FrameFlag.ERROR | FrameFlag.FD
"""The flags of frames that are no object CAN_MESSAGE."""


_CHANNEL: Final = 1
"""The channel's number; Vector's tools count from 1."""

_NOT_A_NAME: Final = re.compile(r"[^\w.:-]+", re.ASCII)


class BlfFormat(BlockFormat):
    """The blocks of one BLF file.

    Args:
        start_s: Time of its first frame, since 1970.
    """

    suffix: Final = ".blf"

    def __init__(self, start_s: float) -> None:
        self.start_s = float(math.floor(start_s))  # the header has milliseconds; this has none
        self._stop_s = start_s
        self._objects = 0
        self._unpacked = blf.FILE_HEADER_SIZE

    def opening(self) -> bytes:
        """Return the beginning of the file."""
        return self.header(blf.FILE_HEADER_SIZE)

    def header(self, size: int) -> bytes:
        """Return the file's header for a size in bytes."""
        fields: list[Any] = [b"LOGG", blf.FILE_HEADER_SIZE, _APPLICATION, 0, 0, 0, 2, 6, 8, 1]
        fields += [size, self._unpacked, self._objects, 0]
        fields += blf.timestamp_to_systemtime(self.start_s)
        fields += blf.timestamp_to_systemtime(self._stop_s)
        return blf.FILE_HEADER_STRUCT.pack(*fields).ljust(blf.FILE_HEADER_SIZE, b"\0")

    def rounded(self, times_s: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return times as they will be read back."""
        return self._ticks(times_s).astype(np.float64) * 1e-9 + self.start_s

    def _ticks(self, times_s: NDArray[np.float64]) -> NDArray[np.uint64]:
        ticks = np.rint((times_s - self.start_s) * 1e9)
        return np.maximum(ticks, 0.0).astype(np.uint64)

    def block(self, rows: FrameRows, at_byte: int) -> bytes:
        """Return frames as a self-contained container.

        Args:
            rows: The frames, with times since 1970.
            at_byte: The place in the file.
        """
        objects = self._all_objects(rows)
        packed = zlib.compress(objects, _FAST)
        size = _HEAD + len(packed)
        filling = size % 4  # as python-can's reader and writer have it
        beyond = (at_byte + size + filling) % _PAGE
        if beyond > _PAGE - _HEAD:
            # Padding: readers ignore bytes behind the end of the packed data.
            packed += bytes(_PAGE - beyond + _ALIGNED)
            size = _HEAD + len(packed)
            filling = size % 4
        self._objects += len(rows)
        self._unpacked += _HEAD + len(objects)
        if len(rows):
            self._stop_s = float(rows.times_s[-1])
        base = blf.OBJ_HEADER_BASE_STRUCT.pack(
            b"LOBJ", blf.OBJ_HEADER_BASE_STRUCT.size, 1, size, blf.LOG_CONTAINER
        )
        head = blf.LOG_CONTAINER_STRUCT.pack(blf.ZLIB_DEFLATE, len(objects))
        return base + head + packed + bytes(filling)

    def _all_objects(self, rows: FrameRows) -> bytes:
        peculiar = np.flatnonzero(rows.table["flags"] & _PECULIAR)
        if not len(peculiar):
            return self._messages(rows)
        pieces: list[bytes] = []
        begin = 0
        for row in peculiar.tolist():
            pieces.append(self._messages(rows.part(begin, row)))
            pieces.append(self._peculiar(rows, row))
            begin = row + 1
        pieces.append(self._messages(rows.part(begin, len(rows))))
        return b"".join(pieces)

    def _messages(self, rows: FrameRows) -> bytes:
        table = rows.table
        objects = np.zeros(len(rows), MESSAGE)
        objects["signature"] = b"LOBJ"
        objects["header_size"] = _OBJECT_HEAD
        objects["header_version"] = 1
        objects["size"] = _CLASSIC_SIZE
        objects["kind"] = blf.CAN_MESSAGE
        objects["time_flags"] = blf.TIME_ONE_NANS
        objects["time"] = self._ticks(rows.times_s)
        objects["channel"] = _CHANNEL
        flags = table["flags"]
        sent = np.where(flags & FrameFlag.TRANSMITTED, blf.DIR, 0)
        remote = np.where(flags & FrameFlag.REMOTE, blf.REMOTE_FLAG, 0)
        objects["flags"] = sent | remote
        objects["length"] = table["length"]
        extended = np.where(flags & FrameFlag.EXTENDED, np.uint32(blf.CAN_MSG_EXT), np.uint32(0))
        objects["id"] = table["id"] | extended
        objects["data"] = table["data"]
        return objects.tobytes()

    def _peculiar(self, rows: FrameRows, row: int) -> bytes:
        """Return an error frame, or one of CAN FD."""
        flags = int(rows.table["flags"][row])
        arbitration_id = int(rows.table["id"][row])
        if flags & FrameFlag.EXTENDED:
            arbitration_id |= blf.CAN_MSG_EXT
        data = rows.data(row)
        if flags & FrameFlag.ERROR:
            kind = blf.CAN_ERROR_EXT
            body = blf.CAN_ERROR_EXT_STRUCT.pack(
                _CHANNEL, 0, 0, 0, 0, len(data), 0, arbitration_id, 0, data
            )
        else:
            kind = blf.CAN_FD_MESSAGE
            sent = blf.DIR if flags & FrameFlag.TRANSMITTED else 0
            marks = blf.EDL
            marks |= blf.BRS if flags & FrameFlag.BITRATE_SWITCH else 0
            marks |= blf.ESI if flags & FrameFlag.ERROR_STATE else 0
            body = blf.CAN_FD_MSG_STRUCT.pack(
                _CHANNEL,
                sent,
                len2dlc(len(data)),
                arbitration_id,
                0,
                0,
                marks,
                len(data),
                data,
            )
        base = blf.OBJ_HEADER_BASE_STRUCT.pack(
            b"LOBJ", _OBJECT_HEAD, 1, _OBJECT_HEAD + len(body), kind
        )
        ticks = int(self._ticks(rows.times_s[row : row + 1])[0])
        head = blf.OBJ_HEADER_V1_STRUCT.pack(blf.TIME_ONE_NANS, 0, 0, ticks)
        return base + head + body + bytes(len(body) % 4)


_ERROR_BIT: Final = 0x20000000


class CandumpFormat(BlockFormat):
    """Lines as ``candump -L -x`` writes them; error frames have their class and details.

    python-can's writer of this format omits the content of error frames.

    Args:
        start_s: Unused: every line has the time of day.
        channel: The channel's name in every line.
    """

    suffix: Final = ".log"

    def __init__(self, start_s: float, channel: str) -> None:
        self.start_s = start_s
        self._channel = candump_channel(channel)

    def rounded(self, times_s: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return times as they will be read back."""
        return np.round(times_s, 6)

    def block(self, rows: FrameRows, at_byte: int) -> bytes:  # noqa: ARG002 - as others have it
        """Return frames as lines."""
        return "".join([self._line(rows, row) for row in range(len(rows))]).encode("ascii")

    def _line(self, rows: FrameRows, row: int) -> str:
        time_s, arbitration_id, flags, length, _data = rows.table[row].item()
        sign = "#"
        data = rows.data(row).hex().upper()
        if flags & FrameFlag.ERROR:
            place = f"{_ERROR_BIT | arbitration_id:08X}"
        else:
            place = (
                f"{arbitration_id:08X}" if flags & FrameFlag.EXTENDED else f"{arbitration_id:03X}"
            )
        if flags & FrameFlag.REMOTE:
            data = f"R{length}" if length else "R"
        elif flags & FrameFlag.FD:
            marks = int(bool(flags & FrameFlag.BITRATE_SWITCH))
            marks |= 2 * bool(flags & FrameFlag.ERROR_STATE)
            sign = f"##{marks:X}"
        way = "T" if flags & FrameFlag.TRANSMITTED else "R"
        return f"({time_s:.6f}) {self._channel} {place}{sign}{data} {way}\n"


class AscFormat(BlockFormat):
    """Vector's text format, each line by python-can's writer.

    The format records only the presence of an error frame.

    Args:
        start_s: Time of the first frame, since 1970; the lines count from it.
        channel: Unused: the format numbers its channels.
    """

    suffix: Final = ".asc"

    def __init__(self, start_s: float, channel: str) -> None:  # noqa: ARG002 - as others have it
        self.start_s = start_s
        self._text = io.StringIO()
        self._writer = can.ASCWriter(self._text)

    def opening(self) -> bytes:
        """Return the first lines of the file."""
        return self._taken()

    def closing(self) -> bytes:
        """Return the line that ends the file."""
        return b"End TriggerBlock\n"

    def rounded(self, times_s: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return times as they will be read back."""
        return self.start_s + np.round(times_s - self.start_s, 6)

    def block(self, rows: FrameRows, at_byte: int) -> bytes:  # noqa: ARG002 - as others have it
        """Return frames as lines."""
        for row in range(len(rows)):
            self._writer.on_message_received(_message(rows, row))
        return self._taken()

    def _taken(self) -> bytes:
        text = self._text.getvalue()
        self._text.seek(0)
        self._text.truncate()
        return text.encode("utf-8")


def _message(rows: FrameRows, row: int) -> can.Message:
    time_s, arbitration_id, flags, length, _data = rows.table[row].item()
    remote = bool(flags & FrameFlag.REMOTE)
    return can.Message(
        timestamp=time_s,
        arbitration_id=arbitration_id,
        is_extended_id=bool(flags & FrameFlag.EXTENDED),
        is_remote_frame=remote,
        is_error_frame=bool(flags & FrameFlag.ERROR),
        is_fd=bool(flags & FrameFlag.FD),
        bitrate_switch=bool(flags & FrameFlag.BITRATE_SWITCH),
        error_state_indicator=bool(flags & FrameFlag.ERROR_STATE),
        is_rx=not flags & FrameFlag.TRANSMITTED,
        dlc=length,
        data=None if remote else rows.data(row),
    )


def candump_channel(channel: str) -> str:
    """Return a channel's name as one word of a candump line; a number becomes ``can0``."""
    name = _NOT_A_NAME.sub("_", channel) or "can"
    return f"can{name}" if name.isdigit() else name


def block_format(kind: RecordingFormat, start_s: float, channel: str) -> BlockFormat:
    """Return the format of a new file.

    Args:
        kind: The format.
        start_s: Time of its first frame, since 1970.
        channel: The bus's name, if the format has room for it.
    """
    if kind is RecordingFormat.BLF:
        return BlfFormat(start_s)
    if kind is RecordingFormat.ASC:
        return AscFormat(start_s, channel)
    return CandumpFormat(start_s, channel)
