"""One CAN frame, as everything inside the program passes it on."""

from __future__ import annotations

import enum
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
    """What sort of frame was recorded; the arm sends none of these but TRANSMITTED ones.

    EXTENDED: the identifier has 29 bits. REMOTE: a request without data. ERROR: an error frame.
    FD, BITRATE_SWITCH, ERROR_STATE: CAN FD and its bits. TRANSMITTED: sent by this
    computer, not received. IMPOSSIBLE: its parts contradict one another, so that no bus can have
    carried it; it is given as it was recorded.
    """

    EXTENDED = 1
    REMOTE = 2
    ERROR = 4
    FD = 8
    BITRATE_SWITCH = 16
    ERROR_STATE = 32
    TRANSMITTED = 64
    IMPOSSIBLE = 128
