"""One line of output for each frame of a log: for people, or as JSON."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

from armui.decode.entries import FrameKind
from armui.protocol.codec import InvalidFrame, Message

if TYPE_CHECKING:
    from armui.decode.entries import LogFrame
    from armui.protocol.codec import Codec


def text_line(entry: LogFrame, codec: Codec) -> str:
    """Time in seconds, identifier, message, signals with units; what is odd at the end."""
    message, oddity = _reading(entry, codec)
    parts = [f"{entry.time_s:14.6f}", f"{_identifier(entry):>10}"]
    if message is None:
        parts.append(f"unknown ({_oddity_text(oddity)})")
        parts.append(entry.frame.data.hex(" ").upper())
    else:
        parts.append(f"{message.name:<19}")
        parts.append(
            "  ".join(_signal_text(codec, message, name) for name in codec.signals(message.name))
        )
        if oddity:
            parts.append(f"({_oddity_text(oddity)})")
    return "  ".join(parts).rstrip()


def json_line(entry: LogFrame, codec: Codec) -> str:
    """One JSON object.

    Keys: "t" in seconds, "id", "message" (null when unknown), "signals" by name with "value",
    "unit" and, for codes, "word". A frame that does not follow the protocol has "oddity" with
    "kind" and "detail"; one that cannot be read has its payload in "data", in hexadecimal.
    """
    message, oddity = _reading(entry, codec)
    line: dict[str, object] = {
        "t": entry.time_s,
        "id": _identifier(entry),
        "message": message.name if message else None,
        "signals": _signals_json(codec, message) if message else {},
    }
    if oddity:
        line["oddity"] = {"kind": oddity[0], "detail": oddity[1]}
    if message is None:
        line["data"] = entry.frame.data.hex().upper()
    return json.dumps(line, ensure_ascii=True, allow_nan=False)


def _reading(entry: LogFrame, codec: Codec) -> tuple[Message | None, tuple[str, str] | None]:
    """What a frame says, and what is odd about it, by kind and detail."""
    if entry.kind is not FrameKind.DATA:
        return None, (entry.kind.value, "not of the arm's protocol")
    decoded = codec.decode(entry.frame)
    if isinstance(decoded, InvalidFrame):
        return decoded.message, (decoded.kind.value, decoded.detail)
    return decoded, None


def _oddity_text(oddity: tuple[str, str] | None) -> str:
    return ": ".join(oddity or ())


def _identifier(entry: LogFrame) -> str:
    width = 8 if entry.extended_id else 3
    return f"0x{entry.frame.arbitration_id:0{width}X}"


def _signal_text(codec: Codec, message: Message, name: str) -> str:
    value = message.signals[name]
    text = f"{name}={value:.10g}"
    if unit := codec.unit(message.name, name):
        text += f" {unit}"
    if word := codec.word(message.name, name, value):
        text += f" ({word})"
    return text


def _signals_json(codec: Codec, message: Message) -> dict[str, dict[str, object]]:
    signals = {}
    for name in codec.signals(message.name):
        value = message.signals[name]
        signal: dict[str, object] = {"value": value, "unit": codec.unit(message.name, name)}
        if word := codec.word(message.name, name, value):
            signal["word"] = word
        signals[name] = signal
    return signals
