"""The firmware version an arm reports when asked with 0x4AF (generation 2)."""

from __future__ import annotations

from typing import Final

from armui.protocol.codec import Codec
from armui.protocol.frame import Frame

_PREFIX: Final = "PiPER "
_REQUEST: Final = 1
_FRAME_LENGTH: Final = 8


def version_frames(codec: Codec, signals: dict[str, float], version: str) -> list[Frame]:
    """The version as text cut into frames, filled with zeros; a neighbour's answer is no question.

    Args:
        codec: The arm's.
        signals: Of the 0x4AF that was heard.
        version: As `S-V1.8-5`.
    """
    if signals["Byte0"] != _REQUEST:
        return []
    text = (_PREFIX + version).encode("ascii", "replace")
    chunks = [text[start : start + _FRAME_LENGTH] for start in range(0, len(text), _FRAME_LENGTH)]
    return [
        codec.encode("FirmwareVersion", **{f"Byte{i}": byte for i, byte in enumerate(chunk)})
        for chunk in chunks
    ]
