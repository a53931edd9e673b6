"""What an arm says of itself when asked with 0x4AF (generation 2): eleven frames of text.

The places are those of the maker's own test arm; hardware, batch, date and node number are those of
one arm in the field.
"""

from __future__ import annotations

from typing import Final

from armui.arm.models import model_data
from armui.protocol.codec import Codec
from armui.protocol.frame import Frame
from armui.protocol.generation import PiperModel

_REQUEST: Final = 1
_FRAME_LENGTH: Final = 8
_LENGTH: Final = 11 * _FRAME_LENGTH

_HARDWARE: Final = (0, "H-V1.2-1")
_BATCH: Final = (16, "10")
_NODE_TYPE_AT: Final = 32
_SOFTWARE_AT: Final = 60
_SOFTWARE_LENGTH: Final = 8
"""The date follows at once: a longer version shifts it."""
_DATE: Final = "250925"
_NODE_NUMBER: Final = (76, "15")
_NODE_TYPE: Final = "ARM_MC"


def identity_text(version: str, model: PiperModel) -> bytes:
    """The 88 bytes of the answer, padded with zeros."""
    text = bytearray(_LENGTH)
    types = model_data(model).node_types
    software = version.ljust(_SOFTWARE_LENGTH, "\0") + _DATE
    for at, words in (
        _HARDWARE,
        _BATCH,
        (_NODE_TYPE_AT, types[0] if types else _NODE_TYPE),
        _NODE_NUMBER,
        (_SOFTWARE_AT, software),
    ):
        raw = words.encode("ascii", "replace")
        text[at : at + len(raw)] = raw
    return bytes(text[:_LENGTH])


def version_frames(
    codec: Codec, signals: dict[str, float], version: str, model: PiperModel = PiperModel.PIPER
) -> list[Frame]:
    """The answer cut into frames; a neighbour's answer is no question.

    Args:
        codec: The arm's.
        signals: Of the 0x4AF that was heard.
        version: As `S-V1.8-9`.
        model: The arm.
    """
    if signals["Byte0"] != _REQUEST:
        return []
    text = identity_text(version, model)
    chunks = [text[start : start + _FRAME_LENGTH] for start in range(0, len(text), _FRAME_LENGTH)]
    return [
        codec.encode("FirmwareVersion", **{f"Byte{i}": byte for i, byte in enumerate(chunk)})
        for chunk in chunks
    ]
