"""One line of output for each frame of a log: for people, or as JSON.

Frames of one message differ in few bits but those of its measured values. So a line is made once
for each combination of the other bits (codes, flags), with gaps for time and measured values, and
then filled in, which is many times as fast as building each line.
"""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Final, NamedTuple

import numpy as np

from armui.protocol.codec import InvalidFrame, Message
from armui.protocol.frame import Frame, FrameFlag
from armui.protocol.signal_columns import bit_mask, payload_words, signal_column
from armui.session.frames import NOT_OF_THE_ARM

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from numpy.typing import NDArray

    from armui.protocol.codec import Codec
    from armui.protocol.layout import MessageLayout, SignalLayout
    from armui.session.frames import FrameBatch, LoggedFrame

_MOST_TEMPLATES: Final = 4_096
"""The most templates kept of one message; malicious logs have more combinations of codes than
memory.
"""
_NO_MEANING: Final = -1
"""Stands for every code that a message's selector does not have."""
_KINDS: Final = {
    FrameFlag.IMPOSSIBLE: "impossible frame",
    FrameFlag.ERROR: "error frame",
    FrameFlag.REMOTE: "remote frame",
    FrameFlag.FD: "CAN FD frame",
    FrameFlag.EXTENDED: "frame with a 29-bit identifier",
}
"""The name of each kind of frame that the arm does not send, the most significant first."""


class _Reading(NamedTuple):
    """The message in a frame, and its fault, if any, as kind and detail."""

    message: Message | None
    invalid_frame: tuple[str, str] | None


class _Entry(NamedTuple):
    """The parts of a line but for its time.

    Attributes:
        identifier: In hexadecimal.
        channel: Its name, "" for the first one.
        reading: The decoded content.
        data: Its payload, shown where nothing can be read.
        gaps: Signals to be filled in later.
    """

    identifier: str
    channel: str
    reading: _Reading
    data: bytes
    gaps: frozenset[str]


class _MessagePlan(NamedTuple):
    """The templates of the lines of one message on one channel.

    Attributes:
        layout: The message.
        gaps: Signals that are filled in frame by frame.
        code_mask: The bits of the others.
        channel: The channel's name, "" for the first one.
        templates: Lines with gaps, by the bits under the mask.
    """

    layout: MessageLayout
    gaps: tuple[SignalLayout, ...]
    code_mask: np.uint64
    channel: str
    templates: dict[int, str]


