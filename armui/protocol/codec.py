"""Decodes frames to named signals in physical units, and encodes them, refusing wrong values."""

from __future__ import annotations

import enum
import math
from difflib import get_close_matches
from functools import cache
from typing import TYPE_CHECKING, NamedTuple

from armui.protocol.addressing import Addressing
from armui.protocol.firmware_version import RECOMMENDED, quirks_of
from armui.protocol.frame import EncodeError, Frame
from armui.protocol.generation import Generation
from armui.protocol.layout import load_database, message_layout

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from armui.protocol.firmware_version import FirmwareQuirks, FirmwareVersion, MitLayout
    from armui.protocol.layout import MessageLayout, SignalLayout


_JOINT = "Joint"
"""The signal that holds the joint number of a message."""

_UPGRADE_RANGES = (
    range(0x0A0, 0x0B0),
    range(0x0B0, 0x0C0),
    range(0x4A0, 0x4B0),
    range(0x4B0, 0x4C0),
    range(0x4C0, 0x4D0),
)
"""Identifiers reserved for firmware upgrades; their content is not documented."""

_STEP_NOISE = 1e-6
"""The part of a raw step by which rounding noise may carry a value past the end of a range."""


class Message(NamedTuple):
    """A decoded frame.

    Attributes:
        name: The message's name in the DBC files.
        signals: Physical values by signal name, codes as integers.
    """

    name: str
    signals: dict[str, float]


class InvalidFrameKind(enum.Enum):
    """The ways in which a frame can be invalid."""

    UNKNOWN_ID = "unknown identifier"
    WRONG_LENGTH = "wrong length"
    VALUE_OUTSIDE_TABLE = "value outside the table"


class InvalidFrame(NamedTuple):
    """A frame that does not follow the protocol; to be counted, never fatal.

    Attributes:
        kind: The kind of error.
        arbitration_id: The identifier as seen on the wire.
        detail: One sentence for the log.
        message: The decoded content, if only a value is invalid (a newer firmware may use codes
            that the tables lack); None if the frame cannot be decoded, or names a joint that no arm
            has.
    """

    kind: InvalidFrameKind
    arbitration_id: int
    detail: str
    message: Message | None = None


def raw_value(layout: MessageLayout, signal: SignalLayout, value: float | None) -> int:
    """Return the raw value of a physical one, rounded to the nearest raw step.

    Args:
        layout: The message, for the error's text.
        signal: The signal of that message.
        value: In the signal's unit; None for "leave unchanged".

    Raises:
        EncodeError: The value is out of range, not finite, outside the table, a fraction where only
            whole numbers are legal, or None where nothing can be left unchanged.
    """
    if signal.is_measured and type(value) is float and signal.minimum <= value <= signal.maximum:
        return round(signal.to_steps(value))  # fast path for most values of a moving arm
    if value is None:
        if signal.unchanged_raw is None:
            raise _refused(layout, signal, None, "it cannot be left unchanged: give a value")
        return signal.unchanged_raw
    try:
        steps = signal.to_steps(value)
        finite = math.isfinite(steps)
    except (TypeError, ValueError, OverflowError):
        raise _refused(layout, signal, value, f"give a number: {allowed(signal)}") from None
    if not finite:
        raise _refused(layout, signal, value, f"give a finite number: {allowed(signal)}")
    raw = round(steps)
    if raw in signal.words and abs(steps - raw) < _STEP_NOISE:
        return raw
    if signal.exhaustive or not _within(signal, value):
        raise _refused(layout, signal, value, f"give {allowed(signal)}")
    if signal.is_count and raw != steps:
        raise _refused(layout, signal, value, f"give a whole number: {allowed(signal)}")
    return raw


