"""What a log yields: frames, and places that could not be read."""

from __future__ import annotations

import enum
import math
from typing import TYPE_CHECKING, NamedTuple

from armui.protocol.frame import Frame

if TYPE_CHECKING:
    import can


class FrameKind(enum.Enum):
    """What sort of frame was recorded; the arm speaks DATA only."""

    DATA = "data frame"
    EXTENDED_ID = "frame with a 29-bit identifier"
    CAN_FD = "CAN FD frame"
    REMOTE = "remote frame"
    ERROR = "error frame"


class LogFrame(NamedTuple):
    """One frame of a log.

    Attributes:
        time_s: As recorded: since the start of the log or since 1970, as its format has it.
        frame: Identifier and payload; for other kinds than DATA not a frame of the arm's protocol.
        kind: What sort of frame it is.
        extended_id: The identifier has 29 bits.
    """

    time_s: float
    frame: Frame
    kind: FrameKind
    extended_id: bool = False


class Unreadable(NamedTuple):
    """A place in a log that could not be read.

    Attributes:
        place: Where: "line 12", "byte 4711".
        reason: Why, or what stands there.
    """

    place: str
    reason: str


class NotALogError(Exception):
    """The file cannot be opened, or nothing in it is a frame; the text says which, in one line."""


def log_frame(message: can.Message) -> LogFrame | None:
    """A python-can message as a log's frame, None when its parts contradict one another.

    python-can's readers take damaged numbers at face value: a data length that is not that of the
    data, an identifier of more bits than the frame has, a time that is no number.
    """
    kind = _kind(message)
    data = bytes(message.data)
    top_id = 0x1FFFFFFF if message.is_extended_id else 0x7FF
    longest = 64 if message.is_fd else 8
    sound = math.isfinite(message.timestamp) and (
        kind is FrameKind.ERROR
        or (
            0 <= message.arbitration_id <= top_id
            and 0 <= message.dlc <= longest
            and len(data) == (0 if kind is FrameKind.REMOTE else message.dlc)
        )
    )
    if not sound:
        return None
    frame = Frame(message.arbitration_id, data)
    return LogFrame(message.timestamp, frame, kind, message.is_extended_id)


def _kind(message: can.Message) -> FrameKind:
    if message.is_error_frame:
        return FrameKind.ERROR
    if message.is_remote_frame:
        return FrameKind.REMOTE
    if message.is_fd:
        return FrameKind.CAN_FD
    if message.is_extended_id:
        return FrameKind.EXTENDED_ID
    return FrameKind.DATA
