"""Reads the DBC files that define the messages, and prepares them for the codec.

Every message is prepared before its first frame arrives.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cache
from typing import TYPE_CHECKING, Any, Final, NamedTuple

import cantools
from cantools.database.utils import create_encode_decode_formats, start_bit

from armui.protocol.firmware_version import MitLayout
from armui.protocol.generation import Generation
from armui.system.paths import RESOURCES

if TYPE_CHECKING:
    from collections.abc import Callable, Container, Iterable, Sequence
    from pathlib import Path

    from cantools.database.can import Database
    from cantools.database.can import Message as DbcMessage
    from cantools.database.can import Signal as DbcSignal

_DATABASES: Final = {
    (Generation.ONE, MitLayout.A): "agx_gen1.dbc",
    (Generation.ONE, MitLayout.B): "agx_gen1.dbc",
    (Generation.TWO, MitLayout.A): "agx_gen2_until_1.8-7.dbc",
    (Generation.TWO, MitLayout.B): "agx_gen2.dbc",
}
"""The DBC file of each generation and MIT layout. No bit on the wire tells the two layouts of a MIT
frame apart, so each has a file that any CAN tool opens; a test ensures that they differ in nothing
else.
"""

LEAVE_UNCHANGED = "Leave unchanged"
"""The value tables' name for the raw value that leaves a setting as it is (generation 2)."""

_SHORT_FORMS = {
    "ArcPoint": (1, 8),
    "BusSilence": (1, 8),
    "FirmwareVersion": (1, 8),
    "LinkageSetting": (4, 8),
}
"""Messages whose shorter and longer forms are both accepted: generation 1 sends them shorter than
generation 2, and hosts ask for the version with one byte or with eight.
"""


def database_path(generation: Generation, mit_layout: MitLayout = MitLayout.B) -> Path:
    """Return the DBC file of a generation; for generation 2 that with this layout of MIT frames."""
    return RESOURCES / "protocol" / _DATABASES[generation, mit_layout]


@cache
def load_database(generation: Generation, mit_layout: MitLayout = MitLayout.B) -> Database:
    """Return the protocol of one generation as a cantools database.

    Args:
        generation: The protocol wanted.
        mit_layout: How MIT frames carry their torque, generation 2.

    Returns:
        The database with messages, signals, units, ranges, value tables and cycle times. It is
        parsed once and shared: treat it as read-only.

    Raises:
        FileNotFoundError: The installation lacks the file.
        cantools.database.UnsupportedDatabaseFormatError: The file is damaged.
    """
    path = database_path(generation, mit_layout)
    database = cantools.database.load_file(path, database_format="dbc", strict=True)
    if not isinstance(database, cantools.database.can.Database):
        raise TypeError(f"{path} does not describe a CAN bus")
    return database


class Selection(NamedTuple):
    """The condition under which a signal is present: the value of another signal of the message.

    Attributes:
        selector: The other signal's name.
        first_bit: Its highest bit, counted from the payload's first and highest one.
        bits: Its length.
        raw: The value it must have.
    """

    selector: str
    first_bit: int
    bits: int
    raw: int


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
        legal_raw: Every legal raw value.
        unchanged_raw: The raw value that leaves a setting as it is, or None.
        first_bit: The signal's highest bit, counted from the payload's first and highest one.
        bits: Its length.
        is_signed: Two's complement.
        is_measured: A figure with a unit or a scale, and no codes among its values.
        selection: The condition under which the signal is present, if its bits may hold another
            one; ``None`` if it is always present.
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
    is_measured: bool
    selection: Selection | None = None

    @property
    def is_count(self) -> bool:
        """True if only whole numbers mean something: codes, counters, levels."""
        return not self.unit and not self.is_scaled

    @property
    def is_scaled(self) -> bool:
        """True if physical and raw value differ."""
        return self.divisor != 1 or self.offset != 0

    def to_physical(self, raw: float) -> float:
        """Return the physical value of a raw one."""
        if self.divisor is not None and not self.offset:
            return raw / self.divisor if self.divisor != 1 else raw
        return raw * self.scale + self.offset

    def to_steps(self, value: float) -> float:
        """Return the raw value of a physical one, not rounded."""
        if self.divisor is not None:
            return (value - self.offset) * self.divisor
        return (value - self.offset) / self.scale

    def raw_in(self, data: bytes) -> int:
        """Return the raw value in a payload, without regard to its sign."""
        word = int.from_bytes(data, "big")
        return word >> 8 * len(data) - self.first_bit - self.bits & (1 << self.bits) - 1