def neutral_value(layout: MessageLayout, signal: SignalLayout) -> int:
    """Return the raw value of a signal left out: "leave unchanged" if there is one, else 0.

    Raises:
        EncodeError: 0 is not legal for this signal, so it must be given.
    """
    if signal.unchanged_raw is not None:
        return signal.unchanged_raw
    raw = round(signal.to_steps(0.0))
    if raw not in signal.legal_raw:
        raise _refused(layout, signal, None, f"it must be given: {allowed(signal)}")
    return raw


def chosen_variant(layout: MessageLayout, signals: Mapping[str, float | None]) -> MessageLayout:
    """Return the message's variant for its selector, which is given or neutral.

    Raises:
        EncodeError: The selector's value is illegal, or the variant lacks one of the signals.
    """
    selector = layout.selector
    if selector is None:
        return layout
    given = selector.name in signals
    raw = (
        raw_value(layout, selector, signals[selector.name])
        if given
        else neutral_value(layout, selector)
    )
    variant = layout.variant_of(raw)
    for name in signals:
        if name not in variant.signals:
            selection = layout.signals[name].selection
            word = selector.words.get(selection.raw if selection else raw, "")
            raise EncodeError(
                f"{layout.name}.{name} is only there with {selector.name} = {word!r}; give that",
                message=layout.name,
                signal=name,
                value=signals[name],
            )
    return variant


def unknown_signal(layout: MessageLayout, signal: str) -> EncodeError:
    """Return the error for a signal that the message does not have in this generation."""
    return EncodeError(
        f"{layout.name} has no signal {signal} in this generation; it has {listed(layout.signals)}",
        message=layout.name,
        signal=signal,
    )


def allowed(signal: SignalLayout) -> str:
    """Return the legal values of a signal as text: its range, its codes or both."""
    words = listed(
        f"{number(signal.to_physical(raw), signal)} ({word})"
        for raw, word in sorted(signal.words.items())
    )
    if signal.exhaustive:
        return words
    return f"{_range(signal)}, or {words}" if words else _range(signal)


def number(value: object, signal: SignalLayout) -> str:
    """Return a physical value with its unit, as error messages print it."""
    try:
        text = f"{value:.10g}" if isinstance(value, int | float) else repr(value)
    except OverflowError:
        text = "a number beyond any frame"
    return f"{text} {signal.unit}".rstrip()


def listed(items: Iterable[str]) -> str:
    """Return items as error messages list them."""
    return ", ".join(items)


def _within(signal: SignalLayout, value: float) -> bool:
    slack = signal.scale * _STEP_NOISE
    return signal.minimum - slack < value < signal.maximum + slack


def _range(signal: SignalLayout) -> str:
    return f"{signal.minimum:.10g} to {number(signal.maximum, signal)}"


def _refused(
    layout: MessageLayout, signal: SignalLayout, value: object, remedy: str
) -> EncodeError:
    given = "nothing" if value is None else number(value, signal)
    return EncodeError(
        f"{layout.name}.{signal.name} cannot be {given} (range {_range(signal)}); {remedy}",
        message=layout.name,
        signal=signal.name,
        value=value,
        minimum=signal.minimum,
        maximum=signal.maximum,
        unit=signal.unit,
    )


