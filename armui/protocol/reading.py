"""Payload to physical values: the inner loop of decoding.

Four of five frames of an arm are two or three scaled numbers and nothing else. For these a closure
over names and divisors takes half the time of the general loop.
"""

from __future__ import annotations

import struct
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable, Container, Mapping, Sequence

    from cantools.database.can import Signal as DbcSignal

    from armui.protocol.layout import SignalLayout

    Reader = Callable[[bytes], dict[str, float] | None]

_STRUCT_CODES = {
    (8, False): "B",
    (8, True): "b",
    (16, False): "H",
    (16, True): "h",
    (32, False): "I",
    (32, True): "i",
}


def make_reader(
    signals: Mapping[str, SignalLayout],
    unpack: Callable[[bytes], dict[str, float]],
    checked: Sequence[tuple[str, Container[int]]],
    whole_format: str | None,
) -> Reader:
    """A function from payloads of the right length to physical values by signal name.

    Args:
        signals: The message's signals.
        unpack: Payload to raw values by name.
        checked: (name, legal raw values) of the signals that can hold illegal ones.
        whole_format: As `whole_format` gives it.

    Returns:
        The function; it returns None when a raw value is illegal.
    """
    divided = [
        (signal.name, signal.divisor)
        for signal in signals.values()
        if signal.is_scaled and signal.divisor is not None and not signal.offset
    ]
    if whole_format and len(divided) == len(signals) and not checked:
        whole = struct.Struct(whole_format).unpack
        if len(divided) == 2:
            return _two(whole, divided)
        if len(divided) == 3:
            return _three(whole, divided)
    rest = [s for s in signals.values() if s.is_scaled and (s.divisor is None or s.offset)]
    return _any(unpack, checked, divided, rest)


def whole_format(signals: Sequence[DbcSignal], length: int) -> str | None:
    """The `struct` format of a payload of whole numbers side by side, None for any other.

    Args:
        signals: In payload order.
        length: Bytes of the payload.
    """
    codes = ">"
    position = 0
    for signal in signals:
        code = _STRUCT_CODES.get((signal.length, signal.is_signed))
        if code is None or signal.start != position * 8 + 7:
            return None
        codes += code
        position += signal.length // 8
    return f"{codes}{length - position}x"


def _two(whole: Callable[[bytes], tuple[int, ...]], divided: Sequence[tuple[str, int]]) -> Reader:
    (name_1, divisor_1), (name_2, divisor_2) = divided

    def read(payload: bytes) -> dict[str, float]:
        raw_1, raw_2 = whole(payload)
        return {name_1: raw_1 / divisor_1, name_2: raw_2 / divisor_2}

    return read


def _three(whole: Callable[[bytes], tuple[int, ...]], divided: Sequence[tuple[str, int]]) -> Reader:
    (name_1, divisor_1), (name_2, divisor_2), (name_3, divisor_3) = divided

    def read(payload: bytes) -> dict[str, float]:
        raw_1, raw_2, raw_3 = whole(payload)
        return {
            name_1: raw_1 / divisor_1,
            name_2: raw_2 / divisor_2,
            name_3: raw_3 / divisor_3,
        }

    return read


def _any(
    unpack: Callable[[bytes], dict[str, float]],
    checked: Sequence[tuple[str, Container[int]]],
    divided: Sequence[tuple[str, int]],
    rest: Sequence[SignalLayout],
) -> Reader:
    def read(payload: bytes) -> dict[str, float] | None:
        values = unpack(payload)
        for name, legal in checked:
            if values[name] not in legal:
                return None
        for name, divisor in divided:
            values[name] /= divisor
        for signal in rest:
            values[signal.name] = signal.to_physical(values[signal.name])
        return values

    return read
