"""The columns of a table of feedback and commands, and their values at frames of a log."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, Final, NamedTuple

import numpy as np

from armui.protocol.codes import DEGREES_PER
from armui.protocol.frame import EncodeError
from armui.telemetry.quantities import RECORDS, Field, Record, Source, Space

if TYPE_CHECKING:
    from collections.abc import Iterator

    from numpy.typing import NDArray

    from armui.protocol.codec import Codec
    from armui.protocol.layout import SignalLayout
    from armui.session.exports.history import History, Samples, TimeSpan

TIME_BASE: Final = "JointFeedback56"
"""The message that ends a set of joint angles; each of its frames makes a row."""
COMMANDED: Final = "command"
"""The prefix of columns with commands, from whichever host."""


@dataclass(frozen=True)
class ExportColumn:
    """One quantity as a column.

    Attributes:
        name: The name as in the plots: ``arm.joint_angle.1``; commands begin with ``command.``.
        unit: The operator's unit, "" for codes.
        whole: True if every value is a whole number.
        signals: Its signals in the DBC files; if several, they are bits, the first one worth 1.
        factor: The factor from the unit of the DBC file to this one.
    """

    name: str
    unit: str
    whole: bool
    signals: tuple[str, ...]
    factor: float = 1.0

    def values(self, samples: Samples) -> NDArray[Any]:
        """Return the values of all samples: int64 if they are whole, else float64."""
        if len(self.signals) > 1:
            return samples.bits(self.signals)
        column = samples.column(self.signals[0])
        if self.whole:
            return column
        return column.astype(np.float64) * self.factor


def titled(column: ExportColumn | SignalLayout) -> str:
    """Return the name and unit of a column or signal, for a header."""
    return f"{column.name} [{column.unit}]" if column.unit else column.name


@dataclass(frozen=True)
class RecordColumns:
    """The columns of one message.

    Attributes:
        message: Its name in the DBC files.
        columns: Its columns.
        space: For a command: the kind of command, of which only the newest holds.
        ended_by: For a command: the messages that replace it.
    """

    message: str
    columns: tuple[ExportColumn, ...]
    space: Space | None = None
    ended_by: tuple[str, ...] = ()

    def told_at(
        self, history: History, rows: NDArray[np.int64], times_s: NDArray[np.float64]
    ) -> tuple[Samples, NDArray[np.intp]] | None:
        """Return the samples, and the one that held at each of some frames.

        Feedback holds for half a second; a command until it is ended by another one, a stop, an
        abort or disabled motors.

        Returns:
            The samples, and the index of the one that held at each frame, -1 if none did; ``None``
            if the message has never been heard.
        """
        samples = history.samples(self.message)
        if samples is None:
            return None
        if self.space is None:
            last, fresh = samples.fresh_at(rows, times_s)
            return samples, np.where(fresh, last, -1)
        last = samples.last_at(rows)
        by_stops = self.space is not Space.MODE
        ended = history.ended_at(rows, self.ended_by, by_stops=by_stops)
        return samples, np.where(samples.rows[last] > ended, last, -1)


class TableColumns:
    """All columns of a generation, in the order of the plots' list.

    Args:
        codec: A codec of that generation.

    Attributes:
        records: The messages in order.
    """

    def __init__(self, codec: Codec) -> None:
        self.records = tuple(_records(codec))

    @cached_property
    def columns(self) -> tuple[ExportColumn, ...]:
        """All columns in order."""
        return tuple(column for record in self.records for column in record.columns)


def _records(codec: Codec) -> Iterator[RecordColumns]:
    motions = tuple(
        record.message
        for record in RECORDS
        if record.source is Source.OTHER and record.space is Space.MOTION
    )
    for record in RECORDS:
        # what this program sends and what others send differs in nothing but the sender
        if record.source not in {Source.ARM, Source.OTHER}:
            continue
        columns = tuple(_columns(record, codec))
        if not columns:
            continue
        family = record.message.rstrip("0123456789")
        others = tuple(name for name in motions if name.rstrip("0123456789") != family)
        ended_by = others if record.space is Space.MOTION else ()
        yield RecordColumns(record.message, columns, record.space, ended_by)


def _columns(record: Record, codec: Codec) -> Iterator[ExportColumn]:
    try:
        told = codec.signals(record.message)
    except EncodeError:  # the generation has no such message
        return
    for field in record.fields:
        if any(signal in told for signal in field.signals):
            column = _column(record, field, codec)
            if math.isfinite(column.factor):  # else it counts in no unit of angle: encoder pulses
                yield column


def _column(record: Record, field: Field, codec: Codec) -> ExportColumn:
    kind, _, joint = field.name.partition(".")
    number = joint or ("" if record.number is None else str(record.number))
    source = "arm" if record.source is Source.ARM else COMMANDED
    name = ".".join(part for part in (source, kind, number) if part)
    if len(field.signals) > 1:
        return ExportColumn(name, "", True, field.signals)
    (signal,) = field.signals
    factor = 1.0
    if field.is_angle:
        factor = DEGREES_PER.get(codec.unit(record.message, signal), math.nan)
    step = codec.step(record.message, signal)
    whole = factor == 1.0 and step == 1.0
    return ExportColumn(name, field.unit, whole, field.signals, factor)


class RowTimes(NamedTuple):
    """The frames of a piece of a log that make rows.

    Attributes:
        rows: The numbers of the frames within the log.
        times_s: Their times as recorded.
    """

    rows: NDArray[np.int64]
    times_s: NDArray[np.float64]


def table_rows(history: History, span: TimeSpan, message: str = TIME_BASE) -> RowTimes | None:
    """Return the rows that the newest piece of a log adds, or ``None`` if it adds none.

    Args:
        history: The history, which has processed the piece.
        span: Frames outside of it are left out.
        message: The message whose frames make rows.
    """
    samples = history.samples(message)
    if samples is None:
        return None
    times_s = samples.times_s[samples.old :]
    inside = span.holds(times_s)
    if not inside.any():
        return None
    return RowTimes(samples.new_rows[inside], times_s[inside])
