"""One CAN frame, as everything inside the program passes it on; the error when none can be made."""

from __future__ import annotations

import enum
from dataclasses import KW_ONLY, dataclass
from typing import NamedTuple


class Frame(NamedTuple):
    """A classic CAN data frame with an 11-bit identifier.

    Attributes:
        arbitration_id: The identifier on the wire, 0x000–0x7FF, offsets of 0x470 included.
        data: The payload, 0–8 bytes.
    """

    arbitration_id: int
    data: bytes

    def __str__(self) -> str:
        return f"0x{self.arbitration_id:03X} [{len(self.data)}] {self.data.hex(' ').upper()}"


class FrameFlag(enum.IntFlag):
    """The kind of a recorded frame; the arm sends ordinary frames only.

    EXTENDED: the identifier has 29 bits. REMOTE: a request without data. ERROR: an error frame. FD,
    BITRATE_SWITCH, ERROR_STATE: CAN FD and its bits. TRANSMITTED: sent by this computer, not
    received. IMPOSSIBLE: its parts contradict one another, so that no bus can have carried it; it
    is kept as it was recorded.
    """

    EXTENDED = 1
    REMOTE = 2
    ERROR = 4
    FD = 8
    BITRATE_SWITCH = 16
    ERROR_STATE = 32
    TRANSMITTED = 64
    IMPOSSIBLE = 128


@dataclass(eq=False, repr=False)
class EncodeError(ValueError):
    """A command that cannot be encoded: unknown name, value out of range, code outside the table.

    Nothing has been sent when it is raised.

    Attributes:
        text: Names message, signal, value, legal values and remedy.
        message: Name of the message asked for.
        signal: Name of the signal at fault, "" when the message itself is unknown.
        value: The value given, None when none was.
        minimum: Smallest value allowed, None where there is no range.
        maximum: Largest value allowed, None where there is no range.
        unit: Unit of value, minimum and maximum.
    """

    text: str
    _: KW_ONLY
    message: str
    signal: str = ""
    value: object = None
    minimum: float | None = None
    maximum: float | None = None
    unit: str = ""