class Codec:
    """Encodes and decodes one generation of the protocol with one arm's identifier offsets.

    It keeps no state between frames; several threads may use one codec.

    Attributes:
        generation: The generation of the protocol.
        addressing: The identifier offsets of the arm.
        firmware: The arm's version, which decides the layout of its MIT frames; ``None`` if not
            known: that of the version recommended by the maker is assumed.
        layouts: Every message by its identifier on the wire.
    """

    def __init__(
        self,
        generation: Generation,
        addressing: Addressing = Addressing(),  # noqa: B008 - frozen
        firmware: FirmwareVersion | None = None,
    ) -> None:
        self.generation = generation
        self.addressing = addressing
        self.firmware = firmware
        layouts = _layouts(generation, self.quirks.mit_layout)
        self._by_name = {layout.name: layout for layout in layouts}
        self.layouts = {addressing.to_wire(layout.arbitration_id): layout for layout in layouts}
        self._latest: dict[int, tuple[bytes, Message | InvalidFrame]] = {}

    @property
    def quirks(self) -> FirmwareQuirks:
        """The firmware's quirks; those of the recommended version if it is not known."""
        return quirks_of(self.firmware or RECOMMENDED)

    def decode(self, frame: Frame) -> Message | InvalidFrame:
        """Return the content of a frame; callers must not change it.

        Never raises, whatever the frame holds: it runs on the thread that owns the bus. Results are
        cached, because an arm repeats most of its frames.
        """
        latest = self._latest.get(frame.arbitration_id)
        if latest is not None and latest[0] == frame.data:
            return latest[1]
        layout = self.layouts.get(frame.arbitration_id)
        if layout is None:
            return self._unknown_id(frame.arbitration_id)
        heard = _decoded(layout, frame)
        self._latest[frame.arbitration_id] = frame.data, heard
        return heard

    def encode(self, name: str, **signals: float | None) -> Frame:
        """Return the frame of a message with these signals.

        Args:
            name: The message's name.
            **signals: Physical values by signal name, codes as integers. A signal left out is 0, or
                "leave unchanged" where the protocol has that; None asks for "leave unchanged".

        Returns:
            The frame, with the arm's identifier offsets applied.

        Raises:
            EncodeError: The message or a signal is unknown, a value is out of range, not finite or
                outside its table, a signal without neutral value is missing, None is given where
                nothing can be left unchanged, or the selector excludes a signal.
        """
        layout = self._message(name)
        if not signals.keys() <= layout.signals.keys():
            raise unknown_signal(layout, next(s for s in signals if s not in layout.signals))
        if layout.selector is not None:
            layout = chosen_variant(layout, signals)
        raw = {
            signal.name: raw_value(layout, signal, signals[signal.name])
            if signal.name in signals
            else neutral_value(layout, signal)
            for signal in layout.signals.values()
        }
        return Frame(self.addressing.to_wire(layout.arbitration_id), layout.pack(raw))

    def is_exact(self, frame: Frame) -> bool:
        """Return whether this generation sends the frame so: its length, no reserved bit set.

        Decoding is more tolerant; this check tells the generations apart in a log.
        """
        layout = self.layouts.get(frame.arbitration_id)
        return (
            layout is not None
            and len(frame.data) == layout.length
            and not int.from_bytes(frame.data, "big") & layout.reserved_mask
            and isinstance(self.decode(frame), Message)
        )

    def layout(self, arbitration_id: int) -> MessageLayout | None:
        """Return the message with an identifier on the wire, or None if the tables lack it."""
        return self.layouts.get(arbitration_id)

    def signals(self, message: str) -> tuple[str, ...]:
        """Return the names of a message's signals in the order of bytes and, in a byte, of bits.

        Raises:
            EncodeError: No such message in this generation.
        """
        return tuple(self._message(message).signals)

    def may_lack(self, message: str, signal: str) -> bool:
        """Return whether a frame of the message may hold another signal in this one's place.

        Raises:
            EncodeError: No such message or signal in this generation.
        """
        return self._signal(message, signal).selection is not None

    def unit(self, message: str, signal: str) -> str:
        """Return the unit of a signal, "" for bare numbers and codes.

        Raises:
            EncodeError: No such message or signal in this generation.
        """
        return self._signal(message, signal).unit

    def step(self, message: str, signal: str) -> float:
        """Return the smallest difference a signal can carry, in its unit.

        Raises:
            EncodeError: No such message or signal in this generation.
        """
        return self._signal(message, signal).scale

    def can_leave(self, message: str, signal: str) -> bool:
        """Return whether ``None`` may be encoded: keep the arm's value (0x7FFF, generation 2).

        Raises:
            EncodeError: No such message or signal in this generation.
        """
        return self._signal(message, signal).unchanged_raw is not None

    def word(self, message: str, signal: str, value: float) -> str | None:
        """Return the value table's word for a physical value, or None if it has none.

        Raises:
            EncodeError: No such message or signal in this generation.
        """
        layout = self._signal(message, signal)
        return layout.words.get(round(layout.to_steps(value))) if layout.words else None

    def code(self, message: str, signal: str, word: str) -> int:
        """Return the code of a word in the value table.

        Codes that differ between the generations are thus kept in the files only.

        Raises:
            EncodeError: No such message, signal or word in this generation.
        """
        layout = self._signal(message, signal)
        for raw, known in layout.words.items():
            if known == word:
                return raw
        raise EncodeError(
            f"{message}.{signal} has no {word!r} in generation {int(self.generation)}; "
            f"it knows {listed(layout.words.values())}",
            message=message,
            signal=signal,
            value=word,
        )

    def _message(self, name: str) -> MessageLayout:
        layout = self._by_name.get(name)
        if layout is None:
            close = get_close_matches(name, self._by_name, n=1)
            hint = f"did you mean {close[0]}?" if close else "see the DBC file for the names"
            raise EncodeError(
                f"Generation {int(self.generation)} has no message {name}; {hint}", message=name
            )
        return layout

    def _signal(self, message: str, signal: str) -> SignalLayout:
        layout = self._message(message)
        if signal not in layout.signals:
            raise unknown_signal(layout, signal)
        return layout.signals[signal]

    def _unknown_id(self, arbitration_id: int) -> InvalidFrame:
        if any(arbitration_id in ids for ids in _UPGRADE_RANGES):
            detail = f"0x{arbitration_id:03X} is in the firmware upgrade range (undocumented)"
        elif self.addressing.from_wire(arbitration_id) is None:
            detail = (
                f"0x{arbitration_id:03X} belongs to an arm with other identifier offsets (0x470)"
            )
        else:
            detail = (
                f"0x{arbitration_id:03X} is not in the tables of generation {int(self.generation)}"
            )
        return InvalidFrame(InvalidFrameKind.UNKNOWN_ID, arbitration_id, detail)


