"""Text logs written block by block: candump's lines, and Vector's by python-can's writer."""

from __future__ import annotations

import io
import re
from typing import TYPE_CHECKING, Final

import can
import numpy as np

from armui.protocol.frame import FrameFlag

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from armui.session.recording.rows import FrameRows

_ERROR_BIT: Final = 0x20000000
_NOT_A_NAME: Final = re.compile(r"[^\w.:-]+", re.ASCII)


class CandumpFormat:
    """Lines as ``candump -L -x`` writes them, error frames with their class and details.

    python-can's writer of this format leaves out what an error frame says.

    Args:
        start_s: Not needed: every line has the time of day.
        channel: Stands in every line.
    """

    suffix: Final = ".log"

    def __init__(self, start_s: float, channel: str) -> None:
        self.start_s = start_s
        self._channel = candump_channel(channel)

    def opening(self) -> bytes:
        """Nothing: a log begins with its first frame."""
        return b""

    def header(self, size: int) -> bytes:  # noqa: ARG002 - as others have it
        """Nothing."""
        return b""

    def closing(self) -> bytes:
        """Nothing."""
        return b""

    def rounded(self, times_s: NDArray[np.float64]) -> NDArray[np.float64]:
        """Times as they will be read back."""
        return np.round(times_s, 6)

    def block(self, rows: FrameRows, at_byte: int) -> bytes:  # noqa: ARG002 - as others have it
        """Frames as lines."""
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


class AscFormat:
    """Vector's text format, each line by python-can's writer.

    The format tells of an error frame only that there was one.

    Args:
        start_s: Time of the first frame, since 1970; the lines count from it.
        channel: Not needed: the format numbers its channels.
    """

    suffix: Final = ".asc"

    def __init__(self, start_s: float, channel: str) -> None:  # noqa: ARG002 - as others have it
        self.start_s = start_s
        self._text = io.StringIO()
        self._writer = can.ASCWriter(self._text)

    def opening(self) -> bytes:
        """The lines that tell what file it is."""
        return self._taken()

    def header(self, size: int) -> bytes:  # noqa: ARG002 - as others have it
        """Nothing is written anew."""
        return b""

    def closing(self) -> bytes:
        """The line that ends the file."""
        return b"End TriggerBlock\n"

    def rounded(self, times_s: NDArray[np.float64]) -> NDArray[np.float64]:
        """Times as they will be read back."""
        return self.start_s + np.round(times_s - self.start_s, 6)

    def block(self, rows: FrameRows, at_byte: int) -> bytes:  # noqa: ARG002 - as others have it
        """Frames as lines."""
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
    """A channel's name as a word of a candump line: without blanks, a number as ``can0``."""
    name = _NOT_A_NAME.sub("_", channel) or "can"
    return f"can{name}" if name.isdigit() else name
