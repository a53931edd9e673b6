"""Converts messages to the figures and codes of their series.

It works for one decoded message at a time, as received, or for the frames of a log at once, with
the same values.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields
from operator import itemgetter, mul
from typing import TYPE_CHECKING, Any, Final, TypeVar

import numpy as np

from armui.arm.limits import JOINTS
from armui.protocol.codec import Codec
from armui.protocol.codes import DEGREES_PER
from armui.protocol.frame import EncodeError, FrameFlag
from armui.protocol.signal_columns import payload_words, signal_column
from armui.telemetry.quantities import BUS, RECORDS, Field, Record, Source
from armui.telemetry.series import Row

if TYPE_CHECKING:
    from collections.abc import Sequence

    from _typeshed import DataclassInstance
    from numpy.typing import NDArray

    from armui.protocol.layout import MessageLayout
    from armui.telemetry.series import Series

_Signals = Mapping[str, float]
_FigureMaker = Callable[[_Signals], float]
_NAN: Final = math.nan

_UNPROVEN: Final = frozenset(
    {"SpeedPercent", "TrajectoryPoint", *(f"J{joint}LimitExceeded" for joint in JOINTS)}
)
"""The signals of 0x2A1 bytes 5 and 6, whose meaning depends on the generation."""

NOT_OF_THE_ARM: Final = ~FrameFlag.TRANSMITTED & 0xFF
_IDS: Final = 0x800
_Columns = TypeVar("_Columns", bound="DataclassInstance")


def row_of(record: Record, codec: Codec, *, proven: bool) -> Callable[[_Signals], Row] | None:
    """Return a function that makes a row of a message's signals, or ``None`` if none is understood.

    Args:
        record: The fields that are kept.
        codec: The codec that decodes it.
        proven: True if the arm is known to speak this generation. Otherwise only values with the
            same meaning in both are kept.
    """
    told = told_signals(record, codec, proven=proven)
    if told is None:
        return None
    fields = record.fields
    plain = all(len(field.signals) == 1 and field.signals[0] in told for field in fields)
    if plain and not any(codec.may_lack(record.message, name) for name in told):
        factors = [factor_of(record, field, codec) for field in fields]
        return _plain([field.signals[0] for field in fields], factors)
    makers = tuple(_figure_maker(record, field, codec, told) for field in fields)
    return lambda signals: tuple([make(signals) for make in makers])


def told_signals(record: Record, codec: Codec, *, proven: bool) -> frozenset[str] | None:
    """Return the signals of a message that are understood, or ``None`` if none; see `row_of`."""
    if not (proven or record.common):
        return None
    try:
        told = frozenset(codec.signals(record.message))
    except EncodeError:
        return None
    if not proven and record.message == "ArmStatus":
        told -= _UNPROVEN
    return told


def _plain(names: list[str], factors: list[float]) -> Callable[[_Signals], Row]:
    """Return two signals and more, each as it is or in another unit."""
    values: Callable[[_Signals], Row] = itemgetter(*names)
    if all(factor == 1 for factor in factors):
        return values
    return lambda signals: tuple(map(mul, values(signals), factors))


def factor_of(record: Record, field: Field, codec: Codec) -> float:
    """Return the factor that converts a signal to the field's unit."""
    if not field.is_angle:
        return 1
    return DEGREES_PER.get(codec.unit(record.message, field.signals[0]), _NAN)


def _figure_maker(record: Record, field: Field, codec: Codec, told: frozenset[str]) -> _FigureMaker:
    """Return one figure or code of a row."""
    bits = tuple((1 << place, name) for place, name in enumerate(field.signals) if name in told)
    if not bits:
        missing: float = 0 if field.is_code else _NAN
        return lambda _signals: missing
    if len(field.signals) > 1:
        return lambda signals: sum(bit for bit, name in bits if signals[name] == 1)
    name = field.signals[0]
    factor = factor_of(record, field, codec)
    if codec.may_lack(record.message, name):
        return lambda signals: signals.get(name, _NAN) * factor
    if factor == 1:
        return itemgetter(name)
    return lambda signals: signals[name] * factor


