"""One CAN frame, as everything inside the program passes it on."""

from __future__ import annotations

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