@cache
def _layouts(generation: Generation, mit_layout: MitLayout) -> tuple[MessageLayout, ...]:
    """Return every message of a generation; cached, as each arm and handshake makes a codec."""
    database = load_database(generation, mit_layout)
    return tuple(message_layout(message) for message in database.messages)


def _decoded(layout: MessageLayout, frame: Frame) -> Message | InvalidFrame:
    arbitration_id, data = frame
    if len(data) != layout.length:
        if len(data) not in layout.lengths:
            return _wrong_length(layout, frame)
        data = data[: layout.length].ljust(layout.length, b"\0")
    if layout.selector is not None:
        layout = layout.variant(data)
    values = layout.unpack(data)
    for name, legal in layout.checked:
        if values[name] not in legal:
            return _outside_table(layout, arbitration_id, values)
    return Message(layout.name, layout.scale(values))


def _wrong_length(layout: MessageLayout, frame: Frame) -> InvalidFrame:
    wanted = " or ".join(str(length) for length in layout.lengths)
    detail = f"{layout.name} has {len(frame.data)} bytes instead of {wanted}"
    return InvalidFrame(InvalidFrameKind.WRONG_LENGTH, frame.arbitration_id, detail)


def _outside_table(
    layout: MessageLayout, arbitration_id: int, raw: dict[str, float]
) -> InvalidFrame:
    odd = [layout.signals[name] for name, legal in layout.checked if raw[name] not in legal]
    signals = layout.scale(raw)
    detail = "; ".join(
        f"{layout.name}.{signal.name} is {number(signals[signal.name], signal)}, not "
        + ("in its table" if signal.exhaustive else f"within {allowed(signal)}")
        for signal in odd
    )
    names_nothing = any(signal.name == _JOINT for signal in odd)
    message = None if names_nothing else Message(layout.name, signals)
    return InvalidFrame(InvalidFrameKind.VALUE_OUTSIDE_TABLE, arbitration_id, detail, message)
