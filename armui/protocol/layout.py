"""What the codec knows of each message before the first frame arrives."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable, Container, Mapping

    from cantools.database.can import Message as DbcMessage
    from cantools.database.can import Signal as DbcSignal

LEAVE_UNCHANGED = "Leave unchanged"
"""What the value tables call the raw value that leaves a setting as it is (generation 2)."""

_SHORT_FORMS = {"ArcPoint": (1, 8), "BusSilence": (1, 8), "LinkageSetting": (4, 8)}
"""Messages that generation 1 sends shorter than generation 2; either accepts both lengths."""


@dataclass(frozen=True, slots=True)
class SignalLayout:
    """One signal: scale, range and value table.

    Attributes:
        name: As in the DBC file.
        unit: As in the DBC file, "" for a bare number or code.
        scale: Physical value of one raw step.
        offset: Physical value of the raw value 0.
        divisor: 1 / scale where that is a whole number, else None. Raw / 1000 is the double nearest
            to the decimal value, raw * 0.001 often is not.
        minimum: Smallest physical value.
        maximum: Largest physical value.
        words: Value table, by raw value.
        exhaustive: The table lists every legal value. A table of one entry only names a special
            value that is legal beside the range.
        legal_raw: Every raw value that means something.
        unchanged_raw: The raw value that leaves a setting as it is, or None.
        first_bit: The signal's highest bit, counted from the payload's first and highest one.
        bits: Its length.
        is_signed: Two's complement.
    """

    name: str
    unit: str
    scale: float
    offset: float
    divisor: int | None
    minimum: float
    maximum: float
    words: Mapping[int, str]
    exhaustive: bool
    legal_raw: Container[int]
    unchanged_raw: int | None
    first_bit: int
    bits: int
    is_signed: bool

    @property
    def is_count(self) -> bool:
        """Whether only whole numbers mean something: codes, counters, levels."""
        return not self.unit and not self.is_scaled

    @property
    def is_scaled(self) -> bool:
        """Whether physical and raw value differ."""
        return self.divisor != 1 or self.offset != 0

    def to_physical(self, raw: float) -> float:
        """Physical value of a raw one."""
        if self.divisor is not None and not self.offset:
            return raw / self.divisor if self.divisor != 1 else raw
        return raw * self.scale + self.offset

    def to_steps(self, value: float) -> float:
        """Raw value of a physical one, not rounded."""
        if self.divisor is not None:
            return (value - self.offset) * self.divisor
        return (value - self.offset) / self.scale


@dataclass(frozen=True, slots=True)
class MessageLayout:
    """One message: payload format and signals, ready for the codec's inner loop.

    Attributes:
        name: As in the DBC file.
        arbitration_id: As in the DBC file, without offset.
        length: Bytes of the payload as this generation sends it.
        lengths: Lengths accepted when decoding.
        reserved_mask: The payload's bits, as one big-endian number, that belong to no signal.
        unpack: cantools' decoder; called with payload, False, False it gives raw values by name.
        pack: Raw values of all signals to a payload; unused bits are 0.
        signals: By name, in the order of bytes and, within a byte, of bits.
        checked: (name, legal raw values) of the signals whose payload bits can hold illegal values.
        divided: (name, divisor) of the scaled signals whose scale is one over a whole number.
        stretched: The other scaled signals.
    """

    name: str
    arbitration_id: int
    length: int
    lengths: tuple[int, ...]
    reserved_mask: int
    signals: Mapping[str, SignalLayout]
    unpack: Callable[[bytes, bool, bool], dict[str, Any]]
    pack: Callable[[dict[str, int]], bytes]
    checked: tuple[tuple[str, Container[int]], ...]
    divided: tuple[tuple[str, int], ...]
    stretched: tuple[SignalLayout, ...]

    def scale(self, raw: dict[str, float]) -> dict[str, float]:
        """Turn raw values into physical ones, in place.

        Raw / 1000 is the double nearest to the decimal value; cantools' own raw * 0.001 often is
        not, and the last digit would dance.
        """
        for name, divisor in self.divided:
            raw[name] /= divisor
        for signal in self.stretched:
            raw[signal.name] = signal.to_physical(raw[signal.name])
        return raw


def message_layout(message: DbcMessage) -> MessageLayout:
    """Prepares one message of the database."""
    in_order = sorted(message.signals, key=_byte_and_bit)
    signals = {signal.name: _signal_layout(signal) for signal in in_order}
    checked = tuple(
        (signal.name, signals[signal.name].legal_raw)
        for signal in in_order
        if _can_be_illegal(signal, signals[signal.name])
    )
    scaled = [signal for signal in signals.values() if signal.is_scaled]
    return MessageLayout(
        name=message.name,
        arbitration_id=message.frame_id,
        length=message.length,
        lengths=_SHORT_FORMS.get(message.name, (message.length,)),
        reserved_mask=_reserved_mask(message),
        signals=signals,
        unpack=message.decode_simple,
        pack=partial(message.encode, scaling=False, strict=False),
        checked=checked,
        divided=tuple((s.name, s.divisor) for s in scaled if s.divisor and not s.offset),
        stretched=tuple(s for s in scaled if not s.divisor or s.offset),
    )


def _reserved_mask(message: DbcMessage) -> int:
    ones = {s.name: -1 if s.is_signed else 2**s.length - 1 for s in message.signals}
    used = message.encode(ones, scaling=False, strict=False)
    return int.from_bytes(used, "big") ^ (1 << 8 * message.length) - 1


def _byte_and_bit(signal: DbcSignal) -> tuple[int, int]:
    """Sorts flags within a byte from bit 0 up, wider signals by their first byte."""
    byte, bit = divmod(signal.start, 8)
    return byte, bit if signal.length == 1 else -bit


def _signal_layout(signal: DbcSignal) -> SignalLayout:
    words = {int(raw): str(word) for raw, word in (signal.choices or {}).items()}
    exhaustive = len(words) > 1
    scale, offset = float(signal.scale), float(signal.offset)
    inverse = 1 / scale
    whole = abs(inverse - round(inverse)) < 1e-9
    if signal.byte_order != "big_endian":
        raise ValueError(f"{signal.name} is little-endian in the DBC file; the protocol is not")
    if signal.minimum is None or signal.maximum is None:
        raise ValueError(f"{signal.name} has no range in the DBC file; give it one")
    minimum, maximum = float(signal.minimum), float(signal.maximum)
    legal: Container[int]
    if exhaustive:
        legal = frozenset(words)
    else:
        span = range(round((minimum - offset) / scale), round((maximum - offset) / scale) + 1)
        legal = frozenset((*span, *words)) if len(span) <= 256 else _Span(span, frozenset(words))
    return SignalLayout(
        name=signal.name,
        unit=signal.unit or "",
        scale=scale,
        offset=offset,
        divisor=round(inverse) if whole else None,
        minimum=minimum,
        maximum=maximum,
        words=words,
        exhaustive=exhaustive,
        legal_raw=legal,
        unchanged_raw=next((raw for raw, word in words.items() if word == LEAVE_UNCHANGED), None),
        first_bit=signal.start // 8 * 8 + 7 - signal.start % 8,
        bits=signal.length,
        is_signed=signal.is_signed,
    )


@dataclass(frozen=True, slots=True)
class _Span:
    """A wide range of raw values with a few more beside it."""

    span: range
    extra: frozenset[int]

    def __contains__(self, raw: object) -> bool:
        return isinstance(raw, int) and (raw in self.span or raw in self.extra)


def _can_be_illegal(signal: DbcSignal, layout: SignalLayout) -> bool:
    """Whether the signal's bits can hold a raw value that means nothing."""
    values: int = 2**signal.length
    if isinstance(layout.legal_raw, frozenset):
        return len(layout.legal_raw) < values
    low = -values // 2 if signal.is_signed else 0
    ends = (low, low + values - 1)
    return any(end not in layout.legal_raw for end in ends)