@dataclass(frozen=True, slots=True, eq=False)
class FrameColumns:
    """Frames of a log, one row each, in the order of time.

    Attributes:
        times_s: The times by the samples' clock.
        ids: Identifiers.
        flags: `FrameFlag` bits.
        lengths: Bytes of data.
        payloads: The first 8 bytes of data, zeros behind its end; shape (rows, 8).
    """

    times_s: NDArray[np.float64]
    ids: NDArray[np.uint32]
    flags: NDArray[np.uint8]
    lengths: NDArray[np.uint8]
    payloads: NDArray[np.uint8]

    def __len__(self) -> int:
        return len(self.ids)

    def of(self, rows: NDArray[Any] | slice) -> FrameColumns:
        """Return some of the rows."""
        return FrameColumns(
            self.times_s[rows],
            self.ids[rows],
            self.flags[rows],
            self.lengths[rows],
            self.payloads[rows],
        )


def joined(pieces: Sequence[_Columns]) -> _Columns:
    """Return columns joined one behind the other; there must be at least one piece."""
    kind = type(pieces[0])
    columns = ([getattr(piece, each.name) for piece in pieces] for each in fields(kind))
    return pieces[0] if len(pieces) == 1 else kind(*map(np.concatenate, columns))


class ColumnWriter:
    """Adds the feedback of an arm to its series.

    Args:
        series: The series by name.
        codec: The codec that decodes the frames.
        proven: True if the arm is known to speak the codec's generation.

    Attributes:
        is_feedback: For each identifier, true if it is processed here.
    """

    def __init__(self, series: Mapping[str, Series], codec: Codec, *, proven: bool) -> None:
        layouts = {layout.name: (wire_id, layout) for wire_id, layout in codec.layouts.items()}
        self.is_feedback: NDArray[np.bool_] = np.zeros(_IDS, np.bool_)
        self._writers: dict[int, Callable[[FrameColumns], None]] = {}
        for record in RECORDS:
            if record.source is not Source.ARM or record is BUS:
                continue
            told = told_signals(record, codec, proven=proven)
            if told is None:
                continue
            wire_id, layout = layouts[record.message]
            self._writers[wire_id] = _writer(record, series[record.name], codec, layout, told)
            self.is_feedback[wire_id] = True

    def add_frames(self, frames: FrameColumns) -> None:
        """Add the feedback among frames that are ordinary data frames."""
        order = np.argsort(frames.ids, kind="stable")
        ids = frames.ids[order]
        edges = np.flatnonzero(np.diff(ids)) + 1
        for rows in np.split(order, edges) if order.size else ():
            writer = self._writers.get(int(frames.ids[rows[0]]))
            if writer is not None:
                writer(frames.of(rows))


def _writer(
    record: Record, series: Series, codec: Codec, layout: MessageLayout, told: frozenset[str]
) -> Callable[[FrameColumns], None]:
    lengths = np.array(layout.lengths, np.uint8)
    makers = {field.name: _maker(record, field, codec, layout, told) for field in record.fields}

    def write(frames: FrameColumns) -> None:
        if not (frames.lengths == lengths[0]).all():
            frames = frames.of(np.isin(frames.lengths, lengths))
        if len(frames):
            words = payload_words(frames.payloads)
            columns = {name: make(words) for name, make in makers.items()}
            series.extend(frames.times_s, columns)

    return write


def _maker(
    record: Record, field: Field, codec: Codec, layout: MessageLayout, told: frozenset[str]
) -> Callable[[NDArray[np.uint64]], NDArray[Any]]:
    """Return a function that makes one figure or code of every row; see `_figure_maker`."""
    bits = [(1 << place, name) for place, name in enumerate(field.signals) if name in told]
    if not bits:
        missing = 0 if field.is_code else np.nan
        return lambda words: np.full(words.size, missing)
    if len(field.signals) > 1:
        signals = [(bit, layout.signals[name]) for bit, name in bits]
        return lambda words: np.sum(
            [bit * (signal_column(words, signal) == 1) for bit, signal in signals], axis=0
        )
    factor, signal = factor_of(record, field, codec), layout.signals[field.signals[0]]
    if factor == 1:
        return lambda words: signal_column(words, signal)
    return lambda words: signal_column(words, signal) * factor
