"""Many frames of a log at once into the series: the same values as frame by frame."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any, Final, TypeVar

import numpy as np

from armui.protocol.columns import payload_words, signal_column
from armui.protocol.frame import FrameFlag
from armui.telemetry.quantities import BUS, RECORDS, Source
from armui.telemetry.rows import factor_of, told_signals

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from _typeshed import DataclassInstance
    from numpy.typing import NDArray

    from armui.protocol.codec import Codec
    from armui.protocol.layout import MessageLayout
    from armui.telemetry.quantities import Field, Record
    from armui.telemetry.series import Series

NOT_OF_THE_ARM: Final = ~FrameFlag.TRANSMITTED & 0xFF
_IDS: Final = 0x800
_Columns = TypeVar("_Columns", bound="DataclassInstance")


@dataclass(frozen=True, slots=True, eq=False)
class FrameColumns:
    """Frames of a log, one row each, in the order of time.

    Attributes:
        times_s: By the clock of the samples.
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
        """Some of the rows."""
        return FrameColumns(
            self.times_s[rows],
            self.ids[rows],
            self.flags[rows],
            self.lengths[rows],
            self.payloads[rows],
        )


def joined(pieces: Sequence[_Columns]) -> _Columns:
    """Columns one behind the other; of one piece at least."""
    kind = type(pieces[0])
    columns = ([getattr(piece, each.name) for piece in pieces] for each in fields(kind))
    return pieces[0] if len(pieces) == 1 else kind(*map(np.concatenate, columns))


class ColumnWriter:
    """Takes the feedback of an arm into its series.

    Args:
        series: By name.
        codec: How frames are decoded.
        proven: The arm is known to speak the codec's generation.

    Attributes:
        is_feedback: By identifier, whether it is taken in here.
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

    def take(self, frames: FrameColumns) -> None:
        """Take in the feedback among frames that are ordinary data frames."""
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
    """What makes one figure or code of every row; see `armui.telemetry.rows`."""
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
