"""What the arm says of itself when asked with 0x4AF (generation 2)."""

from __future__ import annotations

import re
from typing import Final

from armui.kinematics.geometry import Geometry
from armui.protocol.codec import Codec
from armui.protocol.frame import Frame

_PREFIX: Final = "PiPER "
_REQUEST: Final = 1
_FRAME_LENGTH: Final = 8
_NEW_ZEROS_SINCE: Final = (1, 6, 3)
"""From this firmware on joints 2 and 3 have their zeros 2° elsewhere."""


def geometry_of(version: str) -> Geometry:
    """Where joints 2 and 3 have their zero; in a version that cannot be read, as of today."""
    numbers = re.fullmatch(r"S-V(\d+)\.(\d+)-(\d+)", version)
    if numbers is None or tuple(map(int, numbers.groups())) >= _NEW_ZEROS_SINCE:
        return Geometry.CURRENT
    return Geometry.BEFORE_V1_6_3


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
