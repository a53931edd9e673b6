"""Frames as records of one size, for a line between two processes of this program."""

from __future__ import annotations

import struct
from collections.abc import Iterable
from typing import Final

from armui.protocol.frame import Frame

_RECORD: Final = struct.Struct("<HB8s")
"""Identifier, length, payload padded with zeros."""

RECORD_BYTES: Final = _RECORD.size
ERROR_MARK: Final = 0x8000
"""Stands in the identifier of an error frame, which a data frame's 11 bits leave free."""
NOT_ACKNOWLEDGED: Final = Frame(ERROR_MARK | 0x020, bytes(8))
"""The error frame of an adapter whose frame nobody acknowledged (linux/can/error.h)."""


def pack(frames: Iterable[Frame]) -> bytes:
    """Return the records of frames, one behind the other."""
    return b"".join(
        _RECORD.pack(frame.arbitration_id, len(frame.data), frame.data) for frame in frames
    )


def unpack(records: bytes) -> list[Frame]:
    """Return the frames of whole records."""
    return [
        Frame(arbitration_id, data[:length])
        for arbitration_id, length, data in _RECORD.iter_unpack(records)
    ]
