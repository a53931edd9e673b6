"""What an arm says of itself when asked with 0x4AF (generation 2)."""

from __future__ import annotations

from typing import Final

from armui.protocol.codec import Codec
from armui.protocol.frame import Frame
from armui.protocol.piper_model import PiperModel
from armui.protocol.version import ANSWER_BYTES

_REQUEST: Final = 1
_FRAME_LENGTH: Final = 8
_HARDWARE: Final = (0, "H-V1.2-1")
_BATCH: Final = (16, "10")
_NODE_NUMBER: Final = (76, "15")
_NODE_TYPE_AT: Final = 32
_NODE_TYPES: Final = {PiperModel.PIPER_X: "Piper_X_MC"}
"""As reported of one arm; what H and L tell isn't known."""
_NODE_TYPE: Final = "ARM_MC"
_SOFTWARE_AT: Final = 60
_DATE: Final = (68, "260316")


def version_frames(
    codec: Codec, signals: dict[str, float], version: str, model: PiperModel = PiperModel.PIPER
) -> list[Frame]:
    """Eleven frames of text, filled with zeros; a neighbour's answer is no question.

    Args:
        codec: The arm's.
        signals: Of the 0x4AF that was heard.
        version: As `S-V1.8-5`.
        model: The arm.
    """
    if signals["Byte0"] != _REQUEST or any(signals[f"Byte{place}"] for place in range(1, 8)):
        return []
    text = bytearray(ANSWER_BYTES)
    node_type = (_NODE_TYPE_AT, _NODE_TYPES.get(model, _NODE_TYPE))
    for start, part in (_HARDWARE, _BATCH, node_type, _DATE, _NODE_NUMBER, (_SOFTWARE_AT, version)):
        data = part.encode("ascii", "replace")
        text[start : start + len(data)] = data
    chunks = [text[start : start + _FRAME_LENGTH] for start in range(0, len(text), _FRAME_LENGTH)]
    return [
        codec.encode("FirmwareVersion", **{f"Byte{i}": byte for i, byte in enumerate(chunk)})
        for chunk in chunks
    ]
