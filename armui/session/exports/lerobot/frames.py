"""What a log tells at the instants of an even rate: where the arm was, and what it was asked."""

from __future__ import annotations

import enum
from typing import TYPE_CHECKING, Final, NamedTuple

import numpy as np

from armui.protocol.codes import ArmStatusCode
from armui.session.exports.export_columns import TableColumns, table_rows

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from armui.protocol.codec import Codec
    from armui.session.exports.export_columns import RecordColumns, RowTimes
    from armui.session.exports.history import History, TimeSpan

    Array = NDArray[np.float64]

MAX_AGE_S: Final = 0.1
"""The highest age of what was measured, at each instant."""
GRIPPER: Final = 6
"""The place of the gripper's opening behind the six angles."""

_VALUES: Final = (*(f"joint_angle.{joint}" for joint in range(1, 7)), "gripper_opening")
_STATUS: Final = "arm.arm_status"
_NO_FAULT: Final = (
    ArmStatusCode.NORMAL,
    ArmStatusCode.TEACHING_RECORDING,
    ArmStatusCode.TEACHING_RUNNING,
    ArmStatusCode.TEACHING_PAUSED,
)


class Cause(enum.IntEnum):
    """Why an instant is in no episode."""

    NONE = 0
    SILENT = 1
    """No angles were heard, or they were older than :data:`MAX_AGE_S`."""
    FAULT = 2
    """The arm told a stop or a fault."""
    NO_GRIPPER = 3
    """The gripper was not heard, though it is at other times."""


class Instants(NamedTuple):
    """A log at an even rate.

    Attributes:
        times_s: As recorded, a period apart.
        measured: (n, 7) six angles in degrees and the opening in mm; NaN: not heard.
        asked: (n, 7) the same as commanded by any host; NaN: no such command held.
        causes: (n,) :class:`Cause`.
    """

    times_s: Array
    measured: Array
    asked: Array
    causes: NDArray[np.int8]


class InstantSampler:
    """Looks at a log at an even rate, piece by piece.

    Args:
        codec: A codec of the arm's generation.
        start_s: The time of the first instant.
        fps: Instants a second.
    """

    def __init__(self, codec: Codec, start_s: float, fps: int) -> None:
        self._start_s = start_s
        self._fps = fps
        self._next = 0
        self._records = _Wanted(codec)
        self._last: Array | None = None
        self._pieces: list[Instants] = []

    def take(self, history: History, span: TimeSpan) -> int:
        """Take in what a piece of the log adds; return the number of new instants."""
        rows = table_rows(history, span)
        if rows is None:
            return 0
        told = self._records.told(history, rows)
        # a clock that was set back tells nothing until it is where it was
        known = told if self._last is None else np.vstack((self._last, told))
        forward = known[:, 0] >= np.maximum.accumulate(known[:, 0])
        known = known[forward]
        self._last = known[-1:]
        first = max(self._next, int(np.ceil((known[0, 0] - self._start_s) * self._fps - 1e-6)))
        behind = int(np.floor((known[-1, 0] - self._start_s) * self._fps + 1e-6)) + 1
        if behind <= first:
            return 0
        self._next = behind
        times_s = self._start_s + np.arange(first, behind) / self._fps
        place = np.searchsorted(known[:, 0], times_s + 1e-9, side="right") - 1
        at = known[np.maximum(place, 0)]
        causes = at[:, 1].astype(np.int8)
        causes[times_s - at[:, 0] > MAX_AGE_S] = Cause.SILENT
        columns = len(_VALUES)
        self._pieces.append(Instants(times_s, at[:, 2 : 2 + columns], at[:, 2 + columns :], causes))
        return len(times_s)

    def instants(self) -> Instants:
        """Return all of them; where the gripper is heard at all, it counts."""
        found = Instants(*(np.concatenate(column) for column in zip(*self._pieces, strict=True)))
        heard = np.isfinite(found.measured[:, GRIPPER])
        if heard.any():
            found.causes[~heard & (found.causes == Cause.NONE)] = Cause.NO_GRIPPER
        return found


class _Wanted:
    """The columns that are wanted, out of those of a table."""

    def __init__(self, codec: Codec) -> None:
        records = TableColumns(codec).records
        self._measured = _places(records, "arm")
        self._asked = _places(records, "command")
        (self._status,) = [each for each in records if each.message == "ArmStatus"]

    def told(self, history: History, rows: RowTimes) -> Array:
        """Return for each row its time, its cause, what was measured and what was asked."""
        measured = _values(history, rows, self._measured, MAX_AGE_S)
        asked = _values(history, rows, self._asked, np.inf)
        # a command that tells some of the joints is none of the six
        asked[~np.isfinite(asked[:, :GRIPPER]).all(axis=1), :GRIPPER] = np.nan
        silent = ~np.isfinite(measured[:, :GRIPPER]).all(axis=1)
        faults = np.where(self._faulty(history, rows), Cause.FAULT, Cause.NONE)
        causes = np.where(silent, Cause.SILENT, faults)
        return np.column_stack((rows.times_s, causes, measured, asked))

    def _faulty(self, history: History, rows: RowTimes) -> NDArray[np.bool_]:
        told = self._status.told_at(history, rows.rows, rows.times_s)
        if told is None:
            return np.zeros(len(rows.rows), np.bool_)
        samples, which = told
        column = next(each for each in self._status.columns if each.name == _STATUS)
        faulty: NDArray[np.bool_] = ~np.isin(column.values(samples)[which], _NO_FAULT)
        return faulty & (which >= 0)


def _places(
    records: tuple[RecordColumns, ...], source: str
) -> list[tuple[RecordColumns, int, int]]:
    """Return where each wanted value stands: its message, column there, and place among them."""
    names = [f"{source}.{value}" for value in _VALUES]
    return [
        (record, place, names.index(column.name))
        for record in records
        for place, column in enumerate(record.columns)
        if column.name in names
    ]


def _values(
    history: History,
    rows: RowTimes,
    places: list[tuple[RecordColumns, int, int]],
    max_age_s: float,
) -> Array:
    """Return (n, 7) the values held at each row; NaN where none did, or an older one."""
    found = np.full((len(rows.rows), len(_VALUES)), np.nan)
    for record, place, into in places:
        told = record.told_at(history, rows.rows, rows.times_s)
        if told is None:
            continue
        samples, which = told
        held = (which >= 0) & (rows.times_s - samples.times_s[which] <= max_age_s)
        found[held, into] = record.columns[place].values(samples)[which[held]]
    return found