class LineFormat:
    """Formats frames as lines.

    Text: time in seconds, identifier, message, signals with units, and any fault at the end.

    JSON: an object with the keys "t" in seconds, "id", "message" (null when unknown), "signals" by
    name with "value", "unit" and, for codes, "word". A frame that does not follow the protocol has
    "invalid frame" with "kind" and "detail"; one that cannot be read has its payload in "data", in
    hexadecimal. A frame of another channel than the log's first one has "channel".

    Args:
        codec: The codec of the recorded arm.
        as_json: True for JSON instead of text.
    """

    def __init__(self, codec: Codec, *, as_json: bool) -> None:
        self._codec = codec
        self._as_json = as_json
        self._plans: dict[tuple[int, int], _MessagePlan] = {}

    def speak(self, codec: Codec) -> None:
        """Decode later batches with another codec."""
        self._codec = codec
        self._plans.clear()

    def lines(self, batch: FrameBatch) -> list[str]:
        """Return a line for each frame of a batch, in order."""
        keys = batch.ids.astype(np.uint64) | batch.channels.astype(np.uint64) << np.uint64(32)
        order = np.argsort(keys, kind="stable")
        ends = np.flatnonzero(np.diff(keys[order])) + 1
        lines = [""] * len(batch)
        for rows in np.split(order, ends):
            for same, plan in self._with_plans(batch, rows, int(keys[rows[0]])):
                for row, line in zip(same.tolist(), self._group(batch, same, plan), strict=True):
                    lines[row] = line
        return lines

    def _with_plans(
        self, batch: FrameBatch, rows: NDArray[np.intp], key: int
    ) -> Iterator[tuple[NDArray[np.intp], _MessagePlan | None]]:
        """Yield groups of one identifier and channel whose frames have the same signals."""
        layout = self._codec.layout(key & 0xFFFFFFFF)
        if layout is None:
            yield rows, None
        elif layout.selector is None:
            yield rows, self._plan((key, 0), layout, batch)
        else:
            codes = signal_column(payload_words(batch.payloads[rows]), layout.selector)
            known = np.where(np.isin(codes, list(layout.variants)), codes, _NO_MEANING)
            for code in np.unique(known).tolist():
                plan = self._plan((key, code), layout.variant_of(code), batch)
                yield rows[known == code], plan

    def _plan(
        self, place: tuple[int, int], layout: MessageLayout, batch: FrameBatch
    ) -> _MessagePlan:
        if place not in self._plans:
            checked = {name for name, _legal in layout.checked}
            gaps = tuple(
                signal
                for signal in layout.signals.values()
                if not signal.words and signal.name not in checked
                if signal.is_scaled or signal.bits > 8
            )
            codes = bit_mask(s for s in layout.signals.values() if s not in gaps)
            channel = _channel_name(batch, place[0] >> 32)
            self._plans[place] = _MessagePlan(layout, gaps, np.uint64(codes), channel, {})
        return self._plans[place]

    def _group(
        self, batch: FrameBatch, rows: NDArray[np.intp], plan: _MessagePlan | None
    ) -> Sequence[str]:
        """Return the lines of frames with the same identifier and channel."""
        if plan is None:
            return [self._single(batch, row) for row in rows.tolist()]
        lengths = batch.lengths[rows]
        plain = (batch.flags[rows] & NOT_OF_THE_ARM) == 0
        plain &= np.isin(lengths, np.array(plan.layout.lengths, np.uint8))
        if not plain.all():
            single = iter([self._single(batch, row) for row in rows[~plain].tolist()])
            filled = iter(self._group(batch, rows[plain], plan))
            return [next(filled if each else single) for each in plain.tolist()]
        words = payload_words(batch.payloads[rows])
        times = batch.times_s[rows].tolist()
        columns = [signal_column(words, signal).tolist() for signal in plan.gaps]
        codes = (words & plan.code_mask).tolist()
        templates = plan.templates
        for code in set(codes).difference(templates):
            if len(templates) >= _MOST_TEMPLATES:
                templates.clear()
            templates[code] = self._template(plan, int(batch.ids[rows[0]]), code)
        try:
            filled_in = zip(rows.tolist(), codes, zip(times, *columns, strict=True), strict=True)
            return [
                template % values if (template := templates[code]) else self._single(batch, row)
                for row, code, values in filled_in
            ]
        except KeyError:  # a template was dropped, as too many are in use
            return [self._single(batch, row) for row in rows.tolist()]

    def _template(self, plan: _MessagePlan, arbitration_id: int, code: int) -> str:
        """Return the line of every frame with these codes, with a "%" for each value that differs.

        It is "" if these codes make a frame unreadable: then each frame gets a line of its own.
        """
        data = code.to_bytes(8, "big")[: plan.layout.length]
        decoded = self._codec.decode(Frame(arbitration_id, data))
        reading = _reading_of(decoded)
        if reading.message is None:
            return ""
        gaps = frozenset(signal.name for signal in plan.gaps)
        entry = _Entry(f"0x{arbitration_id:03X}", plan.channel, reading, b"", gaps)
        return self._line_of(entry)

    def _single(self, batch: FrameBatch, row: int) -> str:
        """Return the line of one frame of any kind."""
        logged = batch.frame(row)
        width = 8 if logged.flags & FrameFlag.EXTENDED else 3
        entry = _Entry(
            f"0x{logged.frame.arbitration_id:0{width}X}",
            _channel_name(batch, int(batch.channels[row])),
            self._reading(logged),
            logged.frame.data,
            frozenset(),
        )
        return self._line_of(entry) % (logged.time_s,)

    def _reading(self, entry: LoggedFrame) -> _Reading:
        for flag, kind in _KINDS.items():
            if entry.flags & flag:
                return _Reading(None, (kind, "not of the arm's protocol"))
        return _reading_of(self._codec.decode(entry.frame))

    def _line_of(self, entry: _Entry) -> str:
        """Return the line with a "%" in place of its time."""
        return self._json(entry) if self._as_json else self._text(entry)

    def _text(self, entry: _Entry) -> str:
        identifier, channel, (message, invalid_frame), data, gaps = entry
        parts = ["%14.6f", f"{identifier:>10}"]
        if channel:
            parts.append(_literal(f"[{channel}]"))
        if message is None:
            parts.append(_literal(f"unknown ({': '.join(invalid_frame or ())})"))
            parts.append(data.hex(" ").upper())
        else:
            parts.append(f"{message.name:<19}")
            names = _names(self._codec, message)
            parts.append("  ".join(self._signal_text(message, name, gaps) for name in names))
            if invalid_frame:
                parts.append(_literal(f"({': '.join(invalid_frame)})"))
        return "  ".join(parts).rstrip()

    def _signal_text(self, message: Message, name: str, gaps: frozenset[str]) -> str:
        value = message.signals[name]
        text = f"{name}=%.10g" if name in gaps else f"{name}={value:.10g}"
        if unit := self._codec.unit(message.name, name):
            text += _literal(f" {unit}")
        if name not in gaps and (word := self._codec.word(message.name, name, value)):
            text += _literal(f" ({word})")
        return text

    def _json(self, entry: _Entry) -> str:
        identifier, channel, (message, invalid_frame), data, gaps = entry
        line: dict[str, object] = {"id": identifier}
        if channel:
            line["channel"] = channel
        line["message"] = message.name if message else None
        head = _literal(json.dumps(line))[1:-1]
        signals = (
            ", ".join(
                self._signal_json(message, name, gaps) for name in _names(self._codec, message)
            )
            if message
            else ""
        )
        tail: dict[str, object] = {}
        if invalid_frame:
            tail["oddity"] = {"kind": invalid_frame[0], "detail": invalid_frame[1]}
        if message is None:
            tail["data"] = data.hex().upper()
        end = ", " + _literal(json.dumps(tail))[1:] if tail else "}"
        return f'{{"t": %s, {head}, "signals": {{{signals}}}{end}'

    def _signal_json(self, message: Message, name: str, gaps: frozenset[str]) -> str:
        value = message.signals[name]
        unit = self._codec.unit(message.name, name)
        if name in gaps:
            return f'{json.dumps(name)}: {{"value": %s, "unit": {_literal(json.dumps(unit))}}}'
        signal: dict[str, object] = {"value": value, "unit": unit}
        if word := self._codec.word(message.name, name, value):
            signal["word"] = word
        return f"{json.dumps(name)}: {_literal(json.dumps(signal))}"


def _reading_of(decoded: Message | InvalidFrame) -> _Reading:
    if isinstance(decoded, InvalidFrame):
        return _Reading(decoded.message, (decoded.kind.value, decoded.detail))
    return _Reading(decoded, None)


def _names(codec: Codec, message: Message) -> list[str]:
    """Return the names of a frame's signals, in the order of its bits."""
    return [name for name in codec.signals(message.name) if name in message.signals]


def _channel_name(batch: FrameBatch, index: int) -> str:
    return str(batch.channel_names[index]) if index else ""


def _literal(text: str) -> str:
    """Return text escaped so that filling in a template leaves it unchanged."""
    return text.replace("%", "%%")
