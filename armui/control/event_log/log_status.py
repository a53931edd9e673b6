"""Finds the changes of the arm's status in the frames of a whole log, as if live: pure.

It finds the same changes as `StatusListener` does frame by frame, in all frames of a message at
once.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from armui.arm.state import FRESH_FOR_S
from armui.control.event_log.status_listener import (
    GAP,
    RATE,
    RATE_SPAN_S,
    STATUS,
    WATCHED,
    StatusChange,
)
from armui.protocol.signal_columns import payload_words, signal_column
from armui.session.session import DataRows

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from armui.protocol.codec import Codec
    from armui.protocol.layout import MessageLayout
    from armui.session.frames import Channel
    from armui.session.session import HasDataRows

MOST: Final = 20_000
"""The most changes kept; a log with more is noise, and further ones are left out."""
_BEFORE_ALL, _BEFORE = -0.5, -0.25
"""Offsets that sort the changes of one frame: the silence before it, the rate, the frame itself."""


def status_changes(session: HasDataRows, channel: Channel, codec: Codec) -> list[StatusChange]:
    """Return the changes of all of `WATCHED`, silences and rates, in the order of the frames.

    Args:
        session: The log.
        channel: The channel of the arm.
        codec: The arm's codec.
    """
    found = [
        (layout, rows)
        for arbitration_id, layout in codec.layouts.items()
        if layout.name in WATCHED
        and (rows := _understood(session.data_rows(channel, arbitration_id), layout)) is not None
    ]
    if not found:
        return []
    numbers = np.sort(np.concatenate([rows.numbers for _layout, rows in found]))
    times_s = np.sort(np.concatenate([rows.times_s for _layout, rows in found]))
    silences = np.flatnonzero(np.diff(times_s) > FRESH_FOR_S)
    begins = numbers[silences + 1]
    told: list[tuple[float, StatusChange]] = []
    for begin, last_s in zip(begins.tolist(), times_s[silences].tolist(), strict=True):
        told.append((begin + _BEFORE_ALL, StatusChange(last_s, GAP, {})))
    for layout, rows in found:
        told += _changes(layout, rows, begins)
        if layout.name == STATUS:
            told += _rates(rows, begins)
    told.sort(key=lambda each: each[0])
    return [heard for _place, heard in told[:MOST]]


def _understood(rows: DataRows | None, layout: MessageLayout) -> DataRows | None:
    if rows is None:
        return None
    good = np.isin(rows.lengths, layout.lengths)
    if good.all():
        return rows
    if not good.any():
        return None
    return rows.of(good)


def _changes(
    layout: MessageLayout, rows: DataRows, begins: NDArray[np.int64]
) -> Iterator[tuple[float, StatusChange]]:
    """Yield the first frame of a message, and each one that differs from the one before it."""
    names = [name for name in WATCHED[layout.name] if name in layout.signals]
    words = payload_words(rows.payloads)
    columns: list[NDArray[Any]] = [signal_column(words, layout.signals[each]) for each in names]
    is_new = np.zeros(rows.numbers.size, np.bool_)
    for column in columns:
        is_new[1:] |= column[1:] != column[:-1]
    is_new[_firsts(rows, begins)] = True
    for row in np.flatnonzero(is_new)[:MOST].tolist():
        values = {name: column[row].item() for name, column in zip(names, columns, strict=True)}
        number = float(rows.numbers[row])
        yield number, StatusChange(float(rows.times_s[row]), layout.name, values)


def _firsts(rows: DataRows, begins: NDArray[np.int64]) -> NDArray[np.int64]:
    """Return the indices of the first row, and of the first one after each silence."""
    places = np.searchsorted(rows.numbers, begins)
    return np.unique(np.concatenate([[0], places[places < rows.numbers.size]])).astype(np.int64)


def _rates(rows: DataRows, begins: NDArray[np.int64]) -> Iterator[tuple[float, StatusChange]]:
    """Yield the frames per second, counted anew after each silence."""
    firsts = _firsts(rows, begins)
    for first, end in zip(firsts.tolist(), [*firsts[1:].tolist(), rows.numbers.size], strict=True):
        times_s = rows.times_s[first:end]
        here = 0
        while True:
            span_s = times_s - times_s[here]
            place = int(np.searchsorted(span_s, RATE_SPAN_S))
            if place >= times_s.size:
                break
            hz = (place - here) / float(span_s[place])
            number = float(rows.numbers[first + place]) + _BEFORE
            yield number, StatusChange(float(times_s[place]), RATE, {"hz": hz})
            here = place