@dataclass(frozen=True, slots=True)
class MessageLayout:
    """One message: payload format and signals, ready for the codec's inner loop.

    Attributes:
        name: As in the DBC file.
        arbitration_id: As in the DBC file, without offset.
        length: Bytes of the payload as this generation sends it.
        lengths: Lengths accepted when decoding.
        reserved_mask: The payload's bits, as one big-endian number, that belong to no signal.
        unpack: A payload of this length to raw values by name, in the order of the bits.
        pack: Raw values of all signals to a payload; unused bits are 0.
        signals: By name, in the order of bytes and, within a byte, of bits.
        checked: (name, legal raw values) of the signals whose payload bits can hold illegal values.
        divided: (name, divisor) of the scaled signals whose scale is one over a whole number.
        stretched: The other scaled signals.
        selector: The signal that selects which others are present; ``None`` in most messages.
        variants: With a selector, the message reduced to the signals present, by the selector's raw
            value. Of such a message ``unpack`` and ``pack`` are its variants'.
        rest: With a selector, the message reduced to the signals that are always present.
    """

    name: str
    arbitration_id: int
    length: int
    lengths: tuple[int, ...]
    reserved_mask: int
    signals: Mapping[str, SignalLayout]
    unpack: Callable[[bytes], dict[str, Any]]
    pack: Callable[[dict[str, int]], bytes]
    checked: tuple[tuple[str, Container[int]], ...]
    divided: tuple[tuple[str, int], ...]
    stretched: tuple[SignalLayout, ...]
    selector: SignalLayout | None = None
    variants: Mapping[int, MessageLayout] = field(default_factory=dict)
    rest: MessageLayout | None = None

    def variant(self, data: bytes) -> MessageLayout:
        """Return the variant for this payload; the message itself if it has no selector."""
        if self.selector is None:
            return self
        return self.variant_of(self.selector.raw_in(data))

    def variant_of(self, raw: int) -> MessageLayout:
        """Return the variant for this raw value of the selector."""
        return self.variants.get(raw, self.rest or self)

    def scale(self, raw: dict[str, float]) -> dict[str, float]:
        """Turn raw values into physical ones, in place.

        Raw / 1000 is the double nearest to the decimal value; cantools' own raw * 0.001 often is
        not, and the last digit would flicker.
        """
        for name, divisor in self.divided:
            raw[name] /= divisor
        for signal in self.stretched:
            raw[signal.name] = signal.to_physical(raw[signal.name])
        return raw


def message_layout(message: DbcMessage) -> MessageLayout:
    """Prepares one message of the database."""
    selector = next((signal for signal in message.signals if signal.is_multiplexer), None)
    if selector is None:
        return _plain_layout(message, message.signals)
    codes = sorted({raw for signal in message.signals for raw in signal.multiplexer_ids or ()})
    rest = [signal for signal in message.signals if signal.multiplexer_ids is None]
    variants = {
        raw: _plain_layout(
            message, [*rest, *(s for s in message.signals if raw in (s.multiplexer_ids or ()))]
        )
        for raw in codes
    }
    whole = _plain_layout(message, message.signals)
    return replace(
        whole,
        selector=whole.signals[selector.name],
        variants=variants,
        rest=_plain_layout(message, rest),
    )


def _plain_layout(message: DbcMessage, of: Sequence[DbcSignal]) -> MessageLayout:
    """Return the layout of a message with some signals, all of which every payload has."""
    in_order = sorted(of, key=_byte_and_bit)
    signals = {signal.name: _signal_layout(signal, message) for signal in in_order}
    checked = tuple(
        (signal.name, signals[signal.name].legal_raw)
        for signal in in_order
        if _can_be_illegal(signal, signals[signal.name])
    )
    scaled = [signal for signal in signals.values() if signal.is_scaled]
    # Raw bits need no scaling, words or second byte order: for them cantools' own `Message` would
    # only add its time, which is most of it.
    bits = create_encode_decode_formats(sorted(of, key=start_bit), message.length).big_endian
    return MessageLayout(
        name=message.name,
        arbitration_id=message.frame_id,
        length=message.length,
        lengths=_SHORT_FORMS.get(message.name, (message.length,)),
        reserved_mask=_reserved_mask(message.length, signals.values()),
        signals=signals,
        unpack=bits.unpack,
        pack=bits.pack,
        checked=checked,
        divided=tuple((s.name, s.divisor) for s in scaled if s.divisor and not s.offset),
        stretched=tuple(s for s in scaled if not s.divisor or s.offset),
    )


def _reserved_mask(length: int, signals: Iterable[SignalLayout]) -> int:
    reserved = (1 << 8 * length) - 1
    for signal in signals:
        reserved &= ~((1 << signal.bits) - 1 << 8 * length - signal.first_bit - signal.bits)
    return reserved


def _byte_and_bit(signal: DbcSignal) -> tuple[int, int]:
    """Return a sort key: flags within a byte from bit 0 up, wider signals by their first byte."""
    byte, bit = divmod(signal.start, 8)
    return byte, bit if signal.length == 1 else -bit


def _selection(signal: DbcSignal, message: DbcMessage) -> Selection | None:
    if signal.multiplexer_ids is None:
        return None
    (raw,) = signal.multiplexer_ids
    by = message.get_signal_by_name(signal.multiplexer_signal or "")
    return Selection(by.name, _first_bit(by), by.length, raw)


def _first_bit(signal: DbcSignal) -> int:
    first: int = signal.start // 8 * 8 + 7 - signal.start % 8
    return first


def _signal_layout(signal: DbcSignal, message: DbcMessage) -> SignalLayout:
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
        first_bit=_first_bit(signal),
        bits=signal.length,
        is_signed=signal.is_signed,
        is_measured=not words and bool(signal.unit or scale != 1.0 or offset),
        selection=_selection(signal, message),
    )


@dataclass(frozen=True, slots=True)
class _Span:
    """A wide range of raw values with a few more beside it."""

    span: range
    extra: frozenset[int]

    def __contains__(self, raw: object) -> bool:
        return isinstance(raw, int) and (raw in self.span or raw in self.extra)


def _can_be_illegal(signal: DbcSignal, layout: SignalLayout) -> bool:
    """Return whether the signal's bits can hold a raw value that means nothing."""
    values: int = 2**signal.length
    if isinstance(layout.legal_raw, frozenset):
        return len(layout.legal_raw) < values
    low = -values // 2 if signal.is_signed else 0
    ends = (low, low + values - 1)
    return any(end not in layout.legal_raw for end in ends)
